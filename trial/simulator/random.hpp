#pragma once
/// \file
/// Random numbers that are the same on every machine.

#include <boost/random/bernoulli_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace plumbline::simulator {

class Random {
 public:
  /// A stream of its own for every experiment of every seed.
  Random(std::uint64_t seed, std::uint64_t stream) {
    std::seed_seq mixed{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                        static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)};
    engine_.seed(mixed);
  }
  double uniform(double low, double high) {
    return boost::random::uniform_real_distribution<double>(low, high)(engine_);
  }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  double normal() { return boost::random::normal_distribution<double>(0, 1)(engine_); }
  bool chance(double probability) {
    return boost::random::bernoulli_distribution<double>(probability)(engine_);
  }
  double sign() { return chance(0.5) ? 1 : -1; }
  std::size_t below(std::size_t count) {
    return boost::random::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[below(all.size())];
  }
  template <class T>
  const T& one_of(std::span<const T> all) {
    return all[below(all.size())];
  }

 private:
  boost::random::mt19937_64 engine_;
};

/// Rounded to so many significant digits, as people write numbers down.
inline double significant(double value, int digits) {
  if (value == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - digits + 1);
  return std::round(value / unit) * unit;
}
/// Rounded to a multiple of a unit.
inline double rounded(double value, double unit) {
  return std::round(value / unit) * unit;
}

}  // namespace plumbline::simulator
