/// \file
/// Effects of what reads loads: a load cell at the end point, the sensor of a joint alone, that of a wrench,
/// and a second one beside it. A servo that imposes a load regulates on what the first one reads.

#include <algorithm>
#include <cmath>

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/responses.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

bool has_load_cell(const Place& at) {
  return at.scales.load_cell;
}

bool reads_load_over_time(const Place& at) {
  return at.scales.measures_force && at.scales.clock;
}

/// Of the first sensor's channels.
std::vector<Channel::Name> first_names() {
  return {Channel::Name::Fx, Channel::Name::Fy, Channel::Name::torque};
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
      lagging({"sensor_lag", "a load sensor that responds", sensors_of(first_names())}, reads_load_over_time),
      delayed({"sensor_lag", "a load sensor that responds", sensors_of(first_names())},
              [](const Place& at) { return reads_load_over_time(at) && shows_in_time(at); }),
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
             for (Response* own : sensors_of(first_names())(to)) {
               own->creep += to.value[0];
               own->creep_time = to.value[1];
             }
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
       .add =
           [](const Addition& to) {
             for (Response* own : sensors_of(first_names())(to))
               own->limit = std::min(own->limit, to.value[0]);
           },
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

/// Its components: all where none is read, as in the catalogue's document.
std::vector<Channel::Name> second_names(const CharacteristicScales& scales) {
  using Name = Channel::Name;
  std::vector<Name> read;
  for (const Name name : {Name::Fx_2, Name::Fy_2, Name::torque_2})
    if (scales.measures(name)) read.push_back(name);
  if (!read.empty()) return read;
  return scales.axes > 1 ? std::vector{Name::Fx_2, Name::Fy_2} : std::vector{Name::torque_2};
}

const char* axis_of(Channel::Name component) {
  return kind_of(component).along_y ? "_y" : "_x";
}

/// One parameter a component: of a force, or of a torque.
auto each_component(ParameterKind of_force, ParameterKind of_torque, const std::string& stem) {
  return [=](const Place& at) {
    std::vector<ParameterRange> all;
    for (const Channel::Name name : second_names(at.scales))
      all.push_back(at.scales.axes == 1 ? of(of_torque, stem, at)
                                        : of(of_force, kept(stem + axis_of(name)), at));
    return all;
  };
}

/// Adds to a member of the errors of its components. \param value  one a component, or one for all
template <class Member>
auto add_to_second(Member member, bool each) {
  return [=](const Addition& to) {
    const double* value = to.value;
    for (const Channel::Name name : second_names(to.scales)) {
      to.rig.sensors.error(name).*member += *value;
      if (each) ++value;
    }
  };
}

std::vector<Effect> second_sensor() {
  const Responder second{"second_lag", "a second sensor of the load that responds",
                         sensors_of({Channel::Name::Fx_2, Channel::Name::Fy_2, Channel::Name::torque_2})};
  const auto in_time = [](const Place& at) { return has_second_sensor(at) && shows_in_time(at); };
  return {
      {.id = "second_zero",
       .words = "a wrong zero of the second sensor of the load",
       .parameters = each_component(ParameterKind::force_zero, ParameterKind::torque_zero, "b"),
       .add = add_to_second(&SensorError::zero, true),
       .possible = has_second_sensor},
      {.id = "second_gain",
       .words = "a scale error of the second sensor of the load",
       .parameters = one_of(ParameterKind::load_gain, "g"),
       .add = add_to_second(&SensorError::gain, false),
       .possible = has_second_sensor},
      {.id = "second_drift",
       .words = "a second sensor of the load that drifts over time",
       .parameters = each_component(ParameterKind::force_drift, ParameterKind::torque_drift, "r"),
       .add = add_to_second(&SensorError::drift, true),
       .possible = in_time},
      {.id = "second_cross_talk",
       .words = "a second sensor of the load with cross-talk between its components",
       .parameters = some_of(ParameterKind::cross_talk, {"c_xy", "c_yx"}),
       .add = add_to_second(&SensorError::neighbours, true),
       .possible =
           [](const Place& at) {
             return at.scales.measures(Channel::Name::Fx_2) && at.scales.measures(Channel::Name::Fy_2);
           }},
      lagging(second, in_time),
      delayed(second, in_time),
  };
}

}  // namespace

std::vector<Effect> load_sensor_effects() {
  std::vector<Effect> rows = first_sensor();
  for (Effect& row : second_sensor()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
