#pragma once
/// \file
/// An experiment: what a lab writes down when it loads a real chain. SI units, radians.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <plumbline/arm/arm_kinematics.hpp>
#include <plumbline/loaded/control.hpp>
#include <string>
#include <vector>

#include "diagnose/bench/arm_sensor.hpp"
#include "diagnose/bench/channel.hpp"
#include "diagnose/bench/load.hpp"
#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::diagnose {

struct Calibration;  // inference/calibration.hpp

/// Largest number of covariates of an experiment.
inline constexpr std::size_t most_covariates = 8;

/// One reading. A missing value is NaN; imposed channels hold the command.
struct Reading {
  double t;
  /// By column of its channel. The first are x, y, Fx, Fy: where the end point is, and the force of the
  /// environment on it, of which compression is Fx < 0; or the angle of a joint alone, 0, its torque, and 0.
  std::vector<double> value;
  std::vector<double> rest =
      {};  ///< joint angles commanded at this reading; empty where those of the run hold
  std::vector<double> covariates = {};  ///< values of Experiment::covariates, in the units of the table
  std::vector<double> wrench = {};      ///< on an arm, in the axes of the world: force, N, and moment, N m

  /// NaN beyond the last value.
  [[nodiscard]] double operator[](std::ptrdiff_t column) const {
    const auto place = static_cast<std::size_t>(column);
    return place < value.size() ? value[place] : std::nan("");
  }
  /// For writing; what stands between is NaN.
  [[nodiscard]] double& operator[](std::ptrdiff_t column) {
    const auto place = static_cast<std::size_t>(column);
    if (place >= value.size()) value.resize(place + 1, std::nan(""));
    return value[place];
  }
  /// The angles of the joints.
  [[nodiscard]] std::vector<double> angles(std::size_t joints) const;
  /// The force of the wrench; zero without one.
  [[nodiscard]] Eigen::Vector3d wrench_force() const {
    if (wrench.empty()) return Eigen::Vector3d::Zero();
    return Eigen::Map<const Eigen::Vector3d>(wrench.data());
  }
};

/// The command between two readings, or beyond them, by linear interpolation; nothing is measured there.
/// \param share  of the way from the first to the second
Reading between(const Reading& from, const Reading& to, double share);

/// The source of numbers and the unit in which they stand there.
struct Origin {
  std::string what;    ///< a channel, "Fx" or "q3", or a key, "link_length"
  std::string source;  ///< for a channel a column name, "column 3" or "constant 0"; else empty
  std::string unit;    ///< "mm"
  double in_si = 1;    ///< of that unit
  std::optional<Channel> channel = std::nullopt;
  std::string si = {};  ///< the unit of its values in readings
};

/// The groups of a decimated run (decimate.hpp).
struct Groups {
  std::size_t size =
      1;  ///< readings of a group, except at turning points and ends; 1 where others were left out
  std::vector<std::size_t> first;  ///< first original reading of each group, and the
                                   ///< end; empty where the run is not decimated
};

/// The joint angles on the observed branch and on the other one, where a chain may take either: a row a
/// reading, a column a joint.
struct Branch {
  std::vector<bool> differs;  ///< by reading, whether the branches differ
  Eigen::ArrayXXd angles, other_angles;
  Eigen::ArrayX2d force;  ///< on the end point on the observed branch, N
  /// The first reading at which the branches differ.
  [[nodiscard]] std::size_t first() const;
};

/// Declared standard deviation of one reading, by kind of channel; 0 for a channel that has none.
struct Noise {
  std::array<double, channel_names> sigma{};

  [[nodiscard]] double operator[](Channel::Name name) const { return sigma[static_cast<std::size_t>(name)]; }
  [[nodiscard]] double& operator[](Channel::Name name) { return sigma[static_cast<std::size_t>(name)]; }
};

/// One loading history from rest, readings in the order in which they were taken.
struct Run {
  std::string id;
  Control control;  ///< what the rig imposes: the end point, while the force is measured; or the reverse
  std::vector<double> rest;  ///< joint angles commanded at the first reading: the unloaded shape
  std::vector<Reading> readings;
  Groups groups = {};
  std::size_t number = 0;  ///< of all runs of the experiment, from 0; see Experiment::run_count
  std::vector<Origin> origins =
      {};  ///< of t, x, y, Fx, Fy, the joint angles and covariates; empty where it was not read
  Device device = Device::chain;         ///< of whose bench it is a run
  std::size_t points = 0;                ///< that are measured of an arm in space; 0 for other benches
  std::vector<Channel> of_sensors = {};  ///< the channels of an arm's sensors beside the tracker
  bool begins_moving = false;     ///< the first reading was taken on the way; else the run begins relaxed
  bool by_weights = false;        ///< an imposed force is that of weights, not of a servo with a load cell
  bool weights_inferred = false;  ///< by_weights follows from the forces, not from the experiment's file
  std::vector<std::string> continued_by = {};  ///< ids of runs that were read as its later parts
  std::vector<std::size_t> interpolated = {};  ///< by covariate, the readings without a value of it
  std::optional<Branch> branch =
      std::nullopt;                     ///< the observed branch, where the nominal model may take either
  std::vector<LoadChannel> loads = {};  ///< what loads the chain besides, as part of the command
  std::vector<Channel> planned = {};    ///< channels to be measured, where nothing has been yet

