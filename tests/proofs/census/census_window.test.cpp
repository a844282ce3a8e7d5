/// Which shapes a census counts, and that neither units nor the edge of the window change them.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "proofs/census/census.hpp"
#include "proofs/exact/as_double.hpp"
#include "proofs/exact/certain_digits.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/span.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

std::vector<Interval> list(const std::vector<const char*>& decimals) {
  std::vector<Interval> values;
  for (const char* text : decimals) values.emplace_back(*parse_decimal(text));
  return values;
}

Point<Interval> at(const char* x, const char* y) {
  return {Interval(*parse_decimal(x)), Interval(*parse_decimal(y))};
}

/// Fig. 7: three unit links, passive base, rest angles -pi/4 and -pi/3.
Chain<Interval> fig7() {
  const Interval pi = Interval::pi();
  return Chain<Interval>(list({"1", "1", "1"}), list({"0", "1", "1"}),
                         {Interval(0), -pi / Interval(4), -pi / Interval(3)});
}

Census fig7_at(const Rational& deflection, int turns = 0) {
  const auto chain = fig7();
  const Point<Interval> p = end_point(chain, chain.rest());
  const Interval x = sqrt(sqr(p.x) + sqr(p.y)) - Interval(deflection);
  return census_at_end_point(chain, {x, Interval(0)}, unwound(chain, turns));
}

std::size_t stable(const Census& census) {
  return static_cast<std::size_t>(
      std::count_if(census.equilibria.begin(), census.equilibria.end(),
                    [](const auto& one) { return one.negative_directions == std::size_t{0}; }));
}

bool near(const CertifiedEquilibrium& one, const std::vector<double>& q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (std::abs(as_double(one.q[i]) - q[i]) > 1e-5) return false;
  }
  return true;
}

bool lists(const Census& census, const std::vector<double>& q) {
  return std::any_of(census.equilibria.begin(), census.equilibria.end(),
                     [&](const auto& one) { return near(one, q); });
}

}  // namespace

TEST_CASE("the count of equilibria changes at folds alone, also where a joint deflects by half a turn") {
  // Between 0.2 L and 0.25 L the last joint of the unwound Z-shape passes half a turn from rest. No two links
  // can fold onto each other before the end point is one link off the base, at 1.2128 L: all shapes with
  // joint angles within half a turn hang together in one circle, with as many minima as maxima.
  for (const Rational& d :
       {Rational(1, 50), Rational(1, 5), Rational(1, 4), Rational(3, 10), Rational(9, 10)}) {
    CAPTURE(d);
    const Census census = fig7_at(d);
    REQUIRE(census.complete());
    CHECK(census.balanced);
    CHECK(census.equilibria.size() == 4);
    CHECK(stable(census) == 2);
  }
  CHECK(lists(fig7_at(Rational(3, 10)), {0.152442, -1.398569, 2.166627}));
  const Census later = fig7_at(Rational(114, 100));
  CHECK(later.equilibria.size() == 6);
  CHECK(stable(later) == 3);
}

TEST_CASE("a wider window keeps what a narrower one has") {
  const Census narrow = fig7_at(Rational(3, 10)), wide = fig7_at(Rational(3, 10), 1);
  REQUIRE(wide.complete());
  CHECK(wide.balanced);  // 9 copies of a circle
  std::size_t inside = 0;
  for (const auto& one : wide.equilibria)
    inside += std::abs(as_double(one.q[1])) < M_PI && std::abs(as_double(one.q[2])) < M_PI ? 1 : 0;
  CHECK(inside == narrow.equilibria.size());
  for (const auto& one : narrow.equilibria)
    CHECK(lists(wide, {as_double(one.q[0]), as_double(one.q[1]), as_double(one.q[2])}));
}

