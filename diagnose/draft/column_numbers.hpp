#pragma once
/// \file
/// Statistics of the numbers of a column.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::diagnose {

/// The numbers of a text, with blanks, commas or brackets between; empty where there is anything else.
std::optional<std::vector<double>> numbers_in(const std::string& text);
/// Distance of the farthest place from a base, m; either coordinate may be missing.
/// \param unit  of the places, m
double farthest(const std::vector<double>& xs, const std::vector<double>& ys,
                const std::array<double, 2>& base, double unit);
/// The values without NaN.
std::vector<double> finite(std::vector<double> values);
/// Median size of the second differences over the range: near 0 for a commanded motion, larger for noise.
double roughness(const std::vector<double>& all);
/// Standard deviation of the noise of a column, from third differences, at least that of its rounding.
double scatter_of(const std::vector<double>& all);

}  // namespace plumbline::diagnose
