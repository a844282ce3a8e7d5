#pragma once
/// \file
/// All equilibria of a planar structure with any ends, supports and dead loads, certified complete in a
/// window.
///
/// Branch and bound over the directions of the links that turn, and the force Fy that holds the end point
/// across where it is held: a box is contracted by the moments from the end point to the base and by interval
/// Newton steps, dropped when empty, and halved. A Newton step strictly into a box's inside proves that
/// exactly one equilibrium lies in it. What can be neither dropped nor proved at the smallest size is
/// reported.
///
/// The window: each joint within half a turn of its rest, a passive one once around (and further full turns
/// where these are asked for), and |Fy| within a bound of its own, for a chain that is nearly folded across
/// may be held by any force.

#include <plumbline/structure/structure.hpp>
#include <vector>

#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

/// One equilibrium: exactly one lies in the box.
struct StructureEquilibrium {
  std::vector<Span> q;  ///< joint angles
  Span across;          ///< force that holds the end point across; 0 where it is not held
  Span x, y, energy;    ///< end point; of springs less the work of all loads
  std::optional<std::size_t> negative_directions;  ///< nothing where the box leaves it open
};

struct StructureCensus {
  std::vector<StructureEquilibrium> equilibria;  ///< by energy
  std::vector<std::vector<Span>> undecided;      ///< joint angles that may be of further ones
  double widest_turn;                            ///< from its rest, of each joint
  double largest_force;  ///< across the end point, that is counted; 0 where it is not held
  std::size_t boxes;     ///< visited

  [[nodiscard]] bool complete() const { return undecided.empty(); }
};

/// \param turns  further full turns of each joint that are counted
/// \throws Error for a follower load, a base that is not held, an end point that is held along, more than ten
/// links,
///         and where the search finds no end
StructureCensus take_census(const Structure<Rational>& structure, const Rational& factor, int turns);

}  // namespace plumbline::proofs
