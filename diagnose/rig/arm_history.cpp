#include "diagnose/rig/arm_history.hpp"

#include <algorithm>
#include <limits>

#include "diagnose/rig/arm_traveller.hpp"

namespace plumbline::diagnose {
namespace {

Eigen::Index columns_of(const Experiment& experiment) {
  return Channel(Channel::Name::place, 3 * experiment.arm_bench.points.size(), experiment.arm->arm.size())
      .column;
}

/// One run of a rig and of its variations; `beside` holds the differences from the rig.
bool walk(const Experiment& experiment, const Run& run, const Rig& rig,
          const std::vector<const Rig*>& variations, Trace& trace, const std::vector<Trace*>& beside) {
  std::size_t sliders = contact_count(rig);
  for (const Rig* one : variations) sliders = std::max(sliders, contact_count(*one));
  ArmTraveller main(experiment, rig, run, sliders);
  std::vector<ArmTraveller> others;
  others.reserve(variations.size());
  for (const Rig* one : variations) others.emplace_back(experiment, *one, run, sliders);
  Eigen::ArrayXd row = Eigen::ArrayXd::Constant(trace.cols(), std::numeric_limits<double>::quiet_NaN()),
                 other = row;
  for (std::size_t r = 0; r < run.readings.size(); ++r) {
    const auto at = static_cast<Eigen::Index>(r);
    const Reading& reading = run.readings[r];
    main.head_for(reading);
    if (!main.settle()) return false;
    if (!others.empty()) main.prepare();
    main.write(row);
    trace.row(at) = row.transpose();
    for (std::size_t p = 0; p < others.size(); ++p) {
      others[p].head_for(reading);
      if (!others[p].settle_beside(main)) return false;
      others[p].write(other);
      beside[p]->row(at) = (other - row).transpose();
      others[p].remember();
    }
    main.remember();
  }
  return true;
}

}  // namespace

Prediction simulate_arm(const Experiment& experiment, const Rig& rig,
                        const std::vector<RigVariation>& variations) {
  Prediction result;
  for (const Run& run : experiment.runs)
    result.runs.push_back(Trace::Constant(static_cast<Eigen::Index>(run.readings.size()),
                                          columns_of(experiment), std::numeric_limits<double>::quiet_NaN()));
  result.sensitivity.assign(variations.size(), result.runs);
  std::vector<const Rig*> varied;
  for (const RigVariation& one : variations) varied.push_back(&one.rig);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    std::vector<Trace*> beside;
    for (std::size_t p = 0; p < variations.size(); ++p) beside.push_back(&result.sensitivity[p][r]);
    if (!walk(experiment, experiment.runs[r], rig, varied, result.runs[r], beside)) {
      result.reached = false;
      return result;
    }
    for (std::size_t p = 0; p < variations.size(); ++p) result.sensitivity[p][r] /= variations[p].step;
  }
  return result;
}

}  // namespace plumbline::diagnose
