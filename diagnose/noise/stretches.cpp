#include "diagnose/noise/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/beliefs.hpp"
#include "diagnose/bench/median.hpp"
#include "diagnose/noise/uneven_noise.hpp"

namespace plumbline::diagnose {
namespace {

/// Differences that say how large noise is.
constexpr std::size_t least_differences = 20;

/// Squares of the differences over the usual one: an outlier or a step counts no more than the noise of a
/// very rough stretch would.
std::vector<double> squares_of(const std::vector<Loudness>& run) {
  constexpr double most = 25;
  std::vector<double> squares;
  for (const Loudness& one : run) squares.push_back(one.size);
  const double usual = median_deviation(squares);
  if (!(usual > 0)) return {};
  for (double& size : squares) size = std::min(std::pow(size / usual, 2), most);
  return squares;
}

/// Where a part of a run is split best, and what twice the log-likelihood gains by it.
struct Split {
  std::size_t at = 0;
  double gain = 0;
  bool rises = false;  ///< what comes after is the larger
};

/// Twice the log-likelihood, largest over the variance, of so many normal deviates with this sum of squares.
double twice_likelihood(double sum, double count) {
  return -count * std::log(std::max(sum / count, 1e-2));  // coarse readings may stand still
}

/// \param from, to  differences, by their number
Split best_split(const std::vector<Loudness>& run, const std::vector<double>& squares, std::size_t from,
                 std::size_t to) {
  const double all = std::accumulate(squares.begin() + static_cast<std::ptrdiff_t>(from),
                                     squares.begin() + static_cast<std::ptrdiff_t>(to), 0.0);
  const double whole = twice_likelihood(all, static_cast<double>(to - from));
  Split best;
  double before = 0;
  for (std::size_t i = from; i < to; ++i) {
    const bool between_readings = i > from && run[i].reading != run[i - 1].reading;
    if (between_readings && i - from >= least_differences && to - i >= least_differences) {
      const double gain = twice_likelihood(before, static_cast<double>(i - from)) +
                          twice_likelihood(all - before, static_cast<double>(to - i)) - whole;
      if (gain > best.gain)
        best = {i, gain,
                before * static_cast<double>(to - i) < (all - before) * static_cast<double>(i - from)};
    }
    before += squares[i];
  }
  return best;
}

void split(const std::vector<Loudness>& run, const std::vector<double>& squares, std::size_t from,
           std::size_t to, std::vector<std::size_t>& borders) {
  const Split best = best_split(run, squares, from, to);
  if (best.gain < beliefs::proportional_gain) return;
  split(run, squares, from, best.at, borders);
  // What no difference tells, as at a corner of the path, is taken to be as rough as the rougher side: the
  // last quiet difference says nothing of the value after it, nor the first one of the value before.
  borders.push_back(best.rises ? run[best.at - 1].reading + 1 : run[best.at].reading - 1);
  split(run, squares, best.at, to, borders);
}

}  // namespace

std::vector<std::size_t> stretch_borders(const std::vector<Loudness>& run) {
  std::vector<std::size_t> borders;
  if (run.size() < 2 * least_differences) return borders;
  if (const std::vector<double> squares = squares_of(run); !squares.empty())
    split(run, squares, 0, run.size(), borders);
  return borders;
}

namespace {

void append(Differences& all, const Differences& more) {
  all.sizes.insert(all.sizes.end(), more.sizes.begin(), more.sizes.end());
  all.levels.insert(all.levels.end(), more.levels.begin(), more.levels.end());
}

/// Of the values that were read in a stretch.
SeenNoise seen_in(const RoughStretch& stretch, const Run& run, const Series& series,
                  const std::vector<double>& values) {
  const auto place = [&](std::size_t reading) {
    return std::lower_bound(series.readings.begin(), series.readings.end(), reading) -
           series.readings.begin();
  };
  const auto first = place(stretch.from), last = place(stretch.to);
  const std::vector<double> here(values.begin() + first, values.begin() + last);
  const std::vector<bool> even =
      goes_evenly(run, {series.readings.begin() + first, series.readings.begin() + last});
  const double sigma = series.sigma * stretch.times;
  SeenNoise seen{Differences(here, sigma).where(even), {}};
  const auto is_here = [&](std::size_t value) {
    const auto number = static_cast<std::ptrdiff_t>(value);
    return number >= first && number < last;
  };
  const Differences in_place(values, sigma, series.between);
  for (std::size_t i = 0; i < series.between.size(); ++i) {
    const Between& one = series.between[i];
    if (!is_here(one.value)) continue;
    // What is elsewhere counts as exact: noise here is no larger than it would then be.
    const double before = is_here(one.before) ? 1 - one.share : 0, after = is_here(one.after) ? one.share : 0;
    const double own = std::sqrt(one.squares() / (1 + before * before + after * after));
    seen.in_place.sizes.push_back(own * in_place.sizes[i]);
    seen.in_place.levels.push_back(in_place.levels[i]);
  }
  return seen;
}

/// What one sensor read in one run.
struct OfSensor {
  std::vector<const Series*> series;
  std::vector<const std::vector<double>*> values;
};

OfSensor of_sensor(std::size_t run, Sensor sensor, const std::vector<Series>& series,
                   const std::vector<std::vector<double>>& values) {
  OfSensor own;
  for (std::size_t s = 0; s < series.size(); ++s)
    if (series[s].run == run && series[s].channel.sensor() == sensor)
      own.series.push_back(&series[s]), own.values.push_back(&values[s]);
  return own;
}

std::vector<Loudness> loudness(const Run& run, const OfSensor& read) {
  std::vector<Loudness> all;
  for (std::size_t s = 0; s < read.series.size(); ++s) {
    const Series& series = *read.series[s];
    const Differences differences(*read.values[s], series.sigma);
    const std::vector<bool> even = goes_evenly(run, series.readings);
    // The two values in its middle enter a third difference most.
    for (std::size_t i = 0; i < differences.sizes.size(); ++i)
      if (even[i]) all.push_back({series.readings[i + 2], differences.sizes[i]});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Loudness& a, const Loudness& b) { return a.reading < b.reading; });
  return all;
}

/// How many times the declared noise a stretch scatters, one at least: where readings scatter less than was
/// declared it is no rougher for others that scatter still less.
double beyond_declared(const std::vector<SeenNoise>& stretch) {
  std::vector<Differences> in_time;
  for (const SeenNoise& one : stretch) in_time.push_back(one.in_time);
  return std::max(1.0, spread(in_time));
}

/// Where a stretch begins and ends is known to a few readings: these count as rough.
void widen(std::vector<RoughStretch>& stretches, std::size_t readings) {
  constexpr std::size_t reach = 3;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : stretches[i - 1].to,
                      after = i + 1 == stretches.size() ? readings : stretches[i + 1].from;
    stretches[i].from = std::max(before + reach, stretches[i].from) - reach;
    stretches[i].to = std::min(after, stretches[i].to + reach);
  }
}

}  // namespace

