#include <doctest/doctest.h>

#include <boost/math/constants/constants.hpp>
#include <numbers>
#include <plumbline/chain/linearised.hpp>
#include <plumbline/straight/buckling_mode.hpp>
#include <random>

#include "tests/close_to.hpp"

using namespace plumbline;

namespace {

/// Lengths and stiffnesses spread log-uniformly over 10^-decades … 10^decades.
Chain<double> graded_chain(std::size_t n, double decades, std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(-decades, decades);
  std::vector<double> length(n), stiffness(n);
  for (double& L : length) L = std::pow(10, exponent(random));
  for (double& k : stiffness) k = std::pow(10, exponent(random));
  return Chain<double>(length, stiffness);
}

/// A double is a fraction.
Chain<Rational> exactly(const Chain<double>& chain) {
  return convert<Rational>(chain, [](double value) { return Rational(value); });
}

/// The certificate: force number m of the chain lies within this relative distance of F.
bool certified(const Chain<Rational>& chain, std::size_t m, double F, double relative) {
  const Rational d(relative);
  return count_below(chain, Rational(Rational(F) * (1 - d))) <= m &&
         count_below(chain, Rational(Rational(F) * (1 + d))) > m;
}

/// Rounding perturbs each of the 2 n data by a few units of 1.1e-16, and what the perturbations do to a
/// critical force is their weighted mean. A link adds two roundings to the run of (h, g): at most n of them.
double tolerance(std::size_t n) {
  return static_cast<double>(2 * n + 8) * 1.2e-16;
}

}  // namespace

TEST_CASE("two links: F = (k_1 L_2^2 + k_2 (L_1 + L_2)^2) / (L_1 L_2 (L_1 + L_2)), from (29) by hand") {
  CHECK(critical_forces(Chain<double>({1, 1}, {1, 1}), 9) == std::vector<double>{2.5});
  CHECK(critical_forces(Chain<double>({1, 1}, {0, 1}), 9) == std::vector<double>{2});  // 2k/L, (2)
  CHECK(critical_forces(Chain<double>({1, 1}, {1, 0}), 9) == std::vector<double>{0.5});
}

TEST_CASE_TEMPLATE(
    "equal links on a passive base: F_m = 4 k/L sin^2(m pi / 2n), k/L and 3k/L for three links", Real, double,
    Mpfr50) {
  using std::abs;
  using std::sin;
  // The heights' pencil is then the square of the second difference T against T itself: eigenvalues of T k/L.
  for (const std::size_t n : {2U, 3U, 4U, 17U, 60U}) {
    std::vector<Real> k(n, Real(3));
    k[0] = Real(0);
    const auto forces = critical_forces(Chain<Real>(std::vector<Real>(n, Real(2)), k), n);
    REQUIRE(forces.size() == n - 1);
    for (std::size_t m = 1; m < n; ++m) {
      const Real s = sin(Real(boost::math::constants::pi<Real>() * Real(m) / Real(2 * n)));
      const Real expected = Real(4) * Real(3) / Real(2) * s * s;
      CHECK(abs(Real(forces[m - 1] / expected - Real(1))) <= Real(2 * n + 8) * epsilon<Real>());
    }
  }
}

TEST_CASE(
    "graded chains: every critical force is certified to its last digits by counts in exact fractions") {
  std::mt19937 random(1);
  for (const std::size_t n : {2U, 3U, 5U, 8U, 13U}) {
    for (int repeat = 0; repeat < 5; ++repeat) {
      for (const double decades : {0.5, 8.0, 20.0}) {
        const auto chain = graded_chain(n, decades, random);
        const auto forces = critical_forces(chain, n);
        REQUIRE(forces.size() == n - 1);
        for (std::size_t m = 0; m + 1 < n; ++m) CHECK(certified(exactly(chain), m, forces[m], tolerance(n)));
      }
    }
  }
}

