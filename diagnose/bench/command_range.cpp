#include "diagnose/bench/command_range.hpp"

namespace plumbline::diagnose {

std::vector<CommandRange> command_ranges(const Experiment& experiment) {
  std::vector<CommandRange> all(experiment.link_length.size());
  for (const Run& run : experiment.runs)
    for (const Reading& reading : run.readings)
      for (std::size_t j = 0; j < reading.rest.size(); ++j) all[j].add(reading.rest[j]);
  return all;
}

}  // namespace plumbline::diagnose
