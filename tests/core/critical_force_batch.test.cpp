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

TEST_CASE("lanes answer for chains in their range alone, and for each of eight by itself") {
  // two links of length L with springs k: masses 1 / (2 L), spacings 4 L^2 / k and L^2 / k, and 1 / (2 L^2 k)
  // is what both are made from; forces 5 k / (2 L)
  struct Size {
    double length, stiffness;
    bool in_range;
  };
  // beyond 2^120 = 1e36 either way, or 2^500 = 3e150 for the third, the lanes leave it to one chain alone
  const std::vector<Size> sizes{{1, 1, true},          {1e30, 1e60, true},    {1e-30, 1e-60, true},
                                {1e40, 1e80, false},   {1e-40, 1e-80, false}, {1, 1e40, false},
                                {1, 1e-40, false},     {1e34, 1e100, false},  {1e34, 1e88, false},
                                {1e-34, 1e-88, false}, {1e-30, 1e-95, false}, {1e30, 1e95, false}};
  for (const Size& one : sizes) {
    CAPTURE(one.length);
    CAPTURE(one.stiffness);
    for (std::size_t odd = 0; odd < detail::lane_count; ++odd) {
      std::vector<double> length(2 * detail::lane_count, 1), stiffness(length.size(), 1);
      length[2 * odd] = length[2 * odd + 1] = one.length;
      stiffness[2 * odd] = stiffness[2 * odd + 1] = one.stiffness;
      const ChainBatch batch{2, length, stiffness};
      const auto forces = detail::lowest_in_lanes(batch, {0, 1, 2, 3, 4, 5, 6, 7});
      for (std::size_t lane = 0; lane < detail::lane_count; ++lane) {
        const double expected = lane == odd ? 2.5 * (one.stiffness / one.length) : 2.5;
        if (lane == odd && !one.in_range)
          CHECK(std::isnan(forces[lane]));
        else
          CHECK(forces[lane] == close_to(expected).epsilon(1e-15));  // a run of two beads, and a step
      }
    }
  }
}
