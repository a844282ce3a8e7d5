#include "verify/section3_chains.hpp"

namespace plumbline {

namespace {

using Model = NominalModel<Mpfr50>;

Mpfr50 middle(const Interval& x) {
  return Mpfr50(x.middle());
}

Chain<Interval> unit_chain(const std::vector<int>& ten_thousandths) {
  std::vector<Interval> rest;
  for (const int angle : ten_thousandths) rest.emplace_back(Rational(angle, 10000));
  return Chain<Interval>({1, 1, 1, 1}, {1, 1, 1, 1}, rest);
}

}  // namespace

Interval pi_enclosure() {
  return {Interval::End("3.14159265358979323846264338327950288419716939937510582097494459"),
          Interval::End("3.14159265358979323846264338327950288419716939937510582097494460")};
}

Chain<Interval> three_link_chain_at(const Rational& alpha1_over_pi, const Rational& alpha2_over_pi) {
  const Interval pi = pi_enclosure();
  return Chain<Interval>({1, 1, 1}, {0, 1, 1},
                         {0, Interval(alpha1_over_pi) * pi, Interval(alpha2_over_pi) * pi});
}

Interval unloaded_reach(const Chain<Interval>& chain) {
  const Point<Interval> p = end_point(chain, chain.rest());
  return sqrt(sqr(p.x) + sqr(p.y));
}

Chain<Interval> u_shaped_chain() {
  return unit_chain({-3179, 558, 3804, 3524});
}
Chain<Interval> z_shaped_chain() {
  return unit_chain({-2417, 6821, -7958, 5170});
}

ZigzagBuckling zigzag_buckling() {
  const Chain<Interval> exact = three_link_chain_at(Rational(1, 10), Rational(-1, 10));
  const Model model(convert<Mpfr50>(exact, middle));
  std::vector<Mpfr50> q = model.chain().rest();
  const Point<Mpfr50> p = end_point(model.chain(), q);
  q[0] = -atan2(p.y, p.x);
  const Vector<Mpfr50> shape = absolute_angles(q);
  Brancher<Model> brancher(model, {Control::end_point, {middle(unloaded_reach(exact)), Mpfr50(0)}, {-1, 0}},
                           shape);
  const auto branch = Tracer<Model>(brancher, {Mpfr50(0), Mpfr50(1) / 10}).run(brancher.start(0, shape));
  if (branch.events.size() != 1 || branch.events[0].kind != EventKind::bifurcation)
    throw Error("Fig. 8", std::to_string(branch.events.size()) + " events up to 0.1 L", "one bifurcation");
  ZigzagBuckling found{branch.events[0].point, true};
  BranchPoint<Mpfr50> at = found.point;
  at.tangent = branch.events[0].crossing;
  for (const int side : {1, -1}) {
    const auto off = brancher.step(at, Mpfr50(side) / 100);
    found.continuous = found.continuous && off && off->negative_directions == 0 && off->load > at.load;
  }
  return found;
}

QuasiBuckling quasi_buckling(const Chain<Interval>& chain) {
  const Model model(convert<Mpfr50>(chain, middle));
  const Vector<Mpfr50> shape = absolute_angles(model.chain().rest());
  Brancher<Model> brancher(model, {Control::end_point, {Mpfr50(19) / 5, Mpfr50(0)}, {-1, 0}}, shape);
  const auto branch = Tracer<Model>(brancher, {Mpfr50(0), Mpfr50(3) / 2}).run(brancher.start(0, shape));
  QuasiBuckling found{
      {}, branch.points.front().stiffness, branch.points.back().stiffness, branch.end == BranchEnd::load};
  for (const auto& point : branch.points) found.stable = found.stable && point.negative_directions == 0;
  for (const auto& event : branch.events) {
    if (event.kind == EventKind::quasi_buckling) found.points.push_back(event.point);
  }
  return found;
}

}  // namespace plumbline
