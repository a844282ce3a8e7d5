/// \file
/// Effects of the bench: how the chain is held, guided and loaded.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool force_is_read(const Place& at) {
  return at.scales.measures_force;
}

bool place_is_read(const Place& at) {
  const bool is_measured = at.scales.measures(Channel::Name::x) || at.scales.measures(Channel::Name::y);
  return at.scales.links && is_measured;
}

}  // namespace

std::vector<Effect> bench_effects() {
  return {
      {.id = "tip_payload",
       .words = "a weight at the end point",
       .parameters =
           [](const Place& at) {
             return std::vector{one_way("weight", "N", 0.1 * at.scales.force, 10 * at.scales.force)};
           },
       .add = [](const Addition& to) { to.rig.payload += to.value[0] * to.down; },
       .possible = [](const Place& at) { return at.scales.weighs; }},
      {.id = "base_compliance",
       .words = "compliance of the base",
       .parameters =
           [](const Place& at) {
             const double c = at.scales.compliance();
             return std::vector{one_way("c_x", "m/N", 0.01 * c, c), one_way("c_y", "m/N", 0.01 * c, c)};
           },
       .add = [](const Addition& to) { to.rig.base_compliance += Vector2(to.value[0], to.value[1]); },
       .possible = has_links},
      {.id = "rail_misalignment",
       .words = "a misaligned rail",
       .parameters = [](const Place&) { return std::vector{both_ways("eps", "rad", 0.05, -0.6, 0.6)}; },
       .add = [](const Addition& to) { to.rig.misalignment += to.value[0]; },
       .possible = has_links},
      {.id = "eccentric_load",
       .words = "a load that acts off the end point",
       .parameters =
           [](const Place& at) {
             return std::vector{both_ways("e", "m", 0.03 * at.scales.link, -at.scales.link, at.scales.link)};
           },
       .add = [](const Addition& to) { to.rig.eccentricity += to.value[0]; },
       .possible = has_links},
      {.id = "tip_stiffness",
       .words = "an end pivot with a rotational stiffness",
       .parameters =
           [](const Place& at) {
             return std::vector{
                 one_way("k_t", "N m/rad", 0.1 * at.scales.stiffness, 10 * at.scales.stiffness)};
           },
       .add = [](const Addition& to) { to.rig.tip_stiffness += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.pivot; }},
      {.id = "guide_friction",
       .words = "dry friction in the guide",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{one_way("f_c", "N", 0.05 * at.scales.force, 3 * at.scales.force)};
           },
       .add = [](const Addition& to) { to.rig.guide_friction += to.value[0]; },
       .possible = force_is_read},
      {.id = "position_offset",
       .words = "an offset of the end point from its command",
       .parameters =
           [](const Place& at) {
             const double small = 0.005 * at.scales.length, far = 0.1 * at.scales.length;
             return std::vector{both_ways("d_x", "m", small, -far, far),
                                both_ways("d_y", "m", small, -far, far)};
           },
       .add = [](const Addition& to) { to.rig.position_offset += Vector2(to.value[0], to.value[1]); },
       .possible = force_is_read},
      {.id = "train_compliance",
       .words = "compliance of the load train",
       .parameters =
           [](const Place& at) {
             const double c = at.scales.compliance();
             return std::vector{one_way("c_t", "m/N", 0.01 * c, c)};
           },
       .add = [](const Addition& to) { to.rig.train_compliance += to.value[0]; },
       .possible = force_is_read},
      {.id = "pulley_friction",
       .words = "friction of a pulley over which the load hangs",
       .dissipates = true,
       .parameters = [](const Place&) { return std::vector{one_way("mu", "ratio", 0.03, 1)}; },
       .add = [](const Addition& to) { to.rig.pulley_friction += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.imposes_force && at.scales.turns_back; }},
      {.id = "moment_arm",
       .words = "moment arms of tendons or pressures that are wrong by one factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.05, -0.8, 3)}; },
       .add = [](const Addition& to) { to.rig.moment_arm_error += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.turned_by_loads; }},
      {.id = "capstan_friction",
       .words = "friction along tendons that pull",
       .dissipates = true,
       .parameters = [](const Place&) { return std::vector{one_way("mu", "ratio", 0.03, 1)}; },
       .add = [](const Addition& to) { to.rig.capstan_friction += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.long_tendon; }},
      {.id = "camera_scale",
       .words = "a camera that shows distances by a wrong factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.01, -0.3, 0.3)}; },
       .add = [](const Addition& to) { to.rig.place_scale += to.value[0]; },
       .possible = place_is_read},
      {.id = "camera_turn",
       .words = "a camera whose axes are turned",
       .parameters = [](const Place&) { return std::vector{both_ways("eps", "rad", 0.02, -0.6, 0.6)}; },
       .add = [](const Addition& to) { to.rig.place_turn += to.value[0]; },
       .possible = place_is_read},
  };
}

}  // namespace plumbline::diagnose
