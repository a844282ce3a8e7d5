#include "proofs/paths/measures.hpp"

#include <doctest/doctest.h>

#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

using Model = NominalModel<double>;

/// That a point is an equilibrium at its load, and says right what it is.
void check_balance(const Model& model, const Loading<double>& loading, const BranchPoint<double>& point) {
  const auto largest = [](const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); };
  const double length = largest(model.chain().length()), stiffness = largest(model.chain().stiffness());
  Expansion<double, 1> at;
  model.expand(point.theta, point.force, at);
  constexpr double rounding =
      1e-12;  // of some dozen operations on numbers of the size of these, and Newton's last step
  CHECK(at.residual.cwiseAbs().maxCoeff() < rounding * stiffness);
  CHECK(std::abs(at.end_point.x - point.end_point.x) < rounding * length);
  CHECK(std::abs(at.end_point.y - point.end_point.y) < rounding * length);
  CHECK(std::abs(at.energy - point.energy) < rounding * stiffness);
  const Point<double> imposed = loading.at(point.load);
  const bool held = loading.control == Control::end_point;
  const Point<double>& found = held ? point.end_point : point.force;
  const double unit = held ? length : stiffness / length;
  CHECK(std::abs(found.x - imposed.x) < rounding * unit);
  CHECK(std::abs(found.y - imposed.y) < rounding * unit);
}

}  // namespace

TEST_CASE("a branch and its events in other units are in balance there, held and under a force") {
  const Chain<double> chain({1, 1, 1, 1}, {5, 5, 5, 6}, {0.6, -1.2, 0.6, 0});
  const auto shape = absolute_angles(chain.rest());
  const Model model(chain);
  const Measures units{std::ldexp(1, -64), std::ldexp(1, 32)};
  const Model scaled(measured(chain, units));
  CHECK(scaled.chain().length()[0] == std::ldexp(1, 64));
  for (const Control control : {Control::end_point, Control::force}) {
    Loading<double> loading{control, {0, 0}, {-1, 0}};
    if (control == Control::end_point) loading.start = end_point(chain, chain.rest());
    Brancher<Model> brancher(model, loading, shape);
    const auto branch = Tracer<Model>(brancher, {0, 2.3}).run(brancher.start(0, shape));
    REQUIRE(branch.points.size() > 2);
    REQUIRE((control == Control::force || !branch.events.empty()));
    const auto there = measured(branch, units, control);
    const auto load = measured(loading, units);
    for (const auto& point : there.points) check_balance(scaled, load, point);
    for (const auto& event : there.events) check_balance(scaled, load, event.point);
    // the stiffness, and how the force changes with the load, are quotients of what is measured
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const auto &here = branch.points[i], &other = there.points[i];
      CHECK(other.stiffness == here.stiffness / (units.force() / units.length));
      CHECK(other.tangent.force.x == here.tangent.force.x / units.force());
      CHECK(other.tangent.load == here.tangent.load / units.load(control));
    }
  }
}

