#include "proofs/paths/certified_path.hpp"

#include <plumbline/branch/branch_tree.hpp>
#include <plumbline/branch/slow_loading.hpp>

#include "proofs/census/census.hpp"
#include "proofs/exact/inertia.hpp"
#include "proofs/paths/located_event.hpp"
#include "proofs/paths/regular_tube.hpp"
#include "tests/proofs/loaded.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using namespace plumbline::proofs::test;

namespace {

constexpr double critical_deflection =
    0.040735331464751;  // of the symmetric zigzag; see tests/core/trace.test.cpp

}  // namespace

TEST_CASE("the number of negative eigenvalues is certain or not given") {
  Matrix<Span> K = Matrix<Span>::Constant(3, 3, Span(1));
  K(0, 0) = Span(2);
  K(1, 1) = Span(-1);
  K(2, 2) = Span(3);
  // determinant 2 (-3 - 1) - (3 - 1) + (1 + 1) = -8: one eigenvalue is negative or three are; the trace is 4
  CHECK(negative_eigenvalues(K) == 1);
  K(2, 2) = Span(0, 3);  // with 0: determinant 2 (0 - 1) - (0 - 1) + 2 = 1, so there are two or none
  CHECK_FALSE(negative_eigenvalues(K));
  CHECK_FALSE(negative_eigenvalues(Matrix<Span>::Constant(2, 2, Span(1))));
}

TEST_CASE("a tube holds the branch to fifty digits, and its tangent") {
  Loaded z = z_chain();
  const Branch<double> branch = z.follow(1);
  BranchEquations equations(z.chain, z.loading);
  const auto exact = [](const Interval& x) { return x.middle(); };
  const auto chain = convert<Located>(z.chain, exact);
  const Loading<Located> loading{
      Control::end_point, {exact(z.loading.start.x), Located(0)}, {Located(-1), Located(0)}};
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    const BranchPoint<double>&a = branch.points[i - 1], &b = branch.points[i];
    CAPTURE(a.load);
    const Vector<Span> from = equations.at(a), to = equations.at(b);
    Vector<Span> normal = to - from;
    normal(4) = normal(5) = Span(0);  // a plane without the force
    for (Span& x : normal) x = Span(x.middle());
    const auto tube = tube_along(equations, from, to, normal);
    if (i < 3) REQUIRE(tube);
    if (!tube) continue;
    const Vector<Span> directions = tangent(*tube);
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
      const Located load = Located(a.load) + Located(share) * (Located(b.load) - Located(a.load));
      const BranchPoint<Located> point = locate_at(chain, loading, share < 0.5 ? a : b, load);
      const auto unknowns = [](const auto& theta, const auto& force, const auto& l) {
        Vector<Located> u(7);
        u << theta.template cast<Located>(), Located(force.x), Located(force.y), Located(l);
        return u;
      };
      const Vector<Located> u = unknowns(point.theta, point.force, point.load),
                            first = unknowns(a.theta, a.force, a.load),
                            chord = unknowns(b.theta, b.force, b.load) - first,
                            t = unknowns(point.tangent.theta, point.tangent.force, point.tangent.load);
      Vector<Located> n(7);
      for (Eigen::Index j = 0; j < 7; ++j) n(j) = Located(normal(j).low);
      const Located s = n.dot(u - first) / n.dot(chord);
      if (s < 0 || s > 1) continue;
      const Vector<Located> off = u - first - s * chord;
      for (Eigen::Index j = 0; j < 7; ++j) {
        CHECK(abs(off(j)) <= Located(tube->image(j)));
        const Located slope = t(j) / n.dot(t);
        CHECK(Located(directions(j).low) <= slope);
        CHECK(slope <= Located(directions(j).high));
      }
    }
  }
}

