#pragma once
/// \file
/// Statistics of the numbers of a column.

#include <vector>

namespace plumbline::diagnose {

/// The values without NaN.
std::vector<double> finite(std::vector<double> values);
/// Median size of the second differences over the range: near 0 for a commanded motion, larger for noise.
double roughness(const std::vector<double>& all);
/// Standard deviation of the noise of a column, from third differences, at least that of its rounding.
double scatter_of(const std::vector<double>& all);

}  // namespace plumbline::diagnose