TEST_CASE("what is stable under a force is found at its own end point, in a window that it lies in") {
  const Chain<Interval> chain(list({"1", "1"}), list({"1", "1"}));
  const Census forced = census_under_force(chain, at("-9", "0"));
  CHECK(forced.balanced);
  std::size_t wound = 0;
  for (const auto& one : forced.equilibria) {
    if (one.negative_directions != std::size_t{0}) continue;
    const std::vector<double> q{as_double(one.q[0]), as_double(one.q[1])};
    const double turned = std::max(std::abs(q[0]), std::abs(q[1]));
    if (turned > 3 * M_PI) continue;  // wound up by more than one turn beyond the window
    const bool beyond = turned > M_PI;
    wound += beyond ? 1 : 0;
    CHECK(lists(census_at_end_point(chain, {one.x, one.y}, unwound(chain, 1)), q));
    CHECK(lists(census_at_end_point(chain, {one.x, one.y}), q) == !beyond);
  }
  CHECK(wound > 0);
}

TEST_CASE("units do not matter, as far as numbers go") {
  const auto count = [](const char* L, const char* k, const char* x) {
    const Census census = census_at_end_point(Chain<Interval>(list({L, L}), list({k, k})), at(x, "0"));
    CHECK(census.complete());
    return census.equilibria.size();
  };
  CHECK(count("1", "1", "1") == 2);
  CHECK(count("1e150", "1e-200", "1e150") == 2);
  CHECK(count("1e-300", "1e300", "1e-300") == 2);
  CHECK(count("3e300", "7e300", "4e300") == 2);
}

TEST_CASE("what doubles cannot hold is refused, never empty") {
  const auto refused = [](const std::vector<const char*>& L, const std::vector<const char*>& k,
                          const std::vector<const char*>& rest, const char* fx) {
    CHECK_THROWS_AS(census_under_force(Chain<Interval>(list(L), list(k), list(rest)), at(fx, "0")), Error);
  };
  refused({"1e200"}, {"1e300"}, {"0"}, "-1e120");
  refused({"1", "1"}, {"1e-300", "1e-300"}, {"0", "0"}, "-1e300");
  refused({"1e200"}, {"1"}, {"0"}, "-1e200");
  refused({"1"}, {"1e-300"}, {"0.1"}, "-1e10");
  refused({"1e-300", "1", "1e300"}, {"1", "1e300", "1e-300"}, {"0", "0", "0"}, "-1");
  refused({"1"}, {"1"}, {"1e300"}, "-1");
}

TEST_CASE("a span that overflows excludes nothing") {
  const double most = std::numeric_limits<double>::max(), nan = std::numeric_limits<double>::quiet_NaN();
  const Span huge(-most, most), zero(0);
  for (const Span& x :
       {huge * huge, huge + huge, huge - huge, huge / Span(1e-300), huge / zero, (huge * huge) * zero,
        (huge + huge) - (huge + huge), Span(nan, nan), 2.0 * (huge + huge)}) {
    CHECK_FALSE(x.empty());
    CHECK_FALSE(intersection(Span(1, 2), x).empty());
    CHECK_FALSE(certainly_positive(x));
    CHECK_FALSE(certainly_negative(x));
  }
  CHECK(intersection(Span(1, 2), Span(3, 4)).empty());
}

TEST_CASE("a shape on the cut of a passive joint's circle is counted once") {
  // q_1 of one equilibrium is where the circle is cut, pi + 0.1234567: one turn apart it occurs at both ends
  const Chain<Interval> chain(list({"1", "1"}), list({"0", "1"}));
  const Census census =
      census_at_end_point(chain, at("-0.602839697403766815617414414251635366801633319457899912730205",
                                    "0.797862331003372323806352902764462810802298607474109892888622"));
  CHECK(census.complete());
  CHECK(census.equilibria.size() == 2);
  for (const auto& one : census.equilibria) CHECK(std::abs(as_double(one.q[0])) <= M_PI);
}

