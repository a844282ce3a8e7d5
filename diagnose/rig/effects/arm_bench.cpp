/// \file
/// Effects of the links, the mount and the instruments of an arm in space.

#include <cmath>

#include "diagnose/priors.hpp"
#include "diagnose/rig/effects/arm_places.hpp"
#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

Vector3<double> vector_of(const double* value) {
  return {value[0], value[1], value[2]};
}

std::vector<ParameterRange> three(std::string_view stem, std::string_view unit, double scale, double most) {
  std::vector<ParameterRange> all;
  for (const char* axis : {"_x", "_y", "_z"})
    all.push_back(both_ways(kept(std::string(stem) + axis), unit, scale, -most, most));
  return all;
}

std::vector<ParameterRange> displacement(const Place& at) {
  return three("d", "m", 0.005 * at.scales.length, at.scales.length);
}

std::vector<ParameterRange> small_turn(const Place&) {
  return three("r", "rad", 0.005, 0.6);
}

/// Compliance of a round tube that bends and twists along a vector: EI = 1 / flexibility, GJ = EI / 1.3.
Matrix6<double> tube(const Vector3<double>& along, double flexibility) {
  const double length = along.norm();
  const Vector3<double> axis = along / length;
  const Eigen::Matrix3d beside = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  Eigen::Matrix3d cross;  // (cross F) = axis x F
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  constexpr double twist = 1.3;
  Matrix6<double> all;
  all.topLeftCorner<3, 3>() = length * length * length / 3 * beside;
  all.bottomLeftCorner<3, 3>() = length * length / 2 * cross;
  all.topRightCorner<3, 3>() = -length * length / 2 * cross;
  all.bottomRightCorner<3, 3>() = length * (beside + twist * axis * axis.transpose());
  const Matrix6<double> compliance = flexibility * all;
  return (compliance + compliance.transpose()) / 2;  // to the last bit
}

std::vector<Effect> links() {
  return {
      {.id = "link_mass",
       .words = "a wrong mass of link {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const double own = at.scales.arm->arm.links[at.joint].mass;
             return std::vector{both_ways("m", "kg", 0.1 * at.scales.mass, -own, 20 * at.scales.mass)};
           },
       .add = [](const Addition& to) { to.rig.arm->arm.links[to.joint].mass += to.value[0]; },
       .possible = loads_show},
      {.id = "link_centre",
       .words = "a wrong centre of mass of link {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) { return three("d", "m", 0.02 * at.scales.length, 0.3 * at.scales.length); },
       .add = [](const Addition& to) { to.rig.arm->arm.links[to.joint].centre += vector_of(to.value); },
       .possible =
           [](const Place& at) { return loads_show(at) && at.scales.arm->arm.links[at.joint].mass > 0; }},
      {.id = "link_flexibility",
       .words = "link {} that bends",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const double soft = 1e-3 / (at.scales.torque * at.scales.link);
             return std::vector{one_way("f", "1/(N m²)", soft, 300 * soft)};
           },
       .add =
           [](const Addition& to) {
             SerialArm<double>& arm = to.rig.arm->arm;
             arm.links[to.joint].compliance += tube(arm.far_end(to.joint).translation(), to.value[0]);
           },
       .possible =
           [](const Place& at) { return at.scales.arm->arm.far_end(at.joint).translation().norm() > 0; }},
  };
}

std::vector<Effect> mount() {
  return {
      {.id = "gravity_compensation",
       .words = "servos that hold a share of the weight without yielding",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.2, -2, 2)}; },
       .add = [](const Addition& to) { to.rig.arm->compensated += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.nominal_weight && loads_show(at); }},
      {.id = "mount_tilt",
       .words = "a base that is tilted against gravity",
       .parameters =
           [](const Place&) {
             return std::vector{both_ways("r_x", "rad", 0.005, -0.3, 0.3),
                                both_ways("r_y", "rad", 0.005, -0.3, 0.3)};
           },
       .add =
           [](const Addition& to) {
             to.rig.arm->arm.base.linear() *= rotation_by(Vector3<double>(to.value[0], to.value[1], 0));
           }},
      {.id = "mount_compliance",
       .words = "a base that yields to the moment on it",
       .parameters =
           [](const Place& at) {
             const double soft = 1e-3 / at.scales.torque;
             return std::vector{one_way("c_x", "rad/(N m)", soft, 300 * soft),
                                one_way("c_y", "rad/(N m)", soft, 300 * soft)};
           },
       .add = [](const Addition& to) { to.rig.arm->mount_compliance += Vector2(to.value[0], to.value[1]); },
       .possible = points_are_read},
      {.id = "thermal_expansion",
       .words = "an arm that grows with its temperature",
       .parameters =
           [](const Place&) {
             constexpr double steel = 1.2e-5;
             return std::vector{both_ways("alpha", "1/K", steel, -100 * steel, 100 * steel)};
           },
       .add = [](const Addition& to) { to.rig.arm->expansion += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.warms && points_are_read(at); }},
  };
}

