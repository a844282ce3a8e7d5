#pragma once
/// \file
/// A planar rig under way in one run: its posture, its memory, and what its sensors read.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/chain_loads.hpp"
#include "diagnose/rig/delayed.hpp"
#include "diagnose/rig/rig_solver.hpp"

namespace plumbline::diagnose {

/// A force that follows another one with a time constant; at the first reading it has followed.
class Follower {
 public:
  /// \param now   changes linearly between readings
  /// \param dt    time since the last reading, s
  /// \param time  constant, s
  Vector2 follow(const Vector2& now, double dt, double time);

 private:
  Vector2 led_ = Vector2::Zero(), at_ = Vector2::Zero();  ///< at the last reading
  bool begun_ = false;
};

class Traveller {
 public:
  Traveller(const Experiment& experiment, const Rig& rig, const Run& run);

  /// Commands other joint angles.
  void turn_to(const std::vector<double>& rest);

  /// The true end point (after position offset and rail misalignment) or the true force (after the load cell,
  /// the pulley and the rail) of a command, and the next loads along the chain. The rail turns about the
  /// unloaded end point.
  /// \param growing  1 while the imposed force grows, -1 while it falls
  [[nodiscard]] const Imposed& impose(const Run& run, const Reading& reading, double growing);

  /// The measured force, in the axes of the rail.
  /// \param dt  time since the last reading; 0 at the first
  Vector2 measure_force(double t, double dt, double direction);

  /// What a second sensor beside the first one reads.
  [[nodiscard]] Vector2 second_load(const Run& run) const;

  /// Sets the expected joint speeds from those of the last step.
  /// \param share  length of the next step of the command over that of the last
  void expect(double share, double dt);

  void remember(const Layout& layout, const TimeStep& during);

  RunRig on;
  LedCommand command;
  Vector2 unloaded;                                      ///< end point of the nominal chain at rest
  Imposed imposed{Control::end_point, Vector2::Zero()};  ///< last
  Posture posture;
  std::vector<JointMemory> memory;

 private:
  /// Adds the moments by which servos hold a share of the nominal weight of the chain as it is commanded.
  void hold_weight(const std::vector<double>& commanded, std::vector<double>& moment) const;
  [[nodiscard]] Vector2 at_end(const Run& run, const Reading& reading, double growing) const;

  const Experiment* experiment_;
  Follower lag_, creep_;           ///< of the load cell
  std::vector<double> rest_then_;  ///< of each joint, at the last reading
  LoadHistory load_history_;
};

}  // namespace plumbline::diagnose
