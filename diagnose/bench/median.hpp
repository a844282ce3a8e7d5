#pragma once
/// \file
/// The middle of some values.

#include <boost/math/statistics/univariate_statistics.hpp>
#include <limits>
#include <vector>

namespace plumbline::diagnose {

/// Of an even number the mean of the middle two; not a number where there are none.
inline double median(std::vector<double> values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : boost::math::statistics::median(values);
}

}  // namespace plumbline::diagnose
