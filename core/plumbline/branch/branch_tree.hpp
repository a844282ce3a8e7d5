#pragma once
/// \file
/// All branches that hang together with some equilibria: followed both ways, and switched at every
/// bifurcation.
///
/// \code{.cpp}
/// #include <plumbline/branch/straight_start.hpp>
///
/// // All shapes of a straight three-link chain that is shortened by up to 0.1: two arches and two zigzags.
/// const Chain<double> chain({1, 1, 1}, {0, 1, 1});
/// const NominalModel<double> model(chain);
/// const Loading<double> push{Control::end_point, {3, 0}, {-1, 0}};
/// Brancher<NominalModel<double>> brancher(model, push, absolute_angles(chain.rest()));
/// const auto starts = straight_starts(brancher, 1e-4);
/// const auto branches = branch_tree(brancher, starts, {.from = 1e-4, .to = 0.1});
/// assert(starts.size() == 4 && branches.size() == 4);
/// \endcode

#include <algorithm>
#include <limits>
#include <plumbline/branch/trace.hpp>

namespace plumbline {

/// Whether a point lies on a branch.
template <SmoothModel Model>
bool lies_on(Brancher<Model>& brancher, const Branch<typename Model::Real>& branch,
             const BranchPoint<typename Model::Real>& point) {
  using Real = typename Model::Real;
  using std::sqrt;
  const Real same = sqrt(epsilon<Real>());
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    const BranchPoint<Real>&a = branch.points[i - 1], &b = branch.points[i];
    const Variation<Real> gap{point.theta - a.theta, {}, point.load - a.load};
    const Variation<Real> step{b.theta - a.theta, {}, b.load - a.load};
    if (brancher.length(gap) > Real(2) * brancher.length(step) + same) continue;
    const Real ahead = brancher.product(gap, a.tangent);
    if (ahead < -same || ahead > brancher.product(step, a.tangent) + same) continue;
    const Variation<Real> back{point.theta - b.theta, {}, point.load - b.load};
    for (const auto& there : {brancher.step(a, ahead), brancher.step(b, brancher.product(back, b.tangent))}) {
      if (there && (there->theta - point.theta).cwiseAbs().maxCoeff() < Real(1000) * same) return true;
    }
  }
  return false;
}

/// A branch through a point, followed backwards and forwards. Its end is the edge of the load window only if
/// both ends are.
template <SmoothModel Model>
Branch<typename Model::Real> both_ways(Tracer<Model>& tracer, BranchPoint<typename Model::Real> start) {
  using Real = typename Model::Real;
  Branch<Real> ahead = tracer.run(start);
  if (ahead.end == BranchEnd::closed) return ahead;
  Brancher<Model>::scale(start.tangent, Real(-1));
  Branch<Real> behind = tracer.run(start);
  const std::size_t shift = behind.points.size() - 1;
  std::reverse(behind.points.begin(), behind.points.end());
  for (BranchPoint<Real>& point : behind.points) Brancher<Model>::scale(point.tangent, Real(-1));
  std::reverse(behind.events.begin(), behind.events.end());
  for (BranchEvent<Real>& event : behind.events) event.before = shift - 1 - event.before;
  behind.points.insert(behind.points.end(), ahead.points.begin() + 1, ahead.points.end());
  for (BranchEvent<Real>& event : ahead.events) {
    event.before += shift;
    behind.events.push_back(std::move(event));
  }
  if (ahead.end != BranchEnd::load) behind.end = ahead.end;
  return behind;
}

/// Every branch through the starts, and every branch that crosses one of those at a simple bifurcation,
/// within the load window. A branch runs through its start from end to end. No further one is begun once
/// there are `most` points.
template <SmoothModel Model>
std::vector<Branch<typename Model::Real>> branch_tree(
    Brancher<Model>& brancher, std::vector<BranchPoint<typename Model::Real>> starts,
    const TraceLimits<typename Model::Real>& limits,
    std::size_t most = std::numeric_limits<std::size_t>::max()) {
  using Real = typename Model::Real;
  std::size_t points = 0;
  std::vector<Branch<Real>> tree;
  Tracer<Model> tracer(brancher, limits);
  for (std::size_t next = 0; next < starts.size() && points < most; ++next) {
    const BranchPoint<Real> start = starts[next];
    const auto traced = [&](const Branch<Real>& branch) { return lies_on(brancher, branch, start); };
    if (std::any_of(tree.begin(), tree.end(), traced)) continue;
    Branch<Real> branch = both_ways(tracer, start);
    for (const BranchEvent<Real>& event : branch.events) {
      if (event.kind != EventKind::bifurcation) continue;
      for (const int side : {1, -1}) {
        BranchPoint<Real> at = event.point;
        at.tangent = event.crossing;
        std::optional<BranchPoint<Real>> off;
        for (Real h = Real(1) / Real(200); !off && h > Real(1) / Real(20000); h /= Real(4)) {
          off = brancher.step(at, Real(side) * h);
          if (off && (off->load < limits.from || off->load > limits.to)) off.reset();
        }
        if (off) starts.push_back(*off);
      }
    }
    points += branch.points.size();
    tree.push_back(std::move(branch));
  }
  return tree;
}

}  // namespace plumbline
