#pragma once
/// \file
/// Chains that benchmarks draw.

#include <cmath>
#include <plumbline/base/number.hpp>
#include <plumbline/chain/chain.hpp>
#include <random>
#include <utility>
#include <vector>

namespace plumbline::bench {

/// Lengths and stiffnesses of five decimals, log-uniform over a factor of 4.
inline Chain<Rational> random_chain(std::size_t links, std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(0, 2);
  const auto list = [&] {
    std::vector<Rational> values;
    for (std::size_t i = 0; i < links; ++i)
      values.emplace_back(std::lround(1e5 * std::exp2(exponent(random))), 100000);
    return values;
  };
  std::vector<Rational> length = list(), stiffness = list();
  return Chain<Rational>(std::move(length), std::move(stiffness));
}

}  // namespace plumbline::bench
