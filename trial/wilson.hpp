#pragma once
/// \file
/// How sure a proportion is.

#include <cstddef>

namespace plumbline::trial {

/// `count` of `total`, with Wilson's score interval at 95 %.
struct Proportion {
  std::size_t count = 0, total = 0;

  void add(bool one) { ++total, count += one; }
  /// NaN for none of none.
  [[nodiscard]] double share() const;
  [[nodiscard]] double low() const;   ///< 0 for none of none
  [[nodiscard]] double high() const;  ///< 1 for none of none
};

}  // namespace plumbline::trial
