#pragma once
/// \file
/// What rows of arms in space ask of a place.

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// Whether the joint slides.
inline bool slides(const Place& at) {
  return at.scales.arm->arm.links[at.joint].kind == JointKind::prismatic;
}

/// The typical load of the joint: a force, N, where it slides, else a torque, N m.
inline double typical_load(const Place& at) {
  return slides(at) ? at.scales.force : at.scales.torque;
}

/// Whether points of the arm are measured.
inline bool points_are_read(const Place& at) {
  return at.scales.measures(Channel::Name::place) || at.scales.measures(Channel::Name::turn);
}

/// Whether a load shows: something yields, or torques are read.
inline bool loads_show(const Place& at) {
  return at.scales.yields || at.scales.measures(Channel::Name::drive);
}

}  // namespace plumbline::diagnose
