#include "diagnose/design/expected_information.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"

using namespace plumbline::diagnose;

namespace {

/// Predicts two readings, the same but for what its one parameter moves.
Forecast at(double first, double second, double slope = 0, double variance = 0) {
  return {Eigen::Vector2d(first, second), Eigen::Vector2d(slope, 0),
          Eigen::MatrixXd::Constant(1, 1, variance)};
}

double normal_density(double x, double mean, double variance) {
  return std::exp(-(x - mean) * (x - mean) / (2 * variance)) / std::sqrt(2 * std::acos(-1.0) * variance);
}

/// Mutual information of one reading and which of two, alike probable, it came from, by the trapezoidal rule.
double information(double mean_a, double variance_a, double mean_b, double variance_b) {
  double sum = 0;
  constexpr double step = 1e-3;
  for (double x = -40; x < 40; x += step) {
    const double a = normal_density(x, mean_a, variance_a), b = normal_density(x, mean_b, variance_b);
    if (a > 0) sum += step * a / 2 * std::log(2 * a / (a + b));
    if (b > 0) sum += step * b / 2 * std::log(2 * b / (a + b));
  }
  return sum;
}

}  // namespace

TEST_CASE("a run tells nothing where hypotheses agree, and all where they differ widely") {
  CHECK(expected_information({at(1, 2), at(1, 2), at(1, 2)}) == doctest::Approx(0));
  CHECK(expected_information({at(0, 0), at(100, 0), at(0, 100)}) == close_to(std::log(3)));
  // Two of three that agree: ln 3 before, 2/3 ln 2 after.
  CHECK(expected_information({at(0, 0), at(0, 0), at(0, 100)}) ==
        close_to(std::log(3) - 2 * std::log(2) / 3));
}

TEST_CASE("the expected information never exceeds the exact one") {
  for (const double apart : {0.2, 0.7, 1.5, 3.0, 6.0})
    for (const double variance : {0.0, 0.5, 3.0, 20.0}) {
      const double expected = expected_information({at(0, 0), at(apart, 0, 1, variance)});
      const double exact = information(0, 1, apart, 1 + variance);
      CAPTURE(apart);
      CAPTURE(variance);
      CHECK(expected <= exact + 1e-6);
      CHECK(expected > exact / 4);
    }
}

TEST_CASE("differences that a free parameter absorbs are worth nothing") {
  const double known = expected_information({at(0, 0, 1, 0), at(2, 0, 1, 0)});
  CHECK(expected_information({at(0, 0, 1, 100), at(2, 0, 1, 100)}) < 0.02 * known);
  // Along a reading that it does not move, it may be as open as it likes.
  CHECK(expected_information({at(0, 0, 1, 100), at(0, 2, 1, 100)}) == close_to(known));
}
