#include <doctest/doctest.h>

#include <boost/math/constants/constants.hpp>
#include <plumbline/algorithm1.hpp>
#include <plumbline/buckling_mode.hpp>
#include <plumbline/linearised.hpp>
#include <random>

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

TEST_CASE("Algorithm 1 in 50 digits finds the same forces and shapes") {
  std::mt19937 random(3);
  const auto chain = convert<Mpfr50>(graded_chain(6, 1, random), [](double value) { return Mpfr50(value); });
  const auto peer = algorithm1(chain);
  const auto modes = critical_modes(chain, 9);
  REQUIRE(modes.size() == peer.size());
  for (std::size_t m = 0; m < peer.size(); ++m) {
    CHECK(abs(modes[m].force / peer[m].force - 1) < Mpfr50(1e-40));
    for (std::size_t i = 0; i < 6; ++i) CHECK(abs(modes[m].q[i] - peer[m].q[i]) < Mpfr50(1e-38));
  }
}

TEST_CASE("a force that is met on the way is counted as one change of sign") {
  // h_2 = 0 at F = 5/2 for the first two links alone
  const Chain<Rational> chain({1, 1, 1}, {1, 1, 1});
  CHECK(count_below(chain, Rational(0)) == 0);
  CHECK(count_below(chain, Rational(1000)) == 2);
}
