/// \file
/// Effects of what reads the joints, such as their angles and the torques of their drives, and of an arm's
/// sensors beside its tracker: one loop over the channels of which there are several of a kind.

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
  KindAt zero, drift, gain;
};

ErrorKinds errors_of(Sensor sensor) {
  using Kind = ParameterKind;
  const KindAt gain = always<Kind::place_gain>;
  switch (sensor) {
    case Sensor::torque:
      return {always<Kind::torque_zero>, always<Kind::torque_drift>, always<Kind::load_gain>};
    case Sensor::angle:
      return {offset_of_joint, drift_of_joint, gain};
    case Sensor::distance:
      return {always<Kind::place>, always<Kind::place_drift>, gain};
    case Sensor::pixel:
      return {always<Kind::pixel_zero>, always<Kind::pixel_drift>, gain};
    default:
      return {always<Kind::fixture_angle>, always<Kind::angle_drift>, gain};
  }
}

bool is_at_joints(const ChannelKind& kind) {
  return kind.index == ChannelKind::Index::joint;
}

/// How many numbers a sensor of the kind reads.
std::size_t numbers(const ChannelKind& kind) {
  return kind.label.find(' ') == std::string_view::npos ? 1 : 2;
}

/// What a row changes of a kind of channel: that of its joint, or all that sensors beside a tracker read;
/// where none is read, as in the catalogue's document, that of one sensor.
std::vector<std::size_t> changed(const ChannelKind& kind, const CharacteristicScales& scales,
                                 std::size_t joint) {
  if (is_at_joints(kind)) return {joint};
  std::vector<std::size_t> all;
  for (const Channel& one : scales.beside_tracker)
    if (one.name == kind.name) all.push_back(one.joint);
  for (std::size_t i = 0; !scales.measures(kind.name) && i < numbers(kind); ++i) all.push_back(i);
  return all;
}

/// One parameter each.
auto each_changed(const ChannelKind& kind, KindAt of_kind, const std::string& stem) {
  return [&kind, of_kind, stem](const Place& at) {
    std::vector<ParameterRange> all;
    for (const std::size_t i : changed(kind, at.scales, at.joint))
      all.push_back(
          of(of_kind(at), kept(is_at_joints(kind) ? stem : stem + "_" + Channel(kind.name, i).label()), at));
    return all;
  };
}

/// Adds to a member of the error of each.
auto add_to_changed(const ChannelKind& kind, double SensorError::*member) {
  return [&kind, member](const Addition& to) {
    const double* value = to.value;
    for (const std::size_t i : changed(kind, to.scales, to.joint))
      to.rig.sensors.error(kind.name, i).*member += *value++;
  };
}

std::vector<Effect> rows_of(const ChannelKind& kind) {
  const ErrorKinds kinds = errors_of(kind.sensor);
  const bool at_joint = is_at_joints(kind);
  const std::string stem(kind.label == "q" ? "angle" : at_joint ? kind.label : kind.noise_key);
  const std::string value =
      at_joint ? "the " + stem + " that is read at joint {}" : "each " + stem + " that is read";
  // What is read of the joints alone has the errors of the joints.
  const bool alone = kind.sensor == Sensor::torque || !at_joint;
  const Possible reads = [name = kind.name](const Place& at) { return at.scales.measures(name); };
  const Possible shows = [=](const Place& at) { return reads(at) && (alone || at.scales.kinds_read() > 1); };
  const Possible in_time = [=](const Place& at) { return reads(at) && shows_in_time(at); };
  const Possible late = [=](const Place& at) { return reads(at) && shows_late(at); };
  const Responder all{stem + "_lag", "sensors of " + stem + "s that respond", sensors_of({kind.name})};
  std::vector<Effect> rows{
      {.id = stem + "_bias",
       .words = "a wrong zero of " + value,
       .at_joint = at_joint,
       .parameters = each_changed(kind, kinds.zero, "b"),
       .add = add_to_changed(kind, &SensorError::zero),
       .possible = shows},
      {.id = stem + "_scale",
       .words = "a wrong scale of " + value,
       .at_joint = at_joint,
       .parameters = each_changed(kind, kinds.gain, "g"),
       .add = add_to_changed(kind, &SensorError::gain),
       .possible = shows},
      {.id = stem + "_drift",
       .words = "a drift over time of " + value,
       .at_joint = at_joint,
       .parameters = each_changed(kind, kinds.drift, "r"),
       .add = add_to_changed(kind, &SensorError::drift),
       .possible = in_time},
      lagging(all, late),
      delayed(all, late),
  };
  if (at_joint || numbers(kind) > 1)
    rows.insert(rows.end() - 2, {.id = stem + "_cross_talk",
                                 .words = "cross-talk of the " + std::string(at_joint ? "joints" : "number") +
                                          " beside it into " + value,
                                 .at_joint = at_joint,
                                 .parameters = each_changed(kind, kinds.gain, "c"),
                                 .add = add_to_changed(kind, &SensorError::neighbours),
                                 .possible = [=](const Place& at) {
                                   return (!at_joint || several_joints(at)) && shows(at);
                                 }});
  return rows;
}

}  // namespace

std::vector<Effect> sensor_effects() {
  using Index = ChannelKind::Index;
  std::vector<Effect> rows;
  for (const ChannelKind& kind : channel_kinds)
    if (kind.index == Index::joint || kind.index == Index::sensor)
      for (Effect& row : rows_of(kind)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace plumbline::diagnose
