#pragma once
/// \file
/// Comparison of numbers of any size.

#include <doctest/doctest.h>

#include <limits>

/// Equal to within a share (`epsilon`, 1.2e-5 unless told) of the larger of the two. `doctest::Approx` alone
/// adds one to the larger: of values far below one it asks next to nothing. Zero is close to zero alone.
inline doctest::Approx close_to(double value) {
  return doctest::Approx(value).scale(std::numeric_limits<double>::min());
}
