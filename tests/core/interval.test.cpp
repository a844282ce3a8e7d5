#include <plumbline/base/interval.hpp>

#include "tests/property.hpp"

using namespace plumbline;

namespace {

Interval around(long centre, long radius) {
  return hull(Interval(Rational(centre - radius, 1000)), Interval(Rational(centre + radius, 1000)));
}

Rational inside(long centre, long radius, long part) {
  return {centre * 16 + radius * part, 16000};
}

}  // namespace

TEST_CASE("the result of an operation contains every value that its arguments allow") {
  check_property("enclosure", [] {
    const auto a = *rc::gen::inRange(-5000L, 5000L);
    const auto b = *rc::gen::inRange(-5000L, 5000L);
    const auto ra = *rc::gen::inRange(0L, 500L);
    const auto rb = *rc::gen::inRange(0L, 500L);
    const Rational x = inside(a, ra, *rc::gen::inRange(-16L, 17L));
    const Rational y = inside(b, rb, *rc::gen::inRange(-16L, 17L));
    const Interval X = around(a, ra);
    const Interval Y = around(b, rb);
    RC_ASSERT(X.contains(x));
    RC_ASSERT((X + Y).contains(x + y));
    RC_ASSERT((X - Y).contains(x - y));
    RC_ASSERT((X * Y).contains(x * y));
    RC_ASSERT((-X).contains(-x));
    RC_ASSERT(sqr(X).contains(x * x));
    RC_ASSERT(!certainly_negative(sqr(X)));
    if (!Y.contains_zero()) RC_ASSERT((X / Y).contains(x / y));
    if (certainly_less(X, Y)) RC_ASSERT(x < y);
    // sin^2 + cos^2 = 1 whatever the width
    RC_ASSERT((sqr(sin(X)) + sqr(cos(X))).contains(1));
  });
}

TEST_CASE("pi is enclosed to the last of 64 digits") {
  const Interval pi = Interval::pi();
  // 62 decimals, cut off and rounded up
  CHECK(pi.lower() > Interval::End("3.14159265358979323846264338327950288419716939937510582097494459"));
  CHECK(pi.upper() < Interval::End("3.14159265358979323846264338327950288419716939937510582097494460"));
  CHECK(pi.lower() < pi.upper());
}

TEST_CASE("a decimal is enclosed, not rounded") {
  const Interval tenth(Rational(1, 10));
  CHECK(tenth.contains(Rational(1, 10)));
  CHECK(tenth.width() > 0);
  CHECK(tenth.width() < Interval::End("1e-63"));
  CHECK_FALSE(Interval::from_double(0.1).contains(Rational(1, 10)));
}

TEST_CASE("what is not certain is not said") {
  const Interval zero_to_one = hull(Interval(0), Interval(1));
  CHECK_FALSE(certainly_positive(zero_to_one));
  CHECK_FALSE(certainly_negative(zero_to_one));
  CHECK_FALSE(certainly_less(zero_to_one, Interval(1)));
  CHECK(certainly_less(zero_to_one, Interval(2)));
  CHECK_FALSE(intersection(zero_to_one, Interval(2)));
  CHECK_FALSE(intersection(Interval(2), zero_to_one));
  CHECK(intersection(zero_to_one, hull(Interval(1), Interval(3)))->contains(1));
}

TEST_CASE("the ends belong to an interval, and nothing beyond them does") {
  const Interval third(Rational(1, 3)), two_to_five = hull(Interval(5), Interval(2));
  for (const int end : {2, 5}) CHECK(two_to_five.contains(end));
  CHECK_FALSE(two_to_five.contains(Rational(2) - Rational(1, 1000000)));
  CHECK_FALSE(two_to_five.contains(Rational(5) + Rational(1, 1000000)));
  CHECK(two_to_five.inside(two_to_five));
  CHECK(two_to_five.inside(hull(Interval(1), Interval(5))));
  CHECK_FALSE(two_to_five.inside(hull(Interval(3), Interval(6))));
  CHECK_FALSE(two_to_five.inside(hull(Interval(0), Interval(4))));
  CHECK(third.lower() <= third.middle());
  CHECK(third.middle() <= third.upper());
  CHECK(two_to_five.width() == 3);
  CHECK(hull(Interval(-1), Interval(2)).contains_zero());
  CHECK(hull(Interval(0), Interval(2)).contains_zero());
  CHECK_FALSE(two_to_five.contains_zero());
}

TEST_CASE(
    "an operation in place is the operation, a square knows its factors, and division by zero knows "
    "nothing") {
  const auto same = [](const Interval& a, const Interval& b) { return a.inside(b) && b.inside(a); };
  const Interval a = hull(Interval(-3), Interval(7)), b = hull(Interval(2), Interval(5));
  Interval sum = a, difference = a, product = a, quotient = a;
  CHECK(same(sum += b, hull(Interval(-1), Interval(12))));
  CHECK(same(difference -= b, hull(Interval(-8), Interval(5))));
  CHECK(same(product *= b, hull(Interval(-15), Interval(35))));
  CHECK(same(quotient /= b, hull(Interval(Rational(-3, 2)), Interval(Rational(7, 2)))));
  CHECK(same(sqr(a), hull(Interval(0), Interval(49))));
  CHECK(same(-b, hull(Interval(-5), Interval(-2))));
  const Interval anything = b / a;
  for (const long x : {-1000000000000L, 0L, 1000000000000L}) CHECK(anything.contains(x));
}

TEST_CASE("outside its domain a function refuses") {
  CHECK_THROWS_WITH_AS(
      sqrt(hull(Interval(Rational(-1, 3)), Interval(Rational(2, 3)))),
      "square root of an interval: found [-0.333334, 0.666667], expected no negative value in it", Error);
  CHECK_THROWS_AS(Interval(Interval::End(2), Interval::End(1)), Error);
  CHECK(sqrt(Interval(2)).contains(Rational(1)) == false);
  CHECK(sqr(sqrt(Interval(2))).contains(2));
}

TEST_CASE("text rounds outwards") {
  CHECK(Interval(Rational(1, 3)).text(3) == "[0.333, 0.334]");
}
