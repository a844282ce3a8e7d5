#include <doctest/doctest.h>

#include <plumbline/straight/critical_force_batch.hpp>
#include <random>

#include "tests/close_to.hpp"

using namespace plumbline;

TEST_CASE(
    "a batch gives what each chain gives alone, graded and passive ones included, on any number of threads") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-8, 8);
  for (const std::size_t n : {2U, 4U, 7U, 30U}) {
    const std::size_t chains = 2051;  // neither whole registers nor whole threads
    std::vector<double> length(chains * n), stiffness(chains * n);
    for (double& L : length) L = std::pow(10, exponent(random));
    for (double& k : stiffness) k = std::pow(10, exponent(random));
    for (std::size_t c = 0; c < chains; c += 5) stiffness[c * n + c % n] = 0;
    length[3] = 1e-200;  // out of the lanes' range
    const ChainBatch batch{n, length, stiffness};
    const auto forces = lowest_forces(batch, 1);
    REQUIRE(forces.size() == chains);
    CHECK(lowest_forces(batch, 3) == forces);
    for (std::size_t c = 0; c < chains; ++c) {
      // 2 n roundings in each of two ways to the same number
      CHECK(forces[c] ==
            close_to(critical_forces(batch.chain(c), 1)[0]).epsilon(static_cast<double>(4 * n) * 1.2e-16));
    }
  }
}

TEST_CASE("a batch says which chain is wrong") {
  const std::vector<double> good(12, 1.0);
  std::vector<double> bad = good;
  bad[9] = -1;
  CHECK_THROWS_WITH_AS(
      lowest_forces({4, bad, good}),
      "chain 3: lengths, entry 2: found a value that is not positive, expected a positive length", Error);
  CHECK_THROWS_WITH_AS(lowest_forces({5, good, good}),
                       "batch: found 12 lengths and 12 stiffnesses, expected as many, a multiple of 5",
                       Error);
  CHECK_THROWS_WITH_AS(lowest_forces({4, good, std::vector<double>(8, 1.0)}),
                       "batch: found 12 lengths and 8 stiffnesses, expected as many, a multiple of 4", Error);
  CHECK_THROWS_AS(lowest_forces({1, good, good}), Error);
  bad = good;
  bad[4] = bad[6] = 0;
  CHECK_THROWS_AS(lowest_forces({4, good, bad}), Error);
  CHECK(lowest_forces({4, {}, {}}).empty());
}
