#include "diagnose/motion/phases.hpp"

#include <cmath>

namespace plumbline::motion {
namespace {

/// Speeds below this share of the root mean square are rest.
constexpr double slow = 0.1;

Phase phase_at(const MotionLog& log, std::size_t reading, double typical_speed) {
  if (!log.powered[reading]) return Phase::unpowered;
  const InitialState state = initial_state(log, reading);
  if (std::abs(state.v) < slow * typical_speed) return Phase::at_rest;
  return state.v * state.a > 0 ? Phase::speeding_up : Phase::slowing_down;
}

}  // namespace

std::vector<PhaseError> errors_by_phase(const std::vector<MotionLog>& logs, const Drive<double>& before,
                                        const Drive<double>& after) {
  std::array<PhaseError, static_cast<std::size_t>(Phase::count)> sums{};
  const double typical_speed = Sizes(logs).speed;
  double all = 0;
  for (const MotionLog& log : logs) {
    const std::vector<double> a = predicted(before, log), b = predicted(after, log);
    for (std::size_t k = 0; k < log.time.size(); ++k, ++all) {
      PhaseError& sum = sums[static_cast<std::size_t>(phase_at(log, k, typical_speed))];
      sum.before += std::abs(a[k] - log.position[k]);
      sum.after += std::abs(b[k] - log.position[k]);
      ++sum.readings;
    }
  }
  std::vector<PhaseError> found;
  for (std::size_t p = 0; p < sums.size(); ++p)
    if (const double n = sums[p].readings; n > 0)
      found.push_back({static_cast<Phase>(p), n / all, sums[p].before / n, sums[p].after / n});
  return found;
}

}  // namespace plumbline::motion