TEST_CASE("both shapes of two links are counted wherever the passive base has to point") {
  // end point at distance 1: the first link stands pi / 3 to either side of it, also where its circle is cut
  const Chain<Interval> chain(list({"1", "1"}), list({"0", "1"}));
  for (int hundredths = -10; hundredths <= 10; ++hundredths) {
    const double first = M_PI + 0.1234567 + hundredths / 200.0;
    for (const double to_end : {-M_PI / 3, M_PI / 3}) {
      const Interval way = Interval::from_double(first + to_end);
      const Census census = census_at_end_point(chain, {cos(way), sin(way)});
      CAPTURE(hundredths);
      CHECK(census.complete());
      CHECK(census.equilibria.size() == 2);
    }
  }
}

TEST_CASE("a passive base turns with the load: the count is that of any direction") {
  const Chain<Interval> chain(list({"1", "1.3", "0.7"}), list({"0", "1", "2"}), list({"0", "0.4", "-0.3"}));
  for (int step = 0; step < 12; ++step) {
    const Interval angle = Interval(Rational(step, 6)) * Interval::pi(), reach(Rational(19, 10));
    const Census census = census_at_end_point(chain, {reach * cos(angle), reach * sin(angle)});
    CAPTURE(step);
    REQUIRE(census.complete());
    CHECK(census.equilibria.size() == 4);
  }
}

TEST_CASE("shapes that share an angle are told apart by the others") {
  // k = (1, 0, 1), F = 1/2 along the axis: q_1 = 0 in more than one shape
  const Chain<Interval> chain(list({"1", "1", "1"}), list({"1", "0", "1"}));
  const Census census = census_under_force(chain, at("-0.5", "0"));
  REQUIRE(census.complete());
  CHECK(census.balanced);                // a passive joint: the sum is 0, so no shape is swallowed
  CHECK(census.equilibria.size() == 2);  // straight, and the last two links folded back
}

TEST_CASE(
    "a shape on the edge of an elastic joint's window is listed, at one end or both, and the count has no "
    "law") {
  // rest angle -4/3 pi to 59 digits, end point (1, 0): one of the two shapes has q_1 = -pi/3, half a turn off
  const Chain<Interval> chain(
      list({"1", "1"}), list({"1", "1"}),
      list({"-4.18879020478639118461684785437267051226289253250014109463325", "0.3"}));
  const Census census = census_at_end_point(chain, at("1", "0"));
  CHECK(census.complete());
  CHECK_FALSE(census.balanced);
  CHECK((lists(census, {-M_PI / 3, 2 * M_PI / 3}) || lists(census, {-7 * M_PI / 3, 2 * M_PI / 3})));
}

TEST_CASE("a shape that the digits put on the edge of the window is listed at one end at least") {
  // as above, the rest angle moved by a few of the last digits that intervals have
  const Rational third = *parse_decimal("4.188790204786390984616857844372670512262892532500141094633259455");
  for (int steps = -40; steps <= 40; ++steps) {
    const Chain<Interval> chain(list({"1", "1"}), list({"1", "1"}),
                                {Interval(Rational(-third + *parse_decimal("1e-58") * steps)), Interval(0)});
    const Census census = census_at_end_point(chain, at("1", "0"));
    CAPTURE(steps);
    CHECK(census.complete());
    CHECK((lists(census, {-M_PI / 3, 2 * M_PI / 3}) || lists(census, {-7 * M_PI / 3, 2 * M_PI / 3})));
  }
}

