/// \file
/// Effects of the tool of an arm in space, and of the flange that holds it.

#include "diagnose/rig/effects/arm_places.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double small_tip = 0.002, large_tip = 0.3;  // rad

bool tool_is_seen(const Place& at) {
  return points_are_read(at) && at.scales.tool_is_measured;
}

/// About each axis of the last link, and between them: a hinge stands the same way with either sign, and its
/// angle acts in proportion.
InitialGuesses hinges(const Place&, const Excitation&) {
  InitialGuesses guesses{{}, 2};
  for (const Vector3<double>& axis :
       {Vector3<double>(1, 0, 0), Vector3<double>(0, 1, 0), Vector3<double>(0, 0, 1),
        Vector3<double>(1, 1, 0), Vector3<double>(1, -1, 0), Vector3<double>(1, 0, 1),
        Vector3<double>(1, 0, -1), Vector3<double>(0, 1, 1), Vector3<double>(0, 1, -1)}) {
    const Vector3<double> along = small_tip * axis.normalized();
    guesses.points.push_back({along.x(), along.y(), along.z()});
  }
  return guesses;
}

}  // namespace

std::vector<Effect> arm_tool_effects() {
  return {
      {.id = "tool_mass",
       .words = "a mass at the tip that the model does not have",
       .parameters =
           [](const Place& at) {
             return std::vector{one_way("m", "kg", 0.1 * at.scales.mass, 20 * at.scales.mass)};
           },
       .add =
           [](const Addition& to) {
             SerialArm<double>& arm = to.rig.arm->arm;
             ArmLink<double>& last = arm.links.back();
             const double sum = last.mass + to.value[0];
             if (sum > 0) last.centre = (last.mass * last.centre + to.value[0] * arm.tip.translation()) / sum;
             last.mass = sum;
           },
       .possible = loads_show},
      {.id = "tool_compliance",
       .words = "a tool that yields to the moment on it",
       .parameters =
           [](const Place& at) {
             const double soft = 1e-3 / at.scales.torque;
             return std::vector{one_way("c", "rad/(N m)", soft, 1000 * soft)};
           },
       .add = [](const Addition& to) { to.rig.arm->tool_compliance += to.value[0]; },
       .possible = tool_is_seen},
      {.id = "tool_play",
       .words = "a loose tool, which tips to the side of its load",
       .parameters = [](const Place&) { return std::vector{one_way("b", "rad", small_tip, large_tip)}; },
       .add = [](const Addition& to) { to.rig.arm->tool_play += to.value[0]; },
       .possible = tool_is_seen},
      {.id = "tool_play",
       .words = "a loose tool, which tips about one axis to the side of its load",
       .parameters =
           [](const Place&) {
             return std::vector{both_ways("b_x", "rad", small_tip, -large_tip, large_tip),
                                both_ways("b_y", "rad", small_tip, -large_tip, large_tip),
                                both_ways("b_z", "rad", small_tip, -large_tip, large_tip)};
           },
       .add =
           [](const Addition& to) {
             to.rig.arm->tool_hinge += Vector3<double>(to.value[0], to.value[1], to.value[2]);
           },
       .possible = tool_is_seen,
       .form = "about one axis",
       .initial_guesses = hinges,
       .perturbation = {.large_step = true}},
  };
}

}  // namespace plumbline::diagnose
