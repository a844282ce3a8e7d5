#include "diagnose/exchange/written_arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/arm_toml.hpp"
#include "diagnose/exchange/corrected_arm.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/inference/calibration.hpp"
#include "diagnose/rig/characteristic_scales.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::Experiment, diagnose::NominalEffect, diagnose::Rig;

/// The points where the experiment has them, before any calibration.
std::vector<OnLink<double>> declared_points(const diagnose::ArmBench& bench) {
  std::vector<OnLink<double>> all;
  for (const diagnose::MeasuredPoint& one : bench.points) {
    all.push_back(one.at);
    if (bench.calibration) all.back().frame = bench.calibration->frames[all.size()].declared;
  }
  return all;
}

/// Whether all that is read is read at the tip, so that an error of the place is one of the tip.
bool is_read_at_tip(const Experiment& experiment) {
  const OnLink<double> tip{experiment.arm->arm.size() - 1, experiment.arm->arm.tip};
  const diagnose::ArmBench& bench = experiment.arm_bench;
  const bool loaded = bench.load == tip && diagnose::characteristic_scales(experiment).imposes_force;
  const std::vector<OnLink<double>> points = declared_points(bench);
  return !loaded && !points.empty() &&
         std::all_of(points.begin(), points.end(), [&](const auto& one) { return one == tip; });
}

/// The arm of a rig, its joints' zeros and stiffnesses in it, its tip where it was read.
SerialArm<double> arm_of(const Experiment& experiment, const Rig& rig) {
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
  if (is_read_at_tip(experiment) &&
      !(rig.arm->points.front() == declared_points(experiment.arm_bench).front()))
    arm.tip = rig.arm->points.front().frame;
  return arm;
}

/// The same correction of the file's own arm, which stands where its file has it: the bench may have it
/// elsewhere in the world, under another gravity.
void place_as_in_file(const SerialArm<double>& file, const SerialArm<double>& nominal,
                      SerialArm<double>& arm) {
  const bool stands = arm.base.matrix() == nominal.base.matrix();
  arm.base = stands ? file.base : file.base * (nominal.base.inverse() * arm.base);
  if (arm.gravity == nominal.gravity) arm.gravity = file.gravity;
}

/// The masses of a file that has none, in place of those that the bench assumed.
void leave_weights_out(const SerialArm<double>& file, SerialArm<double>& arm) {
  for (std::size_t i = 0; i < arm.size(); ++i)
    arm.links[i].mass = file.links[i].mass, arm.links[i].centre = file.links[i].centre;
}

/// The arm of a calibrated bench where its tracker sees it.
void place_as_seen(const diagnose::ArmBench& bench, SerialArm<double>& arm) {
  if (!bench.calibration) return;
  const Pose<double>& tracker = bench.calibration->frames.front().at;
  arm.base = tracker * arm.base;
  arm.gravity = tracker.linear() * arm.gravity;
}

Rig rig_with_effects(Experiment experiment, std::vector<NominalEffect> effects) {
  experiment.effects = std::move(effects);
  return nominal_rig(experiment);
}

/// Whether a model of an arm has all that an effect alone changes: its mechanics, its joints' zeros, springs
/// and dry friction, its tip.
bool is_of_arm(const Experiment& experiment, const NominalEffect& effect) {
  const Rig with = rig_with_effects(experiment, {effect});
  Rig all = rig_with_effects(experiment, {});
  all.arm->arm = with.arm->arm;
  all.rest_error = with.rest_error;
  for (std::size_t j = 0; j < all.encoder.size(); ++j) all.encoder[j].zero = with.encoder[j].zero;
  if (is_read_at_tip(experiment)) all.arm->points = with.arm->points;
  all.stiffness = with.stiffness;
  all.friction = with.friction;
  return all == with;
}

/// Why a model of an arm has no such effect.
std::string why_not(const Experiment& experiment, const NominalEffect& effect) {
  const double flexibility = rig_with_effects(experiment, {effect}).flexibility;
  if (flexibility == 0) return "no part of an arm's model";
  return fmt::format("links of this format are rigid: what slides out bends, EI = {:.4g} N m^2",
                     1 / flexibility);
}

/// What became of the effects; those that are not of an arm's model are taken out of the experiment.
std::vector<Carried> take_out_others(Experiment& experiment) {
  std::vector<Carried> others;
  std::erase_if(experiment.effects, [&, bench = experiment](const NominalEffect& effect) {
    if (is_of_arm(bench, effect)) return false;
    others.push_back({effect.label(), false, why_not(bench, effect)});
    return true;
  });
  return others;
}

}  // namespace

Written written_arm(const Model& model, Format format) {
  Experiment experiment = model.experiment;
  std::vector<Carried> others = take_out_others(experiment);
  const Rig rig = nominal_rig(experiment);
  diagnose::NominalArm nominal = *experiment.arm;
  nominal.arm = arm_of(experiment, rig);
  if (format == Format::toml) {
    place_as_seen(experiment.arm_bench, nominal.arm);
    const std::vector<double> without = rig_with_effects(experiment, {}).friction;
    for (const NominalEffect& effect : experiment.effects)
      if (rig_with_effects(experiment, {effect}).friction != without)
        others.push_back({effect.label(), false, "joints of this format have no dry friction"});
    std::string text = "# " + model.title + "\n";
    for (const Carried& one : others) text += "# NOT CARRIED: " + one.effect + ": " + one.how + "\n";
    return {text + arm_toml(nominal), others};
  }
  if (model.source.empty() || format_of(model.source) != format)
    throw Error("corrected model", "an arm that was not read from a file of this format",
                model.source.empty() ? std::string("a file .toml")
                                     : "a file " + model.source.extension().string() + ", or .toml");
  const ArmEnds ends{nominal.base, nominal.tip};
  const SerialArm<double> file = read_arm(model.source, ends).nominal.arm;
  place_as_in_file(file, experiment.arm->arm, nominal.arm);
  if (experiment.arm_bench.assumed_density > 0) leave_weights_out(file, nominal.arm);
  CorrectedArm corrected{model.title, model.source, ends, nominal.arm};
  corrected.friction = rig.friction;
  corrected.others = others;
  return edited(corrected);
}

}  // namespace plumbline::exchange
