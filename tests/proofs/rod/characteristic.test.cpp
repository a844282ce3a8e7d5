#include "proofs/rod/characteristic.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "proofs/rod/real_frequencies.hpp"
#include "tests/close_to.hpp"
#include "tests/proofs/rod/some_rods.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// Beck's characteristic function (V. V. Bolotin, Nonconservative Problems of the Theory of Elastic
/// Stability, 1963, 2.2) for unit M and V at the base: over -(P² + 4 x), x = ω².
double beck_function(double P, double x) {
  const double root = std::sqrt(P * P / 4 + x), a = std::sqrt(root - P / 2), b = std::sqrt(root + P / 2);
  return -(P * P + 2 * x * (1 + std::cosh(a) * std::cos(b)) + P * std::sqrt(x) * std::sinh(a) * std::sin(b)) /
         (P * P + 4 * x);
}

}  // namespace

TEST_CASE("the characteristic function of Beck's column, and its derivatives") {
  const Characteristic function(divided(beck_rod()), 22, 4000);
  const double scale = function.at(Span(0), Span(3)).value.middle() / beck_function(0, 3);
  for (const double P : {0.0, 5.0, 21.0}) {
    for (const double x : {1.0, 120.0, 3900.0}) {
      const Jet<Span> jet = function.at(Span(P), Span(x));
      const double h = 1e-3, known = scale * beck_function(P, x);
      CHECK(jet.value.middle() == close_to(known).epsilon(1e-9));
      const auto at = [&](double dP, double dx) { return scale * beck_function(P + dP, x + dx); };
      // central differences of step h: 1e-16 / h^2 of rounding in the second, times the functions' size
      if (P > 0)
        CHECK(jet.by_factor.middle() == doctest::Approx((at(h, 0) - at(-h, 0)) / (2 * h)).epsilon(1e-5));
      CHECK(jet.by_square.middle() == doctest::Approx((at(0, h) - at(0, -h)) / (2 * h)).epsilon(1e-5));
      CHECK(function.at(Interval::from_double(P), Interval::from_double(x)).value.width() < 1e-30);
    }
  }
}

TEST_CASE("a jet over spans contains those of its points") {
  const Characteristic function(divided(beck_rod()), 22, 4000);
  const Span factors{10, 10.5}, squares{300, 330};
  const Jet<Span> all = function.at(factors, squares);
  for (const double P : {10.0, 10.2, 10.5}) {
    for (const double x : {300.0, 317.0, 330.0}) {
      const Jet<Span> one = function.at(Span(P), Span(x));
      CHECK(one.value.inside(all.value));
      CHECK(one.by_factor.inside(all.by_factor));
      CHECK(one.by_square.inside(all.by_square));
      CHECK(one.by_square_twice.inside(all.by_square_twice));
    }
  }
}

TEST_CASE("the real frequencies of a cantilever: 3.516^2, 22.03^2, 61.70^2 without a load") {
  const Characteristic function(divided(beck_rod()), 22, 8000);
  CHECK(simple_zeros(function, Span(0), {0, 8000}) == 3);
  CHECK(simple_zeros(function, Span(0), {0, 400}) == 1);
  CHECK(simple_zeros(function, {19, 19.1}, {0, 400}) == 2);
  CHECK(simple_zeros(function, Span(21), {0, 400}) == 0);  // after the flutter
  CHECK_FALSE(simple_zeros(function, {20, 20.1}, {0, 400}).has_value());
}
