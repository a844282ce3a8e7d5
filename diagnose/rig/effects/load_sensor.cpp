/// \file
/// Effects of what reads loads: a load cell at the end point, the sensor of a joint alone, that of a wrench,
/// and a second one beside it. A servo that imposes a load regulates on what the first one reads.

#include <algorithm>
#include <cmath>

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool has_load_cell(const Place& at) {
  return at.scales.load_cell;
}

bool reads_load_over_time(const Place& at) {
  return at.scales.measures_force && at.scales.clock;
}

/// Components of the load: one of a joint alone, else one an axis.
std::vector<ParameterRange> components(ParameterKind of_force, ParameterKind of_torque, std::string_view stem,
                                       const Place& at) {
  return has_links(at) ? each_axis(of_force, stem, at) : std::vector{of(of_torque, stem, at)};
}

/// Adds them to a vector.
void add_components(const Addition& to, Vector3<double>& sum) {
  const auto axes = static_cast<Eigen::Index>(to.scales.axes);
  sum.head(axes) += Eigen::Map<const Eigen::VectorXd>(to.value, axes);
}

std::vector<Effect> first_sensor() {
  return {
      {.id = "force_bias",
       .words = "a wrong zero of the load sensor",
       .parameters =
           [](const Place& at) {
             return components(ParameterKind::force_zero, ParameterKind::torque_zero, "b", at);
           },
       .add = [](const Addition& to) { add_components(to, to.rig.force_bias); },
       .possible = has_load_cell},
      {.id = "force_gain",
       .words = "a scale error of the load sensor",
       .parameters = one_of(ParameterKind::load_gain, "g"),
       .add = [](const Addition& to) { to.rig.force_gain += to.value[0]; },
       .possible = has_load_cell},
      {.id = "sensor_drift",
       .words = "a load sensor that drifts over time",
       .parameters =
           [](const Place& at) {
             return components(ParameterKind::force_drift, ParameterKind::torque_drift, "r", at);
           },
       .add = [](const Addition& to) { add_components(to, to.rig.force_drift); },
       .possible = [](const Place& at) { return at.scales.load_cell && at.scales.clock; }},
      {.id = "sensor_lag",
       .words = "a load sensor that responds with a delay",
       .dissipates = true,
       .parameters = one_of(ParameterKind::lag, "tau"),
       .add = [](const Addition& to) { to.rig.force_lag += to.value[0]; },
       .possible = reads_load_over_time},
      {.id = "sensor_creep",
       .words = "a load sensor that creeps under load",
       .dissipates = true,
       .parameters =
           [](const Place& at) {
             return std::vector{of(ParameterKind::load_gain, "m", at).positive(),
                                of(ParameterKind::decay_time, "tau", at)};
           },
       .add =
           [](const Addition& to) {
             to.rig.force_creep += to.value[0];
             to.rig.creep_time = to.value[1];
           },
       .possible = reads_load_over_time,
       .nested = {"force_gain"},  // of a time constant below the intervals
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             InitialGuesses guesses{{}, 2};
             for (const double share : {0.03, 0.1, 0.3})
               guesses.points.push_back({0.05, std::log(share * at.scales.duration)});
             return guesses;
           },
       .perturbation = {.growing = {0}}},
      {.id = "cross_talk",
       .words = "a load cell with cross-talk between its components",
       .parameters = some_of(ParameterKind::cross_talk, {"c_xy", "c_yx"}),
       .add = [](const Addition& to) { to.rig.cross_talk += Vector2(to.value[0], to.value[1]); },
       .possible = [](const Place& at) { return at.scales.measures_both_forces; }},
      {.id = "cell_curvature",
       .words = "a load cell that is not linear",
       .parameters = some_of(ParameterKind::sensor_curvature, {"c_x", "c_y"}),
       .add = [](const Addition& to) { to.rig.cell_curvature += Vector2(to.value[0], to.value[1]); },
       .possible = [](const Place& at) { return at.scales.load_cell && is_planar(at); }},
      {.id = "saturation",
       .words = "a load cell that saturates",
       .parameters = one_of(ParameterKind::sensor_limit, "limit"),
       .add = [](const Addition& to) { to.rig.force_limit = std::min(to.rig.force_limit, to.value[0]); },
       // A saturated cell repeats its largest reading.
       .possible = [](const Place& at) { return at.scales.at_largest > 3; },
       .initial_guesses =
           [](const Place& at, const Excitation&) {
             return InitialGuesses{
                 {{1 / (0.98 * std::max(at.scales.largest_reading, 1e-3 * at.scales.force))}}, 1};
           },
       .perturbation = {.large_step = true}},
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
  return {x || !y, scales.axes > 1 && (y || !x)};
}

std::vector<ParameterRange> zeros_of_second_sensor(const Place& at) {
  if (!has_links(at)) return {of(ParameterKind::torque_zero, "b", at)};
  const auto [along_x, along_y] = axes_of_second_sensor(at.scales);
  std::vector<ParameterRange> all;
  if (along_x) all.push_back(of(ParameterKind::force_zero, "b_x", at));
  if (along_y) all.push_back(of(ParameterKind::force_zero, "b_y", at));
  return all;
}

std::vector<Effect> second_sensor() {
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
       .parameters = one_of(ParameterKind::load_gain, "g"),
       .add = [](const Addition& to) { to.rig.second_gain += to.value[0]; },
       .possible = has_second_sensor},
  };
}

}  // namespace

std::vector<Effect> load_sensor_effects() {
  std::vector<Effect> rows = first_sensor();
  for (Effect& row : second_sensor()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
