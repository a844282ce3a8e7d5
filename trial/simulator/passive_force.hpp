#pragma once
/// \file
/// The torques that MuJoCo has no element for, as passive forces on its generalised coordinates.

#include <mujoco/mujoco.h>

#include "trial/simulator/joint_law.hpp"

namespace plumbline::simulator {

/// The joints on which the passive forces act, and the memory of these forces.
class PassiveForce {
 public:
  /// \param response  of the model, see Pace
  PassiveForce(const Plan& plan, const Physics& physics, const PlannedRun& run, const mjModel& model,
               double response);

  /// From now on the way counts: before it nothing sticks and what relaxes is relaxed.
  void begin_history();
  /// Lets the memory follow the joints over a time step.
  void remember(const mjData& data, double dt);
  /// Adds to qfrc_passive.
  void add_to(const mjModel& model, mjData& data) const;

 private:
  [[nodiscard]] std::vector<double> deflections(const mjData& data) const;
  void add_magnet(const mjModel& model, mjData& data) const;
  void add_wall(const mjModel& model, mjData& data) const;

  const Physics& physics_;
  std::vector<double> rest_;
  std::vector<int> position_, velocity_;  ///< addresses of the hub hinges in qpos and qvel
  std::vector<JointLaw> law_;
  Contact pivot_;      ///< of the end point: the hubs alone turn it, links do not bend while it rubs
  double turned_ = 0;  ///< sum of the deflections after the last time step
  bool relaxed_ = true;
};

}  // namespace plumbline::simulator
