#include "diagnose/bench/thin_poses.hpp"

#include <limits>

namespace plumbline::diagnose {
namespace {

constexpr std::size_t short_enough_of_poses = 1200, wanted_poses = 800, block_of_poses = 20;

void forget_measured(const std::vector<Channel>& measured, Reading& reading) {
  for (const Channel& channel : measured) channel.in(reading) = std::numeric_limits<double>::quiet_NaN();
}

/// Keeps one block of `every`.
void thin(Run& run, std::size_t every) {
  const std::vector<Channel> measured = run.measured();
  std::vector<Reading> kept;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    if ((i / block_of_poses) % every != 0) continue;
    kept.push_back(std::move(run.readings[i]));
    number.push_back(i);
    if (i > 0 && i % block_of_poses == 0) forget_measured(measured, kept.back());
  }
  number.push_back(run.readings.size());
  run.readings = std::move(kept);
  run.groups.first = std::move(number);
}

}  // namespace

Experiment thinned(Experiment experiment) {
  std::size_t total = 0;
  for (const Run& run : experiment.runs) total += run.readings.size();
  if (total <= short_enough_of_poses) return experiment;
  const std::size_t every = (total + wanted_poses - 1) / wanted_poses;
  for (Run& run : experiment.runs) thin(run, every);
  return experiment;
}

}  // namespace plumbline::diagnose
