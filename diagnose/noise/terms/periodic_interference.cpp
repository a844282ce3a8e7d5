#include <cmath>
#include <complex>
#include <numbers>

#include "diagnose/noise/term.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// The clock of a run: seconds, or readings where its time stamps only count them.
double instant(const NoiseEvidence& evidence, Eigen::Index value) {
  const ReadingPlace& place = evidence.measurements.places()[static_cast<std::size_t>(value)];
  return evidence.measurements.has_clock(place.run) ? evidence.measurements.time()(value)
                                                    : static_cast<double>(place.reading);
}

/// A sinusoid of one frequency in all readings of a sensor, by the clock: amplitude and phase are each
/// series' own.
class PeriodicInterference final : public NoiseTerm {
  [[nodiscard]] std::optional<NoiseProposal> propose(const NoiseEvidence& evidence) const override {
    std::optional<NoiseProposal> best;
    for (const Sensor sensor : all_sensors) {
      const bool known = std::any_of(evidence.shape.interference.begin(), evidence.shape.interference.end(),
                                     [&](const Interference& one) { return one.sensor == sensor; });
      if (!known) look_at(evidence, sensor, best);
    }
    return best;
  }

  static std::vector<const Series*> series_of(const NoiseEvidence& evidence, Sensor sensor) {
    constexpr std::size_t fewest = 12;
    std::vector<const Series*> all;
    for (const Series& one : evidence.measurements.series())
      if (one.channel.sensor() == sensor && one.readings.size() >= fewest) all.push_back(&one);
    return all;
  }

  static std::complex<double> transform(const NoiseEvidence& evidence, const Series& series,
                                        double frequency) {
    std::complex<double> sum = 0;
    for (std::size_t i = series.first; i < series.first + series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (evidence.weight(row) > 0)
        sum += evidence.standardised(row) *
               std::polar(1.0, -2 * std::numbers::pi * frequency * instant(evidence, row));
    }
    return sum;
  }

  static double pause_of(const NoiseEvidence& evidence, const Series& series) {
    const auto first = static_cast<Eigen::Index>(series.first),
               count = static_cast<Eigen::Index>(series.readings.size());
    return (instant(evidence, first + count - 1) - instant(evidence, first)) / static_cast<double>(count - 1);
  }

  /// The one that the readings of a series show of it: a run that is read slowly shows an alias.
  static double frequency_shown(const NoiseEvidence& evidence, const Series& series, double frequency) {
    const double pause = pause_of(evidence, series);
    return pause > 0 ? std::abs(frequency - std::round(frequency * pause) / pause) : 0;
  }

  static void look_at(const NoiseEvidence& evidence, Sensor sensor, std::optional<NoiseProposal>& best) {
    const std::vector<const Series*> all = series_of(evidence, sensor);
    double longest = 0, pause = std::numeric_limits<double>::infinity(), occam = 0;
    for (const Series* one : all) {
      const double own = pause_of(evidence, *one), count = static_cast<double>(one->readings.size());
      longest = std::max(longest, own * (count - 1));
      if (own > 0) pause = std::min(pause, own);
      occam += std::log(count);  // half for amplitude, half for phase
    }
    if (!(longest > 0)) return;
    // Slower than this it is a trend; faster than half the highest sampling rate it is an alias.
    const double lowest = 6 / longest, highest = 0.5 / pause, step = 0.25 / longest;
    const double log_prior =
        std::log(priors::uneven_noise) - std::log(std::max(1.0, (highest - lowest) / step));
    for (double frequency = lowest; frequency < highest; frequency += step) {
      const auto trend = [&](const Series* one) {
        return frequency_shown(evidence, *one, frequency) < lowest;
      };
      if (std::any_of(all.begin(), all.end(), trend)) continue;
      double gain = 0;
      for (const Series* one : all)
        gain += std::norm(transform(evidence, *one, frequency)) / static_cast<double>(one->readings.size());
      const double log_odds = gain - occam + log_prior;
      if (log_odds <= (best ? best->log_odds : 0)) continue;
      best = {log_odds, log_prior - occam, [&evidence, sensor, frequency](NoiseShape& shape) {
                accept(evidence, sensor, frequency, shape);
              }};
    }
  }

  static void accept(const NoiseEvidence& evidence, Sensor sensor, double frequency, NoiseShape& shape) {
    const std::vector<const Series*> all = series_of(evidence, sensor);
    const Eigen::Index before = shape.periodic.cols();
    shape.periodic.conservativeResize(Eigen::NoChange, before + 2 * static_cast<Eigen::Index>(all.size()));
    shape.periodic.rightCols(2 * static_cast<Eigen::Index>(all.size())).setZero();
    for (std::size_t s = 0; s < all.size(); ++s) {
      const Series& series = *all[s];
      const auto count = static_cast<double>(series.readings.size());
      for (std::size_t i = series.first; i < series.first + series.readings.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double phase = 2 * std::numbers::pi * frequency * instant(evidence, row);
        shape.periodic(row, before + 2 * static_cast<Eigen::Index>(s)) = std::cos(phase);
        shape.periodic(row, before + 2 * static_cast<Eigen::Index>(s) + 1) = std::sin(phase);
      }
      const auto first = static_cast<Eigen::Index>(series.first);
      const double pause = pause_of(evidence, series);
      auto place = std::find_if(
          shape.interference.begin(), shape.interference.end(),
          [&](const Interference& one) { return one.run == series.run && one.sensor == sensor; });
      if (place == shape.interference.end())
        place = shape.interference.insert(place, {series.run, sensor, 1 / (frequency * pause), {}});
      place->rms[series.channel] = std::sqrt(2.0) * std::abs(transform(evidence, series, frequency)) / count *
                                   evidence.scale(first) * shape.relative(first);
    }
  }
};

}  // namespace

std::unique_ptr<NoiseTerm> periodic_interference() {
  return std::make_unique<PeriodicInterference>();
}

}  // namespace plumbline::diagnose
