#include "proofs/exact/double_word.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/number.hpp>
#include <random>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

using Word = DoubleWord<double>;

Rational exactly(const Word& x) {
  return Rational(x.high) + Rational(x.low);
}

/// Between 1 and 2, every other time at an end or next to the square root of 2: there bounds are tight.
double significand(std::mt19937_64& random) {
  const auto few = static_cast<double>(random() % 64);
  switch (random() % 6) {
    case 0:
      return 1 + 0x1p-52 * few;
    case 1:
      return 2 - 0x1p-52 * (few + 1);
    case 2:
      return std::sqrt(2.0) + 0x1p-52 * few;
    default:
      return 1 + 0x1p-52 * static_cast<double>(random() >> 12);
  }
}

/// A word next to 2^exponent whose lower half is often as large as it may be.
Word word(std::mt19937_64& random, int exponent) {
  const double sign = random() % 2 == 0 ? 1 : -1;
  const double high = sign * std::ldexp(significand(random), exponent);
  const int below = random() % 2 == 0 ? 54 : 54 + static_cast<int>(random() % 60);
  const double low = (random() % 2 == 0 ? 1 : -1) * std::ldexp(significand(random), exponent - below);
  return exact_sum_of_ordered(high, low);
}

/// The relative error of what was computed, in units of u^2.
double error_of(const Word& found, const Rational& exact) {
  REQUIRE(found.high == found.high + found.low);
  if (exact == 0) return exactly(found) == 0 ? 0 : INFINITY;
  return std::abs(static_cast<double>(Rational((exactly(found) - exact) / exact))) * 0x1p106;
}

}  // namespace

TEST_CASE("sums and products of two doubles are as close as is proved, cancellation included") {
  std::mt19937_64 random(1);
  double sum = 0, product = 0;
  for (int i = 0; i < 20000; ++i) {
    const Word x = word(random, 0), y = word(random, static_cast<int>(random() % 6) - 3);
    const Word near{-x.high, x.low * (i % 7)};  // leaves of the sum what is in the lower halves
    sum = std::max({sum, error_of(x + y, exactly(x) + exactly(y)),
                    error_of(x + exact_sum(near.high, near.low), exactly(x) + exactly(near))});
    product = std::max(product, error_of(x * y, exactly(x) * exactly(y)));
  }
  CHECK(sum <= 3.0001);
  CHECK(product <= 7);
  // not far below: these cases are hard ones
  CHECK(sum > 1.9);
  CHECK(product > 2.9);
  CHECK(double_word_unit * 0x1p106 >= 7);
}
