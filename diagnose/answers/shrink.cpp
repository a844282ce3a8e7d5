#include "diagnose/answers/shrink.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>

namespace plumbline::diagnose {
namespace {

/// How far a run's command goes from where it begins.
double reach_of_command(const Run& run) {
  double reach = 0;
  for (const Reading& reading : run.readings)
    reach = std::max(reach, (run.command(reading) - run.command(run.readings.front())).norm());
  return reach;
}

/// The run to do without: of the kind (control, whether it turns back) that has most runs, the one that goes
/// farthest after the farthest, so that what is left goes as far. The order of the runs does not matter. Of
/// two runs neither: what is left would not tell what the runs have in common from what is one run's own.
std::optional<std::size_t> spare_run(const Experiment& experiment) {
  using Kind = std::pair<Control, bool>;
  std::map<Kind, std::vector<std::size_t>> kinds;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    kinds[{experiment.runs[r].control, experiment.runs[r].turns_back()}].push_back(r);
  auto& most = std::max_element(kinds.begin(), kinds.end(), [](const auto& a, const auto& b) {
                 return a.second.size() < b.second.size();
               })->second;
  if (most.size() < 2 || experiment.runs.size() < 3) return std::nullopt;
  const auto key = [&](std::size_t r) {
    return std::pair(reach_of_command(experiment.runs[r]), experiment.runs[r].id);
  };
  std::sort(most.begin(), most.end(), [&](std::size_t a, std::size_t b) { return key(a) > key(b); });
  return most[1];
}

HeldOut nothing(const Experiment& experiment) {
  HeldOut none;
  for (const Run& run : experiment.runs) none.reading.emplace_back(run.readings.size(), false);
  return none;
}

/// Flat: which values are held out and no outliers.
std::vector<std::vector<std::size_t>> judged_values(const Measurements& measurements, const HeldOut& heldout,
                                                    const std::vector<double>& after) {
  const std::vector<bool> outlier = outliers(measurements, after);
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

/// Blocks of neighbouring values, with their sums of squares.
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

std::map<Channel, ChannelShrink> by_channel(const Measurements& measurements,
                                            const std::vector<std::vector<std::size_t>>& values,
                                            const std::vector<double>& before,
                                            const std::vector<double>& after, const NoiseModel& noise) {
  std::map<Channel, std::vector<std::vector<std::size_t>>> parts;
  for (std::size_t s = 0; s < values.size(); ++s)
    parts[measurements.series()[s].channel].push_back(values[s]);
  std::map<Channel, ChannelShrink> result;
  for (const auto& [channel, part] : parts) {
    Sums sum;
    double count = 0;
    for (const auto& series : part) {
      count += static_cast<double>(series.size());
      for (const std::size_t i : series)
        sum.before += before[i] * before[i], sum.after += after[i] * after[i];
    }
    if (!(sum.before > 0)) continue;
    ChannelShrink& one = result[channel];
    one.ratio = std::sqrt(sum.after / sum.before);
    one.noise_floor_ratio = noise.of(channel) * std::sqrt(count / sum.before);
    bootstrap(blocks(part, before, after), one);
  }
  return result;
}

}  // namespace

HeldOut choose_heldout(const Experiment& experiment) {
  HeldOut heldout = nothing(experiment);
  if (const std::optional<std::size_t> r = spare_run(experiment)) {
    heldout.reading[*r].assign(heldout.reading[*r].size(), true);
    heldout.names.push_back(experiment.runs[*r].id);
    return heldout;
  }
  return choose_blocks(experiment);
}

HeldOut choose_blocks(const Experiment& experiment) {
  HeldOut heldout = nothing(experiment);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    const std::size_t length = run.readings.size() / 8;
    if (length == 0) continue;
    for (const std::size_t from : {2 * length, 5 * length}) {
      std::fill_n(heldout.reading[r].begin() + static_cast<std::ptrdiff_t>(from), length, true);
      heldout.names.push_back(run.id + "[" + std::to_string(run.first_taken(from)) + ":" +
                              std::to_string(run.last_taken(from + length - 1)) + "]");
    }
  }
  return heldout;
}

Experiment without(const Experiment& experiment, const HeldOut& heldout) {
  Experiment rest = experiment;
  constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t r = 0; r < rest.runs.size(); ++r) {
    Run& run = rest.runs[r];
    const std::vector<Channel> measured = run.measured();
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      if (!heldout.reading[r][i]) continue;
      Reading& reading = run.readings[i];
      for (const Channel& channel : measured) channel.in(reading) = unseen;
    }
  }
  // A run of which nothing is left would only be walked for nothing.
  std::erase_if(rest.runs, [&](const Run& run) {
    const auto r = static_cast<std::size_t>(&run - rest.runs.data());
    return std::all_of(heldout.reading[r].begin(), heldout.reading[r].end(), [](bool held) { return held; });
  });
  return rest;
}

Shrink measure_shrink(const Measurements& measurements, const HeldOut& heldout,
                      const std::vector<double>& before, const std::vector<double>& after,
                      const NoiseModel& noise) {
  Shrink shrink;
  const auto values = judged_values(measurements, heldout, after);
  std::map<Channel, double> count;
  Sums all;
  double floor = 0, total = 0;
  for (std::size_t s = 0; s < values.size(); ++s) {
    const Series& series = measurements.series()[s];
    const Channel& channel = series.channel;
    for (const std::size_t i : values[s]) {
      shrink.rms_before[channel] += std::pow(series.sigma * before[i], 2);
      shrink.rms_after[channel] += std::pow(series.sigma * after[i], 2);
      count[channel] += 1;
      all.before += before[i] * before[i];
      all.after += after[i] * after[i];
      floor += std::pow(noise.of(series.channel), 2);
      total += 1;
    }
  }
  if (total == 0) return shrink;
  shrink.heldout = heldout.names;
  for (auto& [channel, sum] : shrink.rms_before) sum = std::sqrt(sum / count[channel]);
  for (auto& [channel, sum] : shrink.rms_after) sum = std::sqrt(sum / count[channel]);
  shrink.ratio = std::sqrt(all.after / all.before);
  shrink.noise_floor_ratio = std::sqrt(floor / all.before);
  shrink.chi2_per_value_after = all.after / floor;
  bootstrap(blocks(values, before, after), shrink);
  shrink.channels = by_channel(measurements, values, before, after, noise);
  return shrink;
}

}  // namespace plumbline::diagnose
