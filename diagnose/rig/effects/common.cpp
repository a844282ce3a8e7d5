/// \file
/// Effects of all joints or links: one factor or offset for all, or one value each within a tolerance.

#include <algorithm>

#include "diagnose/priors.hpp"
#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {

namespace {

/// What stands within a degree where joints yield by a tenth of a radian stands within a milliradian where
/// they hardly yield: workshops make devices as exact as they are stiff.
double angle_tolerance(const Place& at) {
  constexpr double of_deflection = 0.1;
  return std::clamp(of_deflection * at.scales.deflection, priors::zero_tolerance, priors::angle_tolerance);
}

/// Of a link's length, or of the place of an axis, m.
double length_tolerance(const Place& at) {
  const double share = priors::length_tolerance / priors::angle_tolerance * angle_tolerance(at);
  return std::max(share * at.scales.link, priors::axis_tolerance * at.scales.length);
}

std::vector<ParameterRange> places_of_axes(const Place& at) {
  const double small = length_tolerance(at), large = 0.03 * at.scales.length;
  std::vector<ParameterRange> all;
  for (const char* stem : {"x", "y", "z"})
    for (const ParameterRange& one : each(at, {stem, "m", small, -large, large, Which::all}))
      all.push_back(one);
  return all;
}

void add_lengths(const Addition& to) {
  const std::size_t n = to.rig.length.size();
  for (std::size_t j = 0; j < n; ++j) {
    if (to.rig.arm)
      to.rig.arm->arm.links[j].frame.translation() +=
          Vector3<double>(to.value[j], to.value[n + j], to.value[2 * n + j]);
    else
      to.rig.length[j] *= 1 + to.value[j];
  }
}

bool several_links(const Place& at) {
  return several_joints(at) && has_links(at);
}

bool several_standing(const Place& at) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < at.scales.rigid.size(); ++i) count += is_one(Which::standing, at.scales, i);
  return count > 1;
}

}  // namespace

using priors::stiffness_tolerance;

std::vector<Effect> common_effects() {
  return {
      {.id = "stiffness_scale",
       .words = "all stiffnesses wrong by one factor",
       .parameters = one_of(ParameterKind::stiffness_error, "a"),
       .add =
           [](const Addition& to) {
             for (double& k : to.rig.stiffness) k *= 1 + to.value[0];
           },
       .possible = several_elastic},
      {.id = "length_scale",
       .words = "all lengths wrong by one factor",
       .parameters = one_of(ParameterKind::length_error, "a"),
       .add =
           [](const Addition& to) {
             for (std::size_t j = 0; j < to.rig.length.size(); ++j) to.rig.scale_length(j, 1 + to.value[0]);
           },
       .possible = several_links},
      {.id = "rest_offset",
       .words = "all rest angles off by the same angle",
       .parameters = one_of(ParameterKind::joint_angle, "a"),
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
       .is_tolerance = true},
      {.id = "length_spread",
       .words = "lengths that differ from link to link within their tolerance",
       .parameters =
           [](const Place& at) {
             return at.scales.axes == 3 ? places_of_axes(at)
                                        : each(at, {"a", "ratio", length_tolerance(at) / at.scales.link, -0.2,
                                                    0.2, Which::all});
           },
       .add = add_lengths,
       .possible = several_links,
       .within_values = {"length_scale", "link_length", "axis_shift", "tool_offset"},
       .is_tolerance = true},
      {.id = "rest_spread",
       .words = "rest angles that differ from joint to joint within their tolerance",
       .parameters =
           [](const Place& at) {
             return each(at, {"a", "rad", angle_tolerance(at), -0.3, 0.3, Which::standing});
           },
       .add =
           [](const Addition& to) {
             for_each(Which::standing, to, [&](std::size_t i, double a) {
               (encoder_hides({to.scales, i}) ? to.rig.encoder[i].zero : to.rig.rest_error[i]) += a;
             });
           },
       .possible = several_standing,
       .within_values = {"rest_offset", "rest_angle"},
       .is_tolerance = true},
      {
          .id = "play",
          .words = "play in every joint",
          .parameters =
              [](const Place& at) {
                return each(at, {"b", "rad", priors::angle_tolerance, 0, 0.4});
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
      },
      {.id = "friction_spread",
       .words = "dry friction that differs from joint to joint",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             const ParameterRange all = of(ParameterKind::friction_torque, "tau", at);
             return each(at, {"tau", "N m", priors::friction_tolerance * at.scales.torque, 0, all.high});
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
       .perturbation = {.large_step = true}},
      {.id = "hardening_spread",
       .words = "springs that harden or soften, each by its own amount",
       .parameters =
           [](const Place& at) {
             const double scale = 1 / (at.scales.deflection * at.scales.deflection);
             // A joint with a third of the typical deflection needs nine times the c for the same softening.
             const ParameterRange alike = of(ParameterKind::hardening, "c", at);
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
