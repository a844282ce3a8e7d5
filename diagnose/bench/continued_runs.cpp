#include "diagnose/bench/continued_runs.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/chain/kinematics.hpp>

namespace plumbline::diagnose {
namespace {

/// A gap of as many usual steps is none.
constexpr double steps_apart = 2;

/// The command of the unloaded chain.
Eigen::Vector2d unloaded(const Experiment& experiment, const Run& run) {
  if (!run.holds_end_point()) return {0, 0};
  const Chain<double> chain(experiment.link_length, std::vector<double>(experiment.link_length.size(), 1.0));
  const Point<double> end = end_point(chain, run.rest);
  return {end.x, end.y};
}

/// The longest way between successive readings.
double longest_step(const Run& run) {
  double longest = 0;
  for (std::size_t i = 1; i < run.readings.size(); ++i)
    longest = std::max(longest, (run.command(run.readings[i]) - run.command(run.readings[i - 1])).norm());
  return longest;
}

bool goes_on(const Experiment& experiment, const Run& before, const Run& run) {
  if (before.readings.size() < 2 || run.readings.empty() || run.commands_joints()) return false;
  if (run.control != before.control || run.rest != before.rest || run.begins_moving ||
      run.by_weights != before.by_weights || before.commands_joints() ||
      run.reads_angles() != before.reads_angles())
    return false;
  const Reading &last = before.readings.back(), &first = run.readings.front();
  const double pause = first.t - last.t, step = steps_apart * longest_step(before);
  return pause > 0 && pause <= steps_apart * before.sampling_interval() &&
         (run.command(first) - run.command(last)).norm() <= step &&
         (run.command(first) - unloaded(experiment, run)).norm() > step;
}

}  // namespace

void join_continued(Experiment& experiment) {
  std::vector<Run> joined;
  for (Run& run : experiment.runs) {
    if (joined.empty() || !goes_on(experiment, joined.back(), run)) {
      joined.push_back(std::move(run));
      continue;
    }
    Run& whole = joined.back();
    whole.readings.insert(whole.readings.end(), run.readings.begin(), run.readings.end());
    whole.continued_by.push_back(run.id);
    for (std::size_t c = 0; c < whole.interpolated.size(); ++c) whole.interpolated[c] += run.interpolated[c];
  }
  experiment.runs = std::move(joined);
}

}  // namespace plumbline::diagnose
