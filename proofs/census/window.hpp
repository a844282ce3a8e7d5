#pragma once
/// \file
/// Which shapes a census with the end point held counts, and what topology says of their number.
///
/// A joint that is turned by another full turn makes the same shape with another spring moment, so the shapes
/// of one chain at one place are infinitely many, and a census has to say which it counts: those whose joint
/// angles lie in a window. The edge of the window of a joint between two links is where these lie folded flat
/// upon each other; a branch of equilibria leaves the window only by passing through such a fold.

#include <optional>
#include <plumbline/chain/chain.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <vector>

namespace plumbline::proofs {

/// Closed ranges of the relative joint angles, in radians. A passive joint is counted once around, whatever
/// its range.
using Window = std::vector<Interval>;

/// Every joint within half a turn of straight: no shape is left out but by winding a joint up, and each shape
/// occurs once. A joint that rests nearer to folded than to straight is counted within half a turn of folded,
/// and an elastic joint at the base, whose zero is a matter of drawing, within half a turn of its rest.
/// \param turns  further full turns that are counted, to either side
Window unwound(const Chain<Interval>& chain, int turns = 0);

/// The sum of (-1)^(negative directions) that all equilibria with the end point held must have, if none is
/// degenerate: the Euler characteristic of the space of shapes in the window. Nothing where a shape at the
/// edge of the window reaches the end point, or where the window is no whole number of turns wide: there the
/// space has a border, and the count no law.
///
/// The space of shapes is that of the closed polygons with the sides L_1 … L_n and |p|, up to rotation. With
/// a_k the number of sets of k + 1 sides that contain the longest and are shorter than the rest, its Betti
/// numbers are b_k = a_k + a_(n-2-k) (Farber and Schuetz 2007).
std::optional<long> index_sum(const Chain<Interval>& chain, const Point<Interval>& place,
                              const Window& window);

/// The Euler characteristic of the space of closed polygons. No sum of the sides with signs may vanish.
long euler_characteristic_of_polygons(std::vector<double> sides);

}  // namespace plumbline::proofs
