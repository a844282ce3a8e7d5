#pragma once
/// \file
/// Times of several ways to compute the same thing, taken in turn in one process.

#include <algorithm>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace plumbline::bench {

/// Processor time of this process, which other load on the machine does not inflate; all threads count.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Somebody in a race: a name, what is to be done, and what the race found.
struct Runner {
  std::string name;
  std::function<std::vector<double>()> run;  ///< returns the critical forces that it found, ascending
  double seconds = 0;                        ///< median
  double ratio = 1;                          ///< median of its time over the first runner's in the same round
  std::vector<double> result = {};
};

/// Mean time of enough calls to be measured.
inline double time_once(const std::function<std::vector<double>()>& run, std::size_t calls) {
  const double start = processor_seconds();
  for (std::size_t call = 0; call < calls; ++call) static_cast<void>(run());
  return (processor_seconds() - start) / static_cast<double>(calls);
}

/// Rounds in which each runs in turn for a millisecond or one call, as many as fit into about `budget`
/// seconds, three at least; a runner that takes longer than a second runs once.
inline void race(std::vector<Runner>& runners, double budget) {
  std::vector<std::size_t> calls;
  std::vector<std::vector<double>> times(runners.size()), ratios(runners.size());
  double round = 0;
  for (Runner& runner : runners) {
    const double start = processor_seconds();
    runner.result = runner.run();
    const double first = std::max(processor_seconds() - start, 1e-8);
    times[calls.size()].push_back(first);
    const double warm = first > 1 ? first : std::max(time_once(runner.run, 1), 1e-8);
    calls.push_back(first > 1 ? 0 : static_cast<std::size_t>(std::clamp(1e-3 / warm, 1.0, 1e5)));
    round += static_cast<double>(calls.back()) * warm;
  }
  const auto rounds = static_cast<std::size_t>(std::clamp(budget / round, 3.0, 200.0));
  for (std::size_t r = 0; r < rounds; ++r) {
    for (std::size_t i = 0; i < runners.size(); ++i) {
      if (calls[i] == 0) continue;
      if (r == 0) times[i].clear();  // the first call was the warm-up
      times[i].push_back(time_once(runners[i].run, calls[i]));
      ratios[i].push_back(times[i].back() / times[0].back());
    }
  }
  for (std::size_t i = 0; i < runners.size(); ++i) {
    runners[i].seconds = median(times[i]);
    runners[i].ratio = ratios[i].empty() ? runners[i].seconds / median(times[0]) : median(ratios[i]);
  }
}

}  // namespace plumbline::bench
