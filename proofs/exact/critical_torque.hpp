#pragma once
/// \file
/// The lowest torque at which a straight chain has a bent equilibrium beside it.

#include <plumbline/space/end_torque.hpp>

#include "proofs/exact/real_roots.hpp"

namespace plumbline::proofs {

struct CriticalTorque {
  NarrowBracket value;
  bool conservative;  ///< whether the torque has an energy, so that stability is lost there and not before
};

/// The lowest positive root of det(K - T S), proved by Sturm's theorem.
/// \throws Error as torque_pencil() does, for a mechanism, and where there is no positive root
CriticalTorque critical_torque(const SpaceStructure<Rational>& structure, int digits);

}  // namespace plumbline::proofs
