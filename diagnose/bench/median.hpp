#pragma once
/// \file
/// The middle of some values, and of their sizes.

#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace plumbline::diagnose {

/// Of an even number the mean of the middle two; not a number where there are none.
inline double median(std::vector<double> values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : boost::math::statistics::median(values);
}

/// Standard deviation of normal numbers about zero, by the median of their sizes, which any minority of
/// others moves by little.
inline double median_deviation(std::vector<double> values) {
  constexpr double of_normal = 0.6745;  // median of |z|
  for (double& value : values) value = std::abs(value);
  return median(std::move(values)) / of_normal;
}

}  // namespace plumbline::diagnose
