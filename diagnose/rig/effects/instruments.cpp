/// \file
/// Effects of the instruments beyond bias and scale, and differences between runs.

#include <algorithm>

#include "diagnose/beliefs.hpp"
#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool several_runs(const Place& at) {
  return at.scales.runs > 1;
}

/// Largest number of values of one effect over all joints and runs.
constexpr std::size_t most_values = 30;

std::vector<Effect> single_runs() {
  return {
      {.id = "run_rest",
       .words = "rest angles that differ from run to run",
       .parameters =
           [](const Place& at) {
             std::vector<ParameterRange> all;
             for (std::size_t r = 0; r < at.scales.runs; ++r)
               for (const ParameterRange& one :
                    each(at, {numbered("a", r), "rad", beliefs::angle_tolerance, -0.3, 0.3}))
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
             return several_runs(at) && at.scales.runs * at.scales.link_length.size() <= most_values;
           },
       .nested = {"rest_angle", "rest_offset", "rest_spread"}},
      {.id = "run_tare",
       .words = "a load-cell zero that differs from run to run",
       .parameters =
           [](const Place& at) {
             const double small = 0.05 * at.scales.force, large = 3 * at.scales.force;
             std::vector<ParameterRange> all;
             for (std::size_t r = 0; r < at.scales.runs; ++r) {
               all.push_back(both_ways(numbered("b_x", r), "N", small, -large, large));
               all.push_back(both_ways(numbered("b_y", r), "N", small, -large, large));
             }
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
             return several_runs(at) && at.scales.measures_force && 2 * at.scales.runs <= most_values;
           },
       .nested = {"force_bias"}},
  };
}

std::vector<Effect> load_cells() {
  return {
      {.id = "cross_talk",
       .words = "a load cell with cross-talk between its components",
       .parameters =
           [](const Place&) {
             return std::vector{both_ways("c_xy", "ratio", 0.03, -0.8, 0.8),
                                both_ways("c_yx", "ratio", 0.03, -0.8, 0.8)};
           },
       .add = [](const Addition& to) { to.rig.cross_talk += Vector2(to.value[0], to.value[1]); },
       .possible = [](const Place& at) { return at.scales.measures_both_forces; }},
      {.id = "cell_curvature",
       .words = "a load cell that is not linear",
       .parameters =
           [](const Place& at) {
             const double small = 0.03 / at.scales.force, large = 0.25 / at.scales.force;
             return std::vector{both_ways("c_x", "1/N", small, -large, large),
                                both_ways("c_y", "1/N", small, -large, large)};
           },
       .add = [](const Addition& to) { to.rig.cell_curvature += Vector2(to.value[0], to.value[1]); },
       .possible = [](const Place& at) { return at.scales.load_cell; }},
      {.id = "saturation",
       .words = "a load cell that saturates",
       .parameters =
           [](const Place& at) {
             const double f = at.scales.force;
             return std::vector<ParameterRange>{
                 {"limit", "N", Coordinate::reciprocal, 0.3 / f, 1e-3 / f, 10 / f}};
           },
       .add = [](const Addition& to) { to.rig.force_limit = std::min(to.rig.force_limit, to.value[0]); },
       // A saturated cell repeats its largest reading.
       .possible = [](const Place& at) { return at.scales.at_largest > 3; },
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             return InitialGuesses{
                 {{1 / (0.98 * std::max(at.scales.largest_reading, 1e-3 * at.scales.force))}}, 1};
           },
       .perturbation = {.large_step = true}},
      {.id = "sensor_lag",
       .words = "a load cell that responds with a delay",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{one_way("tau", "s", 0.3 * at.scales.sampling_interval, at.scales.duration)};
           },
       .add = [](const Addition& to) { to.rig.force_lag += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.measures_force && at.scales.clock; }},
  };
}

}  // namespace

std::vector<Effect> instrument_effects() {
  std::vector<Effect> rows = single_runs();
  for (Effect& row : load_cells()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
