#pragma once
/// \file
/// The random numbers behind the reference values, the same on every machine.

#include <fmt/format.h>

#include <random>

#include "proofs/exact/decimal.hpp"

namespace plumbline::verify {

/// Random numbers that depend on a name and a seed alone. The generator's output is fixed by the C++
/// standard; the distributions of the standard library are not, hence the plain arithmetic here.
class Draw {
 public:
  Draw(const std::string& name, std::uint64_t seed) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    generator_.seed(hash ^ seed);
  }
  /// A whole number from `low` to `high`.
  int whole(int low, int high) {
    return low + static_cast<int>(generator_() % static_cast<std::uint64_t>(high - low + 1));
  }
  std::size_t count(std::size_t low, std::size_t high) {
    return static_cast<std::size_t>(whole(static_cast<int>(low), static_cast<int>(high)));
  }
  /// A decimal of three digits between 10^low and 10^high.
  Rational decimal(int low, int high) {
    const int mantissa = whole(100, 999);
    return *proofs::parse_decimal(fmt::format("{}e{}", mantissa, whole(low, high - 1) - 2));
  }
  Rational binary() { return Rational(whole(1, 640), 64); }

 private:
  std::mt19937_64 generator_;
};

}  // namespace plumbline::verify
