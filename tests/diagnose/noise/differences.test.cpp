#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/proportional_noise.hpp"
#include "diagnose/noise/uneven_noise.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Third differences that alternate, each exactly as large as noise of the declared sigma and of r times the
/// level is, times `common`: no other proportion explains them as well (Jensen's inequality).
Differences exactly(const std::vector<double>& levels, double r, double common = 1) {
  Differences all;
  all.levels = levels;
  for (std::size_t i = 0; i < levels.size(); ++i)
    all.sizes.push_back((i % 2 == 0 ? common : -common) * std::hypot(1.0, r * levels[i]));
  return all;
}

std::vector<double> rising(std::size_t count, double largest) {
  std::vector<double> levels;
  for (std::size_t i = 1; i <= count; ++i)
    levels.push_back(largest * static_cast<double>(i) / static_cast<double>(count));
  return levels;
}

/// The proportions that are looked at: powers of 1.15 over the largest level.
double on_grid(int power, double largest) {
  return std::pow(1.15, power) / largest;
}

}  // namespace

TEST_CASE("a third difference and its level, by hand") {
  const Differences step({0, 0, 0, 1}, 0.5);
  REQUIRE(step.sizes.size() == 1);
  CHECK(step.sizes[0] == close_to(1 / (std::sqrt(20.0) * 0.5)));
  // the parabola through them is 0.05, -0.15, 0.15, 0.95, weighed 1, 9, 9, 1
  CHECK(step.levels[0] == close_to(std::sqrt((0.0025 + 9 * 0.0225 + 9 * 0.0225 + 0.9025) / 20)));
  // a parabola has none, and is its own level
  const Differences parabola({1, 4, 9, 16, 25}, 1);
  REQUIRE(parabola.sizes.size() == 2);
  CHECK(parabola.sizes[1] == 0);
  CHECK(parabola.levels[0] == close_to(std::sqrt((1 + 9 * 16 + 9 * 81 + 256) / 20.0)));
  CHECK(parabola.levels[1] == close_to(std::sqrt((16 + 9 * 81 + 9 * 256 + 625) / 20.0)));
  const Differences third({1, 0, 0, 0, 2}, 1);
  CHECK(third.sizes[0] == close_to(-1 / std::sqrt(20.0)));
  CHECK(third.sizes[1] == close_to(2 / std::sqrt(20.0)));
  CHECK(Differences({1, 2, 3}, 1).sizes.empty());
  CHECK(Differences({1, 0, 0, 0, 2}, 1).where({false, true}).sizes == std::vector<double>{third.sizes[1]});
  CHECK(Differences({1, 0, 0, 0, 2}, 1).where({true, false}).levels == std::vector<double>{third.levels[0]});
}

TEST_CASE("a proportion that the sizes have exactly is found exactly, in any units and in one run or two") {
  for (const double largest : {1.0, 80.0})
    for (const int power : {9, 14}) {
      CAPTURE(power);
      const double r = on_grid(power, largest);
      const std::vector<double> levels = rising(60, largest);
      CHECK(proportional_noise({exactly(levels, r)}) == close_to(r).epsilon(1e-12));
      const std::vector<double> first(levels.begin(), levels.begin() + 20),
          second(levels.begin() + 20, levels.end());
      CHECK(proportional_noise({exactly(first, r), exactly(second, r)}) == close_to(r).epsilon(1e-12));
      // noise between half of what is declared and all of it agrees as well
      CHECK(proportional_noise({exactly(levels, r, 0.6)}) == close_to(r).epsilon(1e-12));
    }
}

TEST_CASE(
    "noise that is more than declared is rather more in proportion, that is less than half rather less") {
  const std::vector<double> levels = rising(60, 1);
  const double r = on_grid(9, 1);
  CHECK(proportional_noise({exactly(levels, r, 1.6)}) > 1.1 * r);
  CHECK(proportional_noise({exactly(levels, r, 0.25)}) < r / 1.1);
}

TEST_CASE("fewer than thirty differences, or none of any size, show no proportion") {
  const double r = on_grid(20, 1);
  CHECK(proportional_noise({exactly(rising(30, 1), r)}) == close_to(r).epsilon(1e-12));
  CHECK(proportional_noise({exactly(rising(29, 1), r)}) == 0);
  CHECK(proportional_noise({exactly(std::vector<double>(60, 0.0), r)}) == 0);
  Differences mostly_none = exactly(rising(60, 1), r);
  for (std::size_t i = 0; i < 40; ++i) mostly_none.sizes[i] = 0;
  CHECK(proportional_noise({mostly_none}) == 0);
  CHECK(proportional_noise({}) == 0);
}

TEST_CASE("a proportion has to gain sixteen of twice the log-likelihood") {
  // levels 0 and 1 by turns: widths 1 and w, of which all alike lose ln((1 + w^2) / 2) - ln w a value
  const double r = on_grid(4, 1), square = 1 + r * r;
  const double gain = std::log((1 + square) / 2) - std::log(square) / 2;
  const auto enough = static_cast<std::size_t>(std::ceil(beliefs::proportional_gain / gain / 2)) * 2;
  for (const std::size_t count : {enough - 2, enough + 2}) {
    std::vector<double> levels(count);
    for (std::size_t i = 0; i < count; ++i) levels[i] = i % 2 == 0 ? 0 : 1;
    CHECK(proportional_noise({exactly(levels, r)}) == close_to(count < enough ? 0 : r).epsilon(1e-12));
  }
}

TEST_CASE("differences that do not alternate by a fifth are those of a curve") {
  // Of each four one has the sign of its neighbour: products -w/w', but one in four of the other sign.
  const double r = on_grid(9, 1);
  const auto with_turns = [&](std::size_t every) {
    Differences all = exactly(rising(120, 1), r);
    double sign = 1;
    for (std::size_t i = 0; i < all.sizes.size(); ++i) {
      if (i % every != 0) sign = -sign;
      all.sizes[i] = sign * std::abs(all.sizes[i]);
    }
    return proportional_noise({all});
  };
  CHECK(with_turns(3) > 0);   // of neighbours as large a third of products is one: -1/3
  CHECK(with_turns(2) == 0);  // half of them: 0
}

TEST_CASE("a difference that an outlier enters, and the one to either side, say nothing") {
  const double r = on_grid(9, 1);
  Differences all = exactly(rising(63, 1), r);
  for (const std::size_t i : {30U, 31U, 32U}) {
    all.levels[i] = 20;
    all.sizes[i] *= i == 31 ? 100 : 1;
  }
  CHECK(proportional_noise({all}) == close_to(r).epsilon(1e-12));
  // at the ends of a series too
  all = exactly(rising(63, 1), r);
  all.sizes[0] *= 100;
  all.levels[0] = all.levels[1] = 20;
  CHECK(proportional_noise({all}) == close_to(r).epsilon(1e-12));
}

TEST_CASE("joints whose angles scatter alike have no noise of their own") {
  Differences alike;
  for (int i = 0; i < 40; ++i) alike.sizes.push_back(i % 2 == 0 ? 1 : -1), alike.levels.push_back(0);
  CHECK(uneven_noise({{{alike, {}}}, {{alike, {}}}, {{alike, {}}}}) == std::vector<double>{1, 1, 1});
}
