#pragma once
/// \file
/// Events of a branch to more digits: a branch is followed in one number type, what happens on it is located
/// in another.
///
/// \code{.cpp}
/// // The quasi-buckling point of the paper's Z-chain: followed in doubles, located to 50 digits.
/// const auto push = [](const auto& chain) {
///   using Real = std::remove_cvref_t<decltype(chain.length()[0])>;
///   return Loading<Real>{Control::end_point, end_point(chain, chain.rest()), {Real(-1), Real(0)}};
/// };
/// const Chain<Rational> exact({1, 1, 1, 1}, {1, 1, 1, 1},
///                             {Rational("-2417/10000"), Rational("6821/10000"), Rational("-7958/10000"),
///                              Rational("517/1000")});
/// const NominalModel<double> model(from_rational<double>(exact));
/// Brancher<NominalModel<double>> low(model, push(model.chain()), absolute_angles(model.chain().rest()));
/// const auto start = low.start(0, absolute_angles(model.chain().rest()));
/// const auto branch = Tracer<NominalModel<double>>(low, {.from = 0, .to = 1.5}).run(start);
///
/// const NominalModel<Mpfr50> wide(from_rational<Mpfr50>(exact));
/// Brancher<NominalModel<Mpfr50>> high(wide, push(wide.chain()), absolute_angles(wide.chain().rest()));
/// const auto event = sharpen(high, branch.events.at(0));
/// assert(abs(event.point.load - Mpfr50(branch.events[0].point.load)) < Mpfr50("1e-9"));
/// \endcode

#include <plumbline/branch/bifurcation.hpp>
#include <plumbline/branch/branch_event.hpp>

namespace plumbline {

/// A variation in a wider number type.
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
BranchEvent<typename Model::Real> sharpen(Brancher<Model>& brancher, const BranchEvent<Low>& event) {
  using Real = typename Model::Real;
  using std::abs, std::sqrt;
  const auto lost = [] { return Error("branch", "an event that more digits do not show", "an event"); };
  BranchEvent<Real> result{event.kind, event.before, lift<Real>(event.point), {}};
  if (event.kind == EventKind::bifurcation) {
    auto found = detail::BifurcationSolver<Model>(brancher).near(result.point, lift<Real>(event.crossing));
    if (!found || !found->simple()) throw lost();
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
  // the doubles are off by their rounding, times the condition of the event
  const Real near = sqrt(Real(std::numeric_limits<Low>::epsilon()));
  const auto point = brancher.onto(result.point, near);
  auto located = point ? locate(brancher, event.kind, *point) : std::nullopt;
  if (!located) throw lost();
  result.point = std::move(*located);
  result.point.negative_directions = event.point.negative_directions;
  return result;
}

}  // namespace plumbline
