#include "diagnose/bench/unmeasured.hpp"

#include <limits>

namespace plumbline::diagnose {

Experiment unmeasured(Experiment experiment) {
  for (Run& run : experiment.runs) {
    run.planned = run.measurable();
    for (const Channel& channel : run.planned)
      for (Reading& reading : run.readings) channel.in(reading) = std::numeric_limits<double>::quiet_NaN();
    std::erase_if(run.planned, [&](const Channel& one) { return !(one.sigma(experiment.noise) > 0); });
  }
  return experiment;
}

}  // namespace plumbline::diagnose
