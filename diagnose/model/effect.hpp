#pragma once
/// \file
/// The effect catalogue as data: what each effect is called, where it can sit, what parameters it has, where
/// it enters the rig.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/model/rig.hpp"

namespace plumbline::diagnose {

/// The effects, in the order of the catalogue.
enum class EffectId {
  joint_stiffness,
  link_length,
  rest_angle,
  nonlinear_spring,
  backlash,
  joint_friction,
  joint_stop,
  joint_coupling,
  gravity,
  tip_payload,
  base_compliance,
  axial_compliance,
  link_bending,
  rail_misalignment,
  eccentric_load,
  tip_stiffness,
  guide_friction,
  force_bias,
  force_gain,
  position_offset,
  train_compliance,
  viscoelasticity,
  sensor_drift
};
inline constexpr std::size_t effect_count = 23;

/// How a parameter is fitted: as it is, by its logarithm (a time constant), or by its reciprocal (a rigidity,
/// so that zero is the nominal model).
enum class Coordinate { plain, logarithm, reciprocal };

/// A parameter of an effect, in one experiment. `scale`, `low` and `high` are in the fitted coordinate.
struct ParameterRange {
  std::string_view name;
  Coordinate coordinate;
  double scale;      ///< what a lab would call a sizeable effect; the difference step is a share of it
  double low, high;  ///< physical bounds
};

/// An effect at its place. `joint` counts from 1; 0 where the effect is not at one joint.
struct EffectAt {
  EffectId effect;
  std::size_t joint = 0;
  friend bool operator==(const EffectAt&, const EffectAt&) = default;
};

/// A set of effects that act together. Its parameters are those of its effects, one after the other.
struct Candidate {
  std::vector<EffectAt> effects;
  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// The id as the effect catalogue and reports spell it.
std::string_view effect_name(EffectId effect);
/// \throws Error for a word that is not in the catalogue
EffectId effect_id(std::string_view name);
/// Whether the effect sits at one joint or link.
bool sits_at_joint(EffectId effect);

/// The parameters of one effect and of a candidate.
std::vector<ParameterRange> parameter_ranges(const Experiment& experiment, const EffectAt& at);
std::vector<ParameterRange> parameter_ranges(const Experiment& experiment, const Candidate& candidate);

/// A candidate and its fitted coordinates.
struct Instance {
  Candidate candidate;
  std::vector<double> parameters;
};

/// What is left of a candidate of which only some effects stay.
Instance part(const Candidate& candidate, const std::vector<double>& parameters,
              const std::function<bool(const EffectAt&)>& stays);

/// The value in the catalogue's units of a fitted coordinate, and back.
double catalogue_value(Coordinate coordinate, double fitted);
double fitted_value(Coordinate coordinate, double catalogue);

/// The nominal rig with the candidate's effects added. `parameters` are fitted coordinates.
Rig rig_with(const Experiment& experiment, const Candidate& candidate, const std::vector<double>& parameters);

/// Every effect at every place of this chain where it can change anything at all: no stiffness error at a
/// passive joint, no gravity in a horizontal plane, no load-cell effect where no force is measured.
std::vector<EffectAt> possible_effects(const Experiment& experiment);

}  // namespace plumbline::diagnose
