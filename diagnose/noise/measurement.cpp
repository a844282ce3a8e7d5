#include "diagnose/noise/measurement.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "diagnose/noise/proportional_noise.hpp"
#include "diagnose/noise/stretches.hpp"
#include "diagnose/noise/uneven_noise.hpp"

namespace plumbline::diagnose {
namespace {

/// The largest number of which both are multiples, to so much; zero where that is no larger.
double common_divisor(double one, double other, double tolerance) {
  while (other > tolerance) {
    const double left = std::abs(one - std::round(one / other) * other);
    one = other, other = left;
  }
  return one > 100 * tolerance ? one : 0;
}

/// What readings are rounded to: the largest step of which all their differences are multiples, to more
/// digits than anybody writes; zero where there is none, or the differences are so few that it may be larger.
double rounding_step(const std::vector<double>& values) {
  constexpr std::size_t enough = 8;  // random integers have another divisor than 1 in 1 of 120 cases
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  const double tolerance = 1e-9 * largest;
  double step = 0;
  std::size_t steps = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double difference = std::abs(values[i] - values[i - 1]);
    if (difference <= tolerance) continue;
    step = steps == 0 ? difference : common_divisor(step, difference, tolerance);
    ++steps;
    if (step == 0) return 0;
  }
  return steps >= enough || 4 * (values.size() - 1 - steps) >= values.size() ? step : 0;
}

/// What random numbers for the values of a channel begin with.
std::vector<std::uint32_t> seed_of(const Channel& channel, const std::vector<double>& values) {
  std::vector<std::uint32_t> bits{static_cast<std::uint32_t>(channel.name)};
  for (const double value : values) {
    const auto both = std::bit_cast<std::uint64_t>(value);
    bits.push_back(static_cast<std::uint32_t>(both));
    bits.push_back(static_cast<std::uint32_t>(both >> 32));
  }
  return bits;
}

/// Standard deviation of independent noise whose third differences are in the middle as large as those of the
/// values, which a smooth curve hardly has; infinite where there are too few to say, or most of them repeat.
double roughness(const Differences& differences, double proportion) {
  constexpr std::size_t few = 9;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (differences.sizes.size() < few) return unknown;
  const double deviation = spread({differences}, proportion);
  return deviation > 0 ? deviation : unknown;
}

/// Of each value, how many in a row read the same.
std::vector<std::size_t> repeated(const std::vector<double>& values) {
  std::vector<std::size_t> times;
  for (std::size_t i = 0; i < values.size();) {
    std::size_t next = i + 1;
    while (next < values.size() && values[next] == values[i]) ++next;
    times.insert(times.end(), next - i, next - i);
    i = next;
  }
  return times;
}

/// How many times the variance of one coarse reading those have of which so many in a row are the same, for
/// the error of rounding is one: so much the less do they scatter beside it, for that would have shown.
/// \param step  that they are rounded to, declared sigmas
double rounded_alike(double step, std::size_t times) {
  constexpr std::size_t few = 4;  // that noise as large as a step makes equal once in thirty times
  const double rounded = step * step / 12, count = static_cast<double>(times);
  // The farthest of so many is off by the root of 2 ln m deviations, and by no more than half a step.
  const double scatter = times < few ? 1 : std::min(1.0, step * step / (8 * std::log(count)));
  return (scatter + rounded * count) / (scatter + rounded);
}

double mean_interval(const Run& run, const std::vector<std::size_t>& readings) {
  const double time = run.readings[readings.back()].t - run.readings[readings.front()].t;
  return readings.size() > 1 ? time / static_cast<double>(readings.size() - 1) : 0;
}

std::vector<double> clock_of(const Run& run, const Series& series) {
  std::vector<double> clock;
  for (const std::size_t i : series.readings) {
    const double since = run.readings[i].t - run.readings[series.readings.front()].t;
    clock.push_back(series.interval > 0 ? since / series.interval : static_cast<double>(clock.size()));
  }
  return clock;
}

/// Gives every series its pace. Intervals that are alike are the same; a clock that somebody made up tells
/// none.
void tell_paces(const Experiment& experiment, Sensor sensor, std::vector<Series>& all) {
  constexpr double alike = 1.5;
  std::vector<Series*> timed;
  for (Series& one : all)
    if (one.channel.sensor() == sensor && one.interval > 0 && !experiment.runs[one.run].counts_readings())
      timed.push_back(&one);
  std::sort(timed.begin(), timed.end(),
            [](const Series* a, const Series* b) { return a->interval < b->interval; });
  double same = 0;
  for (Series* one : timed) {
    if (one->interval > alike * same) same = one->interval;
    one->pace = same / timed.front()->interval;
  }
}

/// Makes the sigma of a series so many times as large.
void widen(Series& series, double times, SeenNoise& seen) {
  series.sigma *= times;
  series.step /= times;
  for (Differences* differences : {&seen.in_time, &seen.in_place})
    for (double& size : differences->sizes) size /= times;
}

/// By what share of themselves the readings of each channel scatter besides.
std::map<Channel::Name, double> proportions_of(const std::vector<Series>& series,
                                               const std::vector<SeenNoise>& seen) {
  std::map<Channel::Name, std::vector<Differences>> in_time, in_place;
  for (std::size_t s = 0; s < series.size(); ++s) {
    in_time[series[s].channel.name].push_back(seen[s].in_time);
    in_place[series[s].channel.name].push_back(seen[s].in_place);
  }
  std::map<Channel::Name, double> proportions;
  for (const auto& [name, all] : in_time) {
    const double ratio = proportional_noise(all);
    // Along a path that is sampled coarsely a stop looks like noise where forces are large.
    proportions[name] = is_likely(in_place[name], ratio) ? ratio : 0;
  }
  return proportions;
}

}  // namespace

