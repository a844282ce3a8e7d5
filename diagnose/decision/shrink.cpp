#include "diagnose/decision/shrink.hpp"
#include "diagnose/noise/gathered.hpp"
#include "diagnose/noise/outliers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace plumbline::diagnose {
namespace {

/// Values that stand off their neighbours, but not what gathers: that is missed, and no fault of the
/// readings.
std::vector<bool> wild(const Measurements& measurements, const std::vector<double>& after) {
  std::vector<bool> marked = outliers(measurements, after);
  const std::vector<bool> missed = gathered(measurements, marked);
  std::transform(marked.begin(), marked.end(), missed.begin(), marked.begin(), std::greater<>());
  return marked;
}

/// Flat, by series: which values are held out, and no outliers.
std::vector<std::vector<std::size_t>> judged_values(const Measurements& measurements, const HeldOut& heldout,
                                                    const std::vector<bool>& outlier) {
  std::vector<std::vector<std::size_t>> by_series;
  for (const Series& series : measurements.series()) {
    by_series.emplace_back();
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      if (heldout.reading[series.run][series.readings[i]] && !outlier[series.first + i])
        by_series.back().push_back(series.first + i);
  }
  return by_series;
}

struct Sums {
  double before = 0, after = 0;
};

/// Blocks of neighbouring values, with their sums of squares, whatever the order of the runs.
std::vector<Sums> blocks(const std::vector<std::vector<std::size_t>>& values,
                         const std::vector<double>& before, const std::vector<double>& after) {
  constexpr std::size_t length = 8;  // longer than correlated noise remembers, 0.7^8 < 0.06
  std::vector<Sums> result;
  for (const auto& series : values) {
    for (std::size_t i = 0; i < series.size(); ++i) {
      if (i % length == 0) result.emplace_back();
      result.back().before += before[series[i]] * before[series[i]];
      result.back().after += after[series[i]] * after[series[i]];
    }
  }
  std::sort(result.begin(), result.end(), [](const Sums& a, const Sums& b) {
    return std::pair(a.before, a.after) < std::pair(b.before, b.after);
  });
  return result;
}

/// 95 % bounds of a ratio of root mean squares, by resampling the blocks.
template <class Ratio>
void bootstrap(const std::vector<Sums>& blocks, Ratio& shrink) {
  constexpr int draws = 1000;
  std::mt19937_64 random(11);
  std::uniform_int_distribution<std::size_t> pick(0, blocks.size() - 1);
  std::vector<double> ratios;
  for (int draw = 0; draw < draws; ++draw) {
    Sums sum;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Sums& block = blocks[pick(random)];
      sum.before += block.before;
      sum.after += block.after;
    }
    ratios.push_back(std::sqrt(sum.after / sum.before));
  }
  std::sort(ratios.begin(), ratios.end());
  shrink.ratio_low = std::min(shrink.ratio, ratios[draws / 40]);
  shrink.ratio_high = std::max(shrink.ratio, ratios[draws - 1 - draws / 40]);
}

/// Of the values that are held out.
Sums sums(const std::vector<std::vector<std::size_t>>& values, const std::vector<double>& before,
          const std::vector<double>& after) {
  Sums sum;
  for (const auto& series : values)
    for (const std::size_t i : series) sum.before += before[i] * before[i], sum.after += after[i] * after[i];
  return sum;
}

std::map<Channel, ChannelShrink> by_channel(const Measurements& measurements,
                                            const std::vector<std::vector<std::size_t>>& values,
                                            const std::vector<double>& before,
                                            const std::vector<double>& after, const NoiseModel& noise) {
  std::map<Channel, std::vector<std::vector<std::size_t>>> parts;
  for (std::size_t s = 0; s < values.size(); ++s)
    parts[measurements.series()[s].channel].push_back(values[s]);
  std::map<Channel, ChannelShrink> result;
  for (const auto& [channel, part] : parts) {
    const Sums sum = sums(part, before, after);
    double count = 0;
    for (const auto& series : part) count += static_cast<double>(series.size());
    if (!(sum.before > 0)) continue;
    ChannelShrink& one = result[channel];
    one.ratio = std::sqrt(sum.after / sum.before);
    one.noise_floor_ratio = noise.of(channel) * std::sqrt(count / sum.before);
    bootstrap(blocks(part, before, after), one);
  }
  return result;
}

}  // namespace

double Shrink::beyond_noise() const {
  return std::sqrt(std::max(0.0, ratio * ratio - noise_floor_ratio * noise_floor_ratio));
}

Shrink measure_shrink(const Measurements& measurements, const HeldOut& heldout,
                      const std::vector<double>& before, const std::vector<double>& after,
                      const NoiseModel& noise) {
  Shrink shrink;
  const std::vector<bool> outlier = wild(measurements, after);
  const auto values = judged_values(measurements, heldout, outlier);
  std::map<Channel, double> count;
  double floor = 0, chi2 = 0, total = 0;
  for (std::size_t s = 0; s < values.size(); ++s) {
    const Series& series = measurements.series()[s];
    const Channel& channel = series.channel;
    const double scale = noise.of(channel);
    for (const std::size_t i : values[s]) {
      shrink.rms_before[channel] += std::pow(series.sigmas[i - series.first] * before[i], 2);
      shrink.rms_after[channel] += std::pow(series.sigmas[i - series.first] * after[i], 2);
      count[channel] += 1;
      floor += scale * scale;
      chi2 += std::pow(after[i] / scale, 2);
      total += 1;
    }
    // Squares of neighbours correlate by the square of what their values do.
    const double squares = std::pow(noise.correlation_of(series), 2);
    shrink.independent += static_cast<double>(values[s].size()) * (1 - squares) / (1 + squares);
  }
  if (total == 0) return shrink;
  shrink.heldout = heldout.names;
  for (auto& [channel, sum] : shrink.rms_before) sum = std::sqrt(sum / count[channel]);
  for (auto& [channel, sum] : shrink.rms_after) sum = std::sqrt(sum / count[channel]);
  const Sums all = sums(values, before, after);
  const auto every = judged_values(measurements, heldout, std::vector<bool>(after.size(), false));
  for (std::size_t s = 0; s < values.size(); ++s) shrink.left_out += every[s].size() - values[s].size();
  const Sums with_left_out = sums(every, before, after);
  shrink.ratio = std::sqrt(all.after / all.before);
  shrink.ratio_with_left_out = std::sqrt(with_left_out.after / with_left_out.before);
  shrink.noise_floor_ratio = std::sqrt(floor / all.before);
  shrink.chi2_per_value_after = chi2 / total;
  bootstrap(blocks(values, before, after), shrink);
  shrink.channels = by_channel(measurements, values, before, after, noise);
  return shrink;
}

}  // namespace plumbline::diagnose
