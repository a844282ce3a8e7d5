#include "diagnose/noise/noise_steps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace plumbline::diagnose {

double correlation_deviation(double correlation, double values) {
  return (1.4 + 0.8 * correlation) / std::sqrt(values);
}

namespace {

/// Correlation of noise whose second differences over two readings have so many times the variance of those
/// over one: (1 + phi) (3 - phi^2) / (3 - phi).
double correlation_by_curvature(double ratio) {
  const auto times = [](double phi) { return (1 + phi) * (3 - phi * phi) / (3 - phi); };
  double low = -1, high = 1;
  while (high - low > 1e-9) (times((low + high) / 2) < ratio ? low : high) = (low + high) / 2;
  return low;
}

Steps steps_of(const Measurements& measurements, const std::vector<double>& residual, const SeriesGroup& all,
               double pace) {
  const Channel::Name name = all.front()->channel.name;
  const std::vector<double> near = differences(all, residual, 1), far = differences(all, residual, 2);
  Steps steps{static_cast<std::size_t>(name), pace};
  steps.values = static_cast<double>(near.size());
  if (near.empty() || far.empty()) return steps;
  // Coarse readings that mostly repeat have no less noise than rounding is.
  const double rounded = std::pow(rounding(measurements, name), 2);
  const auto variance = [&](const std::vector<double>& differences, double times) {
    return std::max(robust_variance(differences, times * rounded), times * rounded) / 2;
  };
  const double plain = variance(near, 2);
  if (!(plain > 0)) return steps;
  // Of coarser readings, which repeat, the rest is no noise.
  if (rounded <= plain / 2) steps.rounded = rounded;
  steps.near = plain - steps.rounded;
  steps.ratio = (variance(far, 2) - steps.rounded) / steps.near;
  const std::vector<double> bends = second_differences(all, residual, 1),
                            wide_bends = second_differences(all, residual, 2);
  if (!bends.empty()) steps.curved = variance(bends, 6) - 3 * steps.rounded;
  if (wide_bends.empty()) return steps;
  steps.curved_correlation =
      correlation_by_curvature((variance(wide_bends, 6) - 3 * steps.rounded) / steps.curved);
  return steps;
}

}  // namespace

std::vector<Steps> plain_steps(const Measurements& measurements, const std::vector<double>& residual,
                               const Manner& manner) {
  std::map<std::pair<Channel::Name, double>, SeriesGroup> alike;
  for (const Series& series : measurements.series()) {
    const bool paced = manner.with_time[place_of(series.channel.sensor())];
    alike[{series.channel.name, paced ? series.pace : 1}].push_back(&series);
  }
  std::vector<Steps> steps;
  for (const auto& [where, all] : alike) steps.push_back(steps_of(measurements, residual, all, where.second));
  return steps;
}

std::vector<Steps> all_steps(const Measurements& measurements, const std::vector<double>& residual,
                             const Manner& manner) {
  std::vector<Steps> steps = plain_steps(measurements, residual, manner);
  for (Steps& one : steps) {
    if (!manner.by_bends[one.sensor()] || !one.tells_correlation() || !(one.curved > 0)) continue;
    one.near = one.curved / (3 - one.curved_correlation);
    one.ratio = 1 + one.curved_correlation;
    one.values /= 2;  // they tell a correlation so much less
  }
  return steps;
}

}  // namespace plumbline::diagnose
