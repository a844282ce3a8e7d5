// The theorems of proofs/theorems.md that say what lengths, stiffnesses and imperfections do, on random
// chains.

#include <doctest/doctest.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numeric>
#include <plumbline/straight/buckling_mode.hpp>
#include <random>

#include "proofs/census/census.hpp"

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

std::vector<double> random_list(std::mt19937& random, std::size_t n, double low = 0.3, double high = 3) {
  std::uniform_real_distribution<double> any(low, high);
  std::vector<double> values(n);
  for (double& x : values) x = any(random);
  return values;
}

double force(const std::vector<double>& length, const std::vector<double>& stiffness, std::size_t mode) {
  return critical_modes(Chain<double>(length, stiffness), mode + 1).at(mode).force;
}

std::vector<double> directions(const Mode<double>& mode) {
  std::vector<double> phi(mode.q.size());
  std::partial_sum(mode.q.begin(), mode.q.end(), phi.begin());
  return phi;
}

/// sum L_j theta_j^p
double moment(const std::vector<double>& length, const std::vector<double>& theta, int power) {
  double sum = 0;
  for (std::size_t j = 0; j < length.size(); ++j) sum += length[j] * std::pow(theta[j], power);
  return sum;
}

/// The stiffness with which the distribution of theorem "Strongest chain" has the sum one, and its F_1.
std::pair<std::vector<double>, double> strongest(const std::vector<double>& length) {
  const std::size_t n = length.size();
  double total = 0, first = 0;
  for (std::size_t j = 0; j < n; ++j) total += length[j], first += static_cast<double>(j + 1) * length[j];
  std::vector<double> theta(n), stiffness(n, 0);
  for (std::size_t j = 0; j < n; ++j) theta[j] = static_cast<double>(j + 1) - first / total;
  const double best = 1 / moment(length, theta, 2);
  for (std::size_t i = 1; i < n; ++i) stiffness[i] = stiffness[i - 1] - best * length[i - 1] * theta[i - 1];
  return {stiffness, best};
}

}  // namespace

TEST_CASE("Derivative by length: against difference quotients, and its sign") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t n = 2 + static_cast<std::size_t>(trial % 5);
    const auto length = random_list(random, n);
    auto stiffness = random_list(random, n);
    if (trial % 3 == 0) stiffness[0] = 0;
    const auto modes = critical_modes(Chain<double>(length, stiffness), n - 1);
    const double z = std::accumulate(length.begin(), length.end(), 0.0);
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const auto phi = directions(modes[m]);
      const double F = modes[m].force, c = stiffness[0] * phi[0] / z, square = moment(length, phi, 2);
      for (std::size_t j = 0; j < n; ++j) {
        const double slope = -phi[j] * (F * phi[j] + 2 * c) / square, h = 1e-5 * length[j];
        auto longer = length, shorter = length;
        longer[j] += h, shorter[j] -= h;
        const double quotient = (force(longer, stiffness, m) - force(shorter, stiffness, m)) / (2 * h);
        // the quotient is off by h^2 times the third derivative, of the order of F / L^3, and by rounding / h
        CHECK(quotient == doctest::Approx(slope).epsilon(1e-6).scale(F / length[j]));
        const double bound = F > 0 ? -2 * c / F : 0;
        const bool between = phi[j] * (bound - phi[j]) > 0;
        if (std::abs(slope) > 1e-9 * F / length[j]) CHECK((slope > 0) == between);
        if (j == 0 || stiffness[0] == 0) CHECK(slope <= 1e-12 * F / length[j]);
      }
    }
  }
}

TEST_CASE("Concave in stiffness: Southwell and Dunkerley") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t n = 3 + static_cast<std::size_t>(trial % 6);
    const auto length = random_list(random, n), k = random_list(random, n), more = random_list(random, n);
    std::vector<double> both(n);
    for (std::size_t i = 0; i < n; ++i) both[i] = k[i] + more[i];
    CHECK(force(length, both, 0) >= (force(length, k, 0) + force(length, more, 0)) * (1 - 1e-12));
    double flexibility = 0;  // E_2 / E_1 = sum 1 / F_m
    for (const auto& mode : critical_modes(Chain<double>(length, k), n)) flexibility += 1 / mode.force;
    double e1 = 0, e2 = 0;  // "Closed form", divided by the product of all stiffnesses
    std::vector<double> z(n);
    std::partial_sum(length.rbegin(), length.rend(), z.rbegin());
    for (std::size_t i = 0; i < n; ++i) {
      e1 += z[i] * z[i] / k[i];
      for (std::size_t j = i + 1; j < n; ++j) e2 += z[i] * z[j] * (z[i] - z[j]) / (k[i] * k[j]);
    }
    CHECK(e2 / e1 == close_to(flexibility).epsilon(1e-10));
    const double lowest = force(length, k, 0);
    CHECK(e1 / e2 < lowest);
    CHECK(lowest < static_cast<double>(n - 1) * e1 / e2);
  }
}

