#include "diagnose/model/study.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

Vector2 gravity_direction(const Bench& bench) {
  return bench.has_direction ? Vector2(bench.gravity_direction[0], bench.gravity_direction[1])
                             : Vector2(0, -1);
}

std::size_t index_of(const EffectAt& at) {
  return at.joint > 0 ? at.joint - 1 : 0;
}

}  // namespace

Study::Study(Experiment experiment)
    : experiment_(std::move(experiment)), measurements_(experiment_), sizes_(sizes_of(experiment_)) {}

const Prediction& Study::nominal() const {
  if (!nominal_) nominal_ = simulate(experiment_, nominal_rig(experiment_), {});
  return *nominal_;
}

std::vector<double> Study::residual(const Prediction& predicted) const {
  return measurements_.residual(experiment_, predicted);
}

std::vector<double> Study::nominal_residual() const {
  return residual(nominal());
}

Exercise Study::exercise() const {
  Exercise nominal_use{std::vector<double>(experiment_.link_length.size(), 0.0), 0};
  for (std::size_t r = 0; r < nominal().runs.size(); ++r) {
    const Trace& trace = nominal().runs[r];
    for (std::size_t i = 0; i < nominal_use.deflection.size(); ++i) {
      double& largest = nominal_use.deflection[i];
      for (const double q : trace.col(column_q + static_cast<Eigen::Index>(i)))
        if (std::isfinite(q)) largest = std::max(largest, std::abs(q - experiment_.runs[r].rest[i]));
    }
  }
  for (std::size_t i = 0; i < nominal_use.deflection.size(); ++i)
    nominal_use.torque =
        std::max(nominal_use.torque, experiment_.joint_stiffness[i] * nominal_use.deflection[i]);
  return nominal_use;
}

std::vector<ParameterRange> Study::ranges(const EffectAt& at) const {
  return at.effect->parameters({sizes_, index_of(at)});
}

std::vector<ParameterRange> Study::ranges(const Candidate& candidate) const {
  std::vector<ParameterRange> all;
  for (const EffectAt& at : candidate.effects)
    for (const ParameterRange& range : ranges(at)) all.push_back(range);
  return all;
}

std::vector<EffectAt> possible_effects(const Study& study) {
  std::vector<EffectAt> all;
  for (const Effect& row : catalogue()) {
    const std::size_t first = row.at_joint ? 1 : 0;
    const std::size_t last = row.at_joint ? study.sizes().link_length.size() : 0;
    for (std::size_t joint = first; joint <= last; ++joint)
      if (const EffectAt at(row, joint); row.possible({study.sizes(), index_of(at)})) all.push_back(at);
  }
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
  Rig rig = nominal_rig(study.experiment());
  const Vector2 down = gravity_direction(study.experiment().bench);
  std::size_t next = 0;
  for (const EffectAt& at : candidate.effects) {
    std::vector<double> values;
    for (const ParameterRange& range : study.ranges(at))
      values.push_back(catalogue_value(range.coordinate, parameters.at(next++)));
    at.effect->add({rig, index_of(at), down, values.data()});
  }
  return rig;
}

Prediction predict(const Study& study, const Candidate& candidate, const std::vector<double>& parameters,
                   bool with_sensitivity) {
  std::vector<RigVariation> variations;
  if (with_sensitivity) {
    for (const ParameterRange& range : study.ranges(candidate)) {
      std::vector<double> other = parameters;
      const double step = variation_share * range.scale;
      other[variations.size()] += step;
      variations.push_back({rig_with(study, candidate, other), step});
    }
  }
  return simulate(study.experiment(), rig_with(study, candidate, parameters), variations);
}

}  // namespace plumbline::diagnose
