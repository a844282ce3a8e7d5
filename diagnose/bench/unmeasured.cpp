#include "diagnose/bench/unmeasured.hpp"

#include <limits>

namespace plumbline::diagnose {

Experiment unmeasured(Experiment experiment) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> angles(experiment.noise.q > 0 ? experiment.link_length.size() : 0, nothing);
  for (Run& run : experiment.runs) {
    for (Reading& reading : run.readings) reading.q = angles;
    for (const Channel& channel : run.measured())
      for (Reading& reading : run.readings) channel.in(reading) = nothing;
  }
  return experiment;
}

}  // namespace plumbline::diagnose
