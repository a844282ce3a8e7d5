#include "diagnose/design/candidate_poses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "diagnose/bench/command_range.hpp"

namespace plumbline::diagnose {
namespace {

/// Number i of the sequence of van der Corput in a base: evenly spread over 0 to 1.
double spread(std::size_t i, std::size_t base) {
  double value = 0, digit = 1;
  for (; i > 0; i /= base) value += static_cast<double>(i % base) * (digit /= static_cast<double>(base));
  return value;
}

/// Where the joints may be commanded.
std::vector<CommandRange> limits_of(const Experiment& experiment) {
  std::vector<CommandRange> all = command_ranges(experiment);
  for (std::size_t j = 0; j < all.size(); ++j)
    if (const auto [low, high] = experiment.arm->limits[j]; std::isfinite(low) && std::isfinite(high))
      all[j] = {low, high};
  return all;
}

/// The reading with the largest force.
const Reading& heaviest(const Experiment& experiment) {
  const Reading* most = &experiment.runs.front().readings.front();
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings)
      if (reading.wrench_force().norm() > most->wrench_force().norm()) most = &reading;
  return *most;
}

std::string words(const std::vector<double>& pose, const std::vector<double>& wrench) {
  std::string text = fmt::format("the pose ({:.2f})", fmt::join(pose, ", "));
  if (wrench.empty() || std::hypot(wrench[0], wrench[1], wrench[2]) == 0) return text;
  return text + fmt::format(" under the force ({:.3g}, {:.3g}, {:.3g}) N", wrench[0], wrench[1], wrench[2]);
}

}  // namespace

std::vector<CandidateRun> candidate_poses(const Experiment& experiment) {
  constexpr std::size_t poses = 60;
  constexpr std::array<std::size_t, 8> primes{2, 3, 5, 7, 11, 13, 17, 19};
  const Reading& loaded = heaviest(experiment);
  const std::vector<CommandRange> limits = limits_of(experiment);
  std::vector<CandidateRun> all;
  for (std::size_t i = 1; i <= poses; ++i) {
    Run run = experiment.runs.front();
    run.readings.resize(1);
    Reading& reading = run.readings.front();
    for (std::size_t j = 0; j < reading.rest.size(); ++j) {
      constexpr double inside = 0.9;  // of the range: nobody drives to the very limit
      const double share = 0.5 + inside * (spread(i, primes[j % primes.size()]) - 0.5);
      reading.rest[j] = std::round(100 * limits[j].at(share)) / 100;
    }
    run.rest = reading.rest;
    std::vector<std::vector<double>> wrenches{std::vector<double>(reading.wrench.size(), 0.0)};
    if (loaded.wrench != wrenches.front()) wrenches.push_back(loaded.wrench);
    for (const std::vector<double>& wrench : wrenches) {
      reading.wrench = wrench;
      all.push_back({words(reading.rest, wrench), run});
    }
  }
  return all;
}

}  // namespace plumbline::diagnose
