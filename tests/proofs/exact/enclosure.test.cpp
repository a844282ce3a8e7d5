#include "proofs/exact/enclosure.hpp"

#include <doctest/doctest.h>

#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/decimal.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

Rational decimal(const char* text) {
  return *parse_decimal(text);
}

}  // namespace

TEST_CASE("both ends of an enclosure round to the same decimal, however near half-way the force is") {
  // two links of one: the paper's (29) gives F = (k_1 + 4 k_2) / 2
  for (const char* force : {"2.5000001", "2.4999999", "2.50000000003", "2.49999999999997", "2.54999999"}) {
    const Rational F = decimal(force);
    for (const int digits : {1, 2}) {
      CAPTURE(force);
      CAPTURE(digits);
      const auto found = enclose_critical_forces(Chain<Rational>({1, 1}, {2 * F - 4, 1}), 1, digits);
      REQUIRE(found.size() == 1);
      CHECK(found[0].low <= F);
      CHECK(F < found[0].high);
      CHECK(to_decimal(found[0].low, digits) == to_decimal(found[0].high, digits));
    }
  }
}

TEST_CASE("two forces closer than the digits asked for have the same bounds, also where they round apart") {
  // an interior passive joint: F = 2 k_1 / 3 before it and 2 k_3 behind it, that is 2.000000048 and
  // 2.000000052, on two sides of half-way between 2.0000000 and 2.0000001
  for (const bool lower_first : {true, false}) {
    const Rational one = decimal("2.000000048"), other = decimal("2.000000052");
    const Rational before = lower_first ? one : other, behind = lower_first ? other : one;
    const auto found =
        enclose_critical_forces(Chain<Rational>({1, 1, 1}, {before * 3 / 2, 0, behind / 2}), 2, 5);
    REQUIRE(found.size() == 2);
    CHECK(found[0].index == 1);
    CHECK(found[1].index == 2);
    CHECK(found[0].low == found[1].low);
    CHECK(found[0].high == found[1].high);
    CHECK(found[0].below_low == 0);
    CHECK(found[0].below_high == 2);
  }
}

TEST_CASE("a thousand digits of any chain are what counts in fractions say, and so are the counts") {
  for (const std::size_t n : {2U, 5U, 9U, 17U}) {
    for (const std::size_t passive : {n, std::size_t{0}, n / 2}) {
      CAPTURE(n);
      CAPTURE(passive);
      std::vector<Rational> length, stiffness;
      for (std::size_t i = 0; i < n; ++i) {
        length.emplace_back(3 + static_cast<long>(i * i % 7), 7);
        stiffness.emplace_back(i == passive ? 0 : 1 + static_cast<long>(i * i * i % 11), 10);
      }
      const Chain<Rational> chain(length, stiffness);
      const auto found = enclose_critical_forces(chain, 3, 1000);
      REQUIRE(found.size() == std::min<std::size_t>(3, n - 1));
      for (const ForceEnclosure& force : found) {
        CHECK(to_decimal(force.low, 1000) == to_decimal(force.high, 1000));
        CHECK(force.below_low == count_below(chain, force.low));
        CHECK(force.below_high == count_below(chain, force.high));
        CHECK(force.below_low < force.index);
        CHECK(force.index <= force.below_high);
      }
    }
  }
}

TEST_CASE("the lowest forces of a chain in two parts come from either part, in their order") {
  // an interior passive joint: F = 2 k_1 / 3 before it and 2 k_3 behind it
  for (const auto& [first, behind, lowest] : {std::tuple{3, Rational(1, 2), 1}, {3, Rational(4), 2}}) {
    const Chain<Rational> chain({1, 1, 1}, {first, 0, behind});
    const Rational other = lowest == 1 ? 2 : 8;
    for (const int digits : {10, 40}) {
      const auto one = enclose_critical_forces(chain, 1, digits),
                 both = enclose_critical_forces(chain, 2, digits);
      REQUIRE(one.size() == 1);
      REQUIRE(both.size() == 2);
      const auto holds = [](const ForceEnclosure& bounds, const Rational& force) {
        return bounds.low < force && force < bounds.high;
      };
      CHECK(holds(one[0], lowest));
      CHECK(holds(both[0], lowest));
      CHECK(holds(both[1], other));
    }
  }
}
