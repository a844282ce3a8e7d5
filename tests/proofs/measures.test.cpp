#include "proofs/measures.hpp"

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