TEST_CASE("paths without an event are one smooth stable branch") {
  const auto regular = [](Loaded loaded, double to) {
    const Branch<double> branch = loaded.follow(to);
    REQUIRE(branch.end == BranchEnd::load);
    const PathCertificate proved = loaded.certificate(branch);
    CAPTURE(proved.failure);
    CHECK(proved.regular());
    CHECK(proved.runs.at(0).from == 0);
    CHECK(proved.runs.at(0).to == to);
    CHECK(proved.segments + 1 >= branch.points.size());
    CHECK(proved.distance < 1e-10);
    // the sign of the stiffness is that of every point, in double precision
    const bool stiff = std::all_of(branch.points.begin(), branch.points.end(),
                                   [](const BranchPoint<double>& p) { return p.stiffness > 0; });
    CHECK(proved.stiff == stiff);
  };
  regular(z_chain(), 1.5);
  regular(zigzag(1e-3), 1);
  regular(zigzag(-1e-6), 1);
  regular(compressed(Chain<Interval>({1, 2}, {3, 1}, {decimal(3, 10), decimal(-8, 10)})), 1);
  regular(compressed(Chain<Interval>(std::vector<Interval>(8, Interval(1)), {1, 2, 1, 2, 1, 2, 1, 2},
                                     {decimal(1, 10), decimal(-2, 10), decimal(3, 10), decimal(-1, 10),
                                      decimal(2, 10), decimal(1, 10), decimal(-3, 10), decimal(2, 10)})),
          3);
  const Chain<Interval> bent({1, 1, 1}, {1, 1, 1}, {decimal(1, 10), decimal(2, 10), decimal(1, 10)});
  regular(
      {bent, {Control::force, {Interval(0), Interval(0)}, {decimal(-8, 10), decimal(6, 10)}}, rest_of(bent)},
      1);
}

