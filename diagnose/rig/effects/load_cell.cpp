/// \file
/// Effects of the load cell.

#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool has_load_cell(const Place& at) {
  return at.scales.load_cell;
}

}  // namespace

std::vector<Effect> load_cell_effects() {
  return {
      {.id = "force_bias",
       .words = "a tare error of the load cell",
       .parameters =
           [](const Place& at) {
             const double small = 0.05 * at.scales.force, large = 3 * at.scales.force;
             return std::vector{both_ways("b_x", "N", small, -large, large),
                                both_ways("b_y", "N", small, -large, large)};
           },
       .add = [](const Addition& to) { to.rig.force_bias += Vector2(to.value[0], to.value[1]); },
       .possible = has_load_cell},
      {.id = "force_gain",
       .words = "a scale error of the load cell",
       .parameters = [](const Place&) { return std::vector{both_ways("g", "ratio", 0.05, -0.8, 3)}; },
       .add = [](const Addition& to) { to.rig.force_gain += to.value[0]; },
       .possible = has_load_cell},
      {.id = "sensor_drift",
       .words = "a load cell that drifts over time",
       .parameters =
           [](const Place& at) {
             const double rate = at.scales.force / at.scales.duration;
             return std::vector{both_ways("r_x", "N/s", 0.05 * rate, -3 * rate, 3 * rate),
                                both_ways("r_y", "N/s", 0.05 * rate, -3 * rate, 3 * rate)};
           },
       .add = [](const Addition& to) { to.rig.force_drift += Vector2(to.value[0], to.value[1]); },
       // An imposed force cannot drift.
       .possible = [](const Place& at) { return at.scales.measures_force && at.scales.clock; }},
  };
}

}  // namespace plumbline::diagnose
