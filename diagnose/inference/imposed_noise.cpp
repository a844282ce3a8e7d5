#include "diagnose/inference/imposed_noise.hpp"

#include <algorithm>
#include <functional>

#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

double sigma_of_imposed(const Experiment& experiment, const Run& run, const Channel& channel) {
  const bool commanded = run.commands_joints();
  if (run.alone != Alone::no) return commanded ? 0 : channel.sigma(experiment.noise);
  return channel.sigma(run.imposed_noise);
}

/// Moves one imposed number of every reading of a run by its standard deviation.
using Shift = std::function<void(const Experiment&, Run&)>;

Shift of_channel(std::size_t number) {
  return [number](const Experiment& experiment, Run& run) {
    const std::vector<Channel> imposed = run.imposed();
    if (number >= imposed.size()) return;
    const double by = sigma_of_imposed(experiment, run, imposed[number]);
    for (Reading& reading : run.readings) imposed[number].in(reading) += by;
  };
}

Shift of_joint(std::size_t joint) {
  return [joint](const Experiment&, Run& run) {
    const double by = run.imposed_noise.q;
    run.each_rest([&](std::vector<double>& rest) { rest[joint] += by; });
  };
}

bool has_noise(const Experiment& experiment, const Run& run) {
  const std::vector<Channel> imposed = run.imposed();
  return run.imposed_noise.q > 0 || std::any_of(imposed.begin(), imposed.end(), [&](const Channel& one) {
           return sigma_of_imposed(experiment, run, one) > 0;
         });
}

}  // namespace

std::vector<Trace> variance_by_imposed(const Experiment& experiment) {
  const std::vector<Run>& runs = experiment.runs;
  if (std::none_of(runs.begin(), runs.end(), [&](const Run& run) { return has_noise(experiment, run); }))
    return {};
  std::vector<Shift> shifts{of_channel(0), of_channel(1)};
  if (std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.imposed_noise.q > 0; }))
    for (std::size_t j = 0; j < experiment.link_length.size(); ++j) shifts.push_back(of_joint(j));
  const Rig rig = nominal_rig(experiment);
  const Prediction given = simulate(experiment, rig, {});
  std::vector<Trace> variance;
  for (const Trace& trace : given.runs) variance.push_back(Trace::Zero(trace.rows(), trace.cols()));
  for (const Shift& shift : shifts) {
    Experiment moved = experiment;
    for (Run& run : moved.runs) shift(experiment, run);
    const Prediction beside = simulate(moved, rig, {});
    for (std::size_t r = 0; r < variance.size(); ++r) {
      const Trace by = beside.runs[r] - given.runs[r];
      variance[r] += by.isFinite().select(by.square(), 0);
    }
  }
  return variance;
}

}  // namespace plumbline::diagnose
