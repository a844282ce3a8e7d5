/// \file
/// Differences between runs.

#include "diagnose/priors.hpp"
#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

/// Largest number of values of one effect over all joints and runs.
constexpr std::size_t most_values = 30;

}  // namespace

std::vector<Effect> run_effects() {
  return {
      {.id = "run_rest",
       .words = "rest angles that differ from run to run",
       .parameters =
           [](const Place& at) {
             std::vector<ParameterRange> all;
             for (std::size_t r = 0; r < at.scales.runs; ++r)
               for (const ParameterRange& one :
                    each(at, {numbered("a", r), "rad", priors::angle_tolerance, -0.3, 0.3}))
                 all.push_back(one);
             return all;
           },
       .add =
           [](const Addition& to) {
             const double* next = to.value;
             to.rig.run_rest.resize(to.scales.runs, std::vector<double>(to.rig.length.size(), 0.0));
             for (std::vector<double>& rest : to.rig.run_rest) {
               for_each_elastic({to.rig, 0, to.scales, to.down, next}, [&](std::size_t i, double a) {
                 rest[i] += a;
                 ++next;
               });
             }
           },
       .possible =
           [](const Place& at) {
             return several_runs(at) && any_elastic(at) &&
                    at.scales.runs * at.scales.link_length.size() <= most_values;
           },
       .nested = {"rest_angle", "rest_offset", "rest_spread"}},
      {.id = "run_tare",
       .words = "a load-cell zero that differs from run to run",
       .parameters =
           [](const Place& at) {
             std::vector<ParameterRange> all;
             for (std::size_t r = 0; r < at.scales.runs; ++r)
               for (const char* stem : {"b_x", "b_y"})
                 all.push_back(of(ParameterKind::force_zero, numbered(stem, r), at));
             return all;
           },
       .add =
           [](const Addition& to) {
             to.rig.run_tare.resize(to.scales.runs, Vector2::Zero());
             for (std::size_t r = 0; r < to.scales.runs; ++r)
               to.rig.run_tare[r] += Vector2(to.value[2 * r], to.value[2 * r + 1]);
           },
       .possible =
           [](const Place& at) {
             return several_runs(at) && is_planar(at) && at.scales.measures_force &&
                    2 * at.scales.runs <= most_values;
           },
       .nested = {"force_bias"}},
  };
}

}  // namespace plumbline::diagnose
