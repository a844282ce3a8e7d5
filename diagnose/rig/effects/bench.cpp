/// \file
/// Effects of the bench: how the chain is held, guided and loaded.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether a drive holds the end point of a chain, and the force is read.
bool end_force_is_read(const Place& at) {
  return is_planar(at) && at.scales.measures_force;
}

}  // namespace

std::vector<Effect> bench_effects() {
  return {
      {.id = "tip_payload",
       .words = "a weight at the end point",
       .parameters = one_of(ParameterKind::weight, "weight"),
       .add = [](const Addition& to) { to.rig.add_payload(to.value[0], to.down); },
       .possible = [](const Place& at) { return at.scales.weighs && loads_show(at); }},
      {.id = "base_compliance",
       .words = "compliance of the base",
       .parameters = some_of(ParameterKind::end_compliance, {"c_x", "c_y"}),
       .add = [](const Addition& to) { to.rig.base_compliance += Vector2(to.value[0], to.value[1]); },
       .possible = end_is_loaded},
      {.id = "rail_misalignment",
       .words = "a misaligned rail",
       .parameters = one_of(ParameterKind::fixture_angle, "eps"),
       .add = [](const Addition& to) { to.rig.misalignment += to.value[0]; },
       .possible = end_is_loaded},
      {.id = "eccentric_load",
       .words = "a load that acts off the end point",
       .parameters =
           [](const Place& at) {
             return at.scales.axes == 3 ? each_axis(ParameterKind::place, "d", at)
                                        : std::vector{of(ParameterKind::eccentricity, "e", at)};
           },
       .add =
           [](const Addition& to) {
             if (to.rig.arm)
               to.rig.arm->load.frame.translation() += vector_of(to.value);
             else
               to.rig.eccentricity += to.value[0];
           },
       .possible =
           [](const Place& at) {
             return end_is_loaded(at) || (at.scales.axes == 3 && at.scales.imposes_force && loads_show(at));
           }},
      {.id = "tip_stiffness",
       .words = "an end pivot with a rotational stiffness",
       .parameters = one_of(ParameterKind::end_stiffness, "k_t"),
       .add = [](const Addition& to) { to.rig.tip_stiffness += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.pivot; }},
      {.id = "guide_friction",
       .words = "dry friction in the guide",
       .dissipates = true,
       .parameters = one_of(ParameterKind::guide_force, "f_c"),
       .add = [](const Addition& to) { to.rig.guide_friction += to.value[0]; },
       .possible = end_force_is_read},
      {.id = "train_compliance",
       .words = "compliance of the load train",
       .parameters = one_of(ParameterKind::end_compliance, "c_t"),
       .add = [](const Addition& to) { to.rig.train_compliance += to.value[0]; },
       .possible = end_force_is_read},
      {.id = "pulley_friction",
       .words = "friction of a pulley over which the load hangs",
       .dissipates = true,
       .parameters = one_of(ParameterKind::rope_friction, "mu"),
       .add = [](const Addition& to) { to.rig.pulley_friction += to.value[0]; },
       .possible =
           [](const Place& at) { return is_planar(at) && at.scales.imposes_force && turns_back(at); }},
      {.id = "moment_arm",
       .words = "moment arms of tendons or pressures that are wrong by one factor",
       .parameters = one_of(ParameterKind::load_gain, "a"),
       .add = [](const Addition& to) { to.rig.moment_arm_error += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.turned_by_loads; }},
      {.id = "capstan_friction",
       .words = "friction along tendons that pull",
       .dissipates = true,
       .parameters = one_of(ParameterKind::rope_friction, "mu"),
       .add = [](const Addition& to) { to.rig.capstan_friction += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.long_tendon; }},
  };
}

}  // namespace plumbline::diagnose
