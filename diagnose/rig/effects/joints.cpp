/// \file
/// Effects of the joints.

#include <cmath>

#include "diagnose/rig/effects/hardening.hpp"
#include "diagnose/rig/effects/onsets.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool is_elastic(const Place& at) {
  return at.scales.joint_stiffness[at.joint] > 0;
}

InitialGuesses shares_of(double reach, std::initializer_list<double> shares, std::size_t refined) {
  InitialGuesses guesses{{}, refined};
  for (const double share : shares) guesses.points.push_back({share * reach});
  return guesses;
}

}  // namespace

std::vector<Effect> joint_effects() {
  return {
      {.id = "joint_stiffness",
       .words = "a wrong stiffness of joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.2, -0.95, 9)}; },
       .add = [](const Addition& to) { to.rig.stiffness[to.joint] *= 1 + to.value[0]; },
       .possible = is_elastic,
       .in_space = true},
      {.id = "rest_angle",
       .words = "a wrong rest angle of joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             const double w = at.scales.turn;
             return std::vector{both_ways("a", "rad", 0.05 * w, -0.6 * w, 0.6 * w)};
           },
       .add = [](const Addition& to) { to.rig.rest_error[to.joint] += to.value[0]; },
       .possible = is_elastic},
      {.id = "nonlinear_spring",
       .words = "joint springs that harden or soften with their deflection",
       .parameters = [](const Place& at) { return std::vector{hardening(at.scales)}; },
       .add =
           [](const Addition& to) {
             for (double& c : to.rig.hardening) c += to.value[0];
           },
       .in_space = true},
      {.id = "backlash",
       .words = "play in joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             return std::vector{one_way("b", "rad", 0.05 * at.scales.turn, 0.6 * at.scales.turn)};
           },
       .add = [](const Addition& to) { to.rig.backlash[to.joint] += to.value[0]; },
       .possible = is_elastic,
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return shares_of(nominal.deflection[at.joint], {0.02, 0.1, 0.4}, 2);
           },
       .perturbation = {.large_step = true},
       .in_space = true},
      {.id = "joint_friction",
       .words = "dry friction in the joints",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             const double slip = at.scales.stiffness * at.scales.deflection;
             return std::vector{one_way("tau_c", "N m", 0.05 * slip, 10 * slip)};
           },
       .add =
           [](const Addition& to) {
             for (double& torque : to.rig.friction) torque += to.value[0];
           },
       .initial_guesses =
           [](const Place&, const Excitation& nominal) {
             return shares_of(nominal.torque, {0.002, 0.01, 0.05}, 1);
           },
       .perturbation = {.large_step = true},
       .in_space = true},
      {.id = "joint_stop",
       .words = "a stop at joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             return std::vector{onset_angle("s", at.scales.turn),
                                stop_stiffness(at.scales.stiffness_at(at.joint))};
           },
       .add =
           [](const Addition& to) {
             to.rig.stop[to.joint] = to.value[0];
             to.rig.stop_stiffness[to.joint] = to.value[1];
           },
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return stop_guesses([&](double share, double stiff) {
               return std::vector{share * nominal.deflection[at.joint],
                                  stiff * at.scales.stiffness_at(at.joint)};
             });
           },
       .perturbation = {.growing = {1}}},
      {.id = "joint_coupling",
       .words = "springs that couple neighbouring joints",
       .parameters =
           [](const Place& at) {
             const double k = at.scales.stiffness;
             return std::vector{both_ways("kappa", "N m/rad", 0.1 * k, -0.95 * k, 0.95 * k)};
           },
       .add = [](const Addition& to) { to.rig.coupling += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.link_length.size() > 1; }},
      {.id = "viscoelasticity",
       .words = "springs that relax over time",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector<ParameterRange>{
                 one_way("m", "ratio", 0.2, 20),
                 {"tau", "s", Coordinate::logarithm, 1, std::log(0.1 * at.scales.sampling_interval),
                  std::log(20 * at.scales.duration)}};
           },
       .add =
           [](const Addition& to) {
             to.rig.arms.push_back({to.value[0], to.value[1]});
           },
       .possible = [](const Place& at) { return at.scales.clock; },
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             const double low = std::log(0.1 * at.scales.sampling_interval),
                          high = std::log(20 * at.scales.duration);
             InitialGuesses guesses{{}, 2};
             for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
               guesses.points.push_back({0.5 * 0.2, low + share * (high - low)});
             return guesses;
           },
       .perturbation = {.growing = {0}},
       .in_space = true},
  };
}

}  // namespace plumbline::diagnose
