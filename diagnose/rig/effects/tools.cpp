/// \file
/// Effects of the tool, and of the flange that holds it.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool tool_is_seen(const Place& at) {
  return points_are_read(at) && at.scales.tool_is_measured;
}

/// About each axis of the last link, and between them: a hinge stands the same way with either sign, and its
/// angle acts in proportion.
InitialGuesses hinges(const Place& at, const Excitation&) {
  const double small = of(ParameterKind::axis_angle, "b", at).scale;
  InitialGuesses guesses{{}, 2};
  for (const Vector3<double>& axis :
       {Vector3<double>(1, 0, 0), Vector3<double>(0, 1, 0), Vector3<double>(0, 0, 1),
        Vector3<double>(1, 1, 0), Vector3<double>(1, -1, 0), Vector3<double>(1, 0, 1),
        Vector3<double>(1, 0, -1), Vector3<double>(0, 1, 1), Vector3<double>(0, 1, -1)}) {
    const Vector3<double> along = small * axis.normalized();
    guesses.points.push_back({along.x(), along.y(), along.z()});
  }
  return guesses;
}

}  // namespace

std::vector<Effect> tool_effects() {
  return {
      {.id = "tool_compliance",
       .words = "a tool that yields to the moment on it",
       .parameters = one_of(ParameterKind::turning_compliance, "c"),
       .add = [](const Addition& to) { to.rig.arm->tool_compliance += to.value[0]; },
       .possible = tool_is_seen},
      {.id = "tool_play",
       .words = "a loose tool, which tips to the side of its load",
       .parameters =
           [](const Place& at) { return std::vector{of(ParameterKind::axis_angle, "b", at).positive()}; },
       .add = [](const Addition& to) { to.rig.arm->tool_play += to.value[0]; },
       .possible = tool_is_seen},
      {.id = "tool_play",
       .words = "a loose tool, which tips about one axis to the side of its load",
       .parameters = some_of(ParameterKind::axis_angle, {"b_x", "b_y", "b_z"}),
       .add = [](const Addition& to) { to.rig.arm->tool_hinge += vector_of(to.value); },
       .possible = tool_is_seen,
       .form = "about one axis",
       .initial_guesses = hinges,
       .perturbation = {.large_step = true}},
      {.id = "tool_offset",
       .words = "a measured point that is displaced on its link",
       .parameters = some_of(ParameterKind::place, {"d_x", "d_y", "d_z"}),
       .add =
           [](const Addition& to) {
             for (OnLink<double>& point : to.rig.arm->points)
               point.frame.translation() += vector_of(to.value);
           },
       .possible =
           [](const Place& at) {
             return at.scales.measures(Channel::Name::place) || sensors_see_places(at);
           }},
      {.id = "tool_turn",
       .words = "a measured frame that is turned on its link",
       .parameters = some_of(ParameterKind::frame_angle, {"r_x", "r_y", "r_z"}),
       .add =
           [](const Addition& to) {
             for (OnLink<double>& point : to.rig.arm->points)
               point.frame.linear() *= rotation_by(vector_of(to.value));
           },
       .possible =
           [](const Place& at) {
             return at.scales.measures(Channel::Name::turn) || at.scales.measures(Channel::Name::inclination);
           }},
  };
}

}  // namespace plumbline::diagnose
