#include "diagnose/decision/shrink.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace plumbline::diagnose {
namespace {

using Values = std::vector<Eigen::Index>;

/// By series: which values are held out.
std::vector<Values> values_by_series(const Measurements& measurements, const HeldOut& heldout) {
  std::vector<Values> by_series;
  for (const Series& series : measurements.series()) {
    by_series.emplace_back();
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      if (heldout.reading[series.run][series.readings[i]])
        by_series.back().push_back(static_cast<Eigen::Index>(series.first + i));
  }
  return by_series;
}

std::size_t count_of(const std::vector<Values>& values) {
  std::size_t count = 0;
  for (const Values& one : values) count += one.size();
  return count;
}

struct Sums {
  double before = 0, after = 0;
  void operator+=(const Sums& other) { before += other.before, after += other.after; }
  [[nodiscard]] double ratio() const { return std::sqrt(after / before); }
};

/// Residuals in standard deviations of the noise.
struct Residuals {
  VectorXd before, after;
  [[nodiscard]] Sums of(const std::vector<Values>& values) const {
    Sums sum;
    for (const Values& series : values)
      for (const Eigen::Index i : series) sum += {before(i) * before(i), after(i) * after(i)};
    return sum;
  }
};

/// Blocks of neighbouring values, with their sums of squares, whatever the order of the runs.
std::vector<Sums> blocks(const std::vector<Values>& values, const Residuals& residuals) {
  constexpr std::size_t length = 8;  // longer than correlated noise remembers, 0.7^8 < 0.06
  std::vector<Sums> result;
  for (const Values& series : values)
    for (std::size_t i = 0; i < series.size(); ++i) {
      if (i % length == 0) result.emplace_back();
      result.back() += residuals.of({{series[i]}});
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
    for (std::size_t i = 0; i < blocks.size(); ++i) sum += blocks[pick(random)];
    ratios.push_back(sum.ratio());
  }
  std::sort(ratios.begin(), ratios.end());
  shrink.ratio_low = std::min(shrink.ratio, ratios[draws / 40]);
  shrink.ratio_high = std::max(shrink.ratio, ratios[draws - 1 - draws / 40]);
}

std::map<Channel, ChannelShrink> by_channel(const Measurements& measurements,
                                            const std::vector<Values>& values, const Residuals& residuals) {
  std::map<Channel, std::vector<Values>> parts;
  for (std::size_t s = 0; s < values.size(); ++s)
    parts[measurements.series()[s].channel].push_back(values[s]);
  std::map<Channel, ChannelShrink> result;
  for (const auto& [channel, part] : parts) {
    const Sums sum = residuals.of(part);
    if (!(sum.before > 0)) continue;
    ChannelShrink& one = result[channel];
    one.ratio = sum.ratio();
    one.noise_floor_ratio = std::sqrt(static_cast<double>(count_of(part)) / sum.before);
    bootstrap(blocks(part, residuals), one);
  }
  return result;
}

/// Root mean squares of a residual by channel, in its unit.
std::map<Channel, double> rms_of(const Measurements& measurements, const std::vector<Values>& values,
                                 const VectorXd& residual) {
  std::map<Channel, double> sum, count;
  for (std::size_t s = 0; s < values.size(); ++s) {
    const Series& series = measurements.series()[s];
    for (const Eigen::Index i : values[s])
      sum[series.channel] += std::pow(measurements.sigma()(i) * residual(i), 2), count[series.channel] += 1;
  }
  for (auto& [channel, squares] : sum) squares = std::sqrt(squares / count[channel]);
  return sum;
}

}  // namespace

Shrink measure_shrink(const Measurements& measurements, const HeldOut& heldout, const VectorXd& before,
                      const VectorXd& after, const NoiseEstimate& noise) {
  Shrink shrink;
  const std::vector<Values> every = values_by_series(measurements, heldout);
  std::vector<Values> values = every;
  for (Values& series : values)
    std::erase_if(series, [&](Eigen::Index i) { return noise.shape.outlier[static_cast<std::size_t>(i)]; });
  if (count_of(values) == 0) return shrink;
  const VectorXd sigma = noise.sigma(measurements);
  const Residuals residuals{before.cwiseQuotient(sigma), after.cwiseQuotient(sigma)};
  const auto count = static_cast<double>(count_of(values));
  const Sums sum = residuals.of(values);
  shrink.heldout = heldout.names;
  shrink.rms_before = rms_of(measurements, values, before);
  shrink.rms_after = rms_of(measurements, values, after);
  shrink.ratio = sum.ratio();
  shrink.noise_floor_ratio = std::sqrt(count / sum.before);
  shrink.chi2_per_value_after = sum.after / count;
  shrink.outliers = count_of(every) - count_of(values);
  shrink.ratio_with_outliers = residuals.of(every).ratio();
  bootstrap(blocks(values, residuals), shrink);
  shrink.channels = by_channel(measurements, values, residuals);
  return shrink;
}

}  // namespace plumbline::diagnose
