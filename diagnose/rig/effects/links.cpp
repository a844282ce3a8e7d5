/// \file
/// Effects of the links.

#include <algorithm>

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

Vector2 gravity_in_plane(const Addition& to) {
  return to.scales.gravity * to.down;
}

/// Whether a link slides out of another, under loads.
bool slides_under_load(const Place& at) {
  return at.scales.axes == 3 && points_are_read(at) && (at.scales.weighs || at.scales.imposes_force) &&
         std::find(at.scales.slides.begin(), at.scales.slides.end(), true) != at.scales.slides.end();
}

bool weight_shows(const Place& at) {
  return at.scales.weighs && loads_show(at);
}

}  // namespace

std::vector<Effect> link_effects() {
  return {
      {.id = "link_length",
       .words = "a wrong length of link {}",
       .at_joint = true,
       .parameters = one_of(ParameterKind::length_error, "a"),
       .add = [](const Addition& to) { to.rig.scale_length(to.joint, 1 + to.value[0]); },
       // A point that is measured on the last link has a place of its own.
       .possible =
           [](const Place& at) {
             return has_links(at) && at.scales.reach[at.joint] > 0 &&
                    (!points_are_read(at) || at.joint + 1 < at.scales.link_length.size());
           }},
      {.id = "gravity",
       .words = "the weight of the links",
       .parameters = one_of(ParameterKind::density, "rho"),
       .add =
           [](const Addition& to) {
             for (std::size_t j = 0; j < to.rig.length.size(); ++j)
               to.rig.add_bar(j, to.value[0] * to.rig.length[j], standard_gravity * to.down);
           },
       .possible = weight_shows},
      {.id = "link_mass",
       .words = "a wrong mass of link {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const ParameterRange any = of(ParameterKind::mass, "m", at);
             return std::vector{any.within(-at.scales.link_mass[at.joint], any.high)};
           },
       .add = [](const Addition& to) { to.rig.add_mass(to.joint, to.value[0], gravity_in_plane(to)); },
       .possible = [](const Place& at) { return weight_shows(at) && several_joints(at); }},
      {.id = "link_centre",
       .words = "a wrong centre of mass of link {}",
       .at_joint = true,
       .parameters = [](const Place& at) { return each_axis(ParameterKind::centre_place, "d", at); },
       .add =
           [](const Addition& to) {
             if (to.rig.arm)
               to.rig.arm->arm.links[to.joint].centre += vector_of(to.value);
             else
               to.rig.centre[to.joint] += Vector2(to.value[0], to.value[1]);
           },
       .possible =
           [](const Place& at) {
             return has_links(at) && at.scales.nominal_weight && loads_show(at) &&
                    at.scales.link_mass[at.joint] > 0;
           }},
      {.id = "mass_scale",
       .words = "all masses wrong by one factor",
       .parameters = one_of(ParameterKind::mass_error, "a"),
       .add = [](const Addition& to) { to.rig.scale_masses(1 + to.value[0]); },
       .possible = [](const Place& at) { return at.scales.nominal_weight && loads_show(at); }},
      {.id = "axial_compliance",
       .words = "axial compliance of the links",
       .parameters = one_of(ParameterKind::strain_by_force, "c_a"),
       .add = [](const Addition& to) { to.rig.stretch(to.value[0]); },
       .possible = has_links},
      {.id = "link_bending",
       .words = "links that bend",
       .parameters = one_of(ParameterKind::bending_rigidity, "EI"),
       .add = [](const Addition& to) { to.rig.bend(1 / to.value[0]); },
       .possible = has_links,
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             const double scale = of(ParameterKind::bending_rigidity, "EI", at).scale;
             return InitialGuesses{{{0.01 * scale}, {0.3 * scale}, {2.0 * scale}}, 1};
           },
       .perturbation = {.large_step = true, .guesses = 1}},
      {.id = "link_bending",
       .words = "link {} that bends",
       .at_joint = true,
       .parameters = one_of(ParameterKind::bending_rigidity, "EI"),
       .add = [](const Addition& to) { to.rig.arm->bend(to.joint, 1 / to.value[0]); },
       .possible = [](const Place& at) { return at.scales.axes == 3 && at.scales.reach[at.joint] > 0; }},
      {.id = "slide_bending",
       .words = "a sliding link that bends the more the farther it stands out",
       .parameters = one_of(ParameterKind::bending_rigidity, "EI"),
       .add = [](const Addition& to) { to.rig.flexibility += 1 / to.value[0]; },
       .possible = slides_under_load},
  };
}

}  // namespace plumbline::diagnose
