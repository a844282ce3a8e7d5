/// \file
/// Effects of the joints of an arm in space.

#include <cmath>

#include "diagnose/rig/effects/arm_places.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool yields_by_nothing(const Place& at) {
  return !(at.scales.joint_stiffness[at.joint] > 0);
}

bool yields_or_is_weighed(const Place& at) {
  return at.scales.joint_stiffness[at.joint] > 0 || at.scales.measures(Channel::Name::drive);
}

bool turns_and_moves(const Place& at) {
  return !slides(at) && at.scales.moves[at.joint];
}

/// Two unit vectors across an axis.
std::array<Vector3<double>, 2> across(const Vector3<double>& axis) {
  const Vector3<double> first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

std::vector<Effect> encoders() {
  return {
      {.id = "joint_zero",
       .words = "a wrong zero of joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             return slides(at) ? std::vector{both_ways("a", "m", 0.005 * at.scales.length, -at.scales.length,
                                                       at.scales.length)}
                               : std::vector{both_ways("a", "rad", 0.01, -0.6, 0.6)};
           },
       .add = [](const Addition& to) { to.rig.arm->zero[to.joint] += to.value[0]; }},
      {.id = "joint_scale",
       .words = "a wrong gear ratio or encoder scale of joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("g", "ratio", 0.01, -0.3, 0.3)}; },
       .add = [](const Addition& to) { to.rig.arm->scale[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.moves[at.joint]; }},
      {.id = "encoder_ripple",
       .words = "an encoder of joint {} that is off its axis",
       .at_joint = true,
       .parameters =
           [](const Place&) {
             return std::vector{both_ways("c", "rad", 0.003, -0.3, 0.3),
                                both_ways("s", "rad", 0.003, -0.3, 0.3)};
           },
       .add = [](const Addition& to) { to.rig.arm->ripple[to.joint] += Vector2(to.value[0], to.value[1]); },
       .possible = turns_and_moves},
      {.id = "angle_bias",
       .words = "a wrong zero of the angle that is read at joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("b", "rad", 0.01, -0.6, 0.6)}; },
       .add = [](const Addition& to) { to.rig.arm->angle_bias[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.measures(Channel::Name::q); }},
      {.id = "angle_scale",
       .words = "a wrong scale of the angle that is read at joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("g", "ratio", 0.01, -0.3, 0.3)}; },
       .add = [](const Addition& to) { to.rig.arm->angle_scale[to.joint] += to.value[0]; },
       .possible =
           [](const Place& at) { return at.scales.measures(Channel::Name::q) && at.scales.moves[at.joint]; }},
  };
}

std::vector<Effect> forces() {
  return {
      {.id = "joint_compliance",
       .words = "joint {} that yields, which the model has rigid",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const double soft = 1e-3 / typical_load(at);
             return std::vector{slides(at) ? one_way("c", "m/N", soft, 300 * soft)
                                           : one_way("c", "rad/(N m)", soft, 300 * soft)};
           },
       .add = [](const Addition& to) { to.rig.arm->arm.links[to.joint].joint_compliance += to.value[0]; },
       .possible = yields_by_nothing},
      {.id = "joint_friction",
       .words = "dry friction in joint {}",
       .at_joint = true,
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             // Geared axes can hold more by friction than their loads ask for.
             const double load = typical_load(at);
             return std::vector{one_way("tau_c", slides(at) ? "N" : "N m", 0.05 * load, 50 * load)};
           },
       .add = [](const Addition& to) { to.rig.friction[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return yields_or_is_weighed(at) && at.scales.moves[at.joint]; },
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             InitialGuesses guesses{{}, 1};
             for (const double share : {0.02, 0.1, 0.4, 2.0, 10.0})
               guesses.points.push_back({share * typical_load(at)});
             return guesses;
           },
       .perturbation = {.large_step = true}},
      {.id = "joint_balance",
       .words = "a counterweight or spring that loads joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const double small = 0.1 * at.scales.torque, large = 10 * at.scales.torque;
             return std::vector{both_ways("c", "N m", small, -large, large),
                                both_ways("s", "N m", small, -large, large)};
           },
       .add = [](const Addition& to) { to.rig.arm->balance[to.joint] += Vector2(to.value[0], to.value[1]); },
       .possible = [](const Place& at) { return turns_and_moves(at) && yields_or_is_weighed(at); }},
      {.id = "torque_bias",
       .words = "a wrong zero of the torque that is read at joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const double load = typical_load(at);
             return std::vector{both_ways("b", slides(at) ? "N" : "N m", 0.05 * load, -3 * load, 3 * load)};
           },
       .add = [](const Addition& to) { to.rig.arm->torque_bias[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.measures(Channel::Name::drive); }},
      {.id = "torque_scale",
       .words = "a wrong scale of the torque that is read at joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("g", "ratio", 0.05, -0.9, 3)}; },
       .add = [](const Addition& to) { to.rig.arm->torque_scale[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.measures(Channel::Name::drive); }},
  };
}

std::vector<Effect> axes() {
  return {
      {.id = "axis_tilt",
       .words = "an axis of joint {} that is not parallel to where it should be",
       .at_joint = true,
       .parameters =
           [](const Place&) {
             return std::vector{both_ways("u", "rad", 0.003, -0.3, 0.3),
                                both_ways("v", "rad", 0.003, -0.3, 0.3)};
           },
       .add =
           [](const Addition& to) {
             ArmLink<double>& link = to.rig.arm->arm.links[to.joint];
             const auto [first, second] = across(link.axis);
             link.frame.linear() *= rotation_by<double>(to.value[0] * first + to.value[1] * second);
           }},
      {.id = "axis_shift",
       .words = "an axis of joint {} that is displaced",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const double small = 0.002 * at.scales.length, large = 0.1 * at.scales.length;
             return std::vector{both_ways("x", "m", small, -large, large),
                                both_ways("y", "m", small, -large, large),
                                both_ways("z", "m", small, -large, large)};
           },
       .add =
           [](const Addition& to) {
             Pose<double>& frame = to.rig.arm->arm.links[to.joint].frame;
             frame.translation() += Vector3<double>(to.value[0], to.value[1], to.value[2]);
           },
       .nested = {"link_length"}},
  };
}

}  // namespace

std::vector<Effect> arm_joint_effects() {
  std::vector<Effect> rows;
  for (const auto& group : {encoders, forces, axes})
    for (Effect& row : group()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
