#pragma once
/// \file
/// The state of a branch, or of a slowly loaded chain, at a load between those of its stored points.

#include <plumbline/branch/trace.hpp>

namespace plumbline {

namespace detail {

/// Between two points of a branch that enclose the load: by halves along the branch, so that no other branch
/// is met, however near. Nothing where no step reaches the middle.
template <LoadedModel Model>
std::optional<BranchPoint<typename Model::Real>> between_at_load(Brancher<Model>& brancher,
                                                                 BranchPoint<typename Model::Real> a,
                                                                 BranchPoint<typename Model::Real> b,
                                                                 const typename Model::Real& load) {
  using Real = typename Model::Real;
  using std::abs;
  const bool rises = b.load > a.load;
  const auto half = [&](const BranchPoint<Real>& from, const BranchPoint<Real>& to) {
    const Variation<Real> chord{
        to.theta - from.theta, {to.force.x - from.force.x, to.force.y - from.force.y}, to.load - from.load};
    return brancher.step(from, brancher.product(chord, from.tangent) / Real(2));
  };
  // a load of zero is met to a share of itself by no half, however small
  const Real smallest = epsilon<Real>() * epsilon<Real>();
  for (Real part = Real(1);; part /= Real(2)) {
    // from behind first: where the branch begins in a bifurcation, its first point is singular
    auto middle = half(b, a);
    if (!middle) middle = half(a, b);
    if (!middle) return std::nullopt;
    const Real off = middle->load - load;
    if (abs(off) <= Real(4) * epsilon<Real>() * abs(load) || part < smallest) return middle;
    ((off < Real(0)) == rises ? a : b) = std::move(*middle);
  }
}

}  // namespace detail

/// The first point of a branch that has the load. Nothing where the branch does not reach it.
template <LoadedModel Model>
std::optional<BranchPoint<typename Model::Real>> point_at_load(Brancher<Model>& brancher,
                                                               const Branch<typename Model::Real>& branch,
                                                               const typename Model::Real& load) {
  const auto& points = branch.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].load == load) return points[i];
    if (i + 1 == points.size() || (points[i].load < load) == (points[i + 1].load < load)) continue;
    return detail::between_at_load(brancher, points[i], points[i + 1], load);
  }
  return std::nullopt;
}

/// What a slowly loaded chain is at a load: on the last of its stretches whose predecessor ends at or before
/// it. A stretch begins a little after that end, at a bifurcation on the branch that leaves from there.
/// Nothing where the stretch does not reach the load.
template <LoadedModel Model>
std::optional<BranchPoint<typename Model::Real>> state_at_load(
    Brancher<Model>& brancher, const std::vector<Branch<typename Model::Real>>& stretches,
    const typename Model::Real& load) {
  std::size_t on = 0;
  while (on + 1 < stretches.size() && stretches[on].points.back().load <= load) ++on;
  const auto& first = stretches[on].points.front();
  if (on == 0 || first.load <= load) return point_at_load(brancher, stretches[on], load);
  const auto& before = stretches[on - 1];
  if (!before.events.empty() && before.events.back().kind == EventKind::bifurcation)
    return detail::between_at_load(brancher, before.points.back(), first, load);
  return brancher.at_load(first, load);
}

}  // namespace plumbline
