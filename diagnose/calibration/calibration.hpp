#pragma once
/// \file
/// An arm as it is: its frames registered, and every joint a little off.

#include <array>
#include <memory>
#include <optional>

#include "diagnose/calibration/whitening.hpp"
#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

class Study;

/// How large one kind of error is over all joints.
struct LearnedSize {
  EffectAt effect;  ///< at the first joint that has it
  double size;      ///< standard deviation, in the unit of its parameters
  std::string_view unit;
};

/// A frame that was solved for, beside that of the experiment.
struct SolvedFrame {
  std::string name;       ///< "tracker", or a point's
  Pose<double> at;        ///< of the arm's world in the tracker's frame; of the point on its link
  Vector3<double> shift;  ///< standard deviations of its place, m
  Vector3<double> turn;   ///< and of its orientation, rad; zero where nothing shows it
};

/// Root mean squares of what is left of readings that a fit has not seen.
struct LeftOfPoses {
  double place = 0;  ///< distance, m; zero where no places are read
  double turn = 0;   ///< rad; zero where no orientations are read
};

/// The model of every arm: frames of which nothing is known, and zero, shift, tilt, gear and compliance of
/// every joint as random effects whose sizes are learned.
struct Calibration {
  /// Registered. Its nominal effects end with the random ones at their posterior mean.
  Experiment experiment;
  std::size_t random_effects = 0;  ///< number of these
  Whitening whitening;             ///< of its residuals, declared sigmas
  std::vector<SolvedFrame> frames;
  std::vector<LearnedSize> sizes;
  /// What sticks out of them, by a linear fit: posterior means, the first sticks out farthest.
  std::vector<NominalEffect> beside;
  double noise = 1;               ///< standard deviation over the declared one
  std::vector<EffectAt> imitate;  ///< effects that a frame imitates, which are no causes
  /// What the nominal arm in its best frames, least squares over all geometry, and the posterior mean leave.
  LeftOfPoses nominal, least_squares, corrected;
};

/// \param study  of the experiment as it was read, in whatever frames
/// \returns nothing where there are too few readings
std::shared_ptr<const Calibration> calibrated(const Study& study);

}  // namespace plumbline::diagnose
