#include "diagnose/noise/residual_differences.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {

double robust_variance(const std::vector<double>& differences, double start) {
  constexpr double cut = 2.5;
  constexpr double mean_of_cut_square = 0.97756;  // E min(z^2, 2.5^2) for a standard normal z
  double variance = std::max(start, std::pow(median_deviation(differences), 2));
  for (int round = 0; round < 20; ++round) {
    const double limit = cut * cut * variance;
    double sum = 0;
    for (const double d : differences) sum += std::min(d * d, limit);
    const double next = sum / static_cast<double>(differences.size()) / mean_of_cut_square;
    if (std::abs(next - variance) <= 1e-6 * variance) return next;
    variance = next;
  }
  return variance;
}

SeriesGroup series_named(const Measurements& measurements, Channel::Name name) {
  SeriesGroup all;
  for (const Series& series : measurements.series())
    if (series.channel.name == name) all.push_back(&series);
  return all;
}

std::vector<double> differences(const SeriesGroup& all, const std::vector<double>& residual,
                                std::size_t lag) {
  std::vector<double> result;
  for (const Series* one : all) {
    const Series& series = *one;
    for (std::size_t i = lag; i < series.readings.size(); ++i)
      result.push_back(residual[series.first + i] - residual[series.first + i - lag]);
  }
  return result;
}

std::vector<double> second_differences(const SeriesGroup& all, const std::vector<double>& residual,
                                       std::size_t lag) {
  std::vector<double> result;
  for (const Series* one : all) {
    const Series& series = *one;
    for (std::size_t i = series.first + 2 * lag; i < series.first + series.readings.size(); ++i)
      result.push_back(residual[i - 2 * lag] - 2 * residual[i - lag] + residual[i]);
  }
  return result;
}

double rounding(const Measurements& measurements, Channel::Name name) {
  double step = 0;
  for (const Series& series : measurements.series())
    if (series.channel.name == name) step = std::max(step, series.step);
  return step / std::sqrt(12.0);
}

}  // namespace plumbline::diagnose
