#include "proofs/pitchfork.hpp"

#include "proofs/certified_path.hpp"
#include "proofs/decimal.hpp"
#include "proofs/followed_path.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// What is proved of the slow loading along -x: the first part, with what joins it to the second.
PathCertificate first_part(const Chain<Rational>& chain, double last) {
  const auto middle = [](const Interval& x) { return static_cast<double>(x.middle()); };
  const auto exact = from_rational<Interval>(chain);
  const Loading<Interval> loading{Control::end_point, end_point(exact, exact.rest()), {-1, 0}};
  const Point<double> start{middle(loading.start.x), middle(loading.start.y)};
  const PathTask task{convert<double>(exact, middle), {Control::end_point, start, {-1, 0}}, last, 0.05};
  const PathReport report = follow_slowly(task);
  REQUIRE(report.branches.size() > 1);
  PathCertificate before = certify(exact, loading, report.branches[0]);
  const PathCertificate after = certify(exact, loading, report.branches[1]);
  join(before, report.branches[0], after, exact, loading, symmetries(chain, Control::end_point, {-1, 0}));
  return before;
}

std::vector<Rational> decimals(const std::vector<const char*>& texts) {
  std::vector<Rational> values;
  for (const char* text : texts) values.push_back(*parse_decimal(text));
  return values;
}

}  // namespace

TEST_CASE("a symmetric chain's path goes through its pitchfork without a gap") {
  const std::vector<std::pair<Chain<Rational>, double>> chains{
      {Chain<Rational>({1, 1, 1}, {0, 1, 1}, decimals({"-0.1", "0.3", "-0.3"})), 0.1},
      {Chain<Rational>({1, Rational(7, 10), 1}, {0, 2, 2}, decimals({"0.1", "0.2", "-0.2"})), 0.3},
      {Chain<Rational>({1, 1, 1, 1}, {0, 1, 2, 1}, decimals({"0", "0.3", "0", "-0.3"})), 0.5},
      {Chain<Rational>({1, 1, 1, 1, 1}, {0, 1, 2, 2, 1}, decimals({"0", "0.3", "-0.2", "0.2", "-0.3"})),
       0.7}};
  for (const auto& [chain, last] : chains) {
    const PathCertificate proved = first_part(chain, last);
    CHECK(proved.certified());
    REQUIRE(proved.fork);
    CHECK(proved.gaps.empty());
    CHECK(proved.fork->width() < 1e-11);
    CHECK(proved.runs.back().to < proved.fork->low);
  }
}

TEST_CASE("a chain that is symmetric but for one unit in digit 30 has no pitchfork, and keeps its gap") {
  const auto nearly = decimals({"0", "0.3", "-0.300000000000000000000000000001"});
  const PathCertificate open = first_part(Chain<Rational>({1, 1, 1}, {0, 1, 1}, nearly), 0.1);
  CHECK_FALSE(open.fork);
  CHECK(open.gaps.size() == 1);
}

TEST_CASE("symmetries are those of the exact numbers") {
  const Chain<Rational> straight({1, 1}, {1, 1}), base({1, 2, 1}, {0, 3, 3});
  CHECK(symmetries(straight, Control::force, {-1, 0}).size() == 1);
  CHECK(symmetries(straight, Control::force, {-1, 1}).empty());
  CHECK(symmetries(base, Control::end_point, {-1, 0}).size() == 3);
  CHECK(symmetries(base, Control::force, {-1, 0}).size() == 1);
  CHECK(
      symmetries(Chain<Rational>({1, 2, Rational(1000001, 1000000)}, {0, 3, 3}), Control::end_point, {-1, 0})
          .size() == 1);
}
