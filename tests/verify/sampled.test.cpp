#include "verify/sampled/sampled.hpp"

#include <doctest/doctest.h>

#include <atomic>

using namespace plumbline;
using namespace plumbline::verify;

TEST_CASE("random chains are reproducible, differ between seeds, and are of every kind") {
  CHECK(random_chain(7, 3).length() == random_chain(7, 3).length());
  CHECK(random_chain(7, 3).stiffness() != random_chain(8, 3).stiffness());
  bool longest = false, passive_base = false, elastic = false, tie = false;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Chain<double> chain = random_chain(1, i);
    CHECK(chain.passive_joints() <= 1);
    longest = longest || chain.size() == 8;
    passive_base = passive_base || chain.stiffness()[0] == 0;
    elastic = elastic || chain.passive_joints() == 0;
    tie = tie || chain.length()[0] == chain.length()[1];
  }
  CHECK((longest && passive_base && elastic && tie));
}

TEST_CASE("no property fails, and how the chains are shared makes no difference") {
  std::size_t steps = 0;
  const auto count = [&](std::size_t more) { steps += more; };
  const SampledChains one = check_random_chains(60, 11, nullptr, count, 60);
  const SampledChains three = check_random_chains(
      60, 11, nullptr, [](std::size_t) {}, 7);
  CHECK(steps == 60);
  REQUIRE(one.properties.size() == three.properties.size());
  for (std::size_t p = 0; p < one.properties.size(); ++p) {
    CAPTURE(one.properties[p].name);
    CHECK(one.properties[p].chains > 0);
    CHECK(one.properties[p].failures == 0);
    CHECK(one.properties[p].chains == three.properties[p].chains);
    CHECK(one.properties[p].worst_margin == three.properties[p].worst_margin);
    CHECK(one.properties[p].counterexample.empty());
  }
  CHECK(one.agreement.digits == three.agreement.digits);
}

TEST_CASE("the summary of the agreement reads the histogram from the top") {
  DoubleAgreement agreement;
  agreement.digits[15] = 60;
  agreement.digits[12] = 39;
  agreement.digits[7] = 1;
  agreement.unresolved = 5;
  CHECK(
      summary(agreement) ==
      "100 of 105 forces resolved in double; of these half agree to 15 digits or more, 99 % to 12, all to 7");
}