TEST_CASE("every quantity of a branch is divided by its own unit") {
  const Measures units{8, 4};  // forces in 1/2, stiffnesses along the load in 1/16
  CHECK(units.force() == 0.5);
  CHECK(units.load(Control::end_point) == 8);
  CHECK(units.load(Control::force) == 0.5);
  CHECK(units.inverse().length == 0.125);
  CHECK(units.inverse().stiffness == 0.25);
  BranchPoint<double> point{};
  point.load = 1, point.theta = Vector<double>::Constant(2, 3), point.force = {5, 7},
  point.end_point = {11, 13};
  point.energy = 17, point.stiffness = 19, point.negative_directions = 1;
  point.tangent = {Vector<double>::Constant(2, 23), {29, 31}, 37};
  Branch<double> branch{
      {point}, {{EventKind::bifurcation, 0, point, {point.theta, {41, 43}, 47}}}, BranchEnd::load};
  for (const Control control : {Control::end_point, Control::force}) {
    const double load = control == Control::end_point ? 8 : 0.5;
    const Branch<double> there = measured(branch, units, control);
    for (const BranchPoint<double>& one : {there.points.at(0), there.events.at(0).point}) {
      CHECK(one.load == 1 / load);
      CHECK(one.theta == point.theta);
      CHECK(one.force.x == 10);
      CHECK(one.force.y == 14);
      CHECK(one.end_point.x == 11.0 / 8);
      CHECK(one.end_point.y == 13.0 / 8);
      CHECK(one.energy == 17.0 / 4);
      CHECK(one.stiffness == 19 * 16);
      CHECK(one.negative_directions == 1);
      CHECK(one.tangent.theta == point.tangent.theta);
      CHECK(one.tangent.force.x == 58);
      CHECK(one.tangent.force.y == 62);
      CHECK(one.tangent.load == 37 / load);
    }
    const Variation<double>& crossing = there.events[0].crossing;
    CHECK(crossing.theta == point.theta);
    CHECK(crossing.force.x == 82);
    CHECK(crossing.force.y == 86);
    CHECK(crossing.load == 47 / load);
  }
}

TEST_CASE(
    "units are powers of two^32 near the longest link and the stiffest joint, and none where doubles end") {
  const auto of = [](const std::vector<double>& length, const std::vector<double>& stiffness) {
    return measures_of(Chain<double>(length, stiffness));
  };
  CHECK(of({1, 2}, {0, 3}).length == 1);
  CHECK(of({0x1p-17, 0x1p15}, {0x1p15, 0x1p-40}).length == 1);
  CHECK(of({1, 0x1p17}, {1, 0x1p15}).length == 0x1p32);
  CHECK(of({0x1p-17, 0x1p-80}, {1, 1}).length == 0x1p-32);
  CHECK(of({1, 1}, {0x1p-65, 0}).stiffness == 0x1p-64);
  CHECK(of({1, 1}, {0, 0}).stiffness == 1);
  CHECK(of({0x1p384}, {0x1p800}).force() == 0x1p416);
  // a length, a stiffness, a force, and a force over a length
  CHECK_THROWS_AS(of({1e290}, {1e290}), Error);
  CHECK_THROWS_AS(of({1}, {1e290}), Error);
  CHECK_THROWS_AS(of({1e200}, {1e-200}), Error);
  CHECK_THROWS_AS(of({1e-200}, {1e200}), Error);
  CHECK_THROWS_AS(of({1e-100}, {1e150}), Error);
  CHECK_THROWS_AS(of({1e100}, {1e-150}), Error);
}

TEST_CASE(
    "without units the longest link and the stiffest joint are one, and loads are shares of what they make") {
  const Chain<Interval> chain({2, 4}, {6, 3}, {1, 2});
  const auto number = [](const Interval& x) {
    CHECK(x.width() < 1e-30);
    return static_cast<double>(x.middle());
  };
  CHECK(load_unit(chain, Control::end_point) == 4);
  CHECK(load_unit(chain, Control::force) == 1.5);
  for (const Control control : {Control::end_point, Control::force}) {
    const double unit = control == Control::end_point ? 4 : 1.5;
    const auto [bare, loading] = without_units(chain, {control, {3, 6}, {5, 7}});
    CHECK(loading.control == control);
    CHECK(number(bare.length()[0]) == 0.5);
    CHECK(number(bare.length()[1]) == 1);
    CHECK(number(bare.stiffness()[0]) == 1);
    CHECK(number(bare.stiffness()[1]) == 0.5);
    CHECK(number(bare.rest()[1]) == 2);
    CHECK(number(loading.start.x) == 3 / unit);
    CHECK(number(loading.start.y) == 6 / unit);
    CHECK(number(loading.direction.x) == 5);
    CHECK(number(loading.direction.y) == 7);
  }
}
