#pragma once
/// \file
/// An experiment: what a lab writes down when it presses on a real chain. SI units, radians.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <plumbline/loaded/control.hpp>
#include <string>
#include <vector>

#include "diagnose/bench/channel.hpp"
#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::diagnose {

/// One reading. A measured value is NaN where its field is empty; the imposed channels hold what was
/// commanded. (Fx, Fy) is the force that the environment exerts on the end point: compression is Fx < 0.
struct Reading {
  double t, x, y, Fx, Fy;
  std::vector<double> q;  ///< relative joint angles; empty where the run has no such columns
};

/// Where numbers were read, and in which unit they stand there.
struct Origin {
  std::string what;    ///< a channel, "Fx" or "q3", or a key, "link_length"
  std::string source;  ///< of a channel the name of a column, "column 3", "constant 0"; empty where none is
  std::string unit;    ///< "mm"
  double in_si = 1;    ///< of that unit
};

/// How readings were drawn together (condense.hpp).
struct Groups {
  std::size_t size = 1;            ///< so many make one, but at turning points and ends
  std::vector<std::size_t> first;  ///< by reading, the number of the first one that it stands for, and the
                                   ///< end; empty where none were drawn together
};

/// Where a chain may go to either of two sides: the joint angles on the one to which it went, and on the
/// other; a row a reading, a column a joint.
struct Branch {
  std::vector<bool> differs;  ///< by reading, whether the branches differ
  Eigen::ArrayXXd angles, other_angles;
  Eigen::ArrayX2d force;  ///< on the end point, there, N
  /// The first reading at which they are apart.
  [[nodiscard]] std::size_t first() const;
};

/// One loading history from rest, readings in the order in which they were taken.
struct Run {
  std::string id;
  Control control;  ///< what the rig imposes: the end point, while the force is measured; or the reverse
  std::vector<double> rest;  ///< commanded joint angles: the unloaded shape
  std::vector<Reading> readings;
  Groups groups = {};
  std::size_t number = 0;            ///< of all runs of the experiment, from 0; see Experiment::run_count
  std::vector<Origin> origins = {};  ///< of t, x, y, Fx, Fy and the joint angles; empty where it was not read
  bool by_weights = false;  ///< whether an imposed force is that of weights, not of a servo on the load cell
  bool weights_inferred = false;  ///< whether that is told by the forces, not by who took the readings
  std::optional<Branch> branch = std::nullopt;  ///< what the readings say where the model leaves it open

  [[nodiscard]] bool holds_end_point() const { return control == Control::end_point; }
  /// What the rig imposes, along x and along y.
  [[nodiscard]] std::array<Channel, 2> imposed() const;
  /// What was commanded at a reading: an end point, m, or a force, N.
  [[nodiscard]] Eigen::Vector2d command(const Reading& reading) const;
  /// By reading, whether the command goes back from there: its next step is against the one before.
  [[nodiscard]] std::vector<bool> turning_points() const;
  [[nodiscard]] bool turns_back() const;
  /// Whether time stamps only count the readings. A time constant found from them would be that of a clock
  /// that somebody made up.
  [[nodiscard]] bool counts_readings() const;
  /// From one reading to the next where time passes, the middle one, s; zero where none passes.
  [[nodiscard]] double sampling_interval() const;
  /// What answers: the other of force and end point, then the joint angles that the run has columns for.
  [[nodiscard]] std::vector<Channel> measured() const;
  /// First and last of the readings as they were taken, from 0, that a reading stands for.
  [[nodiscard]] std::size_t first_taken(std::size_t reading) const;
  [[nodiscard]] std::size_t last_taken(std::size_t reading) const;
  /// Declared noise of a reading over that of one as it was taken.
  [[nodiscard]] double noise_of_group() const;
};

/// Declared standard deviation of one reading; 0 for a channel without noise.
struct Noise {
  double x, y, Fx, Fy, q;
};

/// What is known of the rig, whether or not the nominal model uses it.
struct Bench {
  enum class Plane { vertical, horizontal, unknown } plane;
  std::array<double, 2> gravity_direction;  ///< unit vector, meaningful with has_direction
  bool has_direction;

  /// Unit vector along which weights pull.
  [[nodiscard]] Eigen::Vector2d down() const {
    return has_direction ? Eigen::Vector2d(gravity_direction[0], gravity_direction[1])
                         : Eigen::Vector2d(0, -1);
  }
};

/// The nominal chain, the rig and the runs.
struct Experiment : NominalChain {
  std::string name;
  Bench bench;
  Noise noise;
  std::vector<Run> runs;
  /// Of all runs, also of those that were left out since they were numbered; 0 before.
  std::size_t run_count = 0;
  std::vector<Origin> origins = {};  ///< of link_length, joint_stiffness, link_mass, gravity and rest
};

}  // namespace plumbline::diagnose