TEST_CASE("Strongest chain: no other distribution of the same stiffness has a larger lowest force") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    const std::size_t n = 2 + static_cast<std::size_t>(trial % 8);
    const auto length = random_list(random, n);
    const auto [stiffness, best] = strongest(length);
    CHECK(std::accumulate(stiffness.begin(), stiffness.end(), 0.0) == close_to(1).epsilon(1e-12));
    CHECK(force(length, stiffness, 0) == close_to(best).epsilon(1e-11));
    for (int other = 0; other < 10; ++other) {
      auto k = random_list(random, n, 0.01, 1);
      k[0] = 0;
      const double sum = std::accumulate(k.begin(), k.end(), 0.0);
      for (double& x : k) x /= sum;
      CHECK(force(length, k, 0) <= best * (1 + 1e-12));
    }
  }
  for (const auto& [n, gain] : {std::pair<std::size_t, double>{4, 0.024}, {9, 0.105}}) {
    const std::vector<double> length(n, 1);
    std::vector<double> equal(n, 1 / static_cast<double>(n - 1));
    equal[0] = 0;
    const double cube = static_cast<double>(n * n * n - n);
    CHECK(strongest(length).second == close_to(12 / cube).epsilon(1e-12));
    CHECK(strongest(length).second / force(length, equal, 0) - 1 == close_to(gain).epsilon(0.02));
  }
}

TEST_CASE(
    "Bent above the lowest force: below F_1 a chain on a passive base has its two straight shapes alone") {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> hundredths(40, 250);
  for (int trial = 0; trial < 12; ++trial) {
    const std::size_t n = 2 + static_cast<std::size_t>(trial % 3);
    std::vector<Rational> length, stiffness;
    for (std::size_t i = 0; i < n; ++i) {
      length.emplace_back(hundredths(random), 100);
      stiffness.emplace_back(i == 0 ? 0 : hundredths(random), 100);
    }
    const Chain<Rational> exact(length, stiffness);
    const double lowest = critical_modes(from_rational<double>(exact), 1)[0].force;
    const auto count = [&](double share) {
      const Interval F = Interval::from_double(-share * lowest);
      const Census census = census_under_force(from_rational<Interval>(exact), {F, Interval(0)});
      REQUIRE(census.complete());
      return census.equilibria.size();
    };
    CAPTURE(trial);
    CHECK(count(0.5) == 2);
    CHECK(count(0.999) == 2);
    CHECK(count(-0.999) == 2);
    CHECK(count(1.001) == 4);
  }
}

TEST_CASE("Imperfection: the 2/3 law of two links whose force falls after buckling") {
  // guided along y = 0 two links have one freedom t = theta_1, and F = E'(t) / (shortening)'(t)
  const double L1 = 2, L2 = 1, k1 = 1, k2 = 0.05;
  const double F1 = (k1 / (L1 * L1) + k2 * (1 / L1 + 1 / L2) * (1 / L1 + 1 / L2)) / (1 / L1 + 1 / L2);
  const double curvature = (-5 + 27 * k2) / 144;  // "Supercritical", with phi = (1/L_1, -1/L_2)
  for (const double epsilon : {1e-3, 1e-4, 1e-5}) {
    // unloaded along the mode: e = phi, so b = F_1
    const auto compression = [&](double t) {
      const double u = -std::asin(L1 * std::sin(t) / L2), du = -L1 * std::cos(t) / (L2 * std::cos(u));
      const double q1 = t - epsilon / L1, q2 = (u - t) + epsilon * (1 / L1 + 1 / L2);
      return (k1 * q1 + k2 * q2 * (du - 1)) / (L1 * std::sin(t) + L2 * std::sin(u) * du);
    };
    const double expected = 3 * std::cbrt(-curvature) * std::pow(epsilon * F1 / 2, 2.0 / 3);
    const auto fold =
        boost::math::tools::brent_find_minima([&](double t) { return -compression(t); }, epsilon, 0.4, 40);
    const double found = F1 + fold.second;
    CAPTURE(epsilon);
    // the theorem leaves out a term smaller by epsilon^(2/3), with a factor of the order of one here
    CHECK(found == close_to(expected).epsilon(std::pow(epsilon, 2.0 / 3)));
  }
}
