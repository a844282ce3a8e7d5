/// \file
/// Effects of the links.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {

std::vector<Effect> link_effects() {
  return {
      {.id = "link_length",
       .words = "a wrong length of link {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.02, -0.3, 0.3)}; },
       .add =
           [](const Addition& to) {
             to.rig.length[to.joint] *= 1 + to.value[0];
             if (!to.rig.arm) return;
             SerialArm<double>& arm = to.rig.arm->arm;
             arm.links[to.joint + 1].frame.translation() *= 1 + to.value[0];
           },
       .possible =
           [](const Place& at) {
             return at.scales.arm ? at.joint + 1 < at.scales.link_length.size() : has_links(at);
           },
       .in_space = true},
      {.id = "gravity",
       .words = "the weight of the links",
       .parameters =
           [](const Place& at) {
             const double density =
                 at.scales.stiffness / (standard_gravity * at.scales.length * at.scales.length);
             return std::vector{one_way("rho", "kg/m", 0.1 * density, 20 * density)};
           },
       .add =
           [](const Addition& to) {
             for (std::size_t j = 0; j < to.rig.length.size(); ++j)
               to.rig.weight[j] += to.value[0] * to.rig.length[j] * standard_gravity * to.down;
           },
       .possible = [](const Place& at) { return at.scales.weighs; }},
      {.id = "mass_scale",
       .words = "all masses wrong by one factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.1, -0.95, 3)}; },
       .add =
           [](const Addition& to) {
             for (Vector2& weight : to.rig.weight) weight *= 1 + to.value[0];
             if (!to.rig.arm) return;
             for (ArmLink<double>& link : to.rig.arm->arm.links) link.mass *= 1 + to.value[0];
           },
       .possible = [](const Place& at) { return at.scales.nominal_weight; },
       .in_space = true},
      {.id = "axial_compliance",
       .words = "axial compliance of the links",
       .parameters =
           [](const Place& at) {
             return std::vector{one_way("c_a", "1/N", 0.01 / at.scales.force, 0.3 / at.scales.force)};
           },
       .add = [](const Addition& to) { to.rig.axial += to.value[0]; },
       .possible = has_links},
      {.id = "link_bending",
       .words = "links that bend",
       .parameters =
           [](const Place& at) {
             const double soft = 1 / (at.scales.stiffness * at.scales.link);
             return std::vector<ParameterRange>{
                 {"EI", "N m²", Coordinate::reciprocal, 0.1 * soft, 1e-6 * soft, 10 * soft}};
           },
       .add = [](const Addition& to) { to.rig.flexibility += 1 / to.value[0]; },
       .possible = has_links,
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             const double scale = 0.1 * (1 / (at.scales.stiffness * at.scales.link));
             return InitialGuesses{{{0.01 * scale}, {0.3 * scale}, {2.0 * scale}}, 1};
           },
       .perturbation = {.large_step = true, .guesses = 1}},
  };
}

}  // namespace plumbline::diagnose
