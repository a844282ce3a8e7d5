#include "diagnose/bench/command_range.hpp"

#include <algorithm>

namespace plumbline::diagnose {

std::vector<CommandRange> command_ranges(const Experiment& experiment) {
  std::vector<CommandRange> all(experiment.link_length.size());
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings)
      for (std::size_t j = 0; j < reading.rest.size(); ++j) {
        all[j].low = std::min(all[j].low, reading.rest[j]);
        all[j].high = std::max(all[j].high, reading.rest[j]);
      }
  return all;
}

}  // namespace plumbline::diagnose
