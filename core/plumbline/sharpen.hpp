#pragma once
/// \file
/// Events of a branch to more digits: a branch is followed in one number type, what happens on it is located
/// in another.

#include <plumbline/trace.hpp>

namespace plumbline {

template <Floating To, Floating From>
Variation<To> lift(const Variation<From>& v) {
  return {v.theta.template cast<To>(), {To(v.force.x), To(v.force.y)}, To(v.load)};
}

/// The place of a point and its tangent; the rest has to be computed anew.
template <Floating To, Floating From>
BranchPoint<To> lift(const BranchPoint<From>& p) {
  BranchPoint<To> point;
  point.load = To(p.load);
  point.theta = p.theta.template cast<To>();
  point.force = {To(p.force.x), To(p.force.y)};
  point.tangent = lift<To>(p.tangent);
  point.negative_directions = p.negative_directions;
  return point;
}

/// An event of a branch, to the working precision of the brancher's number type.
/// \throws Error where there is no such event in that precision
template <SmoothModel Model, Floating Low>
BranchEvent<typename Model::Real> sharpen(Brancher<Model>& brancher, const Branch<Low>& branch,
                                          const BranchEvent<Low>& event) {
  using Real = typename Model::Real;
  using std::abs;
  const auto lost = [] { return Error("branch", "an event that more digits do not show", "an event"); };
  BranchEvent<Real> result{event.kind, event.before, lift<Real>(event.point), {}};
  if (event.kind == EventKind::bifurcation) {
    auto found = BifurcationSolver<Model>(brancher).near(result.point, lift<Real>(event.crossing));
    if (!found || found->tangents.size() != 2 || found->imperfection > Real(256) * epsilon<Real>())
      throw lost();
    const auto along = [&](const Variation<Real>& t) {
      return brancher.product(t, lift<Real>(event.crossing));
    };
    const std::size_t other = abs(along(found->tangents[0])) > abs(along(found->tangents[1])) ? 0 : 1;
    result.crossing = found->tangents[other];
    Variation<Real> tangent = found->tangents[1 - other];
    if (brancher.product(tangent, result.point.tangent) < Real(0)) Brancher<Model>::scale(tangent, Real(-1));
    result.point = found->point;
    brancher.describe_singular(result.point, tangent);
    result.point.negative_directions = event.point.negative_directions;
    return result;
  }
  const BranchPoint<Low>& before = branch.points[event.before];
  BranchPoint<Real> from = brancher.start(Real(before.load), before.theta.template cast<Real>(),
                                          {Real(before.force.x), Real(before.force.y)});
  if (brancher.product(from.tangent, lift<Real>(before.tangent)) < Real(0))
    Brancher<Model>::scale(from.tangent, Real(-1));
  const Variation<Real> way{
      result.point.theta - from.theta, {Real(0), Real(0)}, result.point.load - from.load};
  const Real distance = brancher.product(way, from.tangent);
  Tracer<Model> tracer(brancher, {Real(0), Real(0)});
  const bool fold = event.kind == EventKind::fold;
  const auto measure = [&](const BranchPoint<Real>& at) {
    return fold ? at.tangent.load : at.stiffness_rate;
  };
  for (const Real& reach : {Real(distance * Real(5) / Real(4)), Real(distance * Real(2))}) {
    const auto beyond = brancher.step(from, reach);
    if (!beyond || (measure(from) > Real(0)) == (measure(*beyond) > Real(0))) continue;
    result.point = fold ? tracer.fold(from, reach) : tracer.stationary_stiffness(from, reach);
    return result;
  }
  throw lost();
}

}  // namespace plumbline