Measurements::Measurements(const Experiment& experiment) {
  std::vector<std::vector<double>> all;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    for (const Channel& channel : run.measured()) {
      Series series;
      series.run = r;
      series.channel = channel;
      series.sigma = channel.sigma(experiment.noise) * run.noise_of_group();
      series.first = size_;
      for (std::size_t i = 0; i < run.readings.size(); ++i)
        if (!std::isnan(channel.of(run.readings[i]))) series.readings.push_back(i);
      if (series.readings.empty()) continue;
      series.interval = mean_interval(run, series.readings);
      series.clock = clock_of(run, series);
      const bool read_together =
          !series_.empty() && series_.back().run == r && series_.back().readings == series.readings;
      series.between = read_together ? series_.back().between : between(run, series.readings);
      std::vector<double> values;
      for (const std::size_t i : series.readings) values.push_back(channel.of(run.readings[i]));
      series.seed = seed_of(channel, values);
      series.step = rounding_step(values) / series.sigma;
      size_ += series.readings.size();
      series_.push_back(std::move(series));
      all.push_back(std::move(values));
    }
  }
  for (const Sensor sensor : {Sensor::position, Sensor::force, Sensor::angle})
    tell_paces(experiment, sensor, series_);
  std::vector<SeenNoise> seen;
  for (std::size_t s = 0; s < series_.size(); ++s)
    seen.push_back(seen_noise(experiment.runs[series_[s].run], series_[s], all[s]));
  const auto joint_of = [](const Series& one) { return one.channel.joint; };
  const auto run_of = [](const Series& one) { return one.run; };
  weigh_groups(Sensor::angle, joint_of, &Series::beside_joints, seen);
  for (const Sensor sensor : {Sensor::position, Sensor::force, Sensor::angle})
    weigh_groups(sensor, run_of, &Series::beside_runs, seen);
  weigh_stretches(experiment, all, seen);
  weigh(all, seen);
  repeats_ = diagnose::repeats(experiment, series_);
}

