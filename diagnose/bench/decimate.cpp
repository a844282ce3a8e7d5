#include "diagnose/bench/decimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "diagnose/bench/median.hpp"
#include "diagnose/bench/thin_poses.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

constexpr std::size_t wanted_readings = 500, short_enough = 1000;

/// Smallest number of readings that a run keeps, one of so many runs: forty, at most a thousand in all, and
/// never below twenty.
std::size_t least_readings(std::size_t runs) {
  return std::clamp<std::size_t>(1000 / runs, 20, 40);
}

/// Fractions of a run's extent: the largest extent of a group, and the largest jitter of a logged position.
constexpr double farthest_in_group = 0.1, jitter = 0.01;
/// Jitter as a fraction of the farthest run, for a run that stands still.
constexpr double jitter_at_rest = 0.002;
/// Smallest mean number of groups between turning points: the turning points themselves lose their values.
constexpr double least_of_segment = 4;

/// A range of readings.
struct Segment {
  std::size_t from, to;
  [[nodiscard]] std::size_t count() const { return to - from; }
};

/// Diagonal of the bounding box of all commands of a run.
double extent(const Run& run) {
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Reading& reading : run.readings) {
    const Eigen::Array2d at = run.command(reading);
    if (at.isFinite().all()) low = low.min(at), high = high.max(at);
  }
  return (high >= low).all() ? (high - low).matrix().norm() : 0;
}

/// Turning points of a run by more than a distance.
std::vector<std::size_t> turns_farther_than(const Run& run, double distance) {
  std::vector<std::size_t> turns;
  std::size_t farthest = 0;
  Eigen::Vector2d anchor = run.command(run.readings.front()), far = anchor, ahead(0, 0);
  for (std::size_t i = 1; i < run.readings.size(); ++i) {
    const Eigen::Vector2d at = run.command(run.readings[i]);
    if (!at.allFinite()) continue;
    const double advance = (at - far).dot(ahead);
    if (ahead != Eigen::Vector2d(0, 0) && advance < -distance) {
      turns.push_back(farthest);
      ahead = (at - far).normalized();
    } else if (advance < 0) {
      continue;
    } else if ((at - anchor).norm() > distance) {
      ahead = (at - anchor).normalized();
    } else {
      far = at, farthest = i;
      continue;
    }
    anchor = far = at, farthest = i;
  }
  return turns;
}

/// The readings that stay alone: the ends, and turning points by more than a distance.
std::vector<std::size_t> stops(const Run& run, double distance) {
  std::vector<std::size_t> all = turns_farther_than(run, distance);
  all.insert(all.begin(), 0);
  all.push_back(run.readings.size() - 1);
  return all;
}

/// Decimates one run, group by group.
class Decimator {
 public:
  /// \param most   largest number of readings in a group
  /// \param still  largest change of the command that counts as standing still
  Decimator(const Run& run, std::size_t most, double still)
      : run_(run), stops_(stops(run, std::max(jitter * extent(run), still))), result_(run) {
    result_.readings.clear();
    const double whole = extent(run_);
    const double count = static_cast<double>(run_.readings.size());
    const double farthest = std::min(farthest_in_group * whole / way(),
                                     1 / (least_of_segment * static_cast<double>(stops_.size() - 1)));
    size_ = count * farthest < static_cast<double>(most) ? static_cast<std::size_t>(count * farthest) : most;
  }

  /// The median of two readings is no gain.
  [[nodiscard]] bool gains() const { return size_ > 2; }

  Run result() {
    std::size_t from = 0;
    for (const std::size_t alone : stops_) {
      add(Segment{from, alone});
      add_alone(alone);
      from = alone + 1;
    }
    result_.groups.first.push_back(run_.readings.size());
    if (!sizes_.empty()) result_.groups.size = static_cast<std::size_t>(median(sizes_));
    return std::move(result_);
  }

 private:
  /// Length of the path through the stops.
  [[nodiscard]] double way() const {
    double sum = 0;
    Eigen::Vector2d last = run_.command(run_.readings.front());
    for (const std::size_t stop : stops_) {
      const Eigen::Vector2d at = run_.command(run_.readings[stop]);
      if (!at.allFinite()) continue;
      sum += (at - last).norm();
      last = at;
    }
    return sum;
  }

  template <class Value>
  [[nodiscard]] double mean(const Segment& group, Value value) const {
    double sum = 0;
    for (std::size_t i = group.from; i < group.to; ++i) sum += value(run_.readings[i]);
    return sum / static_cast<double>(group.count());
  }

  [[nodiscard]] Eigen::Vector2d mean_command(const Segment& group) const {
    return {mean(group, [&](const Reading& r) { return run_.command(r).x(); }),
            mean(group, [&](const Reading& r) { return run_.command(r).y(); })};
  }

