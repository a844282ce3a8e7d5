#pragma once
/// \file
/// The equations of a branch of equilibria over boxes, in spans.

#include <array>
#include <plumbline/branch/branch.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/paths/tube_equations.hpp"

namespace plumbline::proofs {

/// With push and way, force and way along the loading's direction, the tangent stiffness is push'/way'.
struct StiffnessChange {
  Span way;    ///< way': where it vanishes the tangent stiffness is infinite
  Span value;  ///< has its sign: push' way'
  Span slope;  ///< has the sign of its derivative: push'' way' - push' way''
  Span bend;   ///< derivative of the slope
};

/// E(u) = 0 under a loading. Unknowns u are theta_1 … theta_n, then Fx and Fy where the end point is held,
/// last the load. There is one equation fewer than unknowns: the solutions are curves. Evaluated at a box,
/// every result encloses what it is at each point inside.
class BranchEquations final : public TubeEquations {
 public:
  BranchEquations(const Chain<Interval>& chain, const Loading<Interval>& loading);

  [[nodiscard]] Eigen::Index unknowns() const { return size_; }
  /// The unknowns of a point that was computed in double precision.
  [[nodiscard]] Vector<Span> at(const BranchPoint<double>& point) const;
  [[nodiscard]] Span load(const Vector<Span>& u) const { return u(size_ - 1); }

  [[nodiscard]] Vector<Span> value(const Vector<Span>& u) override;
  [[nodiscard]] Matrix<Span> derivative(const Vector<Span>& u, const Vector<Span>& normal) override;
  [[nodiscard]] Vector<Span> second(const Vector<Span>& u, const Vector<Span>& v,
                                    const Vector<Span>& w) override;
  /// E'''(u) v v v, and a zero for the plane.
  [[nodiscard]] Vector<Span> third(const Vector<Span>& u, const Vector<Span>& v);
  /// How the tangent stiffness goes along a curve with the given first, second and third derivatives at u.
  [[nodiscard]] StiffnessChange stiffness(const Vector<Span>& u, const std::array<Vector<Span>, 3>& rates);
  /// Negative directions of the energy's Hessian in the sense of the control; nothing where that is open.
  [[nodiscard]] std::optional<std::size_t> negative_directions(const Vector<Span>& u);

 private:
  using Model = NominalModel<Span>;
  void expand(const Vector<Span>& u);
  [[nodiscard]] Variation<Span> variation(const Vector<Span>& v) const;
  /// Derivatives along a curve of the end point's way in the loading's direction.
  [[nodiscard]] std::array<Span, 3> way_of_end_point(const Vector<Span>& u,
                                                     const std::array<Vector<Span>, 3>& rates);
  [[nodiscard]] Span along(const Point<Span>& p) const {
    return loading_.direction.x * p.x + loading_.direction.y * p.y;
  }

  Model model_;
  Loading<Span> loading_;
  bool held_;
  Eigen::Index n_, size_;
  Expansion<Span, 1> at_;
  Point<Span> force_;
};

}  // namespace plumbline::proofs
