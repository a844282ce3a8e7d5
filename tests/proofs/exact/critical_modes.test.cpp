#include "proofs/exact/critical_modes.hpp"

#include <doctest/doctest.h>

#include <boost/math/constants/constants.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/working_precision.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// A chain whose string (theorem "Recursion") is uniform: with the distance to the end point z_i = 1 / i and
/// k_i = z_i^2 its n - 1 beads have mass 1 and its spacings are 1. Fixed at both ends, its deflections are
/// h_i = sin(m pi i / n), its frequencies 2 sin(m pi / 2 n), and so
///
///     F_m = 4 sin^2(m pi / 2 n),   q_i = z_i / k_i (h_i - h_{i-1}), in proportion to i cos(m pi (2 i - 1) /
///     2 n).
Chain<Rational> uniform_string(int n) {
  std::vector<Rational> length, stiffness;
  for (int i = 1; i <= n; ++i) {
    length.push_back(i < n ? Rational(1, i * (i + 1)) : Rational(1, n));
    stiffness.emplace_back(1, i * i);
  }
  return Chain<Rational>(length, stiffness);
}

Mpfr force_of_uniform_string(int n, int m) {
  const Mpfr half = sin(m * boost::math::constants::pi<Mpfr>() / (2 * n));
  return 4 * half * half;
}

/// The angles in proportion to the largest; the first is positive, for m < n.
std::vector<Mpfr> shape_of_uniform_string(int n, int m) {
  std::vector<Mpfr> q;
  Mpfr largest(0);
  for (int i = 1; i <= n; ++i) {
    // an odd multiple of a quarter turn, exactly
    const bool none = m * (2 * i - 1) % (2 * n) == n;
    q.push_back(none ? Mpfr(0)
                     : Mpfr(i * cos(m * (2 * i - 1) * boost::math::constants::pi<Mpfr>() / (2 * n))));
    largest = std::max(largest, Mpfr(abs(q.back())));
  }
  for (Mpfr& angle : q) angle /= largest;
  return q;
}

}  // namespace

TEST_CASE(
    "modes of a chain whose string is uniform: sines, to the last bit, joints that do not turn among them") {
  const WorkingPrecision precision(90);  // far more than what is asked for
  for (const int n : {3, 4, 5, 15, 16, 17, 33}) {
    const Chain<Rational> chain = uniform_string(n);
    for (const auto& [lowest, digits] : {std::pair{1, 8}, {4, 15}, {40, 12}, {3, 25}}) {
      const auto modes = modes_in_decimals(chain, static_cast<std::size_t>(lowest), digits);
      const auto forces = forces_in_decimals(chain, static_cast<std::size_t>(lowest), digits);
      REQUIRE(modes.size() == static_cast<std::size_t>(std::min(lowest, n - 1)));
      REQUIRE(forces.size() == modes.size());
      for (std::size_t at = 0; at < modes.size(); ++at) {
        const int m = static_cast<int>(at) + 1;
        CAPTURE(n);
        CAPTURE(m);
        CAPTURE(digits);
        const Rational force = exactly(force_of_uniform_string(n, m));
        CHECK(modes[at].force == to_decimal(force, digits));
        CHECK(modes[at].energy_factor == to_decimal(force, std::min(digits, 15)));
        CHECK(forces[at].force == modes[at].force);
        CHECK(forces[at].energy_factor == modes[at].energy_factor);
        const std::vector<Mpfr> q = shape_of_uniform_string(n, m);
        std::string signs;
        REQUIRE(modes[at].q.size() == q.size());
        for (std::size_t i = 0; i < q.size(); ++i) {
          CHECK(modes[at].q[i] == static_cast<double>(q[i]));
          signs += q[i] > 0 ? '+' : q[i] < 0 ? '-' : '0';
        }
        CHECK(modes[at].signs == signs);
        // (29) at the base: F_y = -k_1 q_1 / z_1
        CHECK(to_decimal(modes[at].fy, 15) == to_decimal(exactly(Mpfr(-q[0])), 15));
      }
    }
  }
}

TEST_CASE("forces that tie across a passive joint have a shape on either side each, in long chains too") {
  // The uniform string cut where its odd modes have no slope: either half is one bead short of its mirror
  // image, fixed at one end and free at the other, and keeps their forces
  const WorkingPrecision precision(90);
  for (const int n : {5, 17, 35}) {
    const Chain<Rational> whole = uniform_string(n);
    const std::size_t cut = static_cast<std::size_t>(n) / 2;
    std::vector<Rational> stiffness = whole.stiffness();
    stiffness[cut] = 0;
    const auto modes = modes_in_decimals(Chain<Rational>(whole.length(), stiffness), 4, 12);
    REQUIRE(modes.size() == 4);
    for (std::size_t at = 0; at < 4; at += 2) {
      CAPTURE(n);
      const int m = static_cast<int>(at) + 1;  // 1, 3
      CHECK(modes[at].force == to_decimal(exactly(force_of_uniform_string(n, m)), 12));
      CHECK(modes[at + 1].force == modes[at].force);
      const auto left_alone = std::string(static_cast<std::size_t>(n) - cut - 1, '0'),
                 right_alone = std::string(cut, '0');
      const std::size_t left = modes[at].signs.substr(cut + 1) == left_alone ? at : at + 1,
                        right = 2 * at + 1 - left;
      CHECK(modes[left].signs.substr(cut + 1) == left_alone);
      CHECK(modes[right].signs.substr(0, cut) == right_alone);
      // on its own side a mode is that of the whole string, which is as long as one of these turns most
      const std::vector<Mpfr> q = shape_of_uniform_string(n, m);
      for (std::size_t i = 1; i < cut; ++i) {
        const double ratio = modes[left].q[i] / modes[left].q[0];
        CHECK(std::abs(ratio / static_cast<double>(q[i] / q[0]) - 1) < 1e-15);
      }
      for (std::size_t i = cut + 2; i < q.size(); ++i) {
        const double ratio = modes[right].q[i] / modes[right].q.back();
        CHECK(std::abs(ratio / static_cast<double>(q[i] / q.back()) - 1) < 1e-15);
      }
    }
  }
}

TEST_CASE(
    "a force half-way between two decimals goes to the larger, one beside it to the nearer, however near") {
  // two links of one: F = (k_1 + 4 k_2) / 2, and the lowest one of three on a passive base is k
  const Rational little = shifted(Rational(1), -50);
  for (const auto& [half_way, digits, low, high] :
       {std::tuple{"2.5", 1, "2", "3"}, {"2.345", 3, "2.34", "2.35"}, {"1234.5", 4, "1234", "1235"}}) {
    CAPTURE(half_way);
    const Rational F = *parse_decimal(half_way);
    const auto rounded = [&, n = digits](const Rational& force) {
      return forces_in_decimals(Chain<Rational>({1, 1, 1}, {0, force, force}), 1, n).at(0).force;
    };
    CHECK(rounded(F) == high);
    CHECK(rounded(F * (1 + little)) == high);
    CHECK(rounded(F * (1 - little)) == low);
  }
}
