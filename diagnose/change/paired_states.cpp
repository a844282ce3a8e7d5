#include "diagnose/change/paired_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

/// A step of the command by more than this share of its range leads to a place of its own, not along a path.
constexpr double longest_step = 0.1;

/// Everything that is imposed at a reading.
VectorXd imposed(const Run& run, const Reading& reading) {
  std::vector<double> all = run.rest_at(reading);
  const Eigen::Vector2d end = run.imposed_at(reading);
  if (reading.wrench.empty()) all.insert(all.end(), {end.x(), end.y()});
  all.insert(all.end(), reading.wrench.begin(), reading.wrench.end());
  for (const LoadChannel& load : run.loads) all.push_back(reading.covariates[load.covariate]);
  for (double& one : all)
    if (!std::isfinite(one)) one = 0;  // nothing is imposed along it
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// The way of a run, every command over its range.
struct Path {
  std::vector<VectorXd> place;
  std::vector<std::size_t> sweep;  ///< by reading: turning points before it
};

using Ranges = VectorXd;

/// By what is imposed: the range over all runs of both states.
Ranges ranges(const std::vector<const Experiment*>& states) {
  VectorXd low, high;
  for (const Experiment* state : states)
    for (const Run& run : state->runs)
      for (const Reading& reading : run.readings) {
        const VectorXd one = imposed(run, reading);
        if (low.size() == 0) low = high = one;
        if (one.size() != low.size())
          throw Error("run \"" + run.id + "\"", "other commands than those of the other state",
                      "the same kinds of commands and loads in both");
        low = low.cwiseMin(one), high = high.cwiseMax(one);
      }
  return (high - low).unaryExpr([](double range) { return range > 0 ? range : 1; });
}

Path path(const Run& run, const Ranges& range) {
  Path one;
  const std::vector<bool> turns = run.turning_points();
  std::size_t sweep = 0;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    one.place.push_back(imposed(run, run.readings[i]).cwiseQuotient(range));
    one.sweep.push_back(sweep);
    sweep += turns[i] ? 1 : 0;
  }
  return one;
}

/// A place between two readings of a run of the reference.
struct Counterpart {
  std::size_t run, before, after;
  double share;     ///< of the way from the one to the other
  double distance;  ///< from it, over the ranges of the commands
};

/// Where a place lies between two neighbours.
Counterpart projected(const VectorXd& place, const VectorXd& from, const VectorXd& to) {
  const VectorXd way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((place - from).dot(way) / length, 0.0, 1.0) : 0;
  return {0, 0, 0, share, (place - from - share * way).norm()};
}

/// The nearest place of a run, on the same sweep; or a place of its own, however it was reached.
Counterpart nearest(const Path& state, std::size_t i, const Path& reference, std::size_t run) {
  Counterpart best{run, 0, 0, 0, std::numeric_limits<double>::infinity()};
  const bool own_place = i == 0 || (state.place[i] - state.place[i - 1]).norm() > longest_step;
  for (std::size_t k = 0; k < reference.place.size(); ++k) {
    const double here = (state.place[i] - reference.place[k]).norm();
    if ((own_place || reference.sweep[k] == state.sweep[i]) && here < best.distance)
      best = {run, k, k, 0, here};
    if (k == 0 || own_place || reference.sweep[k] != state.sweep[i]) continue;
    Counterpart one = projected(state.place[i], reference.place[k - 1], reference.place[k]);
    if (one.distance >= best.distance) continue;
    one.run = run, one.before = k - 1, one.after = k;
    best = one;
  }
  return best;
}

/// The run of the same name first, then the others in their order.
std::vector<std::size_t> candidates(const Experiment& reference, const Run& run) {
  std::vector<std::size_t> all;
  for (std::size_t r = 0; r < reference.runs.size(); ++r)
    if (reference.runs[r].control == run.control) all.push_back(r);
  std::stable_partition(all.begin(), all.end(),
                        [&](std::size_t r) { return reference.runs[r].id == run.id; });
  return all;
}

class Pairing {
 public:
  Pairing(const Study& reference, const Experiment& state)
      : reference_(reference), range_(ranges({&reference.experiment(), &state})) {
    for (const Run& run : reference.experiment().runs) paths_.push_back(path(run, range_));
  }