TEST_CASE("digits are shown as far as the enclosure goes") {
  const Interval::End low("1.23456789"), high("1.23456791");
  CHECK(certain_digits(Interval(low, high), 50) == "1.2345679");
  CHECK(certain_digits(Interval(-high, -low), 3) == "-1.23");
  CHECK(certain_digits(Interval(Interval::End("-1e-60"), Interval::End("2e-60")), 50) == "0");
  CHECK_THROWS_AS(certain_digits(Interval(low, Interval::End("3")), 50), Error);
  // by symmetry the lateral force is zero; its digits were noise
  const Chain<Interval> chain(list({"1", "1", "1"}), list({"3", "0", "1"}));
  const Census census = census_at_end_point(chain, at("2.9", "0"));
  REQUIRE(census.complete());
  std::size_t zeros = 0;
  for (const auto& one : census.equilibria) {
    for (const Interval& q : one.q) {
      const bool zero = certain_digits(q, 50) == "0";
      zeros += zero ? 1 : 0;
      CHECK((zero || std::abs(as_double(q)) > 1e-3));
    }
  }
  CHECK(zeros > 0);
}

TEST_CASE("too many equilibria stop the search") {
  const Chain<Interval> chain(list({"1"}), list({"1"}), list({"0.1"}));
  CensusLimits few;
  few.listed = 10;
  CHECK_THROWS_AS(census_under_force(chain, at("-100", "0"), few), Error);
  CHECK(census_under_force(chain, at("-100", "0")).equilibria.size() == 63);
}

TEST_CASE("the count has a law where the window is whole turns wide and its edges out of reach") {
  // three links of one with the end point at 2.5: no joint can be folded, and the shapes are circles, whose
  // characteristic is 0; two links at 1.5 make two shapes
  const Interval pi = Interval::pi();
  const Chain<Interval> two(list({"1", "1"}), list({"0", "1"})), elastic(list({"1", "1"}), list({"1", "1"}));
  const Point<Interval> place = at("1.5", "0");
  CHECK(index_sum(two, place, unwound(two)) == 2);
  CHECK(index_sum(elastic, place, {hull(-pi, pi), hull(-pi, pi)}) == 2);
  // a joint that may be anywhere in two turns has twice as many
  const Interval two_turns = hull(-pi, Interval(3) * pi);
  CHECK(index_sum(two, place, {hull(-pi, pi), two_turns}) == 4);
  CHECK(index_sum(elastic, place, {two_turns, two_turns}) == 8);
  // a passive joint is counted once around, whatever is said of it
  CHECK(index_sum(two, place, {hull(-Interval(1), Interval(1)), hull(-pi, pi)}) == 2);
  // the joint cannot turn as far as 2.5 to either side, but that is no whole turn wide
  CHECK_FALSE(index_sum(two, place, {hull(-pi, pi), hull(-Interval(*parse_decimal("2.5")), pi)}));
  // and a whole turn about another angle has an edge that three links can reach
  const Chain<Interval> three(list({"1", "1", "1"}), list({"0", "1", "1"}));
  const Interval half(Rational(1, 2)), turn = pi + pi, whole = hull(-pi, pi);
  const Point<Interval> far = at("2.5", "0");
  CHECK(index_sum(three, far, unwound(three)) == 0);
  CHECK_FALSE(index_sum(three, far, {whole, hull(half, half + turn), whole}));
  CHECK_FALSE(index_sum(three, far, {whole, whole, hull(-half - turn, -half)}));
}

TEST_CASE("the characteristic of polygons: none that close, two, a circle, and surfaces") {
  CHECK(euler_characteristic_of_polygons({1, 1}) == 0);
  CHECK(euler_characteristic_of_polygons({3, 1, 1}) == 0);
  CHECK(euler_characteristic_of_polygons({1.5, 1, 1}) == 2);  // a triangle and its mirror image
  CHECK(euler_characteristic_of_polygons({1, 1, 1.5}) == 2);
  CHECK(euler_characteristic_of_polygons({2.5, 1, 1, 1}) == 0);     // a circle
  CHECK(euler_characteristic_of_polygons({3.5, 1, 1, 1, 1}) == 2);  // a sphere
  CHECK(euler_characteristic_of_polygons({1, 1, 1, 1, 1}) == -6);   // the surface of genus four
  CHECK(euler_characteristic_of_polygons({9, 1, 1, 1, 1}) == 0);
}
