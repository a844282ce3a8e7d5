// What is not said of a path that ends where something is open.
#include <plumbline/branch/slow_loading.hpp>

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