  [[nodiscard]] const EndKind& end() const { return end_kind(device); }
  [[nodiscard]] bool holds_end_point() const { return control == Control::end_point; }
  /// The imposed channels, along x and along y; of a joint alone its angle or its torque.
  [[nodiscard]] std::vector<Channel> imposed() const;
  /// The channels that answer them.
  [[nodiscard]] std::vector<Channel> answering() const;
  /// Values of the imposed channels at a reading: an end point, m, or a force, N; an angle or a torque, and
  /// 0.
  [[nodiscard]] Eigen::Vector2d imposed_at(const Reading& reading) const;
  /// Whether each reading has a command of its own to every joint, as servos get it.
  [[nodiscard]] bool commands_joints() const { return !readings.empty() && !readings.front().rest.empty(); }
  /// The commanded joint angles at a reading: the unloaded shape.
  [[nodiscard]] const std::vector<double>& rest_at(const Reading& reading) const {
    return reading.rest.empty() ? rest : reading.rest;
  }
  /// The largest distance of a joint's angles from those that are commanded; zero without angles.
  /// \param joint  from 0
  /// \param angle  of a reading, by its number; NaN where there is none
  template <class Angle>
  [[nodiscard]] double largest_deflection(std::size_t joint, Angle angle) const {
    double largest = 0;
    for (std::size_t i = 0; i < readings.size(); ++i)
      if (const double turn = std::abs(angle(i) - rest_at(readings[i])[joint]); std::isfinite(turn))
        largest = std::max(largest, turn);
    return largest;
  }
  /// Changes the commanded joint angles: those of the run, and of each reading that has its own.
  template <class Change>
  void each_rest(Change change) {
    change(rest);
    for (Reading& reading : readings)
      if (!reading.rest.empty()) change(reading.rest);
  }
  /// Coordinates of what is commanded, by which the history of a run is told: the imposed values. For joint
  /// angles, the end point of a stretched chain of length 1 with equal links, moved from its place by these
  /// angles. Loads along the chain add to either.
  [[nodiscard]] Eigen::Vector2d command(const Reading& reading) const;
  /// The command before the first reading of a run that begins moving: it comes along the line of the first
  /// motion, from a third of the way to the farthest command. Nothing is measured there.
  [[nodiscard]] std::optional<Reading> before_first() const;
  /// By reading, whether the command reverses there.
  [[nodiscard]] std::vector<bool> turning_points() const;
  [[nodiscard]] bool turns_back() const;
  /// Whether time stamps only count the readings: time constants could not be identified from them.
  [[nodiscard]] bool counts_readings() const;
  /// Median interval between readings of different times, s; zero where no time passes.
  [[nodiscard]] double sampling_interval() const;
  /// The channels that answer or that some reading has, and those that are planned.
  [[nodiscard]] std::vector<Channel> measured() const;
  [[nodiscard]] bool reads_angles() const;
  /// All channels that the bench could measure besides the imposed ones.
  [[nodiscard]] std::vector<Channel> measurable() const;
  /// The first and last original reading, from 0, of a decimated reading.
  [[nodiscard]] std::size_t first_taken(std::size_t reading) const;
  [[nodiscard]] std::size_t last_taken(std::size_t reading) const;
  /// Whether readings of it were left out.
  [[nodiscard]] bool is_thinned() const { return groups.size == 1 && !groups.first.empty(); }
  /// Declared noise of a decimated reading over that of an original one.
  [[nodiscard]] double noise_of_group() const;
};

/// The known properties of the bench, whether or not the nominal model uses them.
struct Bench {
  enum class Plane { vertical, horizontal, unknown } plane;
  std::array<double, 2> gravity_direction;  ///< unit vector, meaningful with has_direction
  bool has_direction;

  /// Unit vector of gravity.
  [[nodiscard]] Eigen::Vector2d down() const {
    return has_direction ? Eigen::Vector2d(gravity_direction[0], gravity_direction[1])
                         : Eigen::Vector2d(0, -1);
  }
};

/// A frame of an arm whose place, or pose, is measured.
struct MeasuredPoint {
  std::string name;
  OnLink<double> at;
};

/// The bench of an arm in space.
struct ArmBench {
  /// Where tracker and sensors stand, and where the points sit on their links: as declared, or anywhere.
  enum class Frames { known, unknown };

  std::vector<MeasuredPoint> points;
  OnLink<double> load{0};  ///< where the wrench acts
  Frames frames = Frames::known;
  std::shared_ptr<const Calibration> calibration = nullptr;  ///< of the nominal arm, or none
  double assumed_density = 0;  ///< of links without masses in their model, kg/m; 0 where these have some
  std::vector<ArmSensor> sensors = {};  ///< beside the tracker

  /// What the sensors read. \param joints  of the arm
  [[nodiscard]] std::vector<Channel> sensor_channels(std::size_t joints) const;
};

/// The nominal model, the bench and the runs.
struct Experiment : NominalChain {
  std::string name;
  Bench bench;
  Noise noise;
  std::vector<Run> runs;
  /// Number of all runs, with those left out since; 0 before numbering.
  std::size_t run_count = 0;
  std::vector<Origin> origins = {};          ///< of link_length, joint_stiffness, link_mass, gravity and rest
  std::vector<std::string> covariates = {};  ///< names of quantities noted at each reading: "temperature"
  std::vector<Load> loads = {};              ///< along the chain
  ArmBench arm_bench = {};                   ///< of an arm in space
};

}  // namespace plumbline::diagnose
