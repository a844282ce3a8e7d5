#pragma once
/// \file
/// The load factor at which a straight rod loses its stability, between two fractions.

#include "proofs/rod/rod_flutter.hpp"

namespace plumbline::proofs {

/// To so many significant digits, 40 at most.
/// \throws Error where the rod cannot be enclosed, with the reason
RodLoss critical_rod(const Rod& rod, int digits);

}  // namespace plumbline::proofs
