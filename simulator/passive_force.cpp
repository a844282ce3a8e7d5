#include "simulator/passive_force.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plumbline::simulator {

void Contact::follow(double turn) {
  if (slip == 0) return;
  const double limit = slip / stiffness;
  bend += turn;
  sticks = std::abs(bend) < limit;
  bend = std::clamp(bend, -limit, limit);
}

PassiveForce::PassiveForce(const Plan& plan, const Physics& physics, const PlannedRun& run,
                           const mjModel& model, double response)
    : physics_(physics), arm_(run.rest.size(), 0), largest_(arm_), last_(arm_) {
  const auto contact = [&](double spring, double slip) {
    constexpr double damping_ratio = 0.3;
    const double stiffness = Contact::relative_stiffness * spring;
    contact_.push_back(
        {stiffness, 2 * damping_ratio * std::sqrt(stiffness * spring) * response, slip, 0, true});
  };
  for (std::size_t j = 0; j < run.rest.size(); ++j) {
    const int joint = mj_name2id(&model, mjOBJ_JOINT, ("q" + std::to_string(j + 1)).c_str());
    position_.push_back(model.jnt_qposadr[joint]);
    velocity_.push_back(model.jnt_dofadr[joint]);
    rest_.push_back(run.rest[j] + physics.joint[j].rest_error);
    contact(physics.joint[j].stiffness, physics.joint[j].friction);
  }
  contact(plan.typical_stiffness() / static_cast<double>(plan.size()), physics.pivot_friction);
}

void PassiveForce::remember(const mjData& data, double dt) {
  const double follow = relaxed_ ? 1.0 : -std::expm1(-dt / physics_.relaxation);
  double turn = 0;
  for (std::size_t j = 0; j < rest_.size(); ++j) {
    const double deflection = data.qpos[position_[j]] - rest_[j];
    arm_[j] += follow * (deflection - arm_[j]);
    largest_[j] = relaxed_ ? std::abs(deflection) : std::max(largest_[j], std::abs(deflection));
    if (!relaxed_) contact_[j].follow(deflection - last_[j]);
    turn += deflection - last_[j];
    last_[j] = deflection;
  }
  if (!relaxed_) contact_.back().follow(turn);
}

double PassiveForce::joint_torque(std::size_t j, double d) const {
  const Joint& joint = physics_.joint[j];
  const double size = std::abs(d);
  const double turned =
      std::copysign(std::max(0.0, size - joint.backlash), d);  // of the spring, behind its play
  double torque = -joint.stiffness * joint.hardening * turned * turned * turned;
  if (joint.backlash > 0) torque -= joint.stiffness * turned;
  if (joint.softening > 0)
    torque -= joint.stiffness * d * std::max(0.2, 1 - joint.softening * std::max(largest_[j], size));
  if (size > joint.stop) torque -= joint.stop_stiffness * std::copysign(size - joint.stop, d);
  if (joint.detent > 0) torque -= joint.detent * std::sin(joint.detent_waves * d);
  return torque - physics_.arm_ratio * joint.stiffness * (d - arm_[j]);
}

void PassiveForce::add_to(const mjModel& model, mjData& data) const {
  std::vector<double> d(rest_.size());
  for (std::size_t j = 0; j < d.size(); ++j) d[j] = data.qpos[position_[j]] - rest_[j];
  for (std::size_t j = 0; j < d.size(); ++j) {
    const double neighbours = (j > 0 ? d[j - 1] : 0) + (j + 1 < d.size() ? d[j + 1] : 0);
    data.qfrc_passive[velocity_[j]] += joint_torque(j, d[j]) + physics_.coupling * neighbours;
  }
  if (!relaxed_) add_friction(data);
  const Magnet& magnet = physics_.magnet;
  if (magnet.strength == 0) return;
  const int end = mj_name2id(&model, mjOBJ_SITE, "end");
  const mjtNum* at = data.site_xpos + 3 * static_cast<std::ptrdiff_t>(end);
  const double x = magnet.place[0] - at[0], y = magnet.place[1] - at[1];
  const double pull = magnet.strength * std::exp(-(x * x + y * y) / (2 * magnet.width * magnet.width));
  const std::array<mjtNum, 3> force{pull * x, pull * y, 0}, torque{0, 0, 0};
  mj_applyFT(&model, &data, force.data(), torque.data(), at, model.site_bodyid[end], data.qfrc_passive);
}

/// The hubs alone turn the end: links do not bend while a pivot rubs.
void PassiveForce::add_friction(mjData& data) const {
  double rate = 0;
  for (const int address : velocity_) rate += data.qvel[address];
  const double pivot = contact_.back().slip > 0 ? contact_.back().torque(rate) : 0;
  for (std::size_t j = 0; j < velocity_.size(); ++j) {
    const double own = contact_[j].slip > 0 ? contact_[j].torque(data.qvel[velocity_[j]]) : 0;
    data.qfrc_passive[velocity_[j]] += own + pivot;
  }
}

}  // namespace plumbline::simulator
