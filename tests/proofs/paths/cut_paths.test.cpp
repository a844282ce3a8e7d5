// What is not said of a path that ends where something is open.
#include <boost/math/tools/roots.hpp>
#include <plumbline/branch/slow_loading.hpp>

#include "proofs/exact/decimal.hpp"
#include "tests/proofs/loaded.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using namespace plumbline::proofs::test;

namespace {

/// The points of a branch before a load, and one at it.
Branch<double> cut_at(Loaded& loaded, const Branch<double>& branch, const BranchPoint<double>& end) {
  Branch<double> cut{{}, {}, BranchEnd::load};
  for (const BranchPoint<double>& point : branch.points) {
    if (loaded.brancher.product({point.theta - end.theta, {0, 0}, point.load - end.load}, end.tangent) >
        -1e-3)
      break;
    cut.points.push_back(point);
  }
  REQUIRE(cut.points.size() > 2);
  cut.points.push_back(end);
  return cut;
}

/// One link, k = L = 1, under the compression 1 + e, pushed aside: load = ((1 + e) sin theta - theta) /
/// cos theta, nearly e theta - theta^3 / 3, has two folds, at +- sqrt(e), that meet in a cusp where e = 0.
Loaded near_cusp(const Rational& e) {
  return {Chain<Interval>({1}, {1}),
          {Control::force, {Interval(Rational(-1 - e)), Interval(0)}, {Interval(0), Interval(-1)}},
          {0.05}};
}
BranchPoint<double> at_angle(const Loaded& link, double e, double theta) {
  // (sin theta - theta) by its series, for it cancels
  const double t2 = theta * theta,
               difference = -theta * t2 * (1 / 6.0 - t2 * (1 / 120.0 - t2 * (1 / 5040.0 - t2 / 362880)));
  BranchPoint<double> point{};
  point.load = (difference + e * std::sin(theta)) / std::cos(theta);
  point.theta = Vector<double>::Constant(1, theta);
  point.force = {-1 - e, -point.load};
  const double slope =
      ((1 + e) * std::cos(theta) - 1 + point.load * std::sin(theta)) / std::cos(theta);  // dload / dtheta
  point.tangent = {Vector<double>::Constant(1, 1), {0, -slope}, slope};
  Brancher<Nominal>::scale(point.tangent, 1 / link.brancher.length(point.tangent));
  return point;
}

}  // namespace

TEST_CASE("regular is what has no gap, one run, is stable and goes up") {
  PathCertificate path;
  path.runs = {{0, 1, 0}};
  CHECK(path.regular());
  const auto regular = [&](auto change) {
    PathCertificate other = path;
    change(other);
    return other.regular();
  };
  CHECK_FALSE(regular([](PathCertificate& p) { p.gaps.push_back({Span(0.5), {}, {}, {}, false}); }));
  CHECK_FALSE(regular([](PathCertificate& p) { p.runs.push_back({1, 2, 0}); }));
  CHECK_FALSE(regular([](PathCertificate& p) { p.runs[0].negative_directions = 1; }));
  CHECK_FALSE(regular([](PathCertificate& p) { p.runs[0].to = -1; }));
  CHECK_FALSE(regular([](PathCertificate& p) { p.runs.clear(); }));
  CHECK_FALSE(regular([](PathCertificate& p) { p.failed_at = Span(0); }));
}

TEST_CASE("a path that is cut at a fold is not certified: whether the load turns there stays open") {
  Loaded link = one_link();
  const Branch<double> branch =
      Tracer<Nominal>(link.brancher, {-2, 2}).run(link.brancher.start(0, link.shape));
  REQUIRE(branch.events.at(0).kind == EventKind::fold);
  const Branch<double> cut = cut_at(link, branch, branch.events[0].point);
  const PathCertificate proved = link.certificate(cut);
  REQUIRE(proved.failed_at);
  CHECK(proved.failed_at->contains(branch.events[0].point.load));
  CHECK(proved.failure == "whether the load turns stays open");
  // a point before it is certified
  Branch<double> before = cut;
  before.points.pop_back();
  CHECK(link.certificate(before).regular());
}

TEST_CASE(
    "a stiffness that is least at the end of a path does not fall all along, nor is that minimum counted") {
  Loaded z = z_chain();
  const Branch<double> branch = z.follow(1.5);
  REQUIRE(branch.events.at(0).kind == EventKind::quasi_buckling);
  const PathCertificate proved = z.certificate(cut_at(z, branch, branch.events[0].point));
  REQUIRE(proved.certified());
  CHECK_FALSE(proved.softens);
  CHECK_FALSE(proved.counted);
  CHECK(proved.softest.empty());
}

