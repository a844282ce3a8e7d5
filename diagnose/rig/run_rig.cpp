#include "diagnose/rig/run_rig.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace plumbline::diagnose {
namespace {

/// Adds a free law in parallel with the spring of its joint.
void add(const FreeLaw& own, const std::vector<double>& times, JointLaw& law) {
  if (!own.knots.empty()) law.table.emplace_back(own.knots);
  for (const FreeLaw::Slider& one : own.sliders) {
    const double turn = one.slips_at;
    if (one.torque > 0) law.slider.push_back({one.torque / turn, one.torque, {}, false, true});
    if (!one.profile.empty()) law.slider.push_back({1 / turn, 1, {}, false, true, TorqueTable(one.profile)});
    if (one.growth > 0) law.slider.push_back({2 * one.growth / (turn * turn), one.growth, {}, true, true});
  }
  for (const FreeLaw::Arm& arm : own.arms) {
    const auto place = std::find(times.begin(), times.end(), arm.time_constant) - times.begin();
    law.arm_stiffness.at(static_cast<std::size_t>(place)) += arm.stiffness;
  }
}

JointLaw joint_law(const Rig& rig, const std::vector<double>& times, std::size_t i) {
  JointLaw law;
  law.stiffness = rig.stiffness[i];
  law.backlash = rig.backlash[i];
  law.stop = rig.stop[i];
  law.stop_stiffness = rig.stop_stiffness[i];
  law.travel = rig.travel[i];
  law.hardening = rig.hardening[i];
  law.asymmetry = rig.asymmetry[i];
  law.knee = rig.knee[i];
  law.give = rig.give[i];
  law.yield = rig.yield;
  law.flow = rig.flow;
  if (std::isfinite(rig.slip[i])) law.yield = rig.slip[i], law.flow = JointLaw::slipping, law.hardens = false;
  for (std::size_t a = 0; a < rig.arms.size(); ++a)
    law.arm_stiffness.at(a) = rig.arms[a].ratio * law.stiffness;
  if (law.stiffness > 0) {
    const double stiff = JointLaw::sticking * law.stiffness;
    const bool gives = rig.presliding > 0 && rig.friction[i] > 0;
    law.slider.push_back({gives ? std::min(stiff, rig.friction[i] / rig.presliding) : stiff, rig.friction[i],
                          rig.friction_law});
    law.slider.back().in_bearing = true;
    for (const Slider& one : rig.sliders[i]) law.slider.push_back({one.ratio * law.stiffness, one.yield});
  }
  for (const FreeLaw& one : rig.laws)
    if (one.joint == i + 1) add(one, times, law);
  for (const StatedTorque& one : rig.stated_torques)
    if (one.joint == i) law.stated.push_back(one);
  if (std::any_of(law.stated.begin(), law.stated.end(), std::mem_fn(&StatedTorque::directed))) {
    law.direction = law.slider.size();
    law.slider.push_back({1 / JointLaw::turning, 1});
    law.slider.back().in_bearing = true;
  }
  return law;
}

}  // namespace

std::vector<double> arm_times(const Rig& rig) {
  std::vector<double> times;
  for (const Arm& arm : rig.arms) times.push_back(arm.time);
  for (const FreeLaw& law : rig.laws)
    for (const FreeLaw::Arm& arm : law.arms)
      if (std::find(times.begin(), times.end(), arm.time_constant) == times.end())
        times.push_back(arm.time_constant);
  return times;
}

std::size_t slider_count(const Rig& rig, std::size_t joint) {
  std::size_t count = rig.sliders[joint].size();
  for (const FreeLaw& law : rig.laws)
    if (law.joint == joint + 1) count += law.sliders.size();
  return count;
}

std::size_t contact_count(const Rig& rig) {
  const bool directed =
      std::any_of(rig.stated_torques.begin(), rig.stated_torques.end(), std::mem_fn(&StatedTorque::directed));
  std::size_t most = 0;
  for (std::size_t i = 0; i < rig.length.size(); ++i) most = std::max(most, slider_count(rig, i));
  const bool dry = rig.friction_law.growth > 0 || std::any_of(rig.friction.begin(), rig.friction.end(),
                                                              [](double torque) { return torque > 0; });
  return (most > 0 || dry || directed ? 1 + most : 0) + (directed ? 1 : 0);
}

RunRig::RunRig(Rig own, const std::vector<double>& commanded_rest)
    : rig(std::move(own)),
      arm_time(arm_times(rig)),
      rest_orientation(0),
      largest_stiffness(*std::max_element(rig.stiffness.begin(), rig.stiffness.end())),
      beyond(rig.length.size()) {
  const std::size_t n = rig.length.size();
  Vector2 carried = rig.payload;
  for (std::size_t j = n; j-- > 0;) {
    beyond[j] = carried;
    carried += rig.weight[j];
  }
  for (std::size_t i = 0; i < n; ++i) joint.push_back(joint_law(rig, arm_time, i));
  turn_to(commanded_rest);
}

void RunRig::turn_to(const std::vector<double>& commanded_rest) {
  command = commanded_rest;
  rest_orientation = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    double led = (1 + rig.command_scale[i]) * commanded_rest[i];
    if (rig.gear_coupling[i] != 0) led += rig.gear_coupling[i] * commanded_rest[i - 1];
    joint[i].rest = led * std::exp(-rig.capstan * static_cast<double>(i)) + rig.rest_error[i] +
                    rig.encoder[i].off(commanded_rest[i]);
    rest_orientation += joint[i].rest;
  }
}

TimeStep time_step(const RunRig& run, double dt) {
  TimeStep result;
  result.relaxed = false;
  for (std::size_t a = 0; a < run.arm_time.size() && dt > 0; ++a) {
    const double ratio = dt / run.arm_time[a];
    result.decay.at(a) = std::exp(-ratio);
    result.gain.at(a) = -std::expm1(-ratio) / ratio;
  }
  return result;
}

Torque direction_of_motion(const RigStep& step, std::size_t joint, double q, const Contact* contact) {
  const JointLaw& law = step.run.joint[joint];
  const JointMemory& last = step.memory[joint];
  const std::size_t s = law.direction;
  if (s >= law.slider.size() || step.interval.relaxed) return {};
  return law.dry(law.slider[s], last.slider[s], q, last, contact[s]);
}

StatedTorque::Place stated_place(const RigStep& step, std::size_t joint, double q,
                                 const Vector3<double>& force) {
  const JointLaw& law = step.run.joint[joint];
  return {q, q - law.rest, step.interval.end, law.stiffness, force, step.interval.covariates};
}

void remember(const RunRig& run, const TimeStep& during, std::size_t joint, double q, const Contact* contact,
              JointMemory& memory) {
  const JointLaw& law = run.joint[joint];
  // Sliders and arms use the previous angle, which is overwritten last.
  for (std::size_t s = 0; s < law.slider.size(); ++s)
    if (law.slider[s].acts() && (law.slider[s].from_rest || !during.relaxed))
      memory.slider.at(s) = law.along(law.slider[s], memory.slider[s], q, memory, contact[s]).value;
  if (!during.relaxed)
    for (std::size_t a = 0; a < run.arm_time.size(); ++a)
      memory.arm[a] = law.viscous(a, q, memory, during.decay[a], during.gain[a]).value;
  law.flow_to(q, memory);
  // The approach to the first reading has no known speed.
  memory.turn = std::abs(during.relaxed ? q : q - memory.angle);
  memory.angle = q;
  memory.led = 0;
}

}  // namespace plumbline::diagnose
