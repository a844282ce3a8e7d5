#pragma once
/// \file
/// The torques that MuJoCo has no element for, as passive forces on its generalised coordinates.

#include <mujoco/mujoco.h>

#include "rig/physics.hpp"

namespace plumbline::rig {

/// Where the passive forces find their joints, and what they remember.
class PassiveForce {
 public:
  PassiveForce(const Physics& physics, const PlannedRun& run, const mjModel& model);

  /// From now on: Maxwell arms follow with their time constant instead of carrying nothing.
  void begin_history() { relaxed_ = false; }
  /// Lets the memory follow the joints over a time step.
  void remember(const mjData& data, double dt);
  /// Adds to qfrc_passive.
  void add_to(const mjModel& model, mjData& data) const;

 private:
  [[nodiscard]] double joint_torque(std::size_t j, double deflection) const;

  const Physics& physics_;
  std::vector<double> rest_;
  std::vector<int> position_, velocity_;  ///< addresses of the hub hinges in qpos and qvel
  std::vector<double> arm_;               ///< where the far end of each Maxwell arm's spring stands
  std::vector<double> largest_;           ///< largest |deflection| so far
  bool relaxed_ = true;
};

}  // namespace plumbline::rig
