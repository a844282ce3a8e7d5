#pragma once
/// \file
/// A proportion with its confidence interval.

#include <cstddef>

namespace plumbline::trial {

/// `count` of `total`, with Wilson's score interval at 95 %.
struct Proportion {
  std::size_t count = 0, total = 0;

  void add(bool one) { ++total, count += one; }
  /// NaN for 0 of 0.
  [[nodiscard]] double share() const;
  [[nodiscard]] double low() const;   ///< 0 for 0 of 0
  [[nodiscard]] double high() const;  ///< 1 for 0 of 0
};

}  // namespace plumbline::trial
