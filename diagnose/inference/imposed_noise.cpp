#include "diagnose/inference/imposed_noise.hpp"

#include <algorithm>

#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

double sigma_of_imposed(const Experiment& experiment, const Run& run) {
  if (run.imposed().size() > 1 || run.commands_joints()) return 0;
  return run.imposed().front().sigma(experiment.noise);
}

}  // namespace

std::vector<Trace> variance_by_imposed(const Experiment& experiment) {
  const std::vector<Run>& runs = experiment.runs;
  if (std::all_of(runs.begin(), runs.end(),
                  [&](const Run& run) { return sigma_of_imposed(experiment, run) == 0; }))
    return {};
  Experiment moved = experiment;
  for (Run& run : moved.runs) {
    const double by = sigma_of_imposed(experiment, run);
    for (Reading& reading : run.readings) run.imposed().front().in(reading) += by;
  }
  const Rig rig = nominal_rig(experiment);
  const Prediction given = simulate(experiment, rig, {}), beside = simulate(moved, rig, {});
  std::vector<Trace> variance;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Trace by = beside.runs[r] - given.runs[r];
    variance.push_back(by.isFinite().select(by.square(), 0));
  }
  return variance;
}

}  // namespace plumbline::diagnose
