#include "diagnose/exchange/written_arm.hpp"

#include <plumbline/base/error.hpp>

#include "diagnose/exchange/arm_toml.hpp"
#include "diagnose/exchange/corrected_arm.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::Experiment, diagnose::NominalEffect, diagnose::Rig;

/// The arm of a rig, its joints' zeros and stiffnesses in it.
SerialArm<double> arm_of(const Rig& rig) {
  SerialArm<double> arm = rig.arm->arm;
  for (std::size_t j = 0; j < arm.size(); ++j) {
    ArmLink<double>& link = arm.links[j];
    const double zero = rig.rest_error[j] + rig.encoder[j].zero;
    if (link.kind == JointKind::prismatic)
      link.frame.translation() += link.frame.linear() * (zero * link.axis);
    else
      link.frame.linear() *= rotation_by<double>(zero * link.axis);
    if (rig.stiffness[j] > 0) link.joint_compliance = 1 / rig.stiffness[j];
  }
  return arm;
}

Rig rig_with_effects(Experiment experiment, std::vector<NominalEffect> effects) {
  experiment.effects = std::move(effects);
  return nominal_rig(experiment);
}

/// Whether an effect alone changes anything that a model of an arm has.
bool is_of_arm(const Experiment& experiment, const NominalEffect& effect) {
  const Rig with = rig_with_effects(experiment, {effect}), without = rig_with_effects(experiment, {});
  return !(arm_of(with) == arm_of(without)) || with.friction != without.friction;
}

std::vector<Carried> others_of(const Experiment& experiment) {
  std::vector<Carried> others;
  for (const NominalEffect& effect : experiment.effects)
    if (!is_of_arm(experiment, effect))
      others.push_back({effect.label(), false, "no part of an arm's model"});
  return others;
}

}  // namespace

Written written_arm(const Model& model, Format format) {
  const Experiment& experiment = model.experiment;
  const Rig rig = nominal_rig(experiment);
  diagnose::NominalArm nominal = *experiment.arm;
  nominal.arm = arm_of(rig);
  const std::vector<Carried> others = others_of(experiment);
  if (format == Format::toml) {
    std::string text = "# " + model.title + "\n";
    for (const Carried& one : others) text += "# NOT CARRIED: " + one.effect + ": " + one.how + "\n";
    return {text + arm_toml(nominal), others};
  }
  if (model.source.empty() || format_of(model.source) != format)
    throw Error("corrected model", "an arm that was not read from a file of this format",
                model.source.empty() ? std::string("a file .toml")
                                     : "a file " + model.source.extension().string() + ", or .toml");
  CorrectedArm corrected{model.title, model.source, {nominal.base, nominal.tip}, nominal.arm};
  corrected.friction = rig.friction;
  corrected.others = others;
  return edited(corrected);
}

}  // namespace plumbline::exchange
