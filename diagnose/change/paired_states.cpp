#include "diagnose/change/paired_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/bench/median.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// A step of the command by more than this share of its range leads to a place of its own, not along a path.
constexpr double longest_step = 0.25;

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

/// Jitter within what counts as one command is no turning point.
Path path(const Run& run, const Ranges& range) {
  Path one;
  VectorXd corner, direction;
  std::size_t sweep = 0;
  for (const Reading& reading : run.readings) {
    const VectorXd& place = one.place.emplace_back(imposed(run, reading).cwiseQuotient(range));
    if (corner.size() == 0) corner = place;
    if (const VectorXd step = place - corner; step.norm() > priors::same_command) {
      sweep += direction.size() > 0 && step.dot(direction) < 0 ? 1 : 0;
      corner = place, direction = step;
    }
    one.sweep.push_back(sweep);
  }
  return one;
}

/// A place between two readings of a run of the reference.
struct Counterpart {
  std::size_t before, after;
  double share;     ///< of the way from the one to the other
  double distance;  ///< from it, over the ranges of the commands
};

/// Where a place lies between two neighbours.
Counterpart projected(const VectorXd& place, const VectorXd& from, const VectorXd& to) {
  const VectorXd way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((place - from).dot(way) / length, 0.0, 1.0) : 0;
  return {0, 0, share, (place - from - share * way).norm()};
}

/// The nearest place of a run on a sweep, or on any.
Counterpart nearest(const VectorXd& place, const Path& reference, std::optional<std::size_t> sweep) {
  Counterpart best{0, 0, 0, std::numeric_limits<double>::infinity()};
  const auto is_there = [&](std::size_t k) { return !sweep || reference.sweep[k] == *sweep; };
  for (std::size_t k = 0; k < reference.place.size(); ++k) {
    if (!is_there(k)) continue;
    if (const double here = (place - reference.place[k]).norm(); here < best.distance) best = {k, k, 0, here};
    if (!sweep || k == 0 || !is_there(k - 1)) continue;
    Counterpart one = projected(place, reference.place[k - 1], reference.place[k]);
    if (one.distance >= best.distance) continue;
    one.before = k - 1, one.after = k;
    best = one;
  }
  return best;
}

/// On the same sweep; or, of a place of its own, however it was reached.
Counterpart counterpart(const Path& state, std::size_t i, const Path& reference) {
  const Counterpart best = nearest(state.place[i], reference, state.sweep[i]);
  const bool own_place = i == 0 || (state.place[i] - state.place[i - 1]).norm() > longest_step;
  return best.distance > priors::same_command && own_place ? nearest(state.place[i], reference, {}) : best;
}

bool is_read(const Reading& reading, const std::vector<Channel>& measured) {
  return std::ranges::any_of(measured, [&](const Channel& c) { return std::isfinite(c.of(reading)); });
}

class Pairing {
 public:
  Pairing(const Study& reference, const Experiment& state)
      : reference_(reference), range_(ranges({&reference.experiment(), &state})) {
    for (const Run& run : reference.experiment().runs) paths_.push_back(path(run, range_));
  }

