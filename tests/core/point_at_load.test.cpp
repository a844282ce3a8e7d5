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
