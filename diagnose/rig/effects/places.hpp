#pragma once
/// \file
/// Conditions of rows: what a device must have, or a bench read, for a reading to depend on an effect.

#include <algorithm>

#include "diagnose/rig/effect.hpp"
#include "diagnose/rig/sizes.hpp"

namespace plumbline::diagnose {

/// Whether a spring, or what stands for one, lets the joint yield.
inline bool is_elastic(const Place& at) {
  return at.scales.joint_stiffness[at.joint] > 0;
}

inline bool any_elastic(const Place& at) {
  return std::any_of(at.scales.joint_stiffness.begin(), at.scales.joint_stiffness.end(),
                     [](double k) { return k > 0; });
}

inline bool is_rigid(const Place& at) {
  return at.scales.rigid[at.joint];
}

/// Whether a torque at the joint shows: it yields or turns freely, or its drive's torque is read.
inline bool torque_shows(const Place& at) {
  return !is_rigid(at) || at.scales.measures(Channel::Name::drive);
}

/// Whether any load shows.
inline bool loads_show(const Place& at) {
  return at.scales.measures(Channel::Name::drive) ||
         std::find(at.scales.rigid.begin(), at.scales.rigid.end(), false) != at.scales.rigid.end();
}

/// At least two elastic joints, joints, links: with one, the row would repeat that of a single joint or link.
inline bool several_elastic(const Place& at) {
  return std::count_if(at.scales.joint_stiffness.begin(), at.scales.joint_stiffness.end(),
                       [](double k) { return k > 0; }) > 1;
}
inline bool several_joints(const Place& at) {
  return at.scales.joint_stiffness.size() > 1;
}

/// At least one link: a joint alone has none.
inline bool has_links(const Place& at) {
  return at.scales.axes > 1;
}

/// Whether links stay in one plane, in which their lengths and rest angles are all of their geometry.
inline bool is_planar(const Place& at) {
  return at.scales.axes == 2;
}

inline bool end_is_loaded(const Place& at) {
  return at.scales.end_is_loaded;
}

/// Whether the command of the joint changes.
inline bool moves(const Place& at) {
  return at.scales.moves[at.joint];
}

inline bool turns_back(const Place& at) {
  return at.scales.turns_back;
}

inline bool several_runs(const Place& at) {
  return at.scales.runs > 1;
}

/// Whether places of the device are read by a camera or a tracker.
inline bool places_are_read(const Place& at) {
  using Name = Channel::Name;
  const bool end = at.scales.measures(Name::x) || at.scales.measures(Name::y);
  return at.scales.measures(Name::place) || (has_links(at) && end);
}

/// Whether a sensor beside the tracker sees the place of a point.
inline bool sensors_see_places(const Place& at) {
  return std::any_of(arm_sensor_kinds().begin(), arm_sensor_kinds().end(), [&](const ArmSensorKind& kind) {
    return !kind.sees_turns && at.scales.measures(kind.reads);
  });
}

/// Whether places or orientations of points are read, or what depends on them.
inline bool points_are_read(const Place& at) {
  return at.scales.measures(Channel::Name::place) || at.scales.measures(Channel::Name::turn) ||
         at.scales.measures(Channel::Name::inclination) || sensors_see_places(at);
}

/// The kind of an offset of the joint: an angle, or a way where it slides.
inline ParameterKind offset_of_joint(const Place& at) {
  return at.scales.slides[at.joint] ? ParameterKind::stroke : ParameterKind::joint_angle;
}

/// The kind of its drift, by time.
inline ParameterKind drift_of_joint(const Place& at) {
  return at.scales.slides[at.joint] ? ParameterKind::stroke_drift : ParameterKind::angle_drift;
}

/// Whether time shows in what a kind of sensor reads. A drive that follows late, or drifts, is all that is
/// seen where that kind alone is read.
inline bool shows_in_time(const Place& at) {
  return at.scales.clock && (at.scales.kinds_read() > 1 || !at.scales.drives);
}

/// Whether a lag of a kind of sensor shows. Loads along the chain that are late are all that is seen where
/// that kind alone is read.
inline bool shows_late(const Place& at) {
  return shows_in_time(at) && (at.scales.kinds_read() > 1 || at.scales.applied.empty());
}

/// Whether joint angles are read, and something else: alone, their sensors' errors are those of the joints.
inline bool angles_are_read_beside(const Place& at) {
  return at.scales.measures(Channel::Name::q) && at.scales.kinds_read() > 1;
}

/// An encoder by which the servo leads the joint does not show its own errors; places do.
inline bool encoder_hides(const Place& at) {
  return at.scales.reads_encoders && angles_are_read_beside(at);
}

}  // namespace plumbline::diagnose
