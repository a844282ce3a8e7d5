#include <plumbline/space/bent_branch.hpp>

#include <plumbline/loaded/equilibrium.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <plumbline/straight/critical_force.hpp>

#include "tests/property.hpp"

using namespace plumbline;

namespace {

double random_number() {
  return random_hundredths(-2, 2) + 0.005;
}

/// Two to four links, joints of one to three axes anyhow, forces, springs and what is held.
BentStructure<double> random_structure() {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(2, 5));
  std::vector<double> length;
  std::vector<SpaceJoint<double>> joints(n);
  for (SpaceJoint<double>& joint : joints) {
    length.push_back(random_hundredths(1, 3));
    for (int axes = *rc::gen::inRange(1, 4); axes > 0; --axes)
      joint.axes.push_back(
          {{random_number(), random_number(), random_number()}, random_hundredths(0, 3), random_number()});
  }
  SpaceSetting<double> setting;
  setting.holds = {{n, 1, Restraint<double>::held()},
                   {n, 2, Restraint<double>::held()},
                   {1, 1, Restraint<double>::sprung(1.5)},
                   {n, 0, Restraint<double>::sprung(0.75)}};
  setting.forces = {{n, {-1, 0.25, 0.5}, true}, {1, {0.5, -1, 0.25}, false}};
  setting.slides = {{0, 0, Restraint<double>::sprung(2)}};
  setting.directions = {1};
  return BentStructure<double>(SpaceChain<double>(std::move(length), std::move(joints)), std::move(setting));
}

Structure<double> pushed_cantilever(std::size_t n) {
  Structure<double> structure{Chain<double>(std::vector<double>(n, 1.0), std::vector<double>(n, 1.0))};
  structure.end_point = {};
  structure.add_compression();
  return structure;
}

}  // namespace

TEST_CASE("gradient and Hessian of a chain in space are the derivatives of its energy and of what is held") {
  check_property("derivatives", [] {
    const BentStructure<double> model = random_structure();
    Vector<double> x = model.rest(), multiplier(model.held());
    for (double& q : x) q += random_number();
    for (double& m : multiplier) m = random_number();
    const double factor = random_number(), h = 1e-5;
    BentExpansion<double> at, ahead, behind;
    model.expand(x, factor, multiplier, at);
    // central differences err by h^2 of third derivatives, and by rounding over h: forces and angles of order
    // 10
    const double slack = 1e-6;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      Vector<double> more = x, less = x;
      more(i) += h, less(i) -= h;
      model.expand(more, factor, multiplier, ahead);
      model.expand(less, factor, multiplier, behind);
      const double rise = model.potential(more, factor) - multiplier.dot(ahead.held) -
                          model.potential(less, factor) + multiplier.dot(behind.held);
      RC_ASSERT(std::abs(rise / (2 * h) - at.gradient(i)) < slack);
      RC_ASSERT(((ahead.gradient - behind.gradient) / (2 * h) - at.hessian.col(i)).cwiseAbs().maxCoeff() <
                slack);
      RC_ASSERT(((ahead.held - behind.held) / (2 * h) - at.held_gradient.col(i)).cwiseAbs().maxCoeff() <
                slack);
    }
  });
}

