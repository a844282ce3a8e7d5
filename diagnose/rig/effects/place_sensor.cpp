/// \file
/// Effects of what reads places: a camera or a tracker, and the frame in which places are told.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool camera_reads(const Place& at) {
  return places_are_read(at) || points_are_read(at);
}

}  // namespace

std::vector<Effect> place_sensor_effects() {
  return {
      {.id = "position_offset",
       .words = "an offset of the frame in which places are told",
       .parameters = [](const Place& at) { return each_axis(ParameterKind::place, "d", at); },
       .add =
           [](const Addition& to) {
             const auto axes = static_cast<Eigen::Index>(to.scales.axes);
             to.rig.position_offset.head(axes) += Eigen::Map<const Eigen::VectorXd>(to.value, axes);
           },
       .possible =
           [](const Place& at) { return has_links(at) && (at.scales.measures_force || camera_reads(at)); }},
      {.id = "camera_scale",
       .words = "a camera or tracker that shows distances by a wrong factor",
       .parameters = one_of(ParameterKind::place_gain, "a"),
       .add = [](const Addition& to) { to.rig.place_scale += to.value[0]; },
       .possible = places_are_read},
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
  };
}

}  // namespace plumbline::diagnose
