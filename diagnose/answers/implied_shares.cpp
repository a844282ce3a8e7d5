#include "diagnose/answers/implied_shares.hpp"

#include <cmath>

#include "diagnose/discrepancy/torque_balance.hpp"

namespace plumbline::diagnose {

std::vector<JointShare> shares_by_unknown_torques(const Study& study, const Findings& findings) {
  std::vector<double> weight(study.scales().link_length.size(), 0.0);
  double most = 0;
  bool any = false;
  for (const Hypothesis& one : findings.hypotheses) {
    const std::vector<EffectAt>& effects = one.candidate.effects;
    if (effects.size() != 1 || !effects.front().effect->outside) continue;
    if (!any) most = one.log_evidence, any = true;  // most evidence first
    weight[effects.front().joint - 1] += std::exp(one.log_evidence - most);
  }
  return joint_shares(weight);
}

std::vector<JointShare> shares_by_causes(const Study& study, const std::vector<RankedCause>& causes) {
  std::vector<double> weight(study.scales().link_length.size(), 0.0);
  for (const RankedCause& cause : causes) {
    const Prediction predicted = predict(study, cause.hypothesis.candidate, cause.hypothesis.parameters);
    std::vector<double> square(weight.size(), 0.0);
    double sum = 0;
    const auto torques = missing_torques(study, as_measured(study.experiment(), predicted));
    for (std::size_t j = 0; j < torques.size(); ++j)
      for (const MissingTorque& one : torques[j]) square[j] += one.torque * one.torque;
    for (const double s : square) sum += s;
    if (!(sum > 0)) continue;
    for (std::size_t j = 0; j < square.size(); ++j) weight[j] += cause.probability * square[j] / sum;
  }
  return joint_shares(weight);
}

std::vector<JointShare> shares_by_names(const Study& study, const std::vector<RankedCause>& causes) {
  std::vector<double> weight(study.scales().link_length.size(), 0.0);
  double sum = 0;
  for (const RankedCause& cause : causes)
    for (const EffectAt& at : cause.cause.effects)
      if (at.joint > 0) weight[at.joint - 1] += cause.probability, sum += cause.probability;
  return sum > 0 ? joint_shares(weight) : std::vector<JointShare>{};
}

}  // namespace plumbline::diagnose
