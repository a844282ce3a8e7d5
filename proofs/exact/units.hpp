#pragma once
/// \file
/// A chain in units of its own: its longest link and its stiffest joint are about one.

#include <plumbline/chain/chain.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <plumbline/loaded/loading.hpp>

namespace plumbline::proofs {

/// Powers of two, so that a change of units is exact.
struct Units {
  Interval length, stiffness;

  [[nodiscard]] Interval force() const { return stiffness / length; }
};

/// The units in which the longest link and the stiffest joint lie in [1/2, 1). The stiffness unit of a chain
/// without springs is one.
Units own_units(const Chain<Interval>& chain);

/// The chain measured in these units.
/// \throws Error where two lengths, or two stiffnesses, differ by a factor above 1e60: searches in double
///         precision could not represent their products
Chain<Interval> in_units(const Chain<Interval>& chain, const Units& units);

/// A load measured in these units: the place of an end point, or a force.
Point<Interval> in_units(const Point<Interval>& load, Control control, const Units& units);

}  // namespace plumbline::proofs
