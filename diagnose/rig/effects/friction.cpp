/// \file
/// Dry friction with a variable slip torque.

#include <cmath>

#include "diagnose/rig/effects/places.hpp"
#include "diagnose/rig/effects/rows.hpp"
#include "diagnose/rig/sizes.hpp"

namespace plumbline::diagnose {
namespace {

/// Initial guesses: small fractions of the largest torque as slip torque, with each of the laws' parameters.
InitialGuesses friction_guesses(double torque, const std::vector<std::vector<double>>& laws) {
  InitialGuesses guesses{{}, 1};
  for (const double share : {0.003, 0.015}) {
    for (const std::vector<double>& law : laws) {
      guesses.points.push_back({share * torque});
      guesses.points.back().insert(guesses.points.back().end(), law.begin(), law.end());
    }
  }
  return guesses;
}

ParameterRange slip_torque(const Place& at) {
  return of(ParameterKind::friction_torque, "tau_c", at);
}

bool slips_both_ways(const Place& at) {
  return turns_back(at) && any_elastic(at);
}

void add_dry(const Addition& to) {
  for (double& torque : to.rig.friction) torque += to.value[0];
}

/// Typical joint speed, rad/s: to the typical deflection and back in the longest run.
double typical_speed(const CharacteristicScales& sizes) {
  return 2 * sizes.deflection / sizes.duration;
}

}  // namespace

std::vector<Effect> friction_effects() {
  const Perturbation perturbation{.growing = {0}, .large_step = true};
  return {
      {.id = "joint_friction",
       .words = "dry friction in the joints that gives a little before it slips",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{slip_torque(at), of(ParameterKind::slip_way, "d_s", at)};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.presliding = to.value[1];
           },
       .possible = slips_both_ways,
       .nested = {"joint_friction"},
       .form = "gives before it slips",
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             const double turn = at.scales.deflection;
             return friction_guesses(
                 nominal.torque, {{std::log(1e-3 * turn)}, {std::log(0.01 * turn)}, {std::log(0.1 * turn)}});
           },
       .perturbation = perturbation},
      {.id = "load_friction",
       .words = "dry friction in the joints that grows with their deflection",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{slip_torque(at), of(ParameterKind::friction_growth, "growth", at)};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.friction_law.growth += to.value[0] * to.value[1];
           },
       .possible = slips_both_ways,
       .nested = {"joint_friction"},
       .initial_guesses =
           [](const Place&, const Excitation& nominal) {
             return friction_guesses(nominal.torque, {{3 / std::max(nominal.largest, 1e-3)}});
           },
       .perturbation = perturbation},
      {.id = "direction_friction",
       .words = "dry friction in the joints that is larger in one direction than in the other",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{slip_torque(at), of(ParameterKind::friction_asymmetry, "uneven", at)};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.friction_law.uneven += to.value[1];
           },
       .possible = slips_both_ways,
       .nested = {"joint_friction"},
       .initial_guesses =
           [](const Place&, const Excitation& nominal) {
             return friction_guesses(nominal.torque, {{0.5}, {-0.5}});
           },
       .perturbation = perturbation},
      {.id = "speed_friction",
       .words = "dry friction in the joints that changes with their speed",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{slip_torque(at), of(ParameterKind::friction_fall, "fall", at),
                                of(ParameterKind::friction_speed, "speed", at)};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.friction_law.fall += to.value[1];
             to.rig.friction_law.speed = to.value[2];
           },
       .possible = [](const Place& at) { return at.scales.clock && slips_both_ways(at); },
       .nested = {"joint_friction"},
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             const double slow = std::log(0.3 * typical_speed(at.scales)), fast = slow + std::log(10.0);
             return friction_guesses(nominal.torque, {{1, slow}, {1, fast}, {-0.5, slow}, {-0.5, fast}});
           },
       .perturbation = perturbation},
  };
}

}  // namespace plumbline::diagnose
