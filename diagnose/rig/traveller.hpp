#pragma once
/// \file
/// A planar rig under way in one run: its posture, its memory, and what its sensors read.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/chain_loads.hpp"
#include "diagnose/rig/joint_states.hpp"
#include "diagnose/rig/rig_solver.hpp"

namespace plumbline::diagnose {

class Traveller {
 public:
  Traveller(const Experiment& experiment, const Rig& rig, const Run& run);

  /// The true end point (after position offset and rail misalignment) or the true force (after the load cell,
  /// the pulley and the rail) of a command, and the next loads along the chain. The rail turns about the
  /// unloaded end point.
  /// \param growing  1 while the imposed force grows, -1 while it falls
  [[nodiscard]] const Imposed& impose(const Run& run, const Reading& reading, double growing);

  /// The force that the load cell shows once it has responded, in the axes of the rail.
  [[nodiscard]] Vector2 felt_force(double t, double direction) const;

  /// The load on a second sensor beside the first one.
  [[nodiscard]] Vector2 load_on_second(const Run& run) const;

  void remember(const Layout& layout);

  JointStates joints;
  Vector2 unloaded;                                      ///< end point of the nominal chain at rest
  Imposed imposed{Control::end_point, Vector2::Zero()};  ///< last
  Posture posture;

 private:
  /// Adds the moments by which servos hold a share of the nominal weight of the chain as it is commanded.
  void hold_weight(const std::vector<double>& commanded, std::vector<double>& moment) const;
  [[nodiscard]] Vector2 at_end(const Run& run, const Reading& reading, double growing) const;

  const Experiment* experiment_;
  std::vector<Vector2> nominal_centre_;  ///< see Rig::centre, where servos hold the weight
  LoadHistory load_history_;
};

}  // namespace plumbline::diagnose