TEST_CASE("a mode satisfies (29) and (30), and its energy factor is its force") {
  std::mt19937 random(2);
  for (const std::size_t n : {2U, 3U, 6U, 12U}) {
    for (int repeat = 0; repeat < 5; ++repeat) {
      const auto plain = graded_chain(n, 2, random);
      auto k = plain.stiffness();
      if (repeat > 0) k[static_cast<std::size_t>(repeat - 1) * (n - 1) / 3] = 0;  // base, interior, end
      const Chain<double> chain(plain.length(), k);
      const auto high = convert<Mpfr50>(chain, [](double x) { return Mpfr50(x); });
      for (const auto& mode : critical_modes(high, n)) {
        using Column = Vector<Mpfr50>;
        const auto q = Eigen::Map<const Column>(mode.q.data(), static_cast<Eigen::Index>(n));
        const Column moment =
            matrix_B(high).topLeftCorner(q.size(), q.size()) * q + matrix_S1(high) * q * mode.force;
        const Column lateral = matrix_S0(high) * mode.fy;
        // terms that cancel are at most F z_1 n times the largest angle
        const Mpfr50 scale = mode.force * matrix_S0(high)(0) * Mpfr50(n);
        CHECK((moment + lateral).lpNorm<Eigen::Infinity>() < scale * Mpfr50(1e-45));
        CHECK(abs(matrix_S0(high).dot(q)) < matrix_S0(high)(0) * Mpfr50(1e-45));
        CHECK(abs(energy_factor(high, mode.q) / mode.force - 1) < Mpfr50(1e-40));
        CHECK(abs(q.squaredNorm() + mode.fy * mode.fy - 1) < Mpfr50(1e-45));
      }
    }
  }
}

TEST_CASE("forces that tie across an interior passive joint come twice, with independent shapes") {
  // Unit links; before the passive joint F = k_1 z_2 / (z_1 L_1) = 2, behind it F = k_3 (1/L_2 + 1/L_3) = 2.
  const Chain<double> chain({1, 1, 1}, {3, 0, 1});
  CHECK(critical_forces(chain, 9) == std::vector<double>{2, 2});
  CHECK(critical_forces(chain, 1) == std::vector<double>{2});
  const auto modes = critical_modes(chain, 9);
  REQUIRE(modes.size() == 2);
  CHECK(modes[0].q[2] == 0);  // the links behind the joint stay in line
  CHECK(modes[0].q[0] > 0);
  CHECK(modes[1].q[0] == 0);
  CHECK(modes[1].q[1] > 0);
  CHECK(modes[1].fy == 0);
  for (const auto& mode : modes) CHECK(energy_factor(chain, mode.q) == close_to(2).epsilon(1e-14));
}

TEST_CASE("near ties in one piece are told apart as far as the type can") {
  // A weak spring in place of the passive joint above.
  for (const double weak : {1e-6, 1e-12, 1e-17, 1e-30}) {
    const Chain<double> chain({1, 1, 1}, {6, weak, 1});  // near {6, 0, 1}: forces 4 and 2 plus the coupling
    const Chain<double> tied({1, 1, 1}, {3, weak, 1});
    for (const auto& near : {chain, tied}) {
      const auto forces = critical_forces(near, 9);
      for (std::size_t m = 0; m < 2; ++m) CHECK(certified(exactly(near), m, forces[m], tolerance(3)));
    }
  }
}

TEST_CASE("scales that leave the range of double on the way do no harm") {
  for (const double scale : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    // F is [k] / [L]
    const Chain<double> long_links({scale, scale}, {scale, scale});
    CHECK(critical_forces(long_links, 1)[0] == close_to(2.5).epsilon(1e-14));
    CHECK(critical_modes(long_links, 1)[0].q[0] == close_to(2 / std::sqrt(21)).epsilon(1e-14));
  }
  const auto apart = critical_modes(Chain<double>({1, 1e-200, 1}, {1, 1e250, 1}), 1)[0];
  const Chain<Mpfr50> same({1, Mpfr50(1e-200), 1}, {1, Mpfr50(1e250), 1});
  const auto expected = critical_modes(same, 2)[0];
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(apart.q[i] == close_to(expected.q[i].convert_to<double>()).epsilon(1e-14));
  }
  CHECK_THROWS_AS(critical_forces(Chain<double>({1e-300, 1e-300}, {1e300, 1e300}), 1), Error);
  std::mt19937 random(4);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const auto chain = graded_chain(6, 70, random);
    const auto forces = critical_forces(chain, 6);
    for (std::size_t m = 0; m < 5; ++m) CHECK(certified(exactly(chain), m, forces[m], tolerance(6)));
  }
}

