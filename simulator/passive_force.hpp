#pragma once
/// \file
/// The torques that MuJoCo has no element for, as passive forces on its generalised coordinates.

#include <mujoco/mujoco.h>

#include "simulator/physics.hpp"

namespace plumbline::simulator {

/// A dry contact: a bristle, this many times stiffer than the joint's spring, that bends until it slips.
/// MuJoCo's own dry friction will not do: it has no memory, and where a held end point could carry the load
/// alone it relaxes at once.
struct Contact {
  static constexpr double relative_stiffness = 300;

  double stiffness = 0, damping = 0, slip = 0;  ///< N m/rad, N m s/rad, N m
  double bend = 0;                              ///< of the bristle, rad
  bool sticks = true;

  void follow(double turn);
  [[nodiscard]] double torque(double rate) const { return -stiffness * bend - (sticks ? damping * rate : 0); }
};

/// Where the passive forces find their joints, and what they remember.
class PassiveForce {
 public:
  /// \param response  of the model, see Pace
  PassiveForce(const Plan& plan, const Physics& physics, const PlannedRun& run, const mjModel& model,
               double response);

  /// From now on: Maxwell arms follow with their time constant instead of carrying nothing.
  void begin_history() { relaxed_ = false; }
  /// Lets the memory follow the joints over a time step.
  void remember(const mjData& data, double dt);
  /// Adds to qfrc_passive.
  void add_to(const mjModel& model, mjData& data) const;

 private:
  void add_friction(mjData& data) const;
  [[nodiscard]] double joint_torque(std::size_t j, double deflection) const;

  const Physics& physics_;
  std::vector<double> rest_;
  std::vector<int> position_, velocity_;  ///< addresses of the hub hinges in qpos and qvel
  std::vector<double> arm_;               ///< where the far end of each Maxwell arm's spring stands
  std::vector<double> largest_;           ///< largest |deflection| so far
  std::vector<double> last_;              ///< deflection after the last time step
  std::vector<Contact> contact_;          ///< of the hubs and, last, of the end pivot
  bool relaxed_ = true;
};

}  // namespace plumbline::simulator
