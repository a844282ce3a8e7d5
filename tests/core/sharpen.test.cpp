#include <doctest/doctest.h>

#include <plumbline/branch/sharpen.hpp>
#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>

using namespace plumbline;

TEST_CASE(
    "a bifurcation in more digits keeps which way the branch goes, and which way the other one crosses") {
  const auto zigzag = [](auto angle) {
    using Real = decltype(angle);
    return NominalModel<Real>(Chain<Real>({1, 1, 1}, {0, 1, 1}, {0, angle, -angle}));
  };
  const auto push = [](const auto& model) {
    using Real = typename std::remove_cvref_t<decltype(model)>::Real;
    using std::atan2, std::sqrt;
    std::vector<Real> q = model.chain().rest();
    const auto p = end_point(model.chain(), q);
    q[0] = -atan2(p.y, p.x);
    const Real span = sqrt(p.x * p.x + p.y * p.y);
    return std::pair{Loading<Real>{Control::end_point, {span, Real(0)}, {Real(-1), Real(0)}},
                     absolute_angles(q)};
  };
  const auto model = zigzag(boost::math::constants::pi<double>() / 10);
  const auto [loading, shape] = push(model);
  Brancher<NominalModel<double>> low(model, loading, shape);
  const auto branch = Tracer<NominalModel<double>>(low, {0, 0.1}).run(low.start(0, shape));
  REQUIRE(branch.events.size() == 1);
  const auto wide = zigzag(Mpfr50(boost::math::constants::pi<Mpfr50>() / 10));
  const auto [wide_loading, wide_shape] = push(wide);
  Brancher<NominalModel<Mpfr50>> high(wide, wide_loading, wide_shape);
  const auto event = sharpen(high, branch.events[0]);
  // The symmetric branch keeps theta_1 = theta_3, and the arches leave it where that alone changes.
  CHECK(abs(event.point.theta(0) - event.point.theta(2)) < Mpfr50("1e-45"));
  CHECK(abs(event.point.tangent.theta(0) - event.point.tangent.theta(2)) < Mpfr50("1e-20"));
  CHECK(abs(event.crossing.theta(0) + event.crossing.theta(2)) < Mpfr50("1e-20"));
  CHECK(abs(event.crossing.theta(1)) < Mpfr50("1e-20"));
  CHECK(event.point.tangent.load > Mpfr50("1e-3"));
}

TEST_CASE("an event that is none in more digits is refused") {
  // one link under a force square to it turns steadily; a straight cantilever crosses, a bent one does not
  const NominalModel<double> straight(Chain<double>({1, 1}, {1, 1}));
  Brancher<NominalModel<double>> low(straight, {Control::force, {0, 0}, {-1, 0}}, Vector<double>::Zero(2));
  const auto branch = Tracer<NominalModel<double>>(low, {0, 1}).run(low.start(0, Vector<double>::Zero(2)));
  REQUIRE(branch.events.size() == 1);
  const char* const refusal = "branch: found an event that more digits do not show, expected an event";
  const auto wide = [](const Mpfr50& rest) {
    return NominalModel<Mpfr50>(Chain<Mpfr50>({1, 1}, {1, 1}, {rest, Mpfr50(0)}));
  };
  const Loading<Mpfr50> push{Control::force, {Mpfr50(0), Mpfr50(0)}, {Mpfr50(-1), Mpfr50(0)}};
  const auto exact = wide(0), bent = wide(Mpfr50("1e-12"));
  const Vector<Mpfr50> shape = Vector<Mpfr50>::Constant(2, Mpfr50(0));
  Brancher<NominalModel<Mpfr50>> crosses(exact, push, shape), passes(bent, push, shape);
  // (3 - sqrt 5) / 2, the lesser eigenvalue of (2 -1; -1 1)
  CHECK(abs(sharpen(crosses, branch.events[0]).point.load - (3 - sqrt(Mpfr50(5))) / 2) < Mpfr50("1e-45"));
  CHECK_THROWS_WITH_AS(sharpen(passes, branch.events[0]), refusal, Error);

  // its load, theta / cos theta, turns back only beyond a quarter turn
  const NominalModel<double> link(Chain<double>({1}, {1}));
  Brancher<NominalModel<double>> aside(link, {Control::force, {0, 0}, {0, 1}}, Vector<double>::Zero(1));
  const auto regular = aside.start(0.1, Vector<double>::Zero(1));
  const NominalModel<Mpfr50> wide_link(Chain<Mpfr50>({1}, {1}));
  Brancher<NominalModel<Mpfr50>> more(wide_link, {Control::force, {0, 0}, {Mpfr50(0), Mpfr50(1)}},
                                      Vector<Mpfr50>::Constant(1, Mpfr50(0)));
  CHECK_THROWS_WITH_AS(sharpen(more, BranchEvent<double>{EventKind::fold, 0, regular, {}}), refusal, Error);
}