  /// Median of a function of the readings that hold a channel.
  template <class Value>
  [[nodiscard]] double middle(const Segment& group, const Channel& channel, Value value) const {
    std::vector<double> values;
    for (std::size_t i = group.from; i < group.to; ++i)
      if (!std::isnan(channel.of(run_.readings[i]))) values.push_back(value(run_.readings[i]));
    return median(std::move(values));
  }

  /// A quadratic trend along the path.
  struct Trend {
    Eigen::Vector2d along{0, 0};
    double slope = 0, curve = 0;

    [[nodiscard]] double operator()(const Eigen::Vector2d& from_centre) const {
      const double s = from_centre.dot(along);
      return (slope + curve * s) * s;
    }
  };

  /// A quadratic version of Tukey's resistant line, through the medians of three thirds of the group with two
  /// groups on either side, at least nine readings, for outliers must not turn it. With fewer neighbours the
  /// group's own noise bends the curve: with one group on either side the result scatters by 8 % more, with
  /// two by 2 %.
  [[nodiscard]] Trend trend(const Segment& group, const Segment& segment, const Channel& channel) const {
    const std::size_t wider = std::max<std::size_t>(2 * group.count(), 4);
    const Segment seen{std::max(segment.from + wider, group.from) - wider,
                       std::min(segment.to, group.to + wider)};
    const std::size_t third = std::max<std::size_t>(1, seen.count() / 3);
    const std::array<Segment, 3> thirds{
        {{seen.from, seen.from + third}, {seen.from + third, seen.to - third}, {seen.to - third, seen.to}}};
    const Eigen::Vector2d centre = mean_command(group);
    Trend found;
    found.along = mean_command(thirds[2]) - mean_command(thirds[0]);
    found.along /= found.along.squaredNorm();
    std::array<double, 3> at{}, value{};
    for (std::size_t i = 0; i < thirds.size(); ++i) {
      at[i] = middle(thirds[i], channel,
                     [&](const Reading& r) { return (run_.command(r) - centre).dot(found.along); });
      value[i] = middle(thirds[i], channel, [&](const Reading& r) { return channel.of(r); });
    }
    const double before = (value[1] - value[0]) / (at[1] - at[0]),
                 after = (value[2] - value[1]) / (at[2] - at[1]);
    found.curve = (after - before) / (at[2] - at[0]);
    found.slope = before - found.curve * (at[0] + at[1]);
    return std::isfinite(found.slope) ? found : Trend{};
  }

  /// Median of a channel after removal of its trend, which is zero at the mean command.
  [[nodiscard]] double block_median(const Segment& group, const Segment& segment,
                                    const Channel& channel) const {
    const Trend off = trend(group, segment, channel);
    const Eigen::Vector2d centre = mean_command(group);
    return middle(group, channel,
                  [&](const Reading& r) { return channel.of(r) - off(run_.command(r) - centre); });
  }

  /// Splits a range into equal groups.
  void add(const Segment& segment) {
    const std::size_t groups = (segment.count() + size_ - 1) / size_;
    for (std::size_t g = 0; g < groups; ++g) {
      const Segment group{segment.from + g * segment.count() / groups,
                          segment.from + (g + 1) * segment.count() / groups};
      Reading& one = begin(group);
      // The median of a few readings would scatter more than the others.
      const bool few = 2 * group.count() < size_;
      for (const Channel& channel : run_.measured())
        channel.in(one) = few ? unseen : block_median(group, segment, channel);
      if (!few) sizes_.push_back(static_cast<double>(group.count()));
    }
  }

  void add_alone(std::size_t reading) {
    Reading& one = begin({reading, reading + 1});
    for (const Channel& channel : run_.measured()) channel.in(one) = unseen;
  }

  /// A reading with the mean time and command of a group.
  Reading& begin(const Segment& group) {
    Reading one = run_.readings[group.from];
    one.t = mean(group, [](const Reading& reading) { return reading.t; });
    for (const Channel& channel : run_.imposed())
      channel.in(one) = mean(group, [&](const Reading& reading) { return channel.of(reading); });
    for (std::size_t j = 0; j < one.rest.size(); ++j)
      one.rest[j] = mean(group, [&](const Reading& reading) { return reading.rest[j]; });
    for (std::size_t c = 0; c < one.covariates.size(); ++c)
      one.covariates[c] = mean(group, [&](const Reading& reading) { return reading.covariates[c]; });
    result_.readings.push_back(std::move(one));
    result_.groups.first.push_back(group.from);
    return result_.readings.back();
  }

  static constexpr double unseen = std::numeric_limits<double>::quiet_NaN();