SeenNoise seen_noise(const Run& run, const Series& series, const std::vector<double>& values) {
  SeenNoise seen;
  std::vector<RoughStretch> stretches;
  std::size_t from = 0;
  for (const RoughStretch& rough : series.rough) {
    if (rough.from > from) stretches.push_back({from, rough.from, 1});
    stretches.push_back(rough);
    from = rough.to;
  }
  stretches.push_back({from, run.readings.size(), 1});
  for (const RoughStretch& stretch : stretches) {
    const SeenNoise here = seen_in(stretch, run, series, values);
    append(seen.in_time, here.in_time);
    append(seen.in_place, here.in_place);
  }
  return seen;
}

std::vector<std::vector<RoughStretch>> rough_stretches(const Experiment& experiment,
                                                       const std::vector<Series>& series,
                                                       const std::vector<std::vector<double>>& values,
                                                       Sensor sensor) {
  std::vector<std::vector<RoughStretch>> stretches(experiment.runs.size());
  std::vector<std::vector<SeenNoise>> seen;
  for (std::size_t r = 0; r < stretches.size(); ++r) {
    const Run& run = experiment.runs[r];
    const OfSensor read = of_sensor(r, sensor, series, values);
    std::vector<std::size_t> borders = stretch_borders(loudness(run, read));
    borders.push_back(run.readings.size());
    for (std::size_t from = 0; const std::size_t to : borders) {
      stretches[r].push_back({from, to, 1});
      from = to;
      seen.emplace_back();
      for (std::size_t s = 0; s < read.series.size(); ++s)
        seen.back().push_back(seen_in(stretches[r].back(), run, *read.series[s], *read.values[s]));
    }
  }
  std::vector<double> times = uneven_noise(seen);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = std::min(times[i], beyond_declared(seen[i]));
  auto next = times.begin();
  for (std::size_t r = 0; r < stretches.size(); ++r) {
    for (RoughStretch& one : stretches[r]) one.times = *next++;
    const bool split = stretches[r].size() > 1;
    std::erase_if(stretches[r], [&](const RoughStretch& one) { return !split || one.times == 1; });
    widen(stretches[r], experiment.runs[r].readings.size());
  }
  return stretches;
}

}  // namespace plumbline::diagnose