TEST_CASE("the lowest force alone is the first of all, and so are the m lowest") {
  std::mt19937 random(5);
  for (const std::size_t n : {2U, 33U, 64U, 257U, 500U}) {
    for (const double decades : {0.0, 0.5, 4.0}) {
      const auto chain = graded_chain(n, decades, random);
      const auto all = critical_forces(chain, n), three = critical_forces(chain, 3);
      REQUIRE(all.size() == n - 1);
      CHECK(std::is_sorted(all.begin(), all.end()));
      CHECK(lowest_critical_force(chain) == critical_forces(chain, 1)[0]);
      CHECK(critical_forces(chain, 1)[0] == close_to(all[0]).epsilon(tolerance(n)));
      for (std::size_t m = 0; m < three.size(); ++m) {
        CHECK(three[m] == close_to(all[m]).epsilon(tolerance(n)));
      }
    }
  }
}

TEST_CASE("long chains keep 13 digits") {
  for (const std::size_t n : {1000U, 100000U, 1000000U}) {
    // equal links of a length that is no double's power of two on a passive base
    std::vector<double> k(n, 0.3);
    k[0] = 0;
    const double force = critical_forces(Chain<double>(std::vector<double>(n, 0.1), k), 1)[0];
    const long double L = 0.1, stiffness = 0.3, s = std::sin(std::numbers::pi_v<long double> / (2.0L * n));
    CHECK(std::abs(static_cast<double>(force / (4 * stiffness / L * s * s) - 1)) < 1e-13);
  }
}

TEST_CASE("two hundred digits, in a precision set at run time") {
  const unsigned before = Mpfr::default_precision();
  Mpfr::default_precision(200);
  const Mpfr force = critical_forces(Chain<Mpfr>({1, 1, 1}, {0, 1, 1}), 2)[1];
  CHECK(abs(force - 3) < pow(Mpfr(10), -198));
  Mpfr::default_precision(before);
}

TEST_CASE("a force that is met on the way is counted as one change of sign, and not below itself") {
  // h_2 = 0 at F = 5/2 for two unit links with unit springs; a third link goes on from there
  const Rational F(5, 2), little(1, 1000000);
  const Chain<Rational> two({1, 1}, {1, 1});
  CHECK(count_below(two, F) == 0);
  CHECK(count_below(two, Rational(F + little)) == 1);
  CHECK(count_below(two, Rational(0)) == 0);
  // h_2 = 0 at F = p_1 (c_1 + c_2) with p_1 = 6, c_1 = 1/9, c_2 = 1/4
  const Chain<Rational> three({1, 1, 1}, {1, 1, 1});
  const Rational zero(13, 6);
  CHECK(count_below(three, Rational(zero - little)) == count_below(three, zero));
  CHECK(count_below(three, Rational(zero + little)) == count_below(three, zero));
  CHECK(count_below(three, Rational(1000)) == 2);
}

TEST_CASE("a mode that bends at one end alone is right at both, as fifty digits show") {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> exponent(-3, 3);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> length(3 + trial % 3), stiffness(length.size());
    for (double& L : length) L = std::pow(10, exponent(random) / 2);
    for (double& k : stiffness) k = std::pow(10, exponent(random));
    const Chain<double> chain(length, stiffness);
    const auto exact = convert<Mpfr50>(chain, [](double x) { return Mpfr50(x); });
    const auto modes = critical_modes(chain, length.size());
    const auto true_modes = critical_modes(exact, length.size());
    REQUIRE(modes.size() == true_modes.size());
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (m > 0 && modes[m].force < 1.01 * modes[m - 1].force) continue;  // the shapes of near twins mix
      if (m + 1 < modes.size() && modes[m + 1].force < 1.01 * modes[m].force) continue;
      for (std::size_t i = 0; i < length.size(); ++i) {
        // a twin at a hundredth lets an error of some roundings grow a hundredfold
        CAPTURE(trial);
        CHECK(std::abs(modes[m].q[i] - static_cast<double>(true_modes[m].q[i])) < 1e-12);
      }
    }
  }
}
