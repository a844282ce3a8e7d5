#include "verify/sampled/chain_properties.hpp"

#include <plumbline/straight/critical_force.hpp>

#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

Margin margin(const std::string& property, const Sample& sample) {
  for (const ChainProperty& candidate : chain_properties()) {
    if (candidate.name == property) return candidate.margin(sample);
  }
  FAIL("no property " << property);
  return {};
}

/// Binary numbers with eight digits over as many octaves, simplest first when a failure is shrunk.
rc::Gen<double> positive(int octaves) {
  return rc::gen::map(
      rc::gen::pair(rc::gen::inRange(0, 256), rc::gen::inRange(-octaves / 2, octaves / 2 + 1)),
      [](const auto& parts) { return std::ldexp(1 + parts.first / 256.0, parts.second); });
}

Chain<double> any_chain() {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(2, 9));
  const int octaves = *rc::gen::element(0, 4, 26);  // without any, ties abound
  const auto numbers = rc::gen::container<std::vector<double>>(n, positive(octaves));
  const std::vector<double> length = *numbers;
  std::vector<double> stiffness = *numbers;
  if (*rc::gen::inRange(0, 3) == 1) stiffness[0] = 0;  // at most one passive joint, most often the base
  if (stiffness[0] != 0 && *rc::gen::inRange(0, 8) == 1)
    stiffness[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(n)))] = 0;
  return Chain<double>(length, stiffness);
}

}  // namespace

TEST_CASE("every property holds for any chain") {
  check_property("every property holds", [] {
    const Chain<double> chain = any_chain();
    RC_LOG() << "lengths " << rc::toString(chain.length()) << ", stiffness "
             << rc::toString(chain.stiffness());
    const Sample sample(chain);
    for (const ChainProperty& property : chain_properties()) {
      RC_LOG() << '\n' << property.name;
      RC_ASSERT(property.margin(sample).value_or(0) <= 1);
    }
  });
}

TEST_CASE("every property fails where it should") {
  const Chain<double> elastic({1, 0.5, 2}, {1, 3, 2}), passive({1, 0.5, 2}, {0, 3, 2});
  for (const Chain<double>& chain : {elastic, passive}) {
    const Sample right(chain);
    Sample wrong = right;  // the forces of the chain for another chain
    wrong.exact =
        Chain<Rational>({1, Rational(1, 2), 2}, {right.exact.stiffness()[0], 3, Rational(2000001, 1000000)});
    for (const char* property : {"forces", "energy factors", "product", "sum", "sum of inverses"}) {
      CAPTURE(property);
      CHECK(margin(property, right).value() <= 1);
      CHECK(margin(property, wrong).value() > 1);
    }
    Sample imprecise = right;
    imprecise.forces_in_double[1] *= 1 + 1e-11;  // the condition allows 1e-12 here
    CHECK(margin("double", imprecise).value() > 1);
  }
}

TEST_CASE("reversal is claimed for a passive base only") {
  CHECK(margin("reversal", Sample(Chain<double>({1, 2, 1}, {0, 1, 3}))) == Margin(0));
  CHECK(!margin("reversal", Sample(Chain<double>({1, 2, 1}, {1, 1, 3}))));
}

TEST_CASE("with an elastic base reversal and monotonicity in length are not true") {
  const auto lowest_above = [](const Chain<Rational>& chain, const Rational& force) {
    return count_below(chain, force) == 0;
  };
  // n = 2: F = (k_1 z_2^2 + k_2 z_1^2) / (L_1 L_2 (L_1 + L_2)); with k_2 = 0 it is k_1 L_2 / (L_1 (L_1 +
  // L_2)), 1/2 for unit lengths and 2/3 after L_2 was doubled
  CHECK(lowest_above(Chain<Rational>({1, 2}, {1, 0}), Rational(3, 5)));
  CHECK(!lowest_above(Chain<Rational>({1, 1}, {1, 0}), Rational(3, 5)));
  // reversed, lengths 1, 2 have F = 1 * 1 / (2 * 3) = 1/6
  CHECK(!lowest_above(Chain<Rational>({2, 1}, {1, 0}), Rational(1, 5)));
}
