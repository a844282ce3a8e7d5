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
  CHECK(proved.stiff);
}

TEST_CASE("a path that ends where the stiffness vanishes is not stiff") {
  // two links over a passive base snap through: the force has a maximum, where the end point goes on
  Loaded arch = compressed(Chain<Interval>({1, 1}, {1, 1}, {decimal(3, 10), decimal(-6, 10)}));
  const Branch<double> branch = arch.follow(1.2);
  const auto soft = std::find_if(branch.points.begin(), branch.points.end(),
                                 [](const BranchPoint<double>& p) { return !(p.stiffness > 0); });
  REQUIRE(soft != branch.points.begin());
  REQUIRE(soft != branch.points.end());
  const BranchPoint<double> before = *std::prev(soft);
  const auto stiffness = [&](double load) { return arch.brancher.at_load(before, load).value().stiffness; };
  double low = before.load, high = soft->load;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (stiffness(middle) > 0 ? low : high) = middle;
  }
  const PathCertificate at_zero = arch.certificate(cut_at(arch, branch, *arch.brancher.at_load(before, low)));
  REQUIRE(at_zero.certified());
  CHECK_FALSE(at_zero.stiff);
  CHECK(arch.certificate(cut_at(arch, branch, *arch.brancher.at_load(before, low - 1e-2))).stiff);
}
