/// \file
/// Effects of all joints or links: one factor or offset for all, or one value each within a tolerance.

#include "diagnose/priors.hpp"
#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/hardening.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {

using priors::stiffness_tolerance, priors::length_tolerance, priors::angle_tolerance;

std::vector<Effect> common_effects() {
  return {
      {.id = "stiffness_scale",
       .words = "all stiffnesses wrong by one factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.1, -0.95, 9)}; },
       .add =
           [](const Addition& to) {
             for (double& k : to.rig.stiffness) k *= 1 + to.value[0];
           },
       .possible = several_elastic,
       .in_space = true},
      {.id = "length_scale",
       .words = "all lengths wrong by one factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.01, -0.3, 0.3)}; },
       .add =
           [](const Addition& to) {
             for (double& L : to.rig.length) L *= 1 + to.value[0];
           },
       .possible = several_links},
      {.id = "rest_offset",
       .words = "all rest angles off by the same angle",
       .parameters =
           [](const Place& at) {
             const double w = at.scales.turn;
             return std::vector{both_ways("a", "rad", 0.03 * w, -0.6 * w, 0.6 * w)};
           },
       .add =
           [](const Addition& to) {
             for (double& error : to.rig.rest_error) error += to.value[0];
           },
       .possible = several_elastic},
      {.id = "stiffness_spread",
       .words = "stiffnesses that differ from joint to joint within their tolerance",
       .parameters =
           [](const Place& at) {
             return each(at, {"a", "ratio", stiffness_tolerance, -0.8, 2});
           },
       .add =
           [](const Addition& to) {
             for_each_elastic(to, [&](std::size_t i, double a) { to.rig.stiffness[i] *= 1 + a; });
           },
       .possible = several_elastic,
       .within_values = {"stiffness_scale", "joint_stiffness", "force_gain"},
       .is_tolerance = true,
       .in_space = true},
      {.id = "length_spread",
       .words = "lengths that differ from link to link within their tolerance",
       .parameters =
           [](const Place& at) {
             return each(at, {"a", "ratio", length_tolerance, -0.2, 0.2, false});
           },
       .add =
           [](const Addition& to) {
             for (std::size_t j = 0; j < to.rig.length.size(); ++j) to.rig.length[j] *= 1 + to.value[j];
           },
       .possible = several_links,
       .within_values = {"length_scale", "link_length"},
       .is_tolerance = true},
      {.id = "rest_spread",
       .words = "rest angles that differ from joint to joint within their tolerance",
       .parameters =
           [](const Place& at) {
             return each(at, {"a", "rad", angle_tolerance, -0.3, 0.3});
           },
       .add =
           [](const Addition& to) {
             for_each_elastic(to, [&](std::size_t i, double a) { to.rig.rest_error[i] += a; });
           },
       .possible = several_elastic,
       .within_values = {"rest_offset", "rest_angle"},
       .is_tolerance = true},
      {.id = "play",
       .words = "play in every joint",
       .parameters =
           [](const Place& at) {
             return each(at, {"b", "rad", angle_tolerance, 0, 0.4});
           },
       .add =
           [](const Addition& to) {
             for_each_elastic(to, [&](std::size_t i, double b) { to.rig.backlash[i] += b; });
           },
       .possible = several_elastic,
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             InitialGuesses guesses{{}, 2};
             for (const double share : {0.05, 0.2}) {
               guesses.points.emplace_back();
               for (std::size_t i = 0; i < at.scales.joint_stiffness.size(); ++i)
                 if (at.scales.joint_stiffness[i] > 0)
                   guesses.points.back().push_back(share * nominal.deflection[i]);
             }
             return guesses;
           },
       .at_least = 2,
       .in_space = true},
      {.id = "friction_spread",
       .words = "dry friction that differs from joint to joint",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             const double slip = at.scales.stiffness * at.scales.deflection;
             return each(at, {"tau", "N m", priors::friction_tolerance * slip, 0, 10 * slip});
           },
       .add =
           [](const Addition& to) {
             for_each_elastic(to, [&](std::size_t i, double torque) { to.rig.friction[i] += torque; });
           },
       .possible = several_elastic,
       .nested = {"joint_friction"},
       .within_values = {"joint_friction"},
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             InitialGuesses guesses{{}, 1};
             for (const double share : {0.005, 0.03})
               guesses.points.emplace_back(each(at, {}).size(), share * nominal.torque);
             return guesses;
           },
       .perturbation = {.large_step = true},
       .in_space = true},
      {.id = "hardening_spread",
       .words = "springs that harden or soften, each by its own amount",
       .parameters =
           [](const Place& at) {
             const double scale = 1 / (at.scales.deflection * at.scales.deflection);
             // A joint with a third of the typical deflection needs nine times the c for the same softening.
             const ParameterRange alike = hardening(at.scales);
             return each(at, {"c", "1/rad²", priors::hardening_tolerance * scale, 9 * alike.low, alike.high});
           },
       .add =
           [](const Addition& to) {
             for_each_elastic(to, [&](std::size_t i, double c) { to.rig.hardening[i] += c; });
           },
       .possible = several_elastic,
       .nested = {"nonlinear_spring"},
       .within_values = {"nonlinear_spring"},
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             const double scale = 1 / (at.scales.deflection * at.scales.deflection);
             InitialGuesses guesses{{}, 1};
             for (const double share : {0.0, 0.3, -0.1})
               guesses.points.emplace_back(each(at, {}).size(), share * scale);
             return guesses;
           }},
  };
}

}  // namespace plumbline::diagnose
