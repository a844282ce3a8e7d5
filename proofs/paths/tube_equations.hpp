#pragma once
/// \file
/// Equations whose solutions are curves, as tubes around these are proved from them.

#include <plumbline/base/number.hpp>

#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

/// E(u) = 0, one equation fewer than unknowns. Evaluated at a box, every result encloses what it is at each
/// point inside.
class TubeEquations {
 public:
  virtual ~TubeEquations() = default;
  /// E(u), and a zero for the plane.
  [[nodiscard]] virtual Vector<Span> value(const Vector<Span>& u) = 0;
  /// E'(u), bordered by the normal of a plane as last row.
  [[nodiscard]] virtual Matrix<Span> derivative(const Vector<Span>& u, const Vector<Span>& normal) = 0;
  /// E''(u) v w, and a zero for the plane.
  [[nodiscard]] virtual Vector<Span> second(const Vector<Span>& u, const Vector<Span>& v,
                                            const Vector<Span>& w) = 0;
};

}  // namespace plumbline::proofs
