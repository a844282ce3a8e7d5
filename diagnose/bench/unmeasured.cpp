#include "diagnose/bench/unmeasured.hpp"

#include <limits>

namespace plumbline::diagnose {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A finite orientation, here that of the nominal arm, says that it is read.
Experiment unmeasured_arm(Experiment experiment) {
  const Noise& noise = experiment.noise;
  const std::size_t joints = experiment.arm->arm.size(), points = experiment.arm_bench.points.size();
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) {
      reading.q.assign(noise.q > 0 ? joints : 0, nothing);
      reading.torque.assign(noise.torque > 0 ? joints : 0, nothing);
      reading.points.clear();
      for (std::size_t p = 0; p < points; ++p) {
        reading.points.insert(reading.points.end(), 3, nothing);
        reading.points.insert(reading.points.end(), 3, noise.turn > 0 ? 0.0 : nothing);
      }
    }
  return experiment;
}

}  // namespace

Experiment unmeasured(Experiment experiment) {
  if (experiment.arm) return unmeasured_arm(std::move(experiment));
  const std::vector<double> angles(experiment.noise.q > 0 ? experiment.link_length.size() : 0, nothing);
  for (Run& run : experiment.runs) {
    for (Reading& reading : run.readings) reading.q = angles;
    for (const Channel& channel : run.measured())
      for (Reading& reading : run.readings) channel.in(reading) = nothing;
    // A finite value says that it is read.
    for (Reading& reading : run.readings)
      reading.second_load = {experiment.noise.Fx_2 > 0 ? 0.0 : nothing,
                             experiment.noise.Fy_2 > 0 ? 0.0 : nothing};
  }
  return experiment;
}

}  // namespace plumbline::diagnose