TEST_CASE("a path that ends where the stiffness vanishes is not stiff, one that ends before it is") {
  std::mt19937 random(5);
  int found = 0;
  for (std::size_t trial = 0; trial < 200 && found < 3; ++trial) {
    const std::size_t n = 2 + trial % 4;
    const auto tenths = [&](int low, int high) { return random_decimals(random, n, low, high, 10); };
    Loaded loaded = compressed(Chain<Interval>(tenths(5, 15), tenths(5, 20), tenths(-9, 9)));
    const Branch<double> branch = loaded.follow(0.8);
    const auto soft = std::find_if(branch.points.begin(), branch.points.end(),
                                   [](const BranchPoint<double>& p) { return !(p.stiffness > 0); });
    if (soft - branch.points.begin() < 4 || soft == branch.points.end() || soft->negative_directions > 0)
      continue;
    const BranchPoint<double> before = *std::prev(soft);
    const auto at = [&](double load) { return loaded.brancher.at_load(before, load); };
    double low = before.load, high = soft->load;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (at(middle).value().stiffness > 0 ? low : high) = middle;
    }
    const PathCertificate at_zero = loaded.certificate(cut_at(loaded, branch, *at(low)));
    REQUIRE(at_zero.certified());
    CHECK_FALSE(at_zero.stiff);
    Branch<double> earlier = branch;
    earlier.events.clear();
    earlier.points.erase(earlier.points.begin() + (soft - branch.points.begin()) - 1, earlier.points.end());
    CHECK(loaded.certificate(earlier).stiff);
    ++found;
  }
  CHECK(found > 0);
}

TEST_CASE("two folds in a path are both proved, or the path is not") {
  for (const char* text :
       {"1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12", "1e-14", "1e-15", "1e-16", "1e-18"}) {
    CAPTURE(text);
    const double e = std::stod(text);
    const Loaded link = near_cusp(*parse_decimal(text));
    Branch<double> branch{{}, {}, BranchEnd::load};
    const double folds = std::sqrt(2 * e);
    for (const double theta : {-5 * folds - 0.02, -2 * folds - 0.01, 0.0, 2 * folds + 0.01, 5 * folds + 0.02})
      branch.points.push_back(at_angle(link, e, theta));
    const PathCertificate proved = link.certificate(branch);
    if (e >= 1e-6) CHECK(proved.certified());
    if (!proved.certified()) continue;
    CHECK(proved.folds.size() == 2);
    REQUIRE(proved.runs.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(proved.runs[i].negative_directions == (i == 1 ? 1 : 0));
  }
}

TEST_CASE("the type of what lies behind a fold is proved, or the path is not, however short it is") {
  std::size_t refused = 0, proved_behind = 0;
  const double e = 1e-2;
  const Loaded link = near_cusp(Rational(1, 100));
  const double fold =
      boost::math::tools::bisect([&](double t) { return 1 + e - std::cos(t) - t * std::sin(t); }, 0.01, 0.5,
                                 [](double a, double b) { return b - a < 1e-17; })
          .first;
  for (double beyond = 1e-2; beyond > 1e-17; beyond /= 1.7) {
    CAPTURE(beyond);
    Branch<double> branch{{}, {}, BranchEnd::load};
    for (const double theta : {fold + 0.1, fold + 0.03, fold + 0.01, fold - beyond})
      branch.points.push_back(at_angle(link, e, theta));
    const PathCertificate proved = link.certificate(branch);
    if (!proved.certified()) {
      ++refused;
      continue;
    }
    CHECK(proved.runs.at(0).negative_directions == 0);
    CHECK(proved.runs.size() == proved.folds.size() + 1);
    if (proved.runs.size() == 2) {
      ++proved_behind;
      CHECK(proved.runs[1].negative_directions == 1);
    }
  }
  CHECK(refused > 0);
  CHECK(proved_behind > 5);
}

TEST_CASE("where the least stiffness may be one minimum or two none is claimed") {
  // under the compression 4 / 3 + off the stiffness is -1 / 3 plus a quartic: one minimum where off < 0, two
  // with a maximum between them where off > 0
  for (const std::string off :
       {"-1e-3", "-1e-6", "-1e-10", "-1e-16", "0", "1e-18", "1e-16", "1e-14", "1e-10", "1e-8", "1e-6"}) {
    CAPTURE(off);
    const double e = 1.0 / 3 + std::stod(off);
    const Loaded link = near_cusp(Rational(1, 3) + *parse_decimal(off));
    Branch<double> branch{{}, {}, BranchEnd::load};
    for (int i = -30; i <= 30; ++i) branch.points.push_back(at_angle(link, e, (i + 0.4) / 100.0));
    const PathCertificate proved = link.certificate(branch);
    REQUIRE(proved.certified());
    if (std::stod(off) < -1e-7) CHECK(proved.counted);
    CHECK(proved.softest.size() == (proved.counted ? 1 : 0));
    CHECK((std::stod(off) < 0 || !proved.counted));
  }
}
