/// \file
/// Effects of the bench: how the chain is held, guided and loaded.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/responses.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether a drive holds the end point of a chain, and the force is read.
bool end_force_is_read(const Place& at) {
  return is_planar(at) && at.scales.measures_force;
}

bool is_loaded_along(const Place& at) {
  return !at.scales.applied.empty();
}

/// One parameter a value of the loads along the chain: one where there is none, as in the catalogue's
/// document.
auto each_load(std::string_view stem) {
  return [stem](const Place& at) {
    std::vector<ParameterRange> all;
    for (std::size_t l = 0; l < std::max(at.scales.applied.size(), std::size_t{1}); ++l)
      all.push_back(of(ParameterKind::load_gain, numbered(stem, l), at));
    return all;
  };
}

/// Adds to a member of what these values are told to be, times a unit of each.
template <class Unit>
auto add_to_loads(double ToldValue::*member, Unit unit) {
  return [=](const Addition& to) {
    const double* value = to.value;
    for (const AppliedLoad& one : to.scales.applied)
      to.rig.drive.covariates[one.covariate].*member += *value++ * unit(one, to.scales);
  };
}

/// The responses of covariates.
/// \param numbers  of them
template <class Numbers>
auto responses_of(Numbers numbers) {
  return [numbers](const Addition& to) {
    std::vector<Response*> all;
    for (const std::size_t c : numbers(to.scales)) all.push_back(&to.rig.drive.covariates[c].response);
    return all;
  };
}

/// Errors of what is told of loads along the chain, in shares of the largest, and of other covariates.
std::vector<Effect> told_values() {
  using Scales = CharacteristicScales;
  const auto largest = [](const AppliedLoad& one, const Scales&) { return one.largest; };
  const auto by_time = [](const AppliedLoad& one, const Scales& scales) {
    return one.largest / scales.duration;
  };
  const auto itself = [](const AppliedLoad&, const Scales&) { return 1.0; };
  const auto loads = [](const Scales& scales) {
    std::vector<std::size_t> all;
    for (const AppliedLoad& one : scales.applied) all.push_back(one.covariate);
    return all;
  };
  const auto late = [](const Place& at) { return is_loaded_along(at) && at.scales.clock; };
  const auto others_late = [](const Place& at) { return !at.scales.covariates.empty() && at.scales.clock; };
  const Responder applied{"applied_lag", "loads along the chain that respond", responses_of(loads)};
  const Responder others{"covariate_lag", "covariates that respond",
                         responses_of([](const Scales& scales) { return scales.covariates; })};
  return {
      {.id = "applied_bias",
       .words = "wrong zeros of the loads along the chain",
       .parameters = each_load("b"),
       .add = add_to_loads(&ToldValue::zero, largest),
       .possible = is_loaded_along},
      {.id = "applied_scale",
       .words = "wrong scales of the loads along the chain",
       .parameters = each_load("g"),
       .add = add_to_loads(&ToldValue::gain, itself),
       // A single tendon's is that of its moment arms.
       .possible =
           [](const Place& at) {
             return is_loaded_along(at) && (at.scales.applied.size() > 1 || !at.scales.turned_by_loads);
           },
       .nested = {"moment_arm"}},
      {.id = "applied_drift",
       .words = "loads along the chain that drift over time",
       .parameters = each_load("r"),
       .add = add_to_loads(&ToldValue::drift, by_time),
       .possible = late},
      lagging(applied, late),
      delayed(applied, late),
      lagging(others, others_late),
      delayed(others, others_late),
  };
}

std::vector<Effect> held_and_loaded() {
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

}  // namespace

std::vector<Effect> bench_effects() {
  std::vector<Effect> rows = held_and_loaded();
  for (Effect& row : told_values()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