  const Run& run_;
  std::vector<std::size_t> stops_;
  std::size_t size_;
  std::vector<double> sizes_;
  Run result_;
};

bool equal(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool equal(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double one, double other) { return equal(one, other); });
}

bool same(const std::vector<Channel>& channels, const Reading& a, const Reading& b) {
  return std::all_of(channels.begin(), channels.end(),
                     [&](const Channel& channel) { return equal(channel.of(a), channel.of(b)); });
}

/// Whether the bench imposed the same at two readings.
bool same_command(const Run& run, const Reading& a, const Reading& b) {
  return same(run.imposed(), a, b) && equal(a.rest, b.rest) && equal(a.covariates, b.covariates);
}

/// The smallest difference between values of a channel: a display shows no smaller one.
double smallest_step(const Run& run, const Channel& channel) {
  std::vector<double> values;
  for (const Reading& reading : run.readings)
    if (std::isfinite(channel.of(reading))) values.push_back(channel.of(reading));
  std::sort(values.begin(), values.end());
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] > values[i - 1]) step = std::min(step, values[i] - values[i - 1]);
  return step;
}

/// Logarithm of the probability that noise alone makes two readings equal: the density at zero of the
/// difference of two Gaussian values, times the step, channel by channel.
double log_chance(const Run& run, const std::vector<Channel>& measured, const Noise& noise) {
  double sum = 0;
  for (const Channel& channel : measured) {
    const double sigma = channel.sigma(noise);
    if (sigma > 0)
      sum += std::log(std::min(0.5, smallest_step(run, channel) / (2 * std::sqrt(std::numbers::pi) * sigma)));
  }
  return sum;
}

/// Log odds that k of n neighbours are equal since they are repeated, in a share of which any is as probable.
double log_odds_of_repetition(double k, double n, double log_chance) {
  const double share_summed_out = std::lgamma(k + 1) + std::lgamma(n - k + 1) - std::lgamma(n + 2);
  return std::log(priors::uneven_noise / (1 - priors::uneven_noise)) + share_summed_out - k * log_chance -
         (n - k) * std::log1p(-std::exp(log_chance));
}

/// A run without the readings that a logger wrote again before its sensor had a new one, as a thinned run:
/// the first of equal neighbours stays. Neighbours with equal commands scatter by the noise, and are equal by
/// chance as often as the steps of the values beside it allow. Readings are repeated where that is less
/// probable than a logger that repeats any share of them, of which one in twenty does.
Run without_repeated_readings(Run run, const Noise& noise) {
  const std::vector<Channel> measured = run.measured();
  std::vector<std::size_t> kept{0};
  double alike = 0;
  for (std::size_t i = 1; i < run.readings.size(); ++i) {
    const Reading &before = run.readings[i - 1], &here = run.readings[i];
    const bool commanded_alike = same_command(run, before, here);
    alike += commanded_alike;
    if (!commanded_alike || !same(measured, before, here)) kept.push_back(i);
  }
  const double repeated = static_cast<double>(run.readings.size()) - static_cast<double>(kept.size());
  if (repeated < 1 || !(log_odds_of_repetition(repeated, alike, log_chance(run, measured, noise)) > 0))
    return run;
  std::vector<Reading> readings;
  for (const std::size_t i : kept) readings.push_back(std::move(run.readings[i]));
  kept.push_back(run.readings.size());
  run.readings = std::move(readings);
  run.groups.first = std::move(kept);
  return run;
}

/// The run with its groups numbered as the readings were taken, where some had been left out before.
Run renumbered(Run run, const std::vector<std::size_t>& taken) {
  if (!taken.empty())
    for (std::size_t& first : run.groups.first) first = taken[first];
  return run;
}

}  // namespace

Experiment decimated(Experiment experiment) {
  if (experiment.visits_poses()) return thinned(std::move(experiment));  // neighbours have no median
  std::size_t total = 0;
  for (Run& run : experiment.runs) {
    if (!run.readings.empty()) run = without_repeated_readings(std::move(run), experiment.noise);
    total += run.readings.size();
  }
  if (total <= short_enough) return experiment;
  std::map<Control, double> farthest;
  for (const Run& run : experiment.runs) farthest[run.control] = std::max(farthest[run.control], extent(run));
  for (Run& run : experiment.runs) {
    const std::size_t count = run.readings.size(), groups = std::max(least_readings(experiment.runs.size()),
                                                                     count * wanted_readings / total);
    Decimator decimator(run, (count + groups - 1) / groups, jitter_at_rest * farthest[run.control]);
    if (decimator.gains()) run = renumbered(decimator.result(), run.groups.first);
  }
  return experiment;
}

}  // namespace plumbline::diagnose
