#pragma once
/// \file
/// What is known of an arm whose frames are unknown and whose joints are all a little off, before its
/// diagnosis.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// An error of one joint that every arm has a little of; by parameter, in fitted coordinates.
struct Tolerance {
  EffectAt at;
  std::vector<double> mean;       ///< given the readings; the nominal effects have it
  std::vector<double> deviation;  ///< before any reading
};

/// How large one kind of error is over all joints.
struct LearnedSize {
  EffectAt effect;  ///< at the last joint that has it
  double size;      ///< standard deviation, in the unit of its parameters
  std::string_view unit;
};

/// A frame that was solved for, beside that of the experiment.
struct SolvedFrame {
  enum class Of { tracker, point, sensor } of;
  std::string name;       ///< "tracker", or that of a point or a sensor
  Pose<double> at;        ///< of the arm's world in the tracker's frame; of the point on its link; of the
                          ///< sensor in the arm's world
  Pose<double> declared;  ///< where the experiment had it
  Vector3<double> shift;  ///< standard deviations of its place, m, a sensor's in its own axes
  Vector3<double> turn;   ///< and of its orientation, rad; zero where nothing shows it
  double focal_length = 0, focal_length_sd = 0;  ///< of a camera whose is not known, px
};

/// Root mean squares of what is left of readings that a fit has not seen, by kind of channel, in its unit: of
/// all components of a place, an orientation or a picture together. Zero for what is not read.
struct LeftOfPoses : std::array<double, channel_names> {
  [[nodiscard]] double of(Channel::Name name) const { return (*this)[static_cast<std::size_t>(name)]; }
};

struct Calibration {
  std::vector<SolvedFrame> frames;  ///< the tracker's, those of points, those of sensors
  std::vector<Tolerance> tolerances;
  std::vector<LearnedSize> sizes;  ///< of those that the readings tell
  /// What sticks out of the tolerances, by a linear fit: posterior means, the first sticks out farthest.
  std::vector<NominalEffect> beside;
  double noise = 1;  ///< standard deviation over the declared one
  /// What the nominal arm in its best frames, least squares over all geometry, and the posterior mean leave.
  LeftOfPoses nominal, least_squares, corrected;
};

/// A tolerance's mean in catalogue units.
NominalEffect nominal_effect(const Study& study, const Tolerance& of);

/// The experiment of a calibrated study with the tolerances at their posterior mean beside a cause, which has
/// been part of what they were before; of another study its experiment.
Experiment beside(const Study& study, const Instance& cause);

}  // namespace plumbline::diagnose
