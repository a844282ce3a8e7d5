#include "diagnose/inference/study.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/parallel.hpp>

#include "diagnose/rig/nominal.hpp"
#include "diagnose/rig/sliding_unit.hpp"

namespace plumbline::diagnose {
namespace {

std::size_t index_of(const EffectAt& at) {
  return at.joint > 0 ? at.joint - 1 : 0;
}

/// The largest of a joint over all runs, rad.
/// \param angle  of a run and a reading, by their numbers; NaN where there is none
template <class Angle>
double largest_deflection(const Experiment& experiment, std::size_t joint, Angle angle) {
  double largest = 0;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    largest = std::max(largest, experiment.runs[r].largest_deflection(
                                    joint, [&](std::size_t reading) { return angle(r, reading); }));
  return largest;
}

/// Joints that the nominal model leaves at rest, as a servo arm without its weight, are told by their
/// measured angles.
Excitation exercise_of(const Experiment& experiment, const Prediction& nominal) {
  Excitation use{std::vector<double>(experiment.link_length.size(), 0.0), 0, 0};
  for (std::size_t i = 0; i < use.deflection.size(); ++i) {
    double& most = use.deflection[i];
    most = largest_deflection(experiment, i, [&](std::size_t r, std::size_t reading) {
      return nominal.runs[r](static_cast<Eigen::Index>(reading), column_q + static_cast<Eigen::Index>(i));
    });
    constexpr double at_rest = 1e-9;  // rad: rounding
    if (most < at_rest)
      most = largest_deflection(experiment, i, [&](std::size_t r, std::size_t reading) {
        return Channel(Channel::Name::q, i).of(experiment.runs[r].readings[reading]);
      });
    use.largest = std::max(use.largest, most);
    use.torque = std::max(use.torque, experiment.joint_stiffness[i] * most);
  }
  return use;
}

/// With its runs numbered, unless they were before some were left out.
Experiment numbered(Experiment experiment) {
  if (experiment.run_count > 0) return experiment;
  for (Run& run : experiment.runs) run.number = experiment.run_count++;
  return experiment;
}

Experiment with_rows(Experiment experiment, std::shared_ptr<const std::vector<Effect>> stated) {
  experiment.stated = std::move(stated);
  return experiment;
}

std::vector<const Effect*> all_rows(const Experiment& experiment) {
  std::vector<const Effect*> rows;
  for (const Effect& row : catalogue()) rows.push_back(&row);
  if (experiment.stated == nullptr) return rows;
  for (const Effect& row : *experiment.stated) rows.push_back(&row);
  return rows;
}

}  // namespace

Study::Study(Experiment experiment)
    : experiment_(numbered(std::move(experiment))),
      effects_(all_rows(experiment_)),
      measurements_(experiment_),
      scales_(characteristic_scales(experiment_)),
      nominal_rig_(diagnose::nominal_rig(experiment_)) {}

Study::Study(Experiment experiment, std::shared_ptr<const std::vector<Effect>> stated)
    : Study(with_rows(std::move(experiment), std::move(stated))) {}

Study Study::of(Experiment other) const {
  return Study(std::move(other), experiment_.stated);
}

unsigned Study::threads() const {
  return experiment_.stated && !experiment_.stated->empty() ? 1 : available_threads();
}

const Prediction& Study::nominal() const {
  std::call_once(late_->predicted, [&] { late_->nominal = simulate(experiment_, nominal_rig_, {}); });
  return late_->nominal;
}

VectorXd Study::residual(const Prediction& predicted) const {
  return summed_out().of_residual(measurements_.residual(predicted));
}

VectorXd Study::in_sigmas(const std::vector<Trace>& traces) const {
  return summed_out().of_slope(measurements_.in_sigmas(traces));
}

const SummedOut& Study::summed_out() const {
  std::call_once(late_->summed, [&] {
    if (experiment_.arm_bench.calibration) late_->summed_out = SummedOut(*this);
  });
  return late_->summed_out;
}

VectorXd Study::nominal_residual() const {
  return residual(nominal());
}

const Excitation& Study::excitation() const {
  std::call_once(late_->exercised, [&] { late_->exercise = exercise_of(experiment_, nominal()); });
  return late_->exercise;
}

std::vector<ParameterRange> Study::ranges(const EffectAt& at) const {
  std::vector<ParameterRange> all = at.effect->parameters({scales_, index_of(at)});
  const std::vector<bool>& slides = scales_.slides;
  if (at.joint > 0 ? slides[at.joint - 1] : std::find(slides.begin(), slides.end(), false) == slides.end())
    for (ParameterRange& one : all) one.unit = sliding_unit(one.unit);
  return all;
}

std::vector<ParameterRange> Study::ranges(const Candidate& candidate) const {
  std::vector<ParameterRange> all;
  for (const EffectAt& at : candidate.effects)
    for (const ParameterRange& range : ranges(at)) all.push_back(range);
  return all;
}

namespace {

std::vector<EffectAt> possible_by(const Study& study, const CharacteristicScales& scales) {
  std::vector<EffectAt> all;
  const bool summed_out = study.experiment().arm_bench.calibration != nullptr;
  for (const Effect* row : study.effects()) {
    if (summed_out && row->is_tolerance) continue;
    const std::size_t first = row->at_joint ? 1 : 0;
    const std::size_t last = row->at_joint ? scales.link_length.size() : 0;
    for (std::size_t joint = first; joint <= last; ++joint)
      if (const EffectAt at(*row, joint); row->possible({scales, index_of(at)})) all.push_back(at);
  }
  return all;
}

}  // namespace

std::vector<EffectAt> possible_effects(const Study& study) {
  return possible_by(study, study.scales());
}

std::vector<EffectAt> untimed_effects(const Study& study) {
  if (study.scales().clock) return {};
  CharacteristicScales timed = study.scales();
  timed.clock = true;
  const std::vector<EffectAt> possible = possible_effects(study);
  std::vector<EffectAt> all = possible_by(study, timed);
  std::erase_if(all, [&](const EffectAt& at) {
    return std::find(possible.begin(), possible.end(), at) != possible.end();
  });
  return all;
}

Instance part(const Study& study, const Candidate& candidate, const std::vector<double>& parameters,
              const std::function<bool(const EffectAt&)>& stays) {
  Instance left;
  auto value = parameters.begin();
  for (const EffectAt& at : candidate.effects) {
    const auto next = value + static_cast<std::ptrdiff_t>(study.ranges(at).size());
    if (stays(at)) {
      left.candidate.effects.push_back(at);
      left.parameters.insert(left.parameters.end(), value, next);
    }
    value = next;
  }
  return left;
}

Rig rig_with(const Study& study, const Candidate& candidate, const std::vector<double>& parameters) {
  Rig rig = study.nominal_rig();
  const Vector2 down = study.experiment().bench.down();
  std::size_t next = 0;
  for (const EffectAt& at : candidate.effects) {
    std::vector<double> values;
    for (const ParameterRange& range : study.ranges(at))
      values.push_back(catalogue_value(range.coordinate, parameters.at(next++)));
    at.effect->add({rig, index_of(at), study.scales(), down, values.data()});
  }
  return rig;
}

namespace {

/// The fitted coordinates, one of them farther by a step.
std::vector<double> farther(std::vector<double> parameters, std::size_t p, double step) {
  parameters[p] += step;
  return parameters;
}

/// By parameter, whether small amounts of its effect act otherwise than large ones.
std::vector<bool> act_when_large(const Candidate& candidate, const Study& study) {
  std::vector<bool> all;
  for (const EffectAt& at : candidate.effects)
    all.insert(all.end(), study.ranges(at).size(), at.effect->perturbation.large_step);
  return all;
}

/// Whether a typical amount would change what is read.
bool shows(const Study& study, const std::vector<Trace>& slope, const ParameterRange& range) {
  constexpr double rounding = 1e-6;  // sigma
  return range.scale * study.in_sigmas(slope).norm() > rounding;
}

}  // namespace

Prediction predict(const Study& study, const Candidate& candidate, const std::vector<double>& parameters,
                   bool with_sensitivity) {
  const Experiment& experiment = study.experiment();
  const Rig rig = rig_with(study, candidate, parameters);
  if (!with_sensitivity) return simulate(experiment, rig, {});
  const std::vector<ParameterRange> ranges = study.ranges(candidate);
  std::vector<RigVariation> variations;
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const double step = variation_share * ranges[p].scale;
    variations.push_back({rig_with(study, candidate, farther(parameters, p, step)), step});
  }
  Prediction here = simulate(experiment, rig, variations);
  // Play of a joint that nothing loads is felt along a path of its own, and shows nothing beside another one.
  const std::vector<bool> when_large = act_when_large(candidate, study);
  for (std::size_t p = 0; p < ranges.size() && here.reached; ++p) {
    if (!when_large[p] || shows(study, here.sensitivity[p], ranges[p])) continue;
    const double step = path_share * ranges[p].scale;
    const Prediction there =
        simulate(experiment, rig_with(study, candidate, farther(parameters, p, step)), {});
    if (!there.reached) continue;
    for (std::size_t r = 0; r < here.runs.size(); ++r)
      here.sensitivity[p][r] = (there.runs[r] - here.runs[r]) / step;
  }
  return here;
}

}  // namespace plumbline::diagnose
