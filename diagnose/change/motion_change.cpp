#include "diagnose/change/motion_change.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/change/paired_states.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

using motion::MotionLog;

/// A state as it is diagnosed relative to the other one.
struct MotionSide {
  RelativeLogs relative;
  motion::Diagnosis diagnosis;
  /// Probability of the first cause that is named.
  [[nodiscard]] double explained() const {
    return diagnosis.causes.empty() ? 0 : diagnosis.causes.front().probability;
  }
};

double duration(const MotionLog& log) {
  return log.time.back() - log.time.front();
}

/// A signal of a log at a time since its begin, between its readings.
double at(const MotionLog& log, const std::vector<double>& signal, double since) {
  const double t = log.time.front() + since;
  const auto next = std::upper_bound(log.time.begin(), log.time.end(), t);
  if (next == log.time.begin()) return signal.front();
  if (next == log.time.end()) return signal.back();
  const auto k = static_cast<std::size_t>(next - log.time.begin());
  const double share = (t - log.time[k - 1]) / (log.time[k] - log.time[k - 1]);
  return (1 - share) * signal[k - 1] + share * signal[k];
}

/// Root mean square of the difference of two commands, over the range of the first.
/// \param offset  of the clock of the first against that of the second
double difference_of_commands(const MotionLog& one, const MotionLog& other, double offset) {
  constexpr int places = 200;
  const double whole = std::min(duration(one), duration(other) - offset), from = std::max(0.0, -offset);
  const auto [low, high] = std::minmax_element(one.command.begin(), one.command.end());
  double squares = 0;
  for (int k = 0; k < places; ++k) {
    const double since = from + (whole - from) * k / (places - 1);
    const double off = at(one, one.command, since) - at(other, other.command, since + offset);
    squares += off * off / places;
  }
  return *high > *low ? std::sqrt(squares) / (*high - *low) : std::sqrt(squares);
}

struct Counterlog {
  const MotionLog* log = nullptr;
  double offset = 0, difference = 0;
};

/// The log of the reference that took the same commands as nearly as any.
Counterlog counterpart_of(const MotionLog& log, const std::vector<MotionLog>& reference) {
  constexpr double farthest = 0.1;  // share of the duration by which clocks may be apart
  constexpr int offsets = 20;       // to either side
  Counterlog best;
  for (const MotionLog& other : reference) {
    if (other.gain != log.gain) continue;
    for (int k = -offsets; k <= offsets; ++k) {
      const double offset = farthest * duration(log) * k / offsets;
      const double difference = difference_of_commands(log, other, offset);
      const bool nearer = best.log == nullptr || difference < best.difference ||
                          (difference == best.difference && std::abs(offset) < std::abs(best.offset));
      if (nearer) best = {&other, offset, difference};
    }
  }
  return best.log != nullptr && best.difference <= priors::same_command ? best : Counterlog{};
}

/// Positions of a log, less what the model lacks of its counterpart.
/// \param predicted  the positions of the counterpart by the model
MotionLog relative_log(const MotionLog& log, const Counterlog& there, const std::vector<double>& predicted) {
  const MotionLog& other = *there.log;
  std::vector<double> lack = other.position;
  for (std::size_t k = 0; k < lack.size(); ++k) lack[k] -= predicted[k];
  MotionLog relative = log;
  relative.beside.clear();  // what the model lacks of a channel is not known as well as of positions
  for (std::size_t k = 0; k < log.time.size(); ++k)
    relative.position[k] -= at(other, lack, log.time[k] - log.time.front() + there.offset);
  return relative;
}

/// The mean step of the clock, s.
double step_of(const motion::Bench& bench) {
  double whole = 0, steps = 0;
  for (const MotionLog& log : bench.logs)
    whole += duration(log), steps += static_cast<double>(log.time.size() - 1);
  return whole / steps;
}

MotionSide motion_side(const motion::Bench& reference, const motion::Bench& state,
                       const std::function<std::function<void(double)>(int part)>& progress, int part) {
  const motion::Diagnosis alone = diagnose_motion(motion::Study(reference), progress(part));
  RelativeLogs relative = relative_to(reference, alone.drive, alone.spread, state);
  motion::Diagnosis diagnosis = diagnose_motion(motion::Study(relative.bench), progress(part + 1));
  return {std::move(relative), std::move(diagnosis)};
}

bool same_first_cause(const motion::Diagnosis& one, const motion::Diagnosis& other) {
  if (one.causes.empty() || other.causes.empty()) return false;
  const auto ids = [](const motion::NamedCause& cause) {
    std::vector<std::string> all;
    for (const motion::NamedEffect& effect : cause.effects) all.push_back(effect.id);
    std::sort(all.begin(), all.end());
    return all;
  };
  return ids(one.causes.front()) == ids(other.causes.front());
}

}  // namespace

RelativeLogs relative_to(const motion::Bench& reference, const motion::Drive<double>& drive, double spread,
                         const motion::Bench& state) {
  RelativeLogs result{state, {}, false};
  result.bench.name = state.name + " against " + reference.name;
  result.bench.nominal = drive;
  result.bench.unknown.clear();
  result.bench.held_out.clear();
  std::vector<MotionLog> paired;
  for (const MotionLog& log : state.logs) {
    const Counterlog there = counterpart_of(log, reference.logs);
    result.logs.push_back({log.name, there.log ? there.log->name : "", there.offset});
    if (there.log) paired.push_back(relative_log(log, there, motion::predicted(drive, *there.log)));
  }
  result.cancels = !paired.empty();
  if (result.cancels) {
    result.bench.logs = std::move(paired);
    result.bench.sigma = std::hypot(state.sigma, reference.sigma);
  } else {
    // The lack is as good as constant over the readings of a mean, which average noise alone.
    const double readings = std::max(1.0, motion::mean_duration / step_of(state));
    result.bench.sigma = std::hypot(state.sigma, spread * std::sqrt(readings));
  }
  return result;
}

MotionChange what_changed(const motion::Bench& before, const motion::Bench& after,
                          const std::function<void(double)>& progress) {
  const auto quarter = [&](int part) -> std::function<void(double)> {
    return [&progress, part](double share) {
      if (progress) progress((part + share) / 4);
    };
  };
  MotionSide added = motion_side(before, after, quarter, 0), removed = motion_side(after, before, quarter, 2);
  const Sense sense = same_first_cause(added.diagnosis, removed.diagnosis) ? Sense::either
                      : added.explained() >= removed.explained()           ? Sense::added
                                                                           : Sense::removed;
  MotionSide& best = sense == Sense::removed ? removed : added;
  return {before.name, after.name, sense, std::move(best.diagnosis), std::move(best.relative)};
}

Check check(const MotionChange& change) {
  return check_of(change.diagnosis.seen_gap);
}

}  // namespace plumbline::diagnose
