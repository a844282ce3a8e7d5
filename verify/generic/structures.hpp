#pragma once
/// \file
/// Chains with ends, supports or loads of their own, as a chain file states them: what those checks do with
/// them that take lists too.

#include "verify/generic/quantities.hpp"

namespace plumbline::verify::generic {

/// Whether the straight chain is stable under its loads times `force`.
Judgement stability_of_structure(const Parameters& with, const Printed& printed, const Premises& given);
/// All equilibria under its loads times `factor`: their types or their count.
Judgement equilibria_of_structure(const Parameters& with, const Printed& printed, const Premises& given);

}  // namespace plumbline::verify::generic