  /// Replaces the measured values of runs, each by those of one run of the reference: that of its name, or
  /// else the one left that was at the most of its commands.
  std::vector<PairedRun> relative(std::vector<Run>& runs) {
    std::vector<std::optional<std::size_t>> partner;
    for (const Run& run : runs) partner.push_back(namesake(run));
    for (const auto& one : partner)
      if (one) taken_.insert(*one);
    std::vector<PairedRun> result;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (!partner[r]) partner[r] = likeliest(runs[r]);
      if (partner[r]) taken_.insert(*partner[r]);
      result.push_back(relative(runs[r], partner[r]));
    }
    return result;
  }

 private:
  using Counterparts = std::vector<std::optional<Counterpart>>;

  [[nodiscard]] std::optional<std::size_t> namesake(const Run& run) const {
    const std::vector<Run>& all = reference_.experiment().runs;
    for (std::size_t r = 0; r < all.size(); ++r)
      if (all[r].id == run.id && all[r].control == run.control) return r;
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::size_t> likeliest(const Run& run) const {
    const std::vector<Run>& all = reference_.experiment().runs;
    std::optional<std::size_t> best;
    std::ptrdiff_t most = 0;
    for (std::size_t r = 0; r < all.size(); ++r) {
      if (all[r].control != run.control || taken_.contains(r)) continue;
      const Counterparts there = counterparts(run, r);
      const std::ptrdiff_t count =
          std::ranges::count_if(there, [](const auto& one) { return one.has_value(); });
      if (count > most) most = count, best = r;
    }
    return best;
  }

  /// By reading with measured values: where the reference was at its command. A reading of the reference
  /// counts once.
  [[nodiscard]] Counterparts counterparts(const Run& run, std::size_t reference) const {
    const Path way = path(run, range_);
    const std::vector<Channel> measured = run.measured();
    std::set<std::size_t> used;
    Counterparts all(run.readings.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!is_read(run.readings[i], measured)) continue;
      const Counterpart one = counterpart(way, i, paths_[reference]);
      if (one.distance <= priors::same_command &&
          used.insert(one.share < 0.5 ? one.before : one.after).second)
        all[i] = one;
    }
    return all;
  }

  PairedRun relative(Run& run, std::optional<std::size_t> reference) const {
    const std::vector<Channel> measured = run.measured();
    const Counterparts there = reference ? counterparts(run, *reference) : Counterparts(run.readings.size());
    PairedRun result{run.id, reference ? reference_.experiment().runs[*reference].id : "", 0, 0,
                     std::nan("")};
    std::vector<double> rates;
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      if (!is_read(run.readings[i], measured)) continue;
      ++result.of;
      for (const Channel& channel : measured)
        channel.in(run.readings[i]) -= there[i] ? lack(*reference, *there[i], channel) : std::nan("");
      if (!there[i]) continue;
      ++result.paired;
      if (last)
        rates.push_back(
            rate(run, reference_.experiment().runs[*reference], {*last, i}, {*there[*last], *there[i]}));
      last = i;
    }
    std::erase_if(rates, [](double one) { return !std::isfinite(one) || one <= 0; });
    if (!rates.empty()) result.rate = median(std::move(rates));
    return result;
  }

  /// What the nominal model lacks of the reference.
  [[nodiscard]] double lack(std::size_t run, const Counterpart& at, const Channel& channel) const {
    const std::vector<Reading>& readings = reference_.experiment().runs[run].readings;
    const Trace& predicted = reference_.nominal().runs[run];
    const auto residual = [&](std::size_t k) {
      return channel.of(readings[k]) - predicted(static_cast<Eigen::Index>(k), channel.column);
    };
    if (at.share == 0) return residual(at.before);
    return at.share == 1 ? residual(at.after)
                         : (1 - at.share) * residual(at.before) + at.share * residual(at.after);
  }

  /// Speed between two readings over that between their counterparts; the way is the same.
  [[nodiscard]] static double rate(const Run& run, const Run& other,
                                   std::pair<std::size_t, std::size_t> readings,
                                   const std::pair<Counterpart, Counterpart>& there) {
    if (run.counts_readings() || other.counts_readings()) return std::nan("");
    const auto when = [&](const Counterpart& at) {
      return (1 - at.share) * other.readings[at.before].t + at.share * other.readings[at.after].t;
    };
    return (when(there.second) - when(there.first)) /
           (run.readings[readings.second].t - run.readings[readings.first].t);
  }

  const Study& reference_;
  Ranges range_;
  std::vector<Path> paths_;
  std::set<std::size_t> taken_;  ///< runs of the reference
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
  std::vector<Run>& runs = result.experiment.runs;
  result.runs = Pairing(reference, state).relative(runs);
  std::size_t paired = 0;
  for (const PairedRun& run : result.runs) paired += run.paired;
  constexpr std::size_t fewest = 5;  // as many as a diagnosis needs
  if (paired < fewest)
    throw Error("--against", fmt::format("{} readings at commands that the other state has too", paired),
                fmt::format("at least {}: repeat the runs of one state in the other", fewest));
  std::erase_if(runs, [](const Run& run) {
    const std::vector<Channel> measured = run.measured();
    return std::ranges::none_of(run.readings, [&](const Reading& one) { return is_read(one, measured); });
  });
  result.experiment.noise = of_difference(state, reference.experiment());
  return result;
}

}  // namespace plumbline::diagnose
