#pragma once
/// \file
/// The real frequencies of a rod in a range, for all load factors of an interval at once.

#include <optional>

#include "proofs/rod/characteristic.hpp"

namespace plumbline::proofs {

/// How many zeros the function has in `x` at each factor: where each of these is simple, the same number at
/// all factors, and neither end of `x` is a zero at any. \returns nothing where that is not proved
std::optional<std::size_t> simple_zeros(const Characteristic& function, const Span& factor, const Span& x);

}  // namespace plumbline::proofs