TEST_CASE("a fold is enclosed, with the types on both sides") {
  // as in tests/core/trace.test.cpp: load = (1.2 sin theta - theta) / cos theta turns where
  // 1.2 - cos theta = theta sin theta
  Loaded link = one_link();
  const Branch<double> branch =
      Tracer<Nominal>(link.brancher, {-2, 2}).run(link.brancher.start(0, link.shape));
  const PathCertificate proved = link.certificate(branch);
  CAPTURE(proved.failure);
  REQUIRE(proved.certified());
  REQUIRE(proved.folds.size() == 2);
  REQUIRE(proved.runs.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(proved.runs[i].negative_directions == (i == 1 ? 1 : 0));
  const double theta =
      boost::math::tools::bisect([](double t) { return 1.2 - std::cos(t) - t * std::sin(t); }, 0.3, 1.2,
                                 [](double a, double b) { return b - a < 1e-15; })
          .first;
  const double load = (1.2 * std::sin(theta) - theta) / std::cos(theta);
  CHECK(proved.folds[0].contains(load));
  CHECK(proved.folds[1].contains(-load));
  CHECK_FALSE(proved.regular());
  CHECK_FALSE(proved.stiff);

  // a stretch of the slowly loaded chain ends in the fold: that it is one is proved, too
  const auto history = load_slowly(link.brancher, link.brancher.start(0, link.shape), {-2, 2});
  const PathCertificate snapped = link.certificate(history.at(0));
  REQUIRE(snapped.certified());
  REQUIRE(snapped.folds.size() == 1);
  CHECK(snapped.folds[0].contains(load));
  CHECK(snapped.runs.at(0).negative_directions == 0);
  CHECK(snapped.runs.at(1).negative_directions == 1);
  CHECK(link.certificate(history.at(1)).regular());
}

TEST_CASE("a bifurcation is left out, and said to be; without its event it is refused") {
  Loaded exact = zigzag(0);
  Branch<double> branch = exact.follow(1);
  REQUIRE(branch.events.size() >= 1);
  const PathCertificate proved = exact.certificate(branch);
  CAPTURE(proved.failure);
  REQUIRE(proved.certified());
  CHECK_FALSE(proved.regular());
  REQUIRE(proved.gaps.size() == 1);
  CHECK(proved.gaps[0].loads.contains(critical_deflection));
  CHECK(proved.gaps[0].loads.width() < 1e-4);
  REQUIRE(proved.runs.size() == 2);
  CHECK(proved.runs[0].negative_directions == 0);
  CHECK(proved.runs[1].negative_directions == 1);

  std::erase_if(branch.points,
                [](const BranchPoint<double>& p) { return std::abs(p.load - critical_deflection) < 1e-9; });
  branch.events.clear();
  const PathCertificate refused = exact.certificate(branch);
  REQUIRE(refused.failed_at);
  CHECK(refused.failed_at->low < critical_deflection + 1e-6);
  CHECK(refused.failed_at->high > critical_deflection - 1e-6);
}

TEST_CASE("points of two branches are not one") {
  // just off symmetry two branches pass each other at a distance of about 1e-6^(1/3): the stable one bends
  // away where the other, unstable, seems to go straight on
  Loaded near = zigzag(1e-6), exact = zigzag(0);
  const Branch<double> stable = near.follow(1), symmetric = exact.follow(1);
  Branch<double> joined{{}, {}, BranchEnd::load};
  for (const auto& point : stable.points) {
    if (point.load < critical_deflection - 1e-4) joined.points.push_back(point);
  }
  REQUIRE(joined.points.size() > 3);
  CHECK(near.certificate(joined).regular());
  for (const auto& point : symmetric.points) {
    if (point.load > critical_deflection + 1e-3)
      joined.points.push_back(near.brancher.start(point.load, point.theta, point.force));
  }
  REQUIRE(joined.points.back().negative_directions == 1);
  const PathCertificate refused = near.certificate(joined);
  REQUIRE(refused.failed_at);
  CHECK(refused.failed_at->low > critical_deflection - 1e-3);
  CHECK(refused.failed_at->high < critical_deflection + 2e-3);

  // the mirrored shape at the same load, at one point of the stable branch
  Branch<double> jumping = stable;
  BranchPoint<double>& moved = jumping.points[jumping.points.size() / 2];
  const Vector<double> mirrored = moved.theta.reverse();  // turned by half a turn and read backwards
  moved = near.brancher.start(moved.load, mirrored, moved.force);
  REQUIRE((moved.theta - mirrored).cwiseAbs().maxCoeff() < 1e-3);
  CHECK_FALSE(near.certificate(jumping).certified());
}

TEST_CASE("a point alone shows no branch") {
  Loaded z = z_chain();
  Branch<double> branch = z.follow(1);
  branch.points.resize(1);
  CHECK_FALSE(z.certificate(branch).certified());
}

TEST_CASE("a point that was moved is found") {
  Loaded z = z_chain();
  for (const double by : {1e-5, 1e-3, 0.1}) {
    Branch<double> branch = z.follow(1);
    const std::size_t i = branch.points.size() / 2;
    branch.points[i].theta(2) += by;
    const PathCertificate proved = z.certificate(branch);
    REQUIRE(proved.failed_at);
    CHECK(proved.failed_at->low <= branch.points[i].load);
    CHECK(proved.failed_at->high >= branch.points[i - 1].load);
  }
}

TEST_CASE("three derivatives of a branch enclose those of its power series") {
  std::mt19937 random(29);
  const auto tenths = [&](std::size_t n, int low, int high) {
    return random_decimals(random, n, low, high, 10);
  };
  std::size_t narrow = 0;
  for (const Control control : {Control::end_point, Control::force}) {
    for (std::size_t n = 2; n < 7; ++n) {
      const Chain<Interval> chain(tenths(n, 5, 20), tenths(n, 5, 20), tenths(n, 1, 9));
      const Point<Interval> start =
          control == Control::end_point ? end_point(chain, chain.rest()) : Point<Interval>{0, 0};
      Loaded loaded(chain, {control, start, {decimal(-3, 5), decimal(4, 5)}}, rest_of(chain));
      auto& brancher = loaded.brancher;
      const BranchPoint<double> point = loaded.follow(0.2).points.back();
      brancher.refresh(point);
      BranchSeries<double> series(3);
      brancher.expand(point, series);

      BranchEquations equations(chain, loaded.loading);
      const Vector<Span> at = equations.at(point);
      Vector<Span> normal = Vector<Span>::Constant(equations.unknowns(), Span(0));
      normal.head(point.theta.size()) = brancher.weighted(point.tangent.theta).cast<Span>();
      normal(normal.size() - 1) = brancher.load_weight() * point.tangent.load;
      const auto tube = tube_at(equations, at, normal);
      REQUIRE(tube);
      const auto enclosed = rates(equations, *tube, widened(at, tube->image));
      double factorial = 1;
      for (Eigen::Index k = 1; k <= 3; ++k) {
        factorial *= static_cast<double>(k);
        const double expected = factorial * series.coefficient(BranchSeries<double>::load, k);
        const Span& load = equations.load(enclosed[static_cast<std::size_t>(k - 1)]);
        CAPTURE(k);
        // doubles beside an enclosure around a point that is as good as doubles: the condition of two solves
        const double rounding = 1e-10 * (1 + std::abs(expected));
        CHECK(load.low <= expected + rounding);
        CHECK(load.high >= expected - rounding);
        narrow += load.high - load.low < rounding ? 1 : 0;
      }
      const StiffnessChange change = equations.stiffness(widened(at, tube->image), enclosed);
      series.go_to(0);
      const double slope = series.value(BranchSeries<double>::bend);
      CHECK(change.slope.low <= slope + 1e-9 * (1 + std::abs(slope)));
      CHECK(change.slope.high >= slope - 1e-9 * (1 + std::abs(slope)));
      const double bend = series.slope(BranchSeries<double>::bend);
      CHECK(change.bend.low <= bend + 1e-9 * (1 + std::abs(bend)));
      CHECK(change.bend.high >= bend - 1e-9 * (1 + std::abs(bend)));
    }
  }
  CHECK(narrow > 25);  // of 30: a chain that is pulled nearly straight is the exception
}

TEST_CASE("minima of the tangent stiffness are counted") {
  const PathCertificate z = z_chain().certificate(z_chain().follow(1.5));
  REQUIRE(z.certified());
  CHECK(z.counted);
  REQUIRE(z.softest.size() == 1);
  CHECK(z.softest[0].low < 0.5854925646072256);  // the one of fifty digits, tests/verify
  CHECK(z.softest[0].high > 0.5854925646072257);
  CHECK_FALSE(z.softens);
  // before it the stiffness only falls
  const PathCertificate before = z_chain().certificate(z_chain().follow(0.4));
  CHECK(before.softens);
  CHECK(before.softest.empty());

  std::mt19937 random(5);
  const auto tenths = [&](std::size_t n, int low, int high) {
    return random_decimals(random, n, low, high, 10);
  };
  std::size_t counted = 0, minima = 0;
  for (std::size_t trial = 0; trial < 40; ++trial) {
    const std::size_t n = 2 + trial % 4;
    Loaded loaded = compressed(Chain<Interval>(tenths(n, 5, 15), tenths(n, 5, 20), tenths(n, 1, 9)));
    const Branch<double> branch = loaded.follow(0.8);
    const PathCertificate proved = loaded.certificate(branch);
    REQUIRE(proved.certified());
    if (!proved.counted || !proved.gaps.empty()) continue;
    const auto found = std::count_if(branch.events.begin(), branch.events.end(), [](const auto& event) {
      return event.kind == EventKind::quasi_buckling;
    });
    CHECK(proved.softest.size() == static_cast<std::size_t>(found));
    ++counted;
    minima += proved.softest.size();
  }
  CHECK(counted > 30);
  CHECK(minima > 5);
}

TEST_CASE("where a certified path ends the census has the same equilibrium, of the same type") {
  std::mt19937 random(17);
  const auto thousandths = [&](std::size_t n, int low, int high) {
    return random_decimals(random, n, low, high, 1000);
  };
  std::size_t ends = 0;
  for (std::size_t trial = 0; trial < 16; ++trial) {
    const std::size_t n = 2 + trial % 3;
    auto stiffness = thousandths(n, 500, 2000);
    if (trial % 4 == 3) stiffness[0] = Interval(0);
    const Chain<Interval> chain(thousandths(n, 600, 1500), stiffness, thousandths(n, -900, 900));
    const bool held = trial % 2 == 0 || trial % 4 == 3;
    const Point<Interval> start =
        held ? end_point(chain, chain.rest()) : Point<Interval>{Interval(0), Interval(0)};
    const Loading<Interval> loading{
        held ? Control::end_point : Control::force, start, {decimal(-3, 5), decimal(4, 5)}};
    Loaded loaded(chain, loading, rest_of(chain));
    const Branch<double> branch = loaded.follow(0.4);
    const PathCertificate proved = loaded.certificate(branch);
    CAPTURE(trial);
    CAPTURE(proved.failure);
    REQUIRE(proved.certified());
    const BranchPoint<double>& last = branch.points.back();
    if (branch.end != BranchEnd::load) continue;
    const Interval load = Interval::from_double(last.load);
    const Point<Interval> at = loading.at(load);
    const Census census = held ? census_at_end_point(chain, at) : census_under_force(chain, at);
    REQUIRE(census.complete());
    std::size_t same = 0;
    for (const auto& one : census.equilibria) {
      double theta = 0, off = 0;
      for (std::size_t j = 0; j < n; ++j) {
        theta += as_double(one.q[j]);
        off = std::max(off,
                       std::abs(std::remainder(theta - last.theta(static_cast<Eigen::Index>(j)), 2 * M_PI)));
      }
      if (off > proved.distance + 1e-12) continue;
      ++same;
      CHECK(one.negative_directions == proved.runs.back().negative_directions);
    }
    CHECK(same == 1);
    ++ends;
  }
  CHECK(ends >= 12);
}
