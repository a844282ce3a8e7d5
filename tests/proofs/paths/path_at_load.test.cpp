/// What is said of a path at a load, and of its stiffness across folds.
#include <doctest/doctest.h>

#include <cmath>
#include <plumbline/branch/point_at_load.hpp>
#include <plumbline/branch/slow_loading.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/exact/as_double.hpp"
#include "proofs/paths/certified_path.hpp"

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

using Nominal = NominalModel<double>;

/// Four links that snap: the deflection turns near 1.1424 and again.
const std::vector<Rational> snapping_rest{Rational(6, 10), Rational(-12, 10), Rational(6, 10), 0};

}  // namespace

TEST_CASE("across a fold the stiffness is not finite, and so does not fall all along") {
  const Chain<Interval> chain =
      from_rational<Interval>(Chain<Rational>({1, 1, 1, 1}, {5, 5, 5, 6}, snapping_rest));
  const Loading<Interval> loading{
      Control::end_point, end_point(chain, chain.rest()), {Interval(-1), Interval(0)}};
  const Nominal model(convert<double>(chain, as_double));
  const Vector<double> shape = absolute_angles(model.chain().rest());
  Brancher<Nominal> brancher(
      model, {Control::end_point, {as_double(loading.start.x), as_double(loading.start.y)}, {-1, 0}}, shape);
  const Branch<double> branch = Tracer<Nominal>(brancher, {0, 1.3}).run(brancher.start(0, shape));
  const auto fold = std::find_if(branch.events.begin(), branch.events.end(),
                                 [](const auto& event) { return event.kind == EventKind::fold; });
  REQUIRE(fold != branch.events.end());
  Branch<double> across = branch;
  across.points.resize(std::min(branch.points.size(), fold->before + 4));
  across.end = BranchEnd::load;
  const PathCertificate proved = certify(chain, loading, across);
  REQUIRE(proved.certified());
  CHECK(proved.folds.size() == 1);
  CHECK_FALSE(proved.finite);
  CHECK_FALSE(proved.softens);
  CHECK_FALSE(proved.stiff);
  across.points.resize(fold->before - 1);
  across.events.clear();
  const PathCertificate before = certify(chain, loading, across);
  REQUIRE(before.certified());
  CHECK(before.finite);
}

TEST_CASE("beside a bifurcation the state at a load is that of the branch that the chain is on") {
  // the zigzag of Fig. 8
  const double a = M_PI / 10;
  const Chain<double> chain({1, 1, 1}, {0, 1, 1}, {0, a, -a});
  const Nominal model(chain);
  const Point<double> p = end_point(chain, chain.rest());
  std::vector<double> q = chain.rest();
  q[0] = -std::atan2(p.y, p.x);
  const Vector<double> shape = absolute_angles(q);
  Brancher<Nominal> brancher(model, {Control::end_point, {std::hypot(p.x, p.y), 0}, {-1, 0}}, shape);
  const auto stretches = load_slowly(brancher, brancher.start(0, shape), {0, 0.6});
  REQUIRE(stretches.size() == 2);
  const double critical = stretches[0].points.back().load;
  CHECK(critical == close_to(0.040735331464751).epsilon(1e-9));
  double last = -stretches[0].points.back().force.x;
  for (const double off : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    const auto state = state_at_load(brancher, stretches, critical + off);
    CAPTURE(off);
    REQUIRE(state);
    CHECK(state->load == close_to(critical + off).epsilon(1e-12));
    // on the branch that leaves, the angle off the symmetric shape grows as the root of the load
    const double aside = std::abs(state->theta(0) - stretches[0].points.back().theta(0)) / std::sqrt(off);
    CHECK(aside > 0.3);
    CHECK(aside < 5);
    CHECK(-state->force.x > last);  // the slope is 0.179 from the bifurcation on
    last = -state->force.x;
  }
  const auto near = state_at_load(brancher, stretches, critical + 1e-6),
             far = state_at_load(brancher, stretches, critical + 1e-3);
  REQUIRE((near && far));
  CHECK((near->force.x - far->force.x) / (1e-3 - 1e-6) == close_to(0.17933).epsilon(1e-4));
  const auto before = state_at_load(brancher, stretches, critical - 1e-3);
  REQUIRE(before);
  CHECK(before->negative_directions == 0);
  CHECK_FALSE(state_at_load(brancher, stretches, 0.7));
}
