/// \file
/// Dry friction with a variable slip torque.

#include <cmath>

#include "diagnose/rig/effects/rows.hpp"

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
  const double torque = at.scales.stiffness * at.scales.deflection;
  return one_way("tau_c", "N m", 0.05 * torque, 10 * torque);
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
             const double turn = at.scales.deflection;
             return std::vector<ParameterRange>{
                 slip_torque(at),
                 {"d_s", "rad", Coordinate::logarithm, 1, std::log(1e-4 * turn), std::log(0.5 * turn)}};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.presliding = to.value[1];
           },
       .possible = [](const Place& at) { return at.scales.turns_back; },
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
             const double rate = 1 / at.scales.deflection;
             return std::vector{slip_torque(at), one_way("growth", "1/rad", 2 * rate, 100 * rate)};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.friction_law.growth += to.value[0] * to.value[1];
           },
       .possible = [](const Place& at) { return at.scales.turns_back; },
       .nested = {"joint_friction"},
       .initial_guesses =
           [](const Place&, const Excitation& nominal) {
             return friction_guesses(nominal.torque, {{3 / std::max(nominal.largest, 1e-3)}});
           },
       .perturbation = perturbation,
       .at_least = 2,
       .in_space = true},
      {.id = "direction_friction",
       .words = "dry friction in the joints that is larger in one direction than in the other",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{slip_torque(at), both_ways("uneven", "ratio", 0.3, -1, 1)};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.friction_law.uneven += to.value[1];
           },
       .possible = [](const Place& at) { return at.scales.turns_back; },
       .nested = {"joint_friction"},
       .initial_guesses =
           [](const Place&, const Excitation& nominal) {
             return friction_guesses(nominal.torque, {{0.5}, {-0.5}});
           },
       .perturbation = perturbation,
       .at_least = 2,
       .in_space = true},
      {.id = "speed_friction",
       .words = "dry friction in the joints that changes with their speed",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             const double speed = typical_speed(at.scales);
             return std::vector<ParameterRange>{
                 slip_torque(at),
                 both_ways("fall", "ratio", 0.5, -0.95, 10),
                 {"speed", "rad/s", Coordinate::logarithm, 1, std::log(0.01 * speed), std::log(100 * speed)}};
           },
       .add =
           [](const Addition& to) {
             add_dry(to);
             to.rig.friction_law.fall += to.value[1];
             to.rig.friction_law.speed = to.value[2];
           },
       .possible = [](const Place& at) { return at.scales.clock && at.scales.turns_back; },
       .nested = {"joint_friction"},
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             const double slow = std::log(0.3 * typical_speed(at.scales)), fast = slow + std::log(10.0);
             return friction_guesses(nominal.torque, {{1, slow}, {1, fast}, {-0.5, slow}, {-0.5, fast}});
           },
       .perturbation = perturbation,
       .at_least = 2},
  };
}

}  // namespace plumbline::diagnose
