#pragma once
/// \file
/// Medians.

#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace plumbline::diagnose {

/// The median, the mean of the middle two for an even number; NaN for no values.
inline double median(std::vector<double> values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : boost::math::statistics::median(values);
}

/// A robust standard deviation of zero-mean normal numbers, by the median of their absolute values.
inline double median_deviation(std::vector<double> values) {
  constexpr double of_normal = 0.6745;  // median of |z|
  for (double& value : values) value = std::abs(value);
  return median(std::move(values)) / of_normal;
}

}  // namespace plumbline::diagnose
