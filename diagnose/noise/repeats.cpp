#include "diagnose/noise/repeats.hpp"

#include <algorithm>
#include <map>

namespace plumbline::diagnose {
namespace {

/// The two ends of the way that a run goes: where it begins, and where it is farthest from there.
struct Way {
  Eigen::Vector2d begin, farthest;
  double reach = 0;
};

Way way_of(const Run& run) {
  Way way;
  way.begin = way.farthest = run.command(run.readings.front());
  for (const Reading& reading : run.readings) {
    const Eigen::Vector2d command = run.command(reading);
    if (const double off = (command - way.begin).norm(); off > way.reach) {
      way.reach = off;
      way.farthest = command;
    }
  }
  return way;
}

/// Whether they go between the same ends, whichever they begin at.
bool go_the_same_way(const Run& a, const Way& one, const Run& b, const Way& other) {
  constexpr double close = 0.05;  // of how far they go
  if (a.control != b.control || a.rest != b.rest) return false;
  const auto near = [&](const Eigen::Vector2d& end, const Eigen::Vector2d& as) {
    return (end - as).norm() <= close * one.reach;
  };
  return (near(one.begin, other.begin) && near(one.farthest, other.farthest)) ||
         (near(one.begin, other.farthest) && near(one.farthest, other.begin));
}

/// What was read in some runs of one channel.
Repeats together(const Experiment& experiment, const std::vector<const Series*>& group) {
  Repeats all{group.front()->channel, {}, {}};
  Run way = experiment.runs[group.front()->run];
  way.readings.clear();
  std::vector<std::size_t> readings;
  for (const Series* series : group) {
    const std::vector<Reading>& own = experiment.runs[series->run].readings;
    for (std::size_t i = 0; i < series->readings.size(); ++i) {
      all.values.push_back(series->first + i);
      readings.push_back(way.readings.size() + series->readings[i]);
    }
    way.readings.insert(way.readings.end(), own.begin(), own.end());
  }
  all.between = between(way, readings);
  return all;
}

}  // namespace

std::vector<Repeats> repeats(const Experiment& experiment, const std::vector<Series>& series) {
  std::vector<const Series*> left;
  for (const Series& one : series) left.push_back(&one);
  // Of readings at the same place those of one run stand first: not by the order in which runs are listed.
  std::sort(left.begin(), left.end(), [](const Series* a, const Series* b) { return a->seed < b->seed; });
  // A run that was copied is no second one.
  const auto copied = [](const Series* a, const Series* b) { return a->seed == b->seed; };
  left.erase(std::unique(left.begin(), left.end(), copied), left.end());
  std::map<std::size_t, Way> ways;  // by run
  for (const Series& one : series)
    if (!ways.contains(one.run)) ways[one.run] = way_of(experiment.runs[one.run]);
  const auto repeat = [&](const Series& one, const Series& other) {
    return one.channel == other.channel && go_the_same_way(experiment.runs[one.run], ways[one.run],
                                                           experiment.runs[other.run], ways[other.run]);
  };
  std::vector<Repeats> all;
  while (!left.empty()) {
    const Series& first = *left.front();
    const auto others = std::stable_partition(
        left.begin(), left.end(), [&](const Series* one) { return one == &first || repeat(first, *one); });
    const std::vector<const Series*> group(left.begin(), others);
    left.erase(left.begin(), others);
    if (group.size() > 1) all.push_back(together(experiment, group));
  }
  return all;
}

}  // namespace plumbline::diagnose
