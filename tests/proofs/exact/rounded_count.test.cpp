#include "proofs/exact/rounded_count.hpp"

#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/exact_count.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/working_precision.hpp"
#include "tests/proofs/random_chain.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// 10^0 … 10^(n - 1) or so, mixed: a chain of integers.
std::vector<Integer> random_integers(std::size_t n, unsigned decades) {
  std::vector<Integer> integers;
  while (integers.size() < n)
    integers.push_back(Integer(*rc::gen::inRange(1, 1000)) *
                       mp::pow(Integer(10), *rc::gen::inRange(0U, decades)));
  return integers;
}

std::vector<Rational> fractions(const std::vector<Integer>& integers) {
  return {integers.begin(), integers.end()};
}

/// Where joint `at` (from 0) is passive, if there is one.
std::vector<Integer> with_passive(std::vector<Integer> stiffness, std::size_t at) {
  if (at < stiffness.size()) stiffness[at] = 0;
  return stiffness;
}

/// Decimals right below and above each critical force, of 3 to 38 digits.
std::vector<Rational> beside_critical_forces(const Chain<Rational>& chain) {
  std::vector<Rational> forces;
  int digits = 3;
  for (const ForceEnclosure& force : enclose_critical_forces(chain, chain.size(), 40)) {
    const Rational unit = unit_in_digit(force.low, digits),
                   middle = *parse_decimal(to_decimal(force.low, digits));
    forces.push_back(middle - unit);
    forces.push_back(middle + unit);
    digits = digits < 38 ? digits + 5 : 3;
  }
  return forces;
}

}  // namespace

TEST_CASE("theorem Rounded counts, in numbers of a few bits") {
  check_property("any chain with a passive joint anywhere or nowhere, any force", [] {
    const auto n = *rc::gen::inRange<std::size_t>(2, 12);
    const auto passive = *rc::gen::inRange<std::size_t>(0, 2 * n);
    const Chain<Rational> chain(fractions(random_integers(n, 6)),
                                fractions(with_passive(random_integers(n, 6), passive)));
    const Rational near =
        critical_forces(from_rational<double>(chain), n)[*rc::gen::inRange<std::size_t>(0, n - 1)];
    const Rational F = near * Rational(*rc::gen::inRange(990, 1011), 1000);
    const WorkingPrecision precision(4);
    const Mpfr rounded_F = from_rational<Mpfr>(F);
    const Rational w = exactly(epsilon<Mpfr>()) / 2, exact_F = exactly(rounded_F);
    Rational factor = 1;
    for (std::size_t K = 0; K < 8 * n + 16; ++K) factor *= 1 - w;
    const std::size_t counted = count_below(from_rational<Mpfr>(chain), rounded_F);
    RC_ASSERT(count_below(chain, Rational(exact_F * factor)) <= counted);
    RC_ASSERT(counted <= count_below(chain, Rational(exact_F / factor)));
  });
}

TEST_CASE("what rounded counts decide is the exact count, and next to a critical force they decide") {
  check_property("chains graded over so many decades, a passive joint anywhere or nowhere", [] {
    const auto n = *rc::gen::inRange<std::size_t>(3, 40);
    const auto decades = *rc::gen::element(1U, 4U, 12U, 150U);
    const auto length = random_integers(n, decades);
    const auto stiffness =
        with_passive(random_integers(n, decades), *rc::gen::inRange<std::size_t>(0, 2 * n));
    const Chain<Rational> chain(fractions(length), fractions(stiffness));
    const ExactCount exact(chain);
    for (const Rational& F : beside_critical_forces(chain)) {
      std::size_t sum = 0;
      for (std::size_t part = 0; part < exact.parts().size(); ++part) {
        const auto certain = RoundedCount(length, stiffness, EndPoint::guided, part).below({F})[0];
        RC_ASSERT(certain.has_value());
        RC_ASSERT(*certain == exact.below(F, exact.parts()[part]));
        sum += *certain;
      }
      RC_ASSERT(sum == exact.below(F));  // one force of a chain as short as this: counted in integers
    }
  });
}

TEST_CASE("many forces at once are counted as one by one") {
  check_property("long enough for numbers that round", [] {
    const auto n = *rc::gen::inRange<std::size_t>(20, 50);
    const auto stiffness = with_passive(random_integers(n, 3), *rc::gen::inRange<std::size_t>(0, 2 * n));
    const Chain<Rational> chain(fractions(random_integers(n, 3)), fractions(stiffness));
    const ExactCount count(chain);
    const std::vector<Rational> forces = beside_critical_forces(chain);
    const std::vector<std::size_t> counts = count.below(forces);
    for (std::size_t i = 0; i < forces.size(); ++i) RC_ASSERT(counts[i] == count.below(forces[i]));
  });
}

TEST_CASE("a critical force itself stays open to numbers that round, zero forces are below zero") {
  const std::vector<Integer> ones(30, 1);
  std::vector<Integer> stiffness = ones;
  stiffness[0] = 0;
  // "Equal links": F_m = 4 sin^2(m pi / 2n), which is 1 for m = n / 3
  const RoundedCount rounded(ones, stiffness, EndPoint::guided, 0);
  CHECK(!rounded.below({1})[0].has_value());
  CHECK(rounded.below({1 + shifted(Rational(1), -30)})[0] == 10);
  CHECK(ExactCount(Chain<Rational>(fractions(ones), fractions(stiffness)))
            .below(std::vector<Rational>(20, 1)) == std::vector<std::size_t>(20, 9));
  CHECK(ExactCount(Chain<Rational>(fractions(ones), fractions(stiffness)))
            .below(std::vector<Rational>(20, 0)) == std::vector<std::size_t>(20, 0));
}
