#pragma once
/// \file
/// Which of the nodes that are held across a chain are held already: exactly, from the statement alone.
///
/// A clamp keeps its link's direction at every shape, so that both of the link's nodes are held across where
/// one of them is. No other hold across follows from others at every shape of a planar chain: each link that
/// turns is free to move its far node against its near one.
///
/// \code{.cpp}
/// // Joint 2 stands on the link that the base clamps.
/// Structure<double> chain(Chain<double>({1, 1}, {0, 1}));
/// chain.base.turn = Restraint<double>::held();
/// chain.across = {Restraint<double>::held()};
/// const std::vector<bool> implied = implied_across(chain);
/// assert(implied[1] && !implied[2]);
/// \endcode

#include <plumbline/structure/structure.hpp>
#include <vector>

namespace plumbline {

/// Of nodes 0 … n, those whose hold across follows from that of the node before.
/// \param structure    in the plane or in space
/// \param base         whether the base is held across
/// \param first, last  whether that link keeps its direction
template <class AnyStructure>
std::vector<bool> implied_across(const AnyStructure& structure, bool base, bool first, bool last) {
  const std::size_t n = structure.chain.size();
  std::vector<bool> implied(n + 1, false);
  bool before = base;
  for (std::size_t node = 1; node <= n; ++node) {
    const bool rigid = (first && node == 1) || (last && node == n),
               held = structure.across_at(node).is_held();
    implied[node] = rigid && before && held;
    before = held || (rigid && before);
  }
  return implied;
}

/// The same of a planar structure.
template <Number Real>
std::vector<bool> implied_across(const Structure<Real>& structure) {
  return implied_across(structure, structure.base.across.is_held(), structure.base.turn.is_held(),
                        structure.end_point.turn.is_held());
}

/// What holds the last link's direction of a planar structure; nothing where the base clamps that link.
template <Number Real>
Restraint<Real> end_turn(const Structure<Real>& structure) {
  if (structure.chain.size() == 1 && structure.base.turn.is_held()) return {};
  return structure.end_point.turn;
}

}  // namespace plumbline
