#pragma once
/// \file
/// What happens on a branch: folds, bifurcations, quasi-buckling points.

#include <plumbline/branch/branch.hpp>
#include <string_view>

namespace plumbline {

/// What can happen on a branch.
enum class EventKind {
  fold,           ///< the load turns back: under a growing load the chain must jump (snap)
  bifurcation,    ///< another branch crosses: buckling
  quasi_buckling  ///< the tangent stiffness is least: the shape bends fastest, without a jump
};

/// The word for it.
inline std::string_view name(EventKind kind) {
  switch (kind) {
    case EventKind::fold:
      return "fold";
    case EventKind::bifurcation:
      return "bifurcation";
    case EventKind::quasi_buckling:
      break;
  }
  return "quasi-buckling";
}

/// An event and its place on a branch.
template <Number Real>
struct BranchEvent {
  EventKind kind;            ///< what happens
  std::size_t before;        ///< it lies behind points[before]
  BranchPoint<Real> point;   ///< located to working precision
  Variation<Real> crossing;  ///< at a bifurcation: the tangent of the other branch
};

/// The fold or the least stiffness next to a point of a branch, to working precision: Newton's method, along
/// the branch, for the zero of dload/ds or of the stiffness's slope. Its type is the given point's, for at a
/// fold rounding alone would decide. Nothing where none is near.
template <SmoothModel Model>
std::optional<BranchPoint<typename Model::Real>> locate(Brancher<Model>& brancher, EventKind kind,
                                                        BranchPoint<typename Model::Real> near) {
  using Real = typename Model::Real;
  using Q = BranchSeries<Real>;
  using std::abs, std::sqrt;
  BranchSeries<Real> series(4);  // the slope of the bend takes third derivatives
  const std::size_t type = near.negative_directions;
  for (int iteration = 0; iteration < 12; ++iteration) {
    brancher.refresh(near);
    brancher.expand(near, series);
    const bool fold = kind == EventKind::fold;
    const Real value = fold ? series.coefficient(Q::load, 1) : series.coefficient(Q::bend, 0);
    const Real slope = fold ? Real(Real(2) * series.coefficient(Q::load, 2)) : series.coefficient(Q::bend, 1);
    const Real s = -value / slope;
    if (!is_finite(s) || abs(s) > Real(1) / Real(2)) return std::nullopt;
    auto next = brancher.step(near, s);
    if (!next) return std::nullopt;
    near = std::move(*next);
    if (abs(s) <= sqrt(epsilon<Real>())) {
      near.negative_directions = type;
      return near;
    }
  }
  return std::nullopt;
}

}  // namespace plumbline
