#pragma once
/// \file
/// A tube that holds one smooth curve of equilibria, proved by interval Newton's method with a parameter.
///
/// Between two points a and b the chord is c(s) = a + s (b - a), 0 <= s <= 1; across it stand the planes
/// t · (u - c(s)) = 0. Write u = c(s) + w with |w_i| <= m_i and M = (E'; t) for the bordered derivative. With
/// any matrix Y, and bounds
///
///     z >= |Y E(c(s))|,   R >= |I - Y M|   for all s and w,
///
/// the inequality z + R m < m says that w -> w - Y (E(c(s) + w); t · w) maps the box into its inside and
/// contracts it. So in each plane exactly one equilibrium lies in the tube, M is regular all over the tube,
/// and by the implicit function theorem the equilibria are one analytic curve from the first plane to the
/// last, which no other branch touches in the tube. E(c(s)) differs from its linear interpolation between the
/// ends by s (1 - s) / 2 E'' (b - a)^2 at some place on the chord: it is small of second order, and tubes may
/// be long.

#include "proofs/paths/branch_equations.hpp"

namespace plumbline::proofs {

struct Tube {
  Vector<double> radius;            ///< m
  Vector<double> image;             ///< z + R m: the curve is as near as this to the chord
  Eigen::MatrixXd inverse, defect;  ///< Y, R
};

/// The tube around the chord from a to b. Nothing where none is proved: the chord is too long, or there is no
/// regular branch.
std::optional<Tube> tube_along(TubeEquations& equations, const Vector<Span>& a, const Vector<Span>& b,
                               const Vector<Span>& normal);

/// The box around a point: with every normal inside `normals`, one equilibrium lies in its plane through the
/// point; all these are one piece of one curve.
std::optional<Tube> tube_at(TubeEquations& equations, const Vector<Span>& point, const Vector<Span>& normals);

/// The solution of M x = y for every M in the tube, from an enclosure of Y y.
Vector<Span> solve(const Tube& tube, const Vector<Span>& preconditioned);

/// First, second and third derivative of the curve all over the tube, by its plane's measure t · u.
std::array<Vector<Span>, 3> rates(BranchEquations& equations, const Tube& tube,
                                  const Vector<Span>& everywhere);
/// The first alone.
Vector<Span> tangent(const Tube& tube);

/// 1 or -1, or 0 where it is open.
inline int sign(const Span& x) {
  return certainly_positive(x) ? 1 : certainly_negative(x) ? -1 : 0;
}
/// Y x
Vector<Span> product(const Eigen::MatrixXd& Y, const Vector<Span>& x);
/// Entry by entry.
Vector<Span> hull(const Vector<Span>& a, const Vector<Span>& b);
/// A box around the values of another.
Vector<Span> widened(const Vector<Span>& centre, const Vector<double>& radius);

}  // namespace plumbline::proofs
