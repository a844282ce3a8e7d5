#include "diagnose/model/uneven_noise.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

/// Above which ratio of two deviations, one of `values` third differences, no chance is left. A median of
/// sizes is 0.37 as efficient as their squares, and every second of third differences is new, so that the
/// logarithm of a deviation scatters by the root of 1 / (2 * 0.37 * values / 2); three of these are chance
/// one time in 700.
double beyond_chance(std::size_t values) {
  constexpr double noticeable = 1.5, efficiency = 0.37;
  return std::max(noticeable, std::exp(3 / std::sqrt(efficiency * static_cast<double>(values))));
}

}  // namespace

std::vector<double> uneven_noise(const std::vector<std::vector<double>>& sizes) {
  constexpr std::size_t few = 20;
  std::vector<double> deviation, known;
  for (const std::vector<double>& one : sizes) {
    deviation.push_back(one.size() < few ? 0 : median_deviation(one));
    if (deviation.back() > 0) known.push_back(deviation.back());
  }
  std::vector<double> times(sizes.size(), 1.0);
  if (known.size() < 3) return times;
  const double usual = median(known);
  for (std::size_t j = 0; j < sizes.size(); ++j)
    if (deviation[j] > beyond_chance(sizes[j].size()) * usual) times[j] = deviation[j] / usual;
  return times;
}

}  // namespace plumbline::diagnose
