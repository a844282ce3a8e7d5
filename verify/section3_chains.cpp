#include "verify/section3_chains.hpp"

#include <fmt/core.h>

#include <boost/math/tools/roots.hpp>
#include <plumbline/slow_loading.hpp>

#include "proofs/exactly.hpp"
#include "verify/sign.hpp"

namespace plumbline {

namespace {

Chain<Interval> unit_chain(const std::vector<int>& ten_thousandths) {
  std::vector<Interval> rest;
  for (const int angle : ten_thousandths) rest.emplace_back(Rational(angle, 10000));
  return Chain<Interval>({1, 1, 1, 1}, {1, 1, 1, 1}, rest);
}

Located middle(const Interval& x) {
  return x.middle();
}

template <Floating Real>
Loading<Real> inwards(const Real& reach) {
  return {Control::end_point, {reach, Real(0)}, {Real(-1), Real(0)}};
}

/// The chain turned so that its unloaded end point lies on the x axis; possible with a passive base.
Vector<double> unloaded_shape(const Chain<double>& chain) {
  std::vector<double> q = chain.rest();
  if (chain.passive_joint(0)) {
    const Point<double> p = end_point(chain, q);
    q[0] -= std::atan2(p.y, p.x);
  }
  return absolute_angles(q);
}

}  // namespace

Chain<Interval> three_link_chain_at(const Rational& alpha1_over_pi, const Rational& alpha2_over_pi) {
  return Chain<Interval>(
      {1, 1, 1}, {0, 1, 1},
      {0, Interval(alpha1_over_pi) * Interval::pi(), Interval(alpha2_over_pi) * Interval::pi()});
}

Chain<Interval> fig7_chain() {
  return three_link_chain_at(Rational(-1, 4), Rational(-1, 3));
}
Chain<Interval> fig8_chain() {
  return three_link_chain_at(Rational(1, 10), Rational(-1, 10));
}

Chain<Interval> u_shaped_chain() {
  return unit_chain({-3179, 558, 3804, 3524});
}
Chain<Interval> z_shaped_chain() {
  return unit_chain({-2417, 6821, -7958, 5170});
}

Interval unloaded_reach(const Chain<Interval>& chain) {
  const Point<Interval> p = end_point(chain, chain.rest());
  return sqrt(sqr(p.x) + sqr(p.y));
}
Interval table_1_reach() {
  return Interval(Rational(19, 5));
}

Census held_at(const Chain<Interval>& chain, const Interval& x) {
  Census census = census_at_end_point(chain, {x, Interval(0)});
  if (!census.complete()) throw Error("census", "undecided boxes", "a regular deflection");
  return census;
}

std::string types(const Census& census) {
  std::size_t stable = 0;
  for (const auto& one : census.equilibria) stable += one.negative_directions.value() == 0 ? 1 : 0;
  return fmt::format("{} stable, {} unstable", stable, census.equilibria.size() - stable);
}

std::string extrema(const Census& census, int sign_of_q4) {
  std::size_t count[3] = {0, 0, 0};
  for (const auto& one : census.equilibria) {
    const char q4 = sign_character(sin(one.q.at(3)));
    if (q4 == '0') throw Error("census", "an open sign of q4", "a certain one");
    if (sign_of_q4 == 0 || (q4 == '+') == (sign_of_q4 > 0)) ++count[one.negative_directions.value()];
  }
  return fmt::format("{} minima, {} saddles, {} maxima", count[0], count[1], count[2]);
}

std::string signs(const CertifiedEquilibrium& one, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < one.q.size(); ++i) text += sign_character(one.q[i]);
  return text;
}

std::string letter(const CertifiedEquilibrium& one) {
  const std::string bends = signs(one, 1);
  return bends == "--" ? "U+" : bends == "++" ? "U-" : bends == "+-" ? "Z-" : bends == "-+" ? "Z+" : bends;
}

std::vector<BranchEvent<Located>> SlowPath::of_kind(EventKind kind) const {
  std::vector<BranchEvent<Located>> found;
  for (const auto& event : events) {
    if (event.kind == kind) found.push_back(event);
  }
  return found;
}

bool SlowPath::regular() const {
  return stretches.size() == 1 && stretches[0].end == BranchEnd::load &&
         of_kind(EventKind::quasi_buckling).size() == events.size();
}

BranchPoint<Located> SlowPath::at(const Rational& deflection) const {
  const auto load = from_rational<double>(deflection);
  const BranchPoint<double>* nearest = &stretches[0].points[0];
  for (const Branch<double>& stretch : stretches) {
    for (const BranchPoint<double>& point : stretch.points) {
      if (std::abs(point.load - load) < std::abs(nearest->load - load)) nearest = &point;
    }
  }
  return locate_at(chain, loading, *nearest, from_rational<Located>(deflection));
}

SlowPath compress_slowly(const Chain<Interval>& chain, const Interval& reach, double last, int side) {
  using Model = NominalModel<double>;
  const auto rounded = [](const Interval& x) { return static_cast<double>(x.middle()); };
  const Model model(convert<double>(chain, rounded));
  const Vector<double> shape = unloaded_shape(model.chain());
  Brancher<Model> brancher(model, inwards(rounded(reach)), shape);
  SlowPath path{convert<Located>(chain, middle), inwards(middle(reach)), {}, {}};
  path.stretches = load_slowly(brancher, brancher.start(0, shape), {0, last}, side);
  for (const Branch<double>& stretch : path.stretches) {
    for (auto& event : locate_events(path.chain, path.loading, stretch))
      path.events.push_back(std::move(event));
  }
  return path;
}

CertifiedEquilibrium reached(const Census& census, const SlowPath& path, const Rational& deflection) {
  const std::vector<Located> q = joint_angles(path.at(deflection).theta);
  for (const CertifiedEquilibrium& one : census.equilibria) {
    bool same = true;
    for (std::size_t i = 0; i < q.size() && same; ++i)
      same = abs(one.q[i].middle() - q[i]) < Located("1e-20");
    if (same) return one;
  }
  throw Error("census", "no equilibrium of the path", "every state that the chain can have");
}

Located straightens_at(const SlowPath& path, std::size_t joint, const Rational& from, const Rational& to) {
  const auto angle = [&](const Located& load) { return joint_angles(path.at(exactly(load)).theta)[joint]; };
  const auto low = from_rational<Located>(from), high = from_rational<Located>(to);
  std::uintmax_t evaluations = 100;
  const auto close = [](const Located& a, const Located& b) { return abs(b - a) < Located("1e-58"); };
  const auto [a, b] = boost::math::tools::toms748_solve(angle, low, high, close, evaluations);
  return (a + b) / 2;
}

bool leaves_continuously(const SlowPath& path, const BranchEvent<Located>& bifurcation) {
  const NominalModel<Located> model(path.chain);
  Brancher<NominalModel<Located>> brancher(model, path.loading, absolute_angles(path.chain.rest()));
  BranchPoint<Located> at = bifurcation.point;
  at.tangent = bifurcation.crossing;
  bool both = true;
  for (const int side : {1, -1}) {
    const auto off = brancher.step(at, Located(side) / 100);
    both = both && off && off->negative_directions == 0 && off->load > at.load;
  }
  return both;
}

}  // namespace plumbline
