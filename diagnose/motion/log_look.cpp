#include "diagnose/motion/log_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

namespace plumbline::motion {
namespace {

constexpr std::size_t fewest_readings = 40;

double quantile(std::vector<double>& values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

bool is_saturated(const MotionLog& log, std::size_t k) {
  return log.powered[k] && log.gain * std::abs(log.command[k] - log.position[k]) >= 1;
}

double range_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

}  // namespace

void mend_spikes(MotionLog& log, double sigma) {
  // So far beside a straight line of neighbours that neither noise nor motion gets there and back.
  constexpr double in_sigmas = 25, beside_motion = 5;
  const std::vector<double>& q = log.position;
  for (std::size_t k = 1; k + 1 < q.size(); ++k) {
    const double between = (q[k - 1] + q[k + 1]) / 2, away = std::abs(q[k] - between);
    // Where a fast motion turns, the neighbours agree, and move as far before and after.
    double moved = std::abs(q[k + 1] - q[k - 1]);
    if (k > 1) moved = std::max(moved, std::abs(q[k - 1] - q[k - 2]));
    if (k + 2 < q.size()) moved = std::max(moved, std::abs(q[k + 2] - q[k + 1]));
    if (away < in_sigmas * sigma || away < beside_motion * moved) continue;
    log.position[k] = between;
    ++log.spikes;
  }
}

LogsLook look_at(const std::vector<MotionLog>& logs) {
  LogsLook look;
  look.logs = logs.size();
  std::vector<double> steps;
  double saturated = 0, powered = 0;
  look.quantum = std::numeric_limits<double>::infinity();
  for (const MotionLog& log : logs) {
    look.readings += log.time.size();
    look.spikes += log.spikes;
    for (std::size_t k = 0; k < log.time.size(); ++k) {
      powered += log.powered[k], saturated += is_saturated(log, k);
      if (k == 0) continue;
      steps.push_back(log.time[k] - log.time[k - 1]);
      // Rounding of noise that no encoder has rounded is no quantum.
      if (const double change = std::abs(log.position[k] - log.position[k - 1]); change > 1e-5)
        look.quantum = std::min(look.quantum, change);
    }
  }
  if (!std::isfinite(look.quantum)) look.quantum = 0;
  look.step = quantile(steps, 0.5), look.step_low = quantile(steps, 0.01),
  look.step_high = quantile(steps, 0.99);
  look.saturated = powered > 0 ? saturated / powered : 0;
  look.off = 1 - powered / static_cast<double>(look.readings);
  return look;
}

void require_judgeable(const MotionLog& log) {
  const std::size_t n = log.time.size();
  if (n < fewest_readings)
    throw Error(log.name, fmt::format("{} readings", n), fmt::format("{} at least", fewest_readings));
  for (std::size_t k = 1; k < n; ++k)
    if (!(log.time[k] > log.time[k - 1]))
      throw Error(fmt::format("{}, reading {}", log.name, k + 1),
                  fmt::format("a clock that goes from {:g} to {:g} s", log.time[k - 1], log.time[k]),
                  "time that goes forward");
  if (range_of(log.position) == 0)
    throw Error(log.name, "a position that never changes",
                "a joint in motion; resting benches are diagnosed by their loads");
  std::size_t saturated = 0;
  for (std::size_t k = 0; k < n; ++k) saturated += is_saturated(log, k);
  if (saturated == n)
    throw Error(log.name, "a drive that is saturated all along",
                "commands in the unit of the position, and a gain in duty per rad");
}

}  // namespace plumbline::motion
