/// \file
/// Effects of the joints.

#include <cmath>

#include "diagnose/rig/effects/hardening.hpp"
#include "diagnose/rig/effects/onsets.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool is_elastic(const Place& at) {
  return at.sizes.joint_stiffness[at.joint] > 0;
}

Starts shares_of(double reach, std::initializer_list<double> shares, std::size_t basins) {
  Starts starts{{}, basins};
  for (const double share : shares) starts.from.push_back({share * reach});
  return starts;
}

}  // namespace

std::vector<Effect> joint_effects() {
  return {
      {.id = "joint_stiffness",
       .words = "a wrong stiffness of joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.2, -0.95, 9)}; },
       .add = [](const Addition& to) { to.rig.stiffness[to.joint] *= 1 + to.value[0]; },
       .possible = is_elastic},
      {.id = "rest_angle",
       .words = "a wrong rest angle of joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{both_ways("a", "rad", 0.05, -0.6, 0.6)}; },
       .add = [](const Addition& to) { to.rig.rest_error[to.joint] += to.value[0]; },
       .possible = is_elastic},
      {.id = "nonlinear_spring",
       .words = "joint springs that harden or soften with their deflection",
       .parameters = [](const Place& at) { return std::vector{hardening(at.sizes)}; },
       .add =
           [](const Addition& to) {
             for (double& c : to.rig.hardening) c += to.value[0];
           }},
      {.id = "backlash",
       .words = "play in joint {}",
       .at_joint = true,
       .parameters = [](const Place&) { return std::vector{one_way("b", "rad", 0.05, 0.6)}; },
       .add = [](const Addition& to) { to.rig.backlash[to.joint] += to.value[0]; },
       .possible = is_elastic,
       .starts =
           [](const Place& at, const Exercise& nominal) {
             return shares_of(nominal.deflection[at.joint], {0.02, 0.1, 0.4}, 2);
           },
       .probing = {.large_step = true}},
      {.id = "joint_friction",
       .words = "dry friction in the joints",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             const double slip = at.sizes.stiffness * at.sizes.deflection;
             return std::vector{one_way("tau_c", "N m", 0.05 * slip, 10 * slip)};
           },
       .add =
           [](const Addition& to) {
             for (double& torque : to.rig.friction) torque += to.value[0];
           },
       .starts =
           [](const Place&, const Exercise& nominal) {
             return shares_of(nominal.torque, {0.002, 0.01, 0.05}, 1);
           },
       .probing = {.large_step = true}},
      {.id = "joint_stop",
       .words = "a stop at joint {}",
       .at_joint = true,
       .parameters =
           [](const Place& at) {
             return std::vector{onset_angle("s"), stop_stiffness(at.sizes.stiffness_at(at.joint))};
           },
       .add =
           [](const Addition& to) {
             to.rig.stop[to.joint] = to.value[0];
             to.rig.stop_stiffness[to.joint] = to.value[1];
           },
       .starts =
           [](const Place& at, const Exercise& nominal) {
             return stop_starts([&](double share, double stiff) {
               return std::vector{share * nominal.deflection[at.joint],
                                  stiff * at.sizes.stiffness_at(at.joint)};
             });
           },
       .probing = {.growing = {1}}},
      {.id = "joint_coupling",
       .words = "springs that neighbouring joints share",
       .parameters =
           [](const Place& at) {
             const double k = at.sizes.stiffness;
             return std::vector{both_ways("kappa", "N m/rad", 0.1 * k, -0.95 * k, 0.95 * k)};
           },
       .add = [](const Addition& to) { to.rig.coupling += to.value[0]; },
       .possible = [](const Place& at) { return at.sizes.link_length.size() > 1; }},
      {.id = "viscoelasticity",
       .words = "springs that relax in time",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector<ParameterRange>{
                 one_way("m", "ratio", 0.2, 20),
                 {"tau", "s", Coordinate::logarithm, 1, std::log(0.1 * at.sizes.pause),
                  std::log(20 * at.sizes.duration)}};
           },
       .add =
           [](const Addition& to) {
             to.rig.arms.push_back({to.value[0], to.value[1]});
           },
       .possible = [](const Place& at) { return at.sizes.clock; },
       .starts =
           [](const Place& at, const Exercise&) {
             const double low = std::log(0.1 * at.sizes.pause), high = std::log(20 * at.sizes.duration);
             Starts starts{{}, 2};
             for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
               starts.from.push_back({0.5 * 0.2, low + share * (high - low)});
             return starts;
           },
       .probing = {.growing = {0}}},
  };
}

}  // namespace plumbline::diagnose
