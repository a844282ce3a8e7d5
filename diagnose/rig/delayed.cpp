#include "diagnose/rig/delayed.hpp"

#include <algorithm>

namespace plumbline::diagnose {
namespace {

/// What is commanded at a time before that of some reading.
Reading commanded_at(double t, const Reading& before, const Reading& after) {
  const double way = after.t - before.t;
  return way > 0 ? between(before, after, std::clamp((t - before.t) / way, 0.0, 1.0)) : after;
}

}  // namespace

std::vector<Reading> delayed(const Run& run, double delay) {
  std::vector<Reading> all = run.readings;
  const Reading start = run.before_first().value_or(run.readings.empty() ? Reading{} : run.readings.front());
  std::vector<const Reading*> known{&start};
  for (const Reading& one : run.readings)
    if (run.command(one).allFinite()) known.push_back(&one);
  std::size_t next = 1;  // of those known, the first that is not before the delayed time
  for (Reading& one : all) {
    const double t = one.t - delay;
    while (next + 1 < known.size() && known[next]->t < t) ++next;
    if (next >= known.size()) break;
    const Reading then = commanded_at(t, *known[next - 1], *known[next]);
    one.rest = then.rest;
    if (run.holds_end_point() || !run.by_weights)
      for (const Channel& channel : run.imposed()) channel.in(one) = channel.of(then);
  }
  return all;
}

LedCommand::LedCommand(const Run& run, double delay)
    : behind_(delay > 0 ? delayed(run, delay) : std::vector<Reading>{}) {}

const Reading& LedCommand::at(const Stop& stop) {
  if (behind_.empty() || !stop.to) return stop.reading;
  if (!stop.from || stop.share == 1) return behind_[*stop.to];
  on_the_way_ = between(behind_[*stop.from], behind_[*stop.to], stop.share);
  return on_the_way_;
}

}  // namespace plumbline::diagnose