TEST_CASE("a planar chain with the end point held is the nominal chain") {
  const std::vector<double> rest{-0.2417, 0.6821, -0.7958, 0.5170};
  const Chain<double> chain({1, 1, 1, 1}, {1, 1, 1, 1}, rest);
  const NominalModel<double> nominal(chain);
  EquilibriumSolver<NominalModel<double>> reference(nominal);
  const auto expected = reference.under_force({-0.8, 0}, absolute_angles(rest));
  Structure<double> structure(chain);
  structure.end_point = {};
  structure.add_compression();
  const auto model = bent_structure(structure);
  BentSolver<double> solver(model);
  const auto found = solver.at_factor(model.rest(), 0.8, Vector<double>(0));
  REQUIRE(found);
  CHECK(found->negative_directions == expected.negative_directions);
  CHECK((absolute_angles(model.angles(found->x)) - expected.theta).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("the straight chain bifurcates at its critical forces, and leaves them stable and forked") {
  const Structure<double> structure = pushed_cantilever(3);
  const auto model = bent_structure(structure);
  const BentLimits<double> limits{0, 4};
  BentTracer<double> tracer(model, limits);
  const auto start = tracer.solver().at_factor(model.rest(), 0, Vector<double>(0));
  REQUIRE(start);
  const auto branch = tracer.run(*start);
  REQUIRE(branch.events.size() == 3);
  const double pi = std::acos(-1.0);
  for (std::size_t m = 0; m < 3; ++m) {
    CHECK(branch.events[m].kind == BentEventKind::bifurcation);
    const double expected = 2 - 2 * std::cos((2 * static_cast<double>(m) + 1) * pi / 7);
    CHECK(branch.events[m].point.factor == doctest::Approx(expected).epsilon(1e-10));
    CHECK(tracer.leave(branch.events[m], 1e-3).size() == 2);
  }
  const auto history = load_slowly(tracer, *start, limits);
  REQUIRE(history.size() == 2);
  CHECK(history[1].points.back().factor == 4);
  CHECK(history[1].points.back().negative_directions == 0);
  CHECK(history[1].points.back().x(0) > 1);
}

TEST_CASE("a single leaning link carries k q / (L sin q)") {
  Structure<double> structure = pushed_cantilever(1);
  const auto model = bent_structure(structure);
  BentSolver<double> solver(model);
  const auto rest = solver.settle(Vector<double>::Constant(1, 0.1), 1.25).value();
  CHECK(rest.x(0) / std::sin(rest.x(0)) == doctest::Approx(1.25).epsilon(1e-12));
}

TEST_CASE("a chain of universal joints in space buckles towards its weaker side") {
  const SpaceJoint<double> universal{{{{0, 0, 1}, 3, 0}, {{0, 1, 0}, 1, 0}}};
  SpaceSetting<double> setting;
  setting.holds = {{3, 1, Restraint<double>::held()}, {3, 2, Restraint<double>::held()}};
  setting.forces = {{3, {-1, 0, 0}, true}};
  const BentStructure<double> model(SpaceChain<double>({1, 1, 1}, {universal, universal, universal}),
                                    setting);
  const double critical = lowest_critical_force(Chain<double>({1, 1, 1}, {1, 1, 1}));
  const BentLimits<double> limits{0, 2 * critical};
  BentTracer<double> tracer(model, limits);
  const auto start = tracer.solver().at_factor(model.rest(), 0, Vector<double>::Constant(2, 0.0));
  REQUIRE(start);
  const auto branch = tracer.run(*start);
  REQUIRE(!branch.events.empty());
  CHECK(branch.events[0].point.factor == doctest::Approx(critical).epsilon(1e-10));
  for (const Eigen::Index stiff : {0, 2, 4}) CHECK(std::abs(branch.events[0].direction(stiff)) < 1e-8);
}

TEST_CASE("an unstable start of slow loading is refused") {
  const auto model = bent_structure(pushed_cantilever(2));
  const BentLimits<double> limits{0, 2};
  BentTracer<double> tracer(model, limits);
  const auto start = tracer.solver().at_factor(model.rest(), 1, Vector<double>(0));
  REQUIRE(start);
  CHECK_THROWS_AS(load_slowly(tracer, *start, limits), Error);
}

TEST_CASE("a passive link under a moment finds no rest, and its path ends there") {
  // the bed turns the last link back with c L^2 sin q cos q = 0.5 at most
  Structure<double> structure(Chain<double>({1, 1}, {0, 0}));
  structure.base.turn = Restraint<double>::held();
  structure.end_point = {{}, Restraint<double>::sprung(1), {}};
  structure.moment = 1;
  const auto model = bent_structure(structure);
  const BentLimits<double> limits{0, 1};
  BentTracer<double> tracer(model, limits);
  const auto history =
      load_slowly(tracer, tracer.solver().at_factor(model.rest(), 0, Vector<double>()).value(), limits);
  REQUIRE(history.size() == 1);
  CHECK(history[0].end == BentEnd::flight);
  // nearer to the fold than a step: the factor there is short of it by the square of the step, 2 / 20^2
  CHECK(history[0].points.back().factor == doctest::Approx(0.5).epsilon(0.005));
  CHECK_FALSE(tracer.solver().settle(model.rest(), 0.6).has_value());
}

TEST_CASE("what a clamped link holds already is held once") {
  Structure<double> structure(Chain<double>({1, 2, 1}, {0, 1, 1}));
  structure.base.turn = Restraint<double>::held();
  structure.end_point = clamped<double>();
  structure.across = {Restraint<double>::held(), Restraint<double>::held()};
  // joint 2 on the first link; the end point on the last, whose near joint is held; its turning stays
  CHECK(implied_across(structure) == std::vector<bool>{false, true, false, true});
  CHECK(bent_structure(structure).held() == 2);
  structure.base.across = {};  // the base slides: joint 2 holds it
  CHECK(implied_across(structure) == std::vector<bool>{false, false, false, true});
  Structure<double> rod(Chain<double>({1}, {0}));
  rod.base.turn = Restraint<double>::held();
  rod.base.along = {};
  rod.end_point = {Restraint<double>::sprung(1), Restraint<double>::held(), Restraint<double>::held()};
  CHECK(bent_structure(rod).held() == 0);
}
