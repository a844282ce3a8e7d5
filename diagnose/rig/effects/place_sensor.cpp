/// \file
/// Effects of what reads places: a camera or a tracker, and the frame in which places are told.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/responses.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool camera_reads(const Place& at) {
  return places_are_read(at) || points_are_read(at);
}

bool several_axes_are_read(const Place& at) {
  using Name = Channel::Name;
  return at.scales.measures(Name::place) ||
         (has_links(at) && at.scales.measures(Name::x) && at.scales.measures(Name::y));
}

bool frame_shows(const Place& at) {
  return has_links(at) && (at.scales.measures_force || camera_reads(at));
}

/// Adds to the first axes of a vector.
template <class Member>
auto add_to_axes(Member member) {
  return [member](const Addition& to) {
    const auto axes = static_cast<Eigen::Index>(to.scales.axes);
    (to.rig.*member).head(axes) += Eigen::Map<const Eigen::VectorXd>(to.value, axes);
  };
}

}  // namespace

std::vector<Effect> place_sensor_effects() {
  using Name = Channel::Name;
  const Responder camera{"place_lag", "a camera or tracker that responds",
                         sensors_of({Name::x, Name::y, Name::place, Name::turn})};
  const auto late = [](const Place& at) { return camera_reads(at) && shows_late(at); };
  return {
      {.id = "position_offset",
       .words = "an offset of the frame in which places are told",
       .parameters = [](const Place& at) { return each_axis(ParameterKind::place, "d", at); },
       .add = add_to_axes(&Rig::position_offset),
       .possible = frame_shows},
      {.id = "place_drift",
       .words = "a frame in which places are told that drifts over time",
       .parameters = [](const Place& at) { return each_axis(ParameterKind::place_drift, "r", at); },
       .add = add_to_axes(&Rig::place_drift),
       .possible = [](const Place& at) { return frame_shows(at) && at.scales.clock; }},
      {.id = "camera_scale",
       .words = "a camera or tracker that shows distances by a wrong factor",
       .parameters = one_of(ParameterKind::place_gain, "a"),
       .add = [](const Addition& to) { to.rig.place_scale += to.value[0]; },
       .possible = places_are_read},
      {.id = "camera_skew",
       .words = "a camera or tracker whose axes are not square",
       .parameters =
           [](const Place& at) {
             return at.scales.axes == 3 ? some_of(ParameterKind::place_gain, {"c_xy", "c_xz", "c_yz"})(at)
                                        : std::vector{of(ParameterKind::place_gain, "c_xy", at)};
           },
       .add =
           [](const Addition& to) {
             to.rig.place_skew +=
                 to.scales.axes == 3 ? vector_of(to.value) : Vector3<double>(to.value[0], 0, 0);
           },
       .possible = several_axes_are_read},
      {.id = "camera_turn",
       .words = "a camera or tracker whose axes are turned",
       .parameters =
           [](const Place& at) {
             return at.scales.axes == 3 ? some_of(ParameterKind::frame_angle, {"r_x", "r_y", "r_z"})(at)
                                        : std::vector{of(ParameterKind::frame_angle, "eps", at)};
           },
       // In space the frame is turned; in the plane what is read.
       .add =
           [](const Addition& to) {
             to.rig.place_turn += to.scales.axes == 3 ? Vector3<double>(-vector_of(to.value))
                                                      : Vector3<double>(0, 0, to.value[0]);
           },
       .possible = camera_reads},
      lagging(camera, late),
      delayed(camera, late),
  };
}

}  // namespace plumbline::diagnose