/// Gives the readings of a sensor in a group (of a joint, of a run) where it scatters more than in the others
/// a sigma to match.
void Measurements::weigh_groups(Sensor sensor, std::size_t (*group_of)(const Series&),
                                double Series::*beside_others, std::vector<SeenNoise>& seen) {
  std::vector<std::vector<SeenNoise>> groups;
  for (std::size_t s = 0; s < series_.size(); ++s) {
    if (series_[s].channel.sensor() != sensor) continue;
    groups.resize(std::max(groups.size(), group_of(series_[s]) + 1));
    groups[group_of(series_[s])].push_back(seen[s]);
  }
  const std::vector<double> times = uneven_noise(groups);
  for (std::size_t s = 0; s < series_.size(); ++s) {
    if (series_[s].channel.sensor() != sensor) continue;
    const double own = times[group_of(series_[s])];
    series_[s].*beside_others = own;
    widen(series_[s], own, seen[s]);
  }
}

/// Marks where in a run a sensor scatters more than elsewhere; not where its readings scatter in proportion,
/// for they do so wherever they are large.
void Measurements::weigh_stretches(const Experiment& experiment,
                                   const std::vector<std::vector<double>>& values,
                                   std::vector<SeenNoise>& seen) {
  std::set<Sensor> in_proportion;
  for (const auto& [name, ratio] : proportions_of(series_, seen))
    if (ratio > 0) in_proportion.insert(Channel{name}.sensor());
  for (const Sensor sensor : {Sensor::position, Sensor::force, Sensor::angle}) {
    if (in_proportion.contains(sensor)) continue;
    const std::vector<std::vector<RoughStretch>> rough = rough_stretches(experiment, series_, values, sensor);
    for (std::size_t s = 0; s < series_.size(); ++s) {
      Series& series = series_[s];
      if (series.channel.sensor() != sensor || rough[series.run].empty()) continue;
      series.rough = rough[series.run];
      seen[s] = seen_noise(experiment.runs[series.run], series, values[s]);
    }
  }
}

/// Gives every value its sigma. What scatters in proportion does so in all runs of a channel. Coarse readings
/// that are the same in a row were rounded alike: together they have that error once.
void Measurements::weigh(const std::vector<std::vector<double>>& values, const std::vector<SeenNoise>& seen) {
  const std::map<Channel::Name, double> proportions = proportions_of(series_, seen);
  for (std::size_t s = 0; s < series_.size(); ++s) {
    Series& series = series_[s];
    series.proportion = proportions.at(series.channel.name);
    const std::vector<std::size_t> times = repeated(values[s]);
    for (std::size_t i = 0; i < values[s].size(); ++i) {
      const double wider = series.step > 0 ? std::sqrt(rounded_alike(series.step, times[i])) : 1;
      series.sigmas.push_back(series.sigma * series.roughness_at(series.readings[i]) *
                              std::hypot(1.0, series.proportion * values[s][i]) * wider);
    }
    series.roughness = roughness(Differences(values[s], series.sigma), series.proportion);
  }
}

std::vector<double> Measurements::residual(const Experiment& experiment, const Prediction& predicted) const {
  std::vector<double> values = in_sigmas(predicted.runs);
  for (const Series& series : series_) {
    const std::vector<Reading>& measured = experiment.runs[series.run].readings;
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      double& value = values[series.first + i];
      value = series.channel.of(measured[series.readings[i]]) / series.sigmas[i] - value;
    }
  }
  return values;
}

std::vector<double> Measurements::in_sigmas(const std::vector<Trace>& traces) const {
  std::vector<double> values;
  values.reserve(size_);
  for (const Series& series : series_) {
    const auto column = traces[series.run].col(column_of(series.channel));
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      values.push_back(column(static_cast<Eigen::Index>(series.readings[i])) / series.sigmas[i]);
  }
  return values;
}

}  // namespace plumbline::diagnose
