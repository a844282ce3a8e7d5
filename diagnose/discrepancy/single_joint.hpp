#pragma once
/// \file
/// What the catalogue makes of the torque law of a bench's only sprung joint, where its nominal spring was a
/// guess: stiffness and rest angle as they may be, a shape of spring, a memory.

#include <optional>

#include "diagnose/decision/shrink.hpp"
#include "diagnose/decision/verdict.hpp"

namespace plumbline::diagnose {

/// What was named of a single joint.
struct NamedLaw {
  Shrink shrink;       ///< of the best explanation
  NoiseModel allowed;  ///< what it was let leave, and was fitted in
};

/// Of a bench with one sprung joint the readings are that joint's torque, and a spring that a laboratory
/// characterises was seldom known before: its stiffness and rest angle are part of the question. Beside
/// these, free as they are, a shape of spring and a memory are tried together; what they are let leave is
/// a share of the gap, for no ideal law is a device's. Those that close the gap on held-out readings, all but
/// a part of it, are named as a class, with a cause outside the catalogue, for what is left is more than
/// noise. Nothing where there is more than one sprung joint, the cause is known, or none does.
std::optional<NamedLaw> name_single_joint(const Study& study, const NoiseModel& noise, Cause& cause);

}  // namespace plumbline::diagnose
