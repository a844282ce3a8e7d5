#pragma once
/// \file
/// Comparison of numbers of any size.

#include <doctest/doctest.h>

#include <limits>

/// Equal to within a fraction (`epsilon`, by default 1.2e-5) of the larger value. `doctest::Approx` alone
/// adds one to the larger, so it accepts almost anything far below one. Only zero is close to zero.
inline doctest::Approx close_to(double value) {
  return doctest::Approx(value).scale(std::numeric_limits<double>::min());
}