std::vector<Effect> trackers() {
  return {
      {.id = "tracker_offset",
       .words = "a frame of the tracker that is displaced",
       .parameters = displacement,
       .add = [](const Addition& to) { to.rig.arm->tracker.translation() += vector_of(to.value); },
       .possible = points_are_read},
      {.id = "tracker_turn",
       .words = "a frame of the tracker that is turned",
       .parameters = small_turn,
       .add = [](const Addition& to) { to.rig.arm->tracker.linear() *= rotation_by(vector_of(to.value)); },
       .possible = points_are_read},
      {.id = "tracker_scale",
       .words = "a tracker that shows distances by a wrong factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.003, -0.3, 0.3)}; },
       .add = [](const Addition& to) { to.rig.arm->tracker_scale += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.measures(Channel::Name::place); }},
      {.id = "tool_offset",
       .words = "a measured point that is displaced on its link",
       .parameters = displacement,
       .add =
           [](const Addition& to) {
             for (OnLink<double>& point : to.rig.arm->points)
               point.frame.translation() += vector_of(to.value);
           },
       .possible = [](const Place& at) { return at.scales.measures(Channel::Name::place); }},
      {.id = "tool_turn",
       .words = "a measured frame that is turned on its link",
       .parameters = small_turn,
       .add =
           [](const Addition& to) {
             for (OnLink<double>& point : to.rig.arm->points)
               point.frame.linear() *= rotation_by(vector_of(to.value));
           },
       .possible = [](const Place& at) { return at.scales.measures(Channel::Name::turn); }},
  };
}

std::vector<Effect> wrench_sensor() {
  const auto is_read = [](const Place& at) { return at.scales.load_cell; };
  return {
      {.id = "wrench_scale",
       .words = "a force sensor that shows a wrong factor of the load",
       .parameters = [](const Place&) { return std::vector{both_ways("g", "ratio", 0.05, -0.9, 3)}; },
       .add = [](const Addition& to) { to.rig.arm->wrench_scale += to.value[0]; },
       .possible = is_read},
      {.id = "wrench_bias",
       .words = "a force sensor with a wrong zero",
       .parameters =
           [](const Place& at) { return three("F", "N", 0.05 * at.scales.force, 3 * at.scales.force); },
       .add = [](const Addition& to) { to.rig.arm->wrench_bias.head<3>() += vector_of(to.value); },
       .possible = is_read},
      {.id = "load_offset",
       .words = "a load that acts beside its point",
       .parameters = displacement,
       .add = [](const Addition& to) { to.rig.arm->load.frame.translation() += vector_of(to.value); },
       .possible = [](const Place& at) { return at.scales.imposes_force && loads_show(at); }},
  };
}

/// Values of all joints within what workshops hold.
std::vector<Effect> tolerances() {
  return {
      {.id = "zero_spread",
       .words = "zeros of the joints that differ within their tolerance",
       .parameters =
           [](const Place& at) {
             return each(at, {"a", "rad", priors::zero_tolerance, -0.1, 0.1, false});
           },
       .add =
           [](const Addition& to) {
             for (std::size_t j = 0; j < to.rig.length.size(); ++j) to.rig.arm->zero[j] += to.value[j];
           },
       .within_values = {"joint_zero"},
       .is_tolerance = true},
      {.id = "axis_spread",
       .words = "axes that are displaced within their tolerance",
       .parameters =
           [](const Place& at) {
             const double small = priors::axis_tolerance * at.scales.length;
             std::vector<ParameterRange> all;
             for (const char* stem : {"x", "y", "z"})
               for (const ParameterRange& one :
                    each(at, {stem, "m", small, -100 * small, 100 * small, false}))
                 all.push_back(one);
             return all;
           },
       .add =
           [](const Addition& to) {
             const std::size_t n = to.rig.length.size();
             for (std::size_t j = 0; j < n; ++j)
               to.rig.arm->arm.links[j].frame.translation() +=
                   Vector3<double>(to.value[j], to.value[n + j], to.value[2 * n + j]);
           },
       .within_values = {"axis_shift", "link_length", "tool_offset"},
       .is_tolerance = true},
  };
}

}  // namespace

std::vector<Effect> arm_bench_effects() {
  std::vector<Effect> rows;
  for (const auto& group : {links, mount, trackers, wrench_sensor, tolerances})
    for (Effect& row : group()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
