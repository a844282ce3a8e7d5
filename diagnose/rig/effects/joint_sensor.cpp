/// \file
/// Effects of what reads the joints, such as their angles and the torques of their drives: one loop over the
/// channels that there are at each joint.

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

/// The kinds of errors of a sensor.
struct ErrorKinds {
  KindAt zero, drift;
  ParameterKind gain;
  bool show_alone;  ///< where nothing else is read; others are then errors of the joints
};

ErrorKinds errors_of(Sensor sensor) {
  using Kind = ParameterKind;
  if (sensor == Sensor::torque)
    return {always<Kind::torque_zero>, always<Kind::torque_drift>, Kind::load_gain, true};
  if (sensor == Sensor::angle) return {offset_of_joint, drift_of_joint, Kind::place_gain, false};
  return {always<Kind::fixture_angle>, always<Kind::angle_drift>, Kind::place_gain, false};
}

template <class Member>
auto add_to(Channel::Name name, Member member) {
  return [=](const Addition& to) { to.rig.sensors.error(name, to.joint).*member += to.value[0]; };
}

/// The rows of a kind of channel that there is at each joint.
std::vector<Effect> rows_of(const ChannelKind& channel) {
  const Channel::Name name = channel.name;
  const ErrorKinds kinds = errors_of(channel.sensor);
  const std::string stem(channel.label == "q" ? "angle" : channel.label);
  const std::string value = "the " + stem + " that is read at joint {}";
  const Possible reads = [name](const Place& at) { return at.scales.measures(name); };
  const Possible shows = [reads, alone = kinds.show_alone](const Place& at) {
    return reads(at) && (alone || at.scales.kinds_read() > 1);
  };
  const Possible in_time = [reads](const Place& at) { return reads(at) && shows_in_time(at); };
  const Responder all{stem + "_lag", "sensors of " + stem + "s that respond", sensors_of({name})};
  return {
      {.id = stem + "_bias",
       .words = "a wrong zero of " + value,
       .at_joint = true,
       .parameters = [zero = kinds.zero](const Place& at) { return std::vector{of(zero(at), "b", at)}; },
       .add = add_to(name, &SensorError::zero),
       .possible = shows},
      {.id = stem + "_scale",
       .words = "a wrong scale of " + value,
       .at_joint = true,
       .parameters = one_of(kinds.gain, "g"),
       .add = add_to(name, &SensorError::gain),
       .possible = shows},
      {.id = stem + "_drift",
       .words = "a drift over time of " + value,
       .at_joint = true,
       .parameters = [drift = kinds.drift](const Place& at) { return std::vector{of(drift(at), "r", at)}; },
       .add = add_to(name, &SensorError::drift),
       .possible = in_time},
      {.id = stem + "_cross_talk",
       .words = "cross-talk of the joints beside it into " + value,
       .at_joint = true,
       .parameters = one_of(kinds.gain, "c"),
       .add = add_to(name, &SensorError::neighbours),
       .possible = [shows](const Place& at) { return several_joints(at) && shows(at); }},
      lagging(all, in_time),
      delayed(all, in_time),
  };
}

}  // namespace

std::vector<Effect> joint_sensor_effects() {
  std::vector<Effect> rows;
  for (const ChannelKind& channel : channel_kinds)
    if (channel.index == ChannelKind::Index::joint)
      for (Effect& row : rows_of(channel)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
