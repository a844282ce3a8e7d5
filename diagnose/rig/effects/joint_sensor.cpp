/// \file
/// Effects of what reads joint angles and the torques of drives.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool torques_are_read(const Place& at) {
  return at.scales.measures(Channel::Name::drive);
}

}  // namespace

std::vector<Effect> joint_sensor_effects() {
  return {
      {.id = "angle_bias",
       .words = "a wrong zero of the angle that is read at joint {}",
       .at_joint = true,
       .parameters = [](const Place& at) { return std::vector{of(offset_of_joint(at), "b", at)}; },
       .add = [](const Addition& to) { to.rig.angle_read[to.joint].zero += to.value[0]; },
       .possible = angles_are_read_beside},
      {.id = "angle_scale",
       .words = "a wrong scale of the angle that is read at joint {}",
       .at_joint = true,
       .parameters = one_of(ParameterKind::place_gain, "g"),
       .add = [](const Addition& to) { to.rig.angle_read[to.joint].gain += to.value[0]; },
       .possible = angles_are_read_beside},
      {.id = "torque_bias",
       .words = "a wrong zero of the torque that is read at joint {}",
       .at_joint = true,
       .parameters = one_of(ParameterKind::torque_zero, "b"),
       .add = [](const Addition& to) { to.rig.torque_read[to.joint].zero += to.value[0]; },
       .possible = torques_are_read},
      {.id = "torque_scale",
       .words = "a wrong scale of the torque that is read at joint {}",
       .at_joint = true,
       .parameters = one_of(ParameterKind::load_gain, "g"),
       .add = [](const Addition& to) { to.rig.torque_read[to.joint].gain += to.value[0]; },
       .possible = torques_are_read},
  };
}

}  // namespace plumbline::diagnose
