/// \file
/// Effects of axes, masses and the base, which have places in space.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool in_space(const Place& at) {
  return at.scales.axes == 3;
}

/// Two unit vectors across an axis.
std::array<Vector3<double>, 2> across(const Vector3<double>& axis) {
  const Vector3<double> first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

}  // namespace

std::vector<Effect> axis_effects() {
  return {
      {.id = "axis_tilt",
       .words = "an axis of joint {} that is not parallel to where it should be",
       .at_joint = true,
       .parameters = some_of(ParameterKind::axis_angle, {"u", "v"}),
       .add =
           [](const Addition& to) {
             ArmLink<double>& link = to.rig.arm->arm.links[to.joint];
             const auto [first, second] = across(link.axis);
             link.frame.linear() *= rotation_by<double>(to.value[0] * first + to.value[1] * second);
           },
       .possible = in_space,
       .everywhere = "tilts of axes"},
      {.id = "axis_shift",
       .words = "an axis of joint {} that is displaced",
       .at_joint = true,
       .parameters = some_of(ParameterKind::axis_place, {"x", "y", "z"}),
       .add =
           [](const Addition& to) {
             to.rig.arm->arm.links[to.joint].frame.translation() += vector_of(to.value);
           },
       .possible = in_space,
       .nested = {"link_length"},
       .everywhere = "shifts of axes"},
      {.id = "mount_tilt",
       .words = "a base that is tilted against gravity",
       .parameters = some_of(ParameterKind::frame_angle, {"r_x", "r_y"}),
       .add =
           [](const Addition& to) {
             to.rig.arm->arm.base.linear() *= rotation_by(Vector3<double>(to.value[0], to.value[1], 0));
           },
       .possible = in_space},
      {.id = "base_compliance",
       .words = "a base that turns under the moment on it",
       .parameters =
           [](const Place& at) {
             return std::vector{of(ParameterKind::turning_compliance, "c_x", at),
                                of(ParameterKind::turning_compliance, "c_y", at)};
           },
       .add = [](const Addition& to) { to.rig.arm->mount_compliance += Vector2(to.value[0], to.value[1]); },
       .possible = points_are_read,
       .form = "turns"},
      {.id = "thermal_expansion",
       .words = "a device that grows with its temperature",
       .parameters = one_of(ParameterKind::expansion, "alpha"),
       .add = [](const Addition& to) { to.rig.arm->expansion += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.warms && points_are_read(at); }},
  };
}

}  // namespace plumbline::diagnose
