/// \file
/// Effects of the servos that lead the joints to their commands, and of their encoders.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/responses.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool hides_and_moves(const Place& at) {
  return encoder_hides(at) && moves(at);
}

bool turns_and_moves(const Place& at) {
  return !at.scales.slides[at.joint] && moves(at);
}

/// Whether both turn and the joint before is moved.
bool turns_beside_one_that_moves(const Place& at) {
  return at.scales.axes == 3 && at.joint > 0 && !at.scales.slides[at.joint] &&
         !at.scales.slides[at.joint - 1] && at.scales.moves[at.joint - 1];
}

/// Whether servos lead the joints.
bool servos_lead(const Place& at) {
  return std::find(at.scales.moves.begin(), at.scales.moves.end(), true) != at.scales.moves.end();
}

/// Whether it shows how drives respond in time.
bool follow_in_time(const Place& at) {
  return at.scales.clock && at.scales.drives;
}

/// Whether it shows apart from a lag of what reads the load: that of a joint alone which is held follows its
/// angle nearly in proportion.
bool follow_by_a_lag(const Place& at) {
  return follow_in_time(at) && (has_links(at) || !at.scales.measures_force);
}

Responder drives() {
  return {"command_delay", "a drive that follows its command",
          [](const Addition& to) { return std::vector{&to.rig.drive.response}; }};
}

}  // namespace

std::vector<Effect> command_effects() {
  return {
      {.id = "rest_angle",
       .words = "a wrong zero of the encoder of joint {}",
       .at_joint = true,
       .parameters = [](const Place& at) { return std::vector{of(offset_of_joint(at), "zero", at)}; },
       .add = [](const Addition& to) { to.rig.encoder[to.joint].zero += to.value[0]; },
       .possible = encoder_hides,
       .form = "of the encoder",
       .everywhere = "zeros of encoders"},
      {.id = "joint_scale",
       .words = "a wrong gear ratio of joint {}, or a wrong scale of its command",
       .at_joint = true,
       .parameters = one_of(ParameterKind::place_gain, "g"),
       .add = [](const Addition& to) { to.rig.command_scale[to.joint] += to.value[0]; },
       .possible = moves,
       .everywhere = "gear ratios"},
      {.id = "joint_scale",
       .words = "a wrong scale of the encoder of joint {}",
       .at_joint = true,
       .parameters = one_of(ParameterKind::place_gain, "scale"),
       .add = [](const Addition& to) { to.rig.encoder[to.joint].scale += to.value[0]; },
       .possible = hides_and_moves,
       .form = "of the encoder"},
      {.id = "gear_coupling",
       .words = "joint {} whose gear turns with the joint before it",
       .at_joint = true,
       .parameters = one_of(ParameterKind::place_gain, "a"),
       .add = [](const Addition& to) { to.rig.gear_coupling[to.joint] += to.value[0]; },
       .possible = turns_beside_one_that_moves},
      {.id = "encoder_ripple",
       .words = "an encoder of joint {} that is off its axis",
       .at_joint = true,
       .parameters = some_of(ParameterKind::axis_angle, {"c", "s"}),
       .add =
           [](const Addition& to) { to.rig.encoder[to.joint].ripple += Vector2(to.value[0], to.value[1]); },
       .possible = turns_and_moves},
      delayed(drives(), follow_in_time, ""),
      lagging(drives(), follow_by_a_lag, "by a time constant"),
      {.id = "command_drift",
       .words = "a command of joint {} whose zero drifts over time",
       .at_joint = true,
       .parameters = [](const Place& at) { return std::vector{of(drift_of_joint(at), "r", at)}; },
       .add = [](const Addition& to) { to.rig.drive.drift[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.clock && moves(at); }},
      {.id = "command_scale",
       .words = "a drive that moves the end point by a wrong factor",
       .parameters = one_of(ParameterKind::place_gain, "g"),
       .add = [](const Addition& to) { to.rig.drive.gain += to.value[0]; },
       .possible = [](const Place& at) { return is_planar(at) && at.scales.measures_force; }},
      {.id = "joint_compliance",
       .words = "joint {} that yields, which the model has rigid",
       .at_joint = true,
       .parameters = one_of(ParameterKind::turning_compliance, "c"),
       .add = [](const Addition& to) { to.rig.arm->arm.links[to.joint].joint_compliance += to.value[0]; },
       .possible = is_rigid,
       .everywhere = "compliances"},
      {.id = "joint_balance",
       .words = "a counterweight or spring that loads joint {}",
       .at_joint = true,
       .parameters = some_of(ParameterKind::balance_torque, {"c", "s"}),
       .add = [](const Addition& to) { to.rig.balance[to.joint] += Vector2(to.value[0], to.value[1]); },
       .possible = [](const Place& at) { return turns_and_moves(at) && torque_shows(at); }},
      {.id = "gravity_compensation",
       .words = "servos that hold a share of the weight without yielding",
       .parameters = one_of(ParameterKind::held_share, "a"),
       .add = [](const Addition& to) { to.rig.compensated += to.value[0]; },
       .possible =
           [](const Place& at) { return servos_lead(at) && at.scales.nominal_weight && loads_show(at); }},
  };
}

}  // namespace plumbline::diagnose