  /// Replaces the measured values of a run.
  PairedRun relative(Run& run) {
    const Path way = path(run, range_);
    const std::vector<std::size_t> among = candidates(reference_.experiment(), run);
    PairedRun result{run.id, {}, 0, 0, std::nan("")};
    const std::vector<Channel> measured = run.measured();
    std::vector<double> rates;
    std::optional<std::pair<std::size_t, Counterpart>> last;
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      Reading& reading = run.readings[i];
      if (std::ranges::none_of(measured, [&](const Channel& c) { return std::isfinite(c.of(reading)); }))
        continue;
      ++result.of;
      const std::optional<Counterpart> there = counterpart(way, i, among);
      for (const Channel& channel : measured)
        channel.in(reading) -= there ? lack(*there, channel) : std::nan("");
      if (!there) continue;
      ++result.paired;
      if (last && last->second.run == there->run)
        rates.push_back(rate(run, last->first, i, last->second, *there));
      last = {i, *there};
      const std::string& name = reference_.experiment().runs[there->run].id;
      if (std::ranges::find(result.reference, name) == result.reference.end())
        result.reference.push_back(name);
    }
    std::erase_if(rates, [](double one) { return !std::isfinite(one) || one <= 0; });
    if (!rates.empty()) result.rate = median(std::move(rates));
    return result;
  }

 private:
  /// The first run that was there at this command, at a reading that has not counted yet.
  std::optional<Counterpart> counterpart(const Path& way, std::size_t i,
                                         const std::vector<std::size_t>& among) {
    for (const std::size_t r : among) {
      const Counterpart one = nearest(way, i, paths_[r], r);
      if (one.distance > same_command) continue;
      if (used_.emplace(r, one.share < 0.5 ? one.before : one.after).second) return one;
    }
    return std::nullopt;
  }

  /// What the nominal model lacks of the reference.
  [[nodiscard]] double lack(const Counterpart& at, const Channel& channel) const {
    const std::vector<Reading>& readings = reference_.experiment().runs[at.run].readings;
    const Trace& predicted = reference_.nominal().runs[at.run];
    const auto residual = [&](std::size_t k) {
      return channel.of(readings[k]) - predicted(static_cast<Eigen::Index>(k), channel.column);
    };
    if (at.share == 0) return residual(at.before);
    return at.share == 1 ? residual(at.after)
                         : (1 - at.share) * residual(at.before) + at.share * residual(at.after);
  }

  /// Speed between two readings over that between their counterparts; the way is the same.
  [[nodiscard]] double rate(const Run& run, std::size_t from, std::size_t to, const Counterpart& first,
                            const Counterpart& second) const {
    const Run& other = reference_.experiment().runs[first.run];
    if (run.counts_readings() || other.counts_readings()) return std::nan("");
    const auto when = [&](const Counterpart& at) {
      return (1 - at.share) * other.readings[at.before].t + at.share * other.readings[at.after].t;
    };
    return (when(second) - when(first)) / (run.readings[to].t - run.readings[from].t);
  }

  const Study& reference_;
  Ranges range_;
  std::vector<Path> paths_;
  std::set<std::pair<std::size_t, std::size_t>> used_;  ///< run and reading
};

/// Declared noise of a difference. Readings of a decimated run scatter less.
Noise of_difference(const Experiment& state, const Experiment& reference) {
  const auto group = [](const Experiment& one) {
    double least = 1, most = 0;
    for (const Run& run : one.runs)
      least = std::min(least, run.noise_of_group()), most = std::max(most, run.noise_of_group());
    return std::pair(least, most);
  };
  const double ratio = group(reference).second / group(state).first;
  Noise noise = state.noise;
  for (std::size_t i = 0; i < noise.sigma.size(); ++i)
    noise.sigma[i] = std::hypot(noise.sigma[i], ratio * reference.noise.sigma[i]);
  return noise;
}

}  // namespace

void require_one_device(const Experiment& a, const Experiment& b) {
  if (a.link_length == b.link_length && a.joint_stiffness == b.joint_stiffness &&
      a.link_mass == b.link_mass && a.gravity == b.gravity && a.effects == b.effects &&
      (a.arm == nullptr) == (b.arm == nullptr))
    return;
  throw Error("--against", "experiments with different nominal models", "one device, with one nominal model");
}

RelativeReadings relative_to(const Study& reference, const Experiment& state) {
  RelativeReadings result{state, {}};
  static_cast<NominalChain&>(result.experiment) = reference.experiment();
  Pairing pairing(reference, state);
  std::size_t paired = 0;
  for (Run& run : result.experiment.runs) {
    result.runs.push_back(pairing.relative(run));
    paired += result.runs.back().paired;
  }
  constexpr std::size_t fewest = 5;  // as many as a diagnosis needs
  if (paired < fewest)
    throw Error("--against", fmt::format("{} readings at commands that the other state has too", paired),
                fmt::format("at least {}: repeat the runs of one state in the other", fewest));
  std::erase_if(result.experiment.runs, [&](const Run& run) {
    return std::ranges::none_of(run.readings, [&](const Reading& one) {
      return std::ranges::any_of(run.measured(), [&](const Channel& c) { return std::isfinite(c.of(one)); });
    });
  });
  result.experiment.noise = of_difference(state, reference.experiment());
  return result;
}

}  // namespace plumbline::diagnose
