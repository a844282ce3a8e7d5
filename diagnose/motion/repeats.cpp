#include "diagnose/motion/repeats.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::motion {
namespace {

/// A course of a log at a time since its begin, on straight lines between readings.
double value_at(const MotionLog& log, const std::vector<double>& course, double since) {
  const double t = log.time.front() + since;
  const auto after = std::upper_bound(log.time.begin() + 1, log.time.end() - 1, t);
  const auto k = static_cast<std::size_t>(after - log.time.begin());
  const double share = (t - log.time[k - 1]) / (log.time[k] - log.time[k - 1]);
  return course[k - 1] + share * (course[k] - course[k - 1]);
}

/// Mean |difference| of a course over the time that both logs have.
double apart(const MotionLog& a, const MotionLog& b, std::vector<double> MotionLog::*course) {
  const double both = std::min(a.time.back() - a.time.front(), b.time.back() - b.time.front());
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < a.time.size() && a.time[k] - a.time.front() <= both; ++k, ++count)
    sum += std::abs((a.*course)[k] - value_at(b, b.*course, a.time[k] - a.time.front()));
  return sum / count;
}

bool are_alike(const MotionLog& a, const MotionLog& b) {
  const double longer = std::max(a.time.back() - a.time.front(), b.time.back() - b.time.front()),
               shorter = std::min(a.time.back() - a.time.front(), b.time.back() - b.time.front());
  if (a.gain != b.gain || a.inertia != b.inertia || a.gravity != b.gravity || shorter < 0.9 * longer)
    return false;
  // Stamps of two runs differ by parts of a step, and commands with them.
  const auto [low, high] = std::minmax_element(a.command.begin(), a.command.end());
  return apart(a, b, &MotionLog::command) < 0.02 * (*high - *low);
}

}  // namespace

std::optional<double> repeatability(const std::vector<const MotionLog*>& logs) {
  double sum = 0, pairs = 0;
  for (std::size_t i = 0; i < logs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (are_alike(*logs[i], *logs[j])) sum += apart(*logs[i], *logs[j], &MotionLog::position), ++pairs;
  if (pairs == 0) return std::nullopt;
  return sum / pairs;
}

}  // namespace plumbline::motion
