#include "diagnose/noise/hum.hpp"

#include <cmath>
#include <utility>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/chord.hpp"
#include "diagnose/noise/spectrum.hpp"

namespace plumbline::diagnose {
namespace {

/// The slowest tone of the spectrum, or one that is slower by up to an ordinate where that leaves less: of
/// what goes round 3.7 times the spectrum shows the flank.
Hum slowest_in(const Eigen::VectorXd& values, const Eigen::VectorXd& clock) {
  const auto count = static_cast<std::size_t>(values.size());
  Hum best = tone_of(values, clock, slowest_tone(count));
  double loud = 0;
  for (Eigen::Index look = 0; look > -looks_an_ordinate; --look) {
    const Slow one = slow_tone(values, clock, looked_at(count, look), true);
    if (!(one.loud > loud)) continue;
    loud = one.loud;
    if (look < 0) best = one.tone;
  }
  return best;
}

/// The loudest tone in these values, and their spectrum.
struct Loudest {
  Hum tone;
  double frequency;
  Eigen::VectorXd shares;
};

Loudest loudest(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double correlation) {
  const auto count = static_cast<std::size_t>(values.size());
  Eigen::VectorXd shares = tone_shares(values, clock, correlation);
  Eigen::Index look = 0;
  shares.maxCoeff(&look);
  const double frequency = looked_at(count, look);
  return {look == 0 ? slowest_in(values, clock) : tone_of(values, clock, frequency), frequency,
          std::move(shares)};
}

/// The chance that noise alone has as loud a tone as this one, the loudest. Fisher: with n ordinates the
/// largest share g of the energy has P(g > x) < n (1 - x)^(n - 1); looking between the ordinates finds no
/// more than twice as often.
double chance_of(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency,
                 double correlation) {
  const double n = ordinates(static_cast<std::size_t>(values.size()));
  return 2 * n * std::pow(1 - tone_share(values, clock, frequency, correlation), n - 1);
}

/// The noise beside the loudest tone of each series, be it noise or not.
NoiseModel noise_beside_tones(const Measurements& measurements, const std::vector<double>& residual) {
  std::vector<Hum> all;
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    const Series& series = measurements.series()[s];
    if (!long_enough(series)) continue;
    all.push_back(loudest(values_of(series, residual), clock_of(series), 0).tone);
    all.back().series = s;
  }
  return estimate_noise(measurements, without_hum(measurements, residual, all));
}

/// What tones differ by where the path comes to the same place, and what they would by chance.
struct AtOnePlace {
  std::size_t count = 0;
  double off = 0, by_chance = 0;

  /// Whether they are much the same.
  [[nodiscard]] bool alike() const {
    constexpr std::size_t few = 8;
    constexpr double share = 0.25;
    return count >= few && off < share * by_chance;
  }
};

/// Within a quarter of its period, as where the path holds still, any tone is much the same: that tells
/// nothing.
void compare(const Series& series, const Hum& one, AtOnePlace& all) {
  constexpr double quarter = 0.25;
  const Eigen::VectorXd wave = wave_of(series, one), clock = clock_of(series);
  const auto later = [&](std::size_t a, std::size_t b) {
    return std::abs(clock[static_cast<Eigen::Index>(a)] - clock[static_cast<Eigen::Index>(b)]) >
           quarter * one.period;
  };
  for (const Between& between : series.between) {
    if (!later(between.value, between.before) || !later(between.value, between.after)) continue;
    ++all.count;
    all.off += std::pow(between.off(wave.data()), 2);
    all.by_chance += one.rms() * one.rms();
  }
}

/// Whether two tones are one by the clock, as far as the longer of their runs tells.
bool is_one_tone(const Series& a, const Hum& in_a, const Series& b, const Hum& in_b) {
  const auto frequency = [](const Series& series, const Hum& one) {
    return 1 / (one.period * series.interval);
  };
  const auto ordinate = [](const Series& series) {
    return 1 / (static_cast<double>(series.readings.size()) * series.interval);
  };
  return std::abs(frequency(a, in_a) - frequency(b, in_b)) < std::min(ordinate(a), ordinate(b));
}

/// Whether a tone is much the same wherever the path comes to the same place, in its own run and in all that
/// have it: then it is of the chain. One run alone may have turned back at its crest.
bool goes_with_the_path(const Measurements& measurements, const Hum& one, const std::vector<Hum>& all) {
  const Series& own = measurements.series()[one.series];
  AtOnePlace here, anywhere;
  compare(own, one, here);
  if (!here.alike()) return false;
  for (const Hum& other : all)
    if (const Series& series = measurements.series()[other.series]; is_one_tone(own, one, series, other))
      compare(series, other, anywhere);
  return anywhere.alike();
}

}  // namespace

std::vector<Hum> find_hum(const Measurements& measurements, const std::vector<double>& residual) {
  constexpr double level = 1e-3;
  std::vector<Hum> all;
  std::vector<Eigen::VectorXd> spectra(measurements.series().size());
  const NoiseModel noise = noise_beside_tones(measurements, residual);
  const auto larger = larger_correlations(measurements, residual, noise);
  const auto by_chance = [&](const Series& series, const Eigen::VectorXd& values, double frequency) {
    const Eigen::VectorXd clock = clock_of(series);
    const double estimated = chance_of(values, clock, frequency, noise.correlation_of(series));
    if (!(estimated < level)) return estimated;
    // Of noise that is slower than was estimated slow tones are none.
    double chance = estimated;
    for (const auto& [value, probability] : larger)
      chance += probability *
                (chance_of(values, clock, frequency, at_pace(series, value, noise.manner)) - estimated);
    return chance;
  };
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    const Series& series = measurements.series()[s];
    if (!long_enough(series)) continue;
    Eigen::VectorXd values = values_of(series, residual);
    for (long i = 0; i < most_tones; ++i) {
      auto [one, frequency, shares] = loudest(values, clock_of(series), noise.correlation_of(series));
      spectra[s] = std::move(shares);
      if (!(by_chance(series, values, frequency) < level) || one.rms() > beliefs::largest_hum) break;
      values -= wave_of(series, one);
      one.series = s;
      all.push_back(one);
    }
  }
  add_shared(measurements, residual, spectra, level, all);
  add_known(measurements, residual, level, all);
  const std::vector<Hum> heard = all;
  std::erase_if(all, [&](const Hum& one) { return goes_with_the_path(measurements, one, heard); });
  return all;
}

Experiment quiet(Experiment experiment, const Measurements& measurements, const std::vector<Hum>& hum) {
  for (const Hum& one : hum) {
    const Series& series = measurements.series()[one.series];
    const Eigen::VectorXd wave = wave_of(series, one);
    std::vector<Reading>& readings = experiment.runs[series.run].readings;
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      series.channel.in(readings[series.readings[i]]) -=
          wave(static_cast<Eigen::Index>(i)) * series.sigmas[i];
  }
  return experiment;
}

}  // namespace plumbline::diagnose
