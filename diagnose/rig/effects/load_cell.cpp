/// \file
/// Effects of the load cell, of the sensor of the load of a joint alone, and of a second sensor.

#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool has_load_cell(const Place& at) {
  return at.scales.load_cell;
}

/// The typical torque of a joint alone.
double typical_load(const Place& at) {
  return at.scales.force * at.scales.length;
}

bool has_load_sensor(const Place& at) {
  return at.scales.load_sensor;
}

bool reads_load_over_time(const Place& at) {
  return at.scales.reads_load && at.scales.clock;
}

std::vector<Effect> load_sensor_effects() {
  return {
      {.id = "load_zero",
       .words = "a wrong zero of the load sensor",
       .parameters =
           [](const Place& at) {
             const double load = typical_load(at);
             return std::vector{both_ways("b", "N m", 0.05 * load, -3 * load, 3 * load)};
           },
       .add = [](const Addition& to) { to.rig.force_bias.x() += to.value[0]; },
       .possible = has_load_sensor},
      {.id = "load_gain",
       .words = "a scale error of the load sensor",
       .parameters = [](const Place&) { return std::vector{both_ways("g", "ratio", 0.05, -0.8, 3)}; },
       .add = [](const Addition& to) { to.rig.force_gain += to.value[0]; },
       .possible = has_load_sensor},
      {.id = "load_drift",
       .words = "a load sensor that drifts over time",
       .parameters =
           [](const Place& at) {
             const double rate = typical_load(at) / at.scales.duration;
             return std::vector{both_ways("r", "N m/s", 0.05 * rate, -3 * rate, 3 * rate)};
           },
       .add = [](const Addition& to) { to.rig.force_drift.x() += to.value[0]; },
       .possible = [](const Place& at) { return at.scales.load_sensor && at.scales.clock; }},
      {.id = "load_lag",
       .words = "a load sensor that responds with a delay",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{one_way("tau", "s", 0.3 * at.scales.sampling_interval, at.scales.duration)};
           },
       .add = [](const Addition& to) { to.rig.force_lag += to.value[0]; },
       .possible = reads_load_over_time},
  };
}

bool has_second_sensor(const Place& at) {
  using Name = Channel::Name;
  return at.scales.measures(Name::Fx_2) || at.scales.measures(Name::Fy_2) ||
         at.scales.measures(Name::torque_2);
}

/// Along x and along y; both where none is read, as in the catalogue's document.
std::array<bool, 2> axes_of_second_sensor(const CharacteristicScales& scales) {
  const bool x = scales.measures(Channel::Name::Fx_2), y = scales.measures(Channel::Name::Fy_2);
  if (!scales.links) return {true, false};
  return {x || !y, y || !x};
}

std::vector<ParameterRange> zeros_of_second_sensor(const Place& at) {
  const double load = at.scales.links ? at.scales.force : typical_load(at);
  const auto zero = [&](const char* name, const char* unit) {
    return both_ways(name, unit, 0.05 * load, -3 * load, 3 * load);
  };
  if (!at.scales.links) return {zero("b", "N m")};
  const auto [along_x, along_y] = axes_of_second_sensor(at.scales);
  std::vector<ParameterRange> all;
  if (along_x) all.push_back(zero("b_x", "N"));
  if (along_y) all.push_back(zero("b_y", "N"));
  return all;
}

std::vector<Effect> second_sensor_effects() {
  return {
      {.id = "second_zero",
       .words = "a wrong zero of the second sensor of the load",
       .parameters = zeros_of_second_sensor,
       .add =
           [](const Addition& to) {
             const double* value = to.value;
             const auto [along_x, along_y] = axes_of_second_sensor(to.scales);
             if (along_x) to.rig.second_zero.x() += *value++;
             if (along_y) to.rig.second_zero.y() += *value;
           },
       .possible = has_second_sensor},
      {.id = "second_gain",
       .words = "a scale error of the second sensor of the load",
       .parameters = [](const Place&) { return std::vector{both_ways("g", "ratio", 0.05, -0.8, 3)}; },
       .add = [](const Addition& to) { to.rig.second_gain += to.value[0]; },
       .possible = has_second_sensor},
  };
}

}  // namespace

std::vector<Effect> load_cell_effects() {
  std::vector<Effect> rows{
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
       .possible = [](const Place& at) { return at.scales.load_cell && at.scales.clock; }},
  };
  for (const auto& group : {load_sensor_effects, second_sensor_effects})
    for (Effect& row : group()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
