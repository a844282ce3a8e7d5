/// \file
/// Effects of the joints.

#include <algorithm>
#include <cmath>

#include "diagnose/rig/effects/onsets.hpp"
#include "diagnose/rig/effects/places.hpp"
#include "diagnose/rig/effects/rows.hpp"
#include "diagnose/rig/sizes.hpp"

namespace plumbline::diagnose {
namespace {

/// A joint whose contact acts: at a spring, or where the torque of its drive is read.
bool rubs(const Place& at) {
  return is_elastic(at) || (is_rigid(at) && torque_shows(at) && moves(at));
}

/// Whether a joint and the next one both yield.
bool neighbours_yield(const Place& at) {
  const std::vector<bool>& rigid = at.scales.rigid;
  return std::adjacent_find(rigid.begin(), rigid.end(), [](bool a, bool b) { return !a && !b; }) !=
         rigid.end();
}

InitialGuesses shares_of(double reach, std::initializer_list<double> shares, std::size_t refined) {
  InitialGuesses guesses{{}, refined};
  for (const double share : shares) guesses.points.push_back({share * reach});
  return guesses;
}

/// The angle at which travel ends, as probably anywhere between the commands.
ParameterRange end_of_travel(const Place& at) {
  const double low = at.scales.least_command[at.joint], high = at.scales.largest_command[at.joint];
  return {.name = "q",
          .unit = "rad",
          .coordinate = Coordinate::plain,
          .scale = 0.05 * (high - low),
          .low = low,
          .high = high,
          .anywhere = true};
}

/// An end of the joint's travel, whatever the command.
Effect limit_of_travel(std::string id, std::string words, std::function<void(const Addition& to)> add) {
  Effect row;
  row.id = std::move(id);
  row.words = std::move(words);
  row.at_joint = true;
  row.parameters = [](const Place& at) { return std::vector{end_of_travel(at)}; };
  row.add = std::move(add);
  row.possible = [](const Place& at) { return is_elastic(at) && moves(at); };
  row.initial_guesses = [](const Place& at, const Excitation&) {
    const ParameterRange range = end_of_travel(at);
    InitialGuesses guesses{{}, 2};
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
      guesses.points.push_back({range.low + share * (range.high - range.low)});
    return guesses;
  };
  row.perturbation.large_step = true;
  return row;
}

}  // namespace

std::vector<Effect> joint_effects() {
  return {
      {.id = "joint_stiffness",
       .words = "a wrong stiffness of joint {}",
       .at_joint = true,
       .parameters = one_of(ParameterKind::stiffness_error, "a"),
       .add = [](const Addition& to) { to.rig.stiffness[to.joint] *= 1 + to.value[0]; },
       .possible = is_elastic,
       .everywhere = "stiffnesses"},
      {.id = "rest_angle",
       .words = "a wrong zero or rest angle of joint {}",
       .at_joint = true,
       .parameters = [](const Place& at) { return std::vector{of(offset_of_joint(at), "a", at)}; },
       .add = [](const Addition& to) { to.rig.rest_error[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return is_elastic(at) || is_rigid(at); },
       .everywhere = "zeros"},
      {.id = "nonlinear_spring",
       .words = "joint springs that harden or soften with their deflection",
       .parameters = one_of(ParameterKind::hardening, "c"),
       .add =
           [](const Addition& to) {
             for (double& c : to.rig.hardening) c += to.value[0];
           },
       .possible = any_elastic},
      {.id = "backlash",
       .words = "play in joint {}",
       .at_joint = true,
       .parameters = [](const Place& at) { return std::vector{of(offset_of_joint(at), "b", at).positive()}; },
       .add = [](const Addition& to) { to.rig.backlash[to.joint] += to.value[0]; },
       .possible = is_elastic,
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return shares_of(nominal.deflection[at.joint], {0.02, 0.1, 0.4}, 2);
           },
       .perturbation = {.large_step = true}},
      {.id = "joint_friction",
       .words = "dry friction in the joints",
       .dissipates = true,
       .parameters = one_of(ParameterKind::friction_torque, "tau_c"),
       .add =
           [](const Addition& to) {
             for (double& torque : to.rig.friction) torque += to.value[0];
           },
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return shares_of(nominal.torque > 0 ? nominal.torque : at.scales.torque, {0.002, 0.01, 0.05}, 1);
           },
       .perturbation = {.large_step = true}},
      {.id = "joint_friction",
       .words = "dry friction in joint {}",
       .at_joint = true,
       .dissipates = true,
       .parameters = one_of(ParameterKind::friction_torque, "tau_c"),
       .add = [](const Addition& to) { to.rig.friction[to.joint] += to.value[0]; },
       .possible = [](const Place& at) { return several_joints(at) && rubs(at); },
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             // Geared axes can hold more by friction than their loads ask for.
             return shares_of(at.scales.typical_load(at.joint), {0.02, 0.1, 0.4, 2.0, 10.0}, 1);
           },
       .perturbation = {.large_step = true}},
      {.id = "joint_stop",
       .words = "a stop at joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             return std::vector{of(ParameterKind::onset_angle, "s", at),
                                of(ParameterKind::stop_stiffness, "k_s", at)};
           },
       .add =
           [](const Addition& to) {
             to.rig.stop[to.joint] = to.value[0];
             to.rig.stop_stiffness[to.joint] = to.value[1];
           },
       .possible = [](const Place& at) { return !is_rigid(at); },
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             return stop_guesses([&](double share, double stiff) {
               return std::vector{share * nominal.deflection[at.joint],
                                  stiff * at.scales.stiffness_at(at.joint)};
             });
           },
       .perturbation = {.growing = {1}}},
      limit_of_travel("upper_limit", "an upper limit of travel of joint {}",
                      [](const Addition& to) {
                        double& end = to.rig.travel[to.joint].high;
                        end = std::min(end, to.value[0]);
                      }),
      limit_of_travel("lower_limit", "a lower limit of travel of joint {}",
                      [](const Addition& to) {
                        double& end = to.rig.travel[to.joint].low;
                        end = std::max(end, to.value[0]);
                      }),
      {.id = "series_friction",
       .words = "friction in series with the spring of joint {}",
       .at_joint = true,
       .dissipates = true,
       .parameters = one_of(ParameterKind::slip_torque, "tau_c"),
       .add =
           [](const Addition& to) { to.rig.slip[to.joint] = std::min(to.rig.slip[to.joint], to.value[0]); },
       // A servo that slipped would let go of what it holds.
       .possible = [](const Place& at) { return is_elastic(at) && turns_back(at) && !moves(at); },
       .initial_guesses =
           [](const Place& at, const Excitation& nominal) {
             InitialGuesses guesses{{}, 2};
             const double carried = at.scales.stiffness_at(at.joint) * nominal.deflection[at.joint],
                          torque = std::max(carried, 1e-3 * at.scales.typical_load(at.joint));
             for (const double share : {0.3, 0.6, 0.9}) guesses.points.push_back({1 / (share * torque)});
             return guesses;
           },
       .perturbation = {.large_step = true}},
      {.id = "joint_coupling",
       .words = "springs that couple neighbouring joints",
       .parameters = one_of(ParameterKind::coupling_stiffness, "kappa"),
       .add = [](const Addition& to) { to.rig.coupling += to.value[0]; },
       .possible = neighbours_yield},
      {.id = "viscoelasticity",
       .words = "springs that relax over time",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{of(ParameterKind::spring_part, "m", at),
                                of(ParameterKind::decay_time, "tau", at)};
           },
       .add =
           [](const Addition& to) {
             to.rig.arms.push_back({to.value[0], to.value[1]});
           },
       .possible = [](const Place& at) { return at.scales.clock && any_elastic(at); },
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             const double low = std::log(0.1 * at.scales.sampling_interval),
                          high = std::log(20 * at.scales.duration);
             InitialGuesses guesses{{}, 2};
             for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
               guesses.points.push_back({0.5 * 0.2, low + share * (high - low)});
             return guesses;
           },
       .perturbation = {.growing = {0}}},
  };
}

}  // namespace plumbline::diagnose
