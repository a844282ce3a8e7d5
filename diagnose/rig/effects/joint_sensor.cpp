/// \file
/// Effects of what reads joint angles, tilts of links, and torques of drives: one loop over their channels.

#include "diagnose/rig/effects/each_joint.hpp"
#include "diagnose/rig/effects/responses.hpp"
#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

using KindAt = ParameterKind (*)(const Place& at);

template <ParameterKind kind>
ParameterKind always(const Place&) {
  return kind;
}

/// Sensors of one kind, one at each joint or link.
struct JointSensor {
  Channel::Name reads;
  const char *stem, *value, *all;  ///< of ids; in words, what one of them reads, and all of them
  KindAt zero, drift;
  ParameterKind gain;
  Possible zero_shows;
};

/// Whether that is read, and something else: alone, its errors are those of the joints.
template <Channel::Name name>
bool is_read_beside(const Place& at) {
  return at.scales.measures(name) && at.scales.kinds_read() > 1;
}

template <Channel::Name name>
bool is_read(const Place& at) {
  return at.scales.measures(name);
}

std::vector<JointSensor> joint_sensors() {
  using Name = Channel::Name;
  using Kind = ParameterKind;
  return {
      {Name::q, "angle", "the angle that is read at joint {}", "sensors of the joints' angles that respond",
       offset_of_joint, drift_of_joint, Kind::place_gain, is_read_beside<Name::q>},
      {Name::tilt, "tilt", "the tilt that is read of link {}", "sensors of the links' tilts that respond",
       always<Kind::fixture_angle>, always<Kind::angle_drift>, Kind::place_gain, is_read_beside<Name::tilt>},
      {Name::drive, "torque", "the torque that is read at joint {}",
       "sensors of the drives' torques that respond", always<Kind::torque_zero>, always<Kind::torque_drift>,
       Kind::load_gain, is_read<Name::drive>}};
}

template <class Member>
auto add_to(Channel::Name name, Member member) {
  return [=](const Addition& to) { to.rig.sensors.error(name, to.joint).*member += to.value[0]; };
}

std::vector<Effect> rows_of(const JointSensor& one) {
  const std::string stem = one.stem, value = one.value;
  const Possible reads = [name = one.reads](const Place& at) { return at.scales.measures(name); };
  const Possible in_time = [reads](const Place& at) { return reads(at) && shows_in_time(at); };
  const Responder all{stem + "_lag", one.all, sensors_of({one.reads})};
  return {
      {.id = stem + "_bias",
       .words = "a wrong zero of " + value,
       .at_joint = true,
       .parameters = [zero = one.zero](const Place& at) { return std::vector{of(zero(at), "b", at)}; },
       .add = add_to(one.reads, &SensorError::zero),
       .possible = one.zero_shows},
      {.id = stem + "_scale",
       .words = "a wrong scale of " + value,
       .at_joint = true,
       .parameters = one_of(one.gain, "g"),
       .add = add_to(one.reads, &SensorError::gain),
       .possible = one.zero_shows},
      {.id = stem + "_drift",
       .words = "a drift over time of " + value,
       .at_joint = true,
       .parameters = [drift = one.drift](const Place& at) { return std::vector{of(drift(at), "r", at)}; },
       .add = add_to(one.reads, &SensorError::drift),
       .possible = in_time},
      {.id = stem + "_cross_talk",
       .words = "cross-talk of the joints beside it into " + value,
       .at_joint = true,
       .parameters = one_of(one.gain, "c"),
       .add = add_to(one.reads, &SensorError::neighbours),
       .possible = [shows = one.zero_shows](const Place& at) { return several_joints(at) && shows(at); }},
      lagging(all, in_time),
      delayed(all, in_time),
  };
}

}  // namespace

std::vector<Effect> joint_sensor_effects() {
  std::vector<Effect> rows;
  for (const JointSensor& one : joint_sensors())
    for (Effect& row : rows_of(one)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
