#include "proofs/exact/span.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/number.hpp>
#include <random>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// Whether the exact value is inside, and neither end farther from it than so many units in the last place.
bool tight(const Span& found, const Rational& exact, double ulps) {
  const Rational low(found.low), high(found.high),
      slack = abs(exact) * Rational(ulps * 2.3e-16) + Rational(1e-300);
  return low <= exact && exact <= high && exact - low <= slack && high - exact <= slack;
}

bool tight(const Span& found, const Mpfr50& exact, double ulps) {
  const Mpfr50 slack = Mpfr50(ulps * 2.3e-16);  // of one: the largest cosine
  return found.low <= exact && exact <= found.high && exact - found.low <= slack &&
         found.high - exact <= slack;
}

}  // namespace

TEST_CASE("sums, products and quotients of doubles are inside, and two units in the last place off at most") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> fraction(-1, 1);
  std::uniform_int_distribution<int> exponent(-60, 60);
  for (int trial = 0; trial < 20000; ++trial) {
    const double a = std::ldexp(fraction(random), exponent(random)),
                 b = std::ldexp(fraction(random), exponent(random));
    CAPTURE(a);
    CAPTURE(b);
    const Rational x(a), y(b);
    // of a difference that cancels no unit is lost: it is exact
    CHECK(tight(Span(a) + Span(b), x + y, 2));
    CHECK(tight(Span(a) - Span(b), x - y, 2));
    CHECK(tight(Span(a) * Span(b), x * y, 2));
    CHECK(tight(a * Span(b), x * y, 2));
    if (b != 0) CHECK(tight(Span(a) / Span(b), x / y, 2));
  }
}

TEST_CASE("spans of any signs hold what their ends and their insides come to") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> value(-2, 2), share(0, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    const auto span = [&] {
      const double p = value(random), q = value(random);
      return Span(std::min(p, q), std::max(p, q));
    };
    const Span a = span(), b = span();
    const auto inside = [&](const Span& s) { return std::min(s.high, s.low + share(random) * s.width()); };
    for (const auto& [p, q] : {std::pair{a.low, b.low},
                               {a.low, b.high},
                               {a.high, b.low},
                               {a.high, b.high},
                               {inside(a), inside(b)}}) {
      const Rational x(p), y(q);
      const auto holds = [](const Span& s, const Rational& exact) {
        return Rational(s.low) <= exact && exact <= Rational(s.high);
      };
      CHECK(holds(a + b, x + y));
      CHECK(holds(a - b, x - y));
      CHECK(holds(a * b, x * y));
      CHECK(holds(p * b, x * y));
      if (b.contains(0))
        CHECK(Span::everything().inside(a / b));
      else
        CHECK(holds(a / b, x / y));
    }
  }
}

TEST_CASE(
    "cosine and sine of a span: those of its angles, to a few units; of one that holds a quarter turn, its "
    "extreme") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> start(-20, 20), width(0, 3), share(0, 1);
  for (int trial = 0; trial < 5000; ++trial) {
    const double a = start(random);
    CAPTURE(a);
    const auto [c, s] = circle(Span(a));
    // four units are added to values that are one off
    CHECK(tight(c, cos(Mpfr50(a)), 6));
    CHECK(tight(s, sin(Mpfr50(a)), 6));
    const Span wide(a, a + width(random));
    const Circle around = circle(wide);
    for (int i = 0; i < 10; ++i) {
      const Mpfr50 at = Mpfr50(a) + Mpfr50(share(random)) * Mpfr50(wide.width());
      CHECK(around.cosine.low <= cos(at));
      CHECK(around.cosine.high >= cos(at));
      CHECK(around.sine.low <= sin(at));
      CHECK(around.sine.high >= sin(at));
    }
  }
}

TEST_CASE("spans with ends beyond the largest double, or at zero, exclude no number that may be inside") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::vector<double> numbers{-1e308, -1e300, -2, -5e-324, 0, 5e-324, 3, 1e300, 1e308};
  std::vector<double> ends = numbers;
  ends.insert(ends.begin(), -infinite);
  ends.push_back(infinite);
  std::vector<Span> spans;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i; j < ends.size(); ++j) {
      if (ends[i] < infinite && ends[j] > -infinite) spans.emplace_back(ends[i], ends[j]);
    }
  }
  const auto holds = [](const Span& s,
                        const Rational& exact) {  // an end that is not a number excludes nothing
    return !(std::isfinite(s.low) ? Rational(s.low) > exact : s.low > 0) &&
           !(std::isfinite(s.high) ? Rational(s.high) < exact : s.high < 0);
  };
  std::size_t excluded = 0;
  for (const Span& a : spans) {
    for (const Span& b : spans) {
      const Span sum = a + b, difference = a - b, product = a * b, quotient = a / b;
      for (const double p : numbers) {
        if (!a.contains(p)) continue;
        const Span multiple = p * b;
        for (const double q : numbers) {
          if (!b.contains(q)) continue;
          const Rational x(p), y(q);
          const bool all = holds(sum, x + y) && holds(difference, x - y) && holds(product, x * y) &&
                           holds(multiple, x * y) && (y == 0 || holds(quotient, x / y));
          excluded += all ? 0 : 1;
        }
      }
    }
  }
  CHECK(excluded == 0);
}
