#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <plumbline/branch/point_at_load.hpp>
#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

using namespace plumbline;

TEST_CASE(
    "the point of a branch at any load is in balance, between its neighbours, and none beyond its ends") {
  using Nominal = NominalModel<double>;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto some = [&](double from, double to) { return from + (to - from) * unit(random); };
    const Nominal model(Chain<double>({some(0.5, 2), some(0.5, 2), some(0.5, 2)},
                                      {some(0.5, 2), some(0.5, 2), some(0.5, 2)},
                                      {some(-1, 1), some(-1, 1), some(-1, 1)}));
    const auto shape = absolute_angles(model.chain().rest());
    const double way = some(-3, 3);
    Brancher<Nominal> brancher(model, {Control::force, {0, 0}, {std::cos(way), std::sin(way)}}, shape);
    const auto branch = Tracer<Nominal>(brancher, {0, 1}).run(brancher.start(0, shape));
    REQUIRE(branch.points.size() > 2);
    const auto& first = branch.points.front();
    const auto& second = branch.points[1];
    CHECK_FALSE(point_at_load(brancher, branch, -1e-3));
    const double load = some(first.load, second.load);
    CAPTURE(load);
    const auto point = point_at_load(brancher, branch, load);
    REQUIRE(point);
    // four roundings of the load are asked for, and a force of one rounds its own balance by as much
    CHECK(std::abs(point->load - load) < 8 * std::numeric_limits<double>::epsilon());
    Expansion<double, 1> at;
    model.expand(point->theta, point->force, at);
    CHECK(at.residual.cwiseAbs().maxCoeff() < 1e-13);
    const double whole = (second.theta - first.theta).norm();
    CHECK((point->theta - first.theta).norm() < 1.01 * whole);
    CHECK((point->theta - second.theta).norm() < 1.01 * whole);
  }
}

TEST_CASE("in fifty digits a point has the load to fifty digits, zero too") {
  using Exact = NominalModel<Mpfr50>;
  const Exact model(Chain<Mpfr50>({1, 2}, {2, 1}, {Mpfr50("0.3"), Mpfr50("-0.5")}));
  const Vector<Mpfr50> shape = absolute_angles(model.chain().rest());
  Brancher<Exact> brancher(model, {Control::force, {0, 0}, {0, 1}}, shape);
  const auto branch = Tracer<Exact>(brancher, {Mpfr50(-1) / 10, Mpfr50(1) / 10, 1})
                          .run(brancher.start(Mpfr50(-1) / 10, shape));
  REQUIRE(branch.points.back().load == Mpfr50(1) / 10);
  for (const Mpfr50& load : {Mpfr50("0.05432"), Mpfr50("-0.05432"), Mpfr50(0)}) {
    CAPTURE(load);
    const auto point = point_at_load(brancher, branch, load);
    REQUIRE(point);
    // a load of a tenth and angles of one, each rounded
    CHECK(abs(point->load - load) < 8 * epsilon<Mpfr50>());
    Expansion<Mpfr50, 1> at;
    model.expand(point->theta, {Mpfr50(0), load}, at);
    CHECK(at.residual.cwiseAbs().maxCoeff() < Mpfr50("1e-48"));
  }
}

TEST_CASE("the state at a load is on the stretch that holds it, and between two stretches where one leaves") {
  using Nominal = NominalModel<double>;
  const Nominal model(Chain<double>({1, 0.8, 1.2}, {1, 2, 1}, {0.3, -0.5, 0.4}));
  const auto shape = absolute_angles(model.chain().rest());
  Brancher<Nominal> brancher(model, {Control::force, {0, 0}, {0, 1}}, shape);
  const auto whole = Tracer<Nominal>(brancher, {0, 0.5, 0.02}).run(brancher.start(0, shape));
  REQUIRE(whole.points.size() > 6);
  // the branch cut in two, one point left out between
  const auto piece = [&](auto first, auto last) {
    return Branch<double>{std::vector<BranchPoint<double>>(first, last), {}, BranchEnd::load};
  };
  const auto begin = whole.points.begin();
  std::vector<Branch<double>> stretches{piece(begin, begin + 3), piece(begin + 4, whole.points.end())};
  const auto load = [&](std::size_t i) { return whole.points[i].load; };
  const auto agrees = [&](double at) {
    const auto state = state_at_load(brancher, stretches, at), expected = point_at_load(brancher, whole, at);
    REQUIRE(state);
    REQUIRE(expected);
    CHECK(std::abs(state->load - at) < 8 * std::numeric_limits<double>::epsilon());
    CHECK((state->theta - expected->theta).norm() < 1e-13);  // some roundings of a turn of less than one
  };
  for (const double at : {(load(0) + load(1)) / 2, load(2), (load(2) + load(4)) / 2, (load(4) + load(5)) / 2})
    agrees(at);
  const auto& last = stretches[0].points.back();
  stretches[0].events.push_back({EventKind::bifurcation, 2, last, {}});
  agrees((load(2) + load(4)) / 2);
  CHECK_FALSE(state_at_load(brancher, stretches, load(0) - 1e-3));
  CHECK_FALSE(state_at_load(brancher, stretches, whole.points.back().load + 1e-3));
}
