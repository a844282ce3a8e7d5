#include "diagnose/bench/assumed_weight.hpp"

#include <algorithm>

#include "diagnose/bench/nominal_arm.hpp"
#include "diagnose/bench/read_arm.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether a run shows weight, or imposes loads beside which it would be one more.
bool tells_loads(const Run& run) {
  const std::vector<Channel> measured = run.measured();
  return std::any_of(measured.begin(), measured.end(),
                     [](const Channel& one) { return one.name == Channel::Name::drive; }) ||
         std::any_of(run.readings.begin(), run.readings.end(),
                     [](const Reading& one) { return !one.wrench.empty(); });
}

}  // namespace

bool is_weightless(const SerialArm<double>& arm) {
  return std::all_of(arm.links.begin(), arm.links.end(), [](const ArmLink<double>& link) {
    return link.mass == 0 && link.joint_compliance == 0 && !yields(link);
  });
}

SerialArm<double> weighed(SerialArm<double> arm, double density) {
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const Vector3<double> way = arm.far_end(i).translation();
    arm.links[i].mass = density * way.norm();
    arm.links[i].centre = way / 2;
  }
  return arm;
}

void assume_weights(Experiment& experiment) {
  constexpr double usual = 10;  // kg/m
  if (!is_weightless(experiment.arm->arm) ||
      std::any_of(experiment.runs.begin(), experiment.runs.end(), tells_loads))
    return;
  NominalArm nominal = *experiment.arm;
  nominal.arm = weighed(std::move(nominal.arm), usual);
  static_cast<NominalChain&>(experiment) = chain_of(nominal);
  experiment.arm_bench.assumed_density = usual;
}

}  // namespace plumbline::diagnose
