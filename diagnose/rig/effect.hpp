#pragma once
/// \file
/// The rows of the catalogue of effects, and candidates: sets of effects that act together.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/rig/characteristic_scales.hpp"
#include "diagnose/rig/parameter_range.hpp"
#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The experiment's scales and, for an effect at one joint or link, its number from 0.
struct Place {
  const CharacteristicScales& scales;
  std::size_t joint;
};

/// Initial guesses of a fit. All of them are evaluated; the fit descends from the best `refined` ones.
struct InitialGuesses {
  std::vector<std::vector<double>> points;
  std::size_t refined;
};

/// The rig to which an effect is added, and the values of its parameters.
struct Addition {
  Rig& rig;
  std::size_t joint;  ///< from 0
  const CharacteristicScales& scales;
  Vector2 down;         ///< direction of gravity
  const double* value;  ///< one a parameter, in catalogue units
};

/// The perturbation by which a linear forecast judges an effect before it is fitted. A parameter that does
/// not grow (the angle of a stop, a time constant) keeps the value of the initial guess. A finite
/// perturbation is as long as the guess itself: it serves where a small amount of the effect acts otherwise
/// than a large one (a joint that sticks, or stays within its play, at a reversal).
struct Perturbation {
  std::vector<std::size_t> growing = {};  ///< parameters that start from zero; all of them when empty
  bool large_step = false;                ///< a finite perturbation
  std::size_t guesses = 100;              ///< number of initial guesses that are perturbed
};

/// One row of the catalogue.
struct Effect {
  std::string id;           ///< as reports and labels spell it
  std::string words;        ///< a noun phrase that can follow "caused by"; {} is the joint or link
  bool at_joint = false;    ///< acts at one joint or link
  bool dissipates = false;  ///< dissipates energy
  /// The names in the ranges live as long as the row.
  std::function<std::vector<ParameterRange>(const Place& at)> parameters;
  std::function<void(const Addition& to)> add;
  /// Whether the effect can change any measured value at this place; everywhere when not given.
  std::function<bool(const Place& at)> possible = [](const Place&) { return true; };
  /// Simpler rows that this row contains at special parameter values.
  std::vector<std::string_view> nested = {};
  /// What distinguishes it from a simpler row of the same id; empty where it is the only one or the simplest.
  std::string_view form = {};
  /// Rows that this row can reproduce by its values at every joint; only its tolerance distinguishes it from
  /// them.
  std::vector<std::string_view> within_values = {};
  /// Initial guesses of a fit. Without them: zero and, for a single parameter, one scale to either side.
  std::function<InitialGuesses(const Place& at, const Excitation& nominal)> initial_guesses = nullptr;
  Perturbation perturbation = {};
  /// Number of parameters of one element, for rows made of several interchangeable elements; reports list the
  /// elements in ascending order of the last of these parameters. 0 for other rows.
  std::size_t element_size = 0;
  /// The rows of every model order (number of elements), this one among them, in ascending order; null where
  /// the order is fixed.
  std::function<std::vector<const Effect*>()> orders = nullptr;
  /// A manufacturing tolerance: present on every chain, and beside any cause.
  bool is_tolerance = false;
  /// A little of it is at every joint of an arm in space, whatever the cause is: a noun phrase for that of
  /// all joints; empty for other rows.
  std::string_view everywhere = {};
  /// Stands for a cause that the catalogue does not have.
  bool outside = false;
};

/// All effects, in the order of diagnose/rig/effects/README.md.
const std::vector<Effect>& catalogue();

/// Ids of former releases, and those that they have now.
const std::map<std::string_view, std::string_view>& former_ids();
/// The present id of an effect that had another one before; other ids stay.
std::string_view current_id(std::string_view id);

/// The row of an id. Of several rows with that id, the first of those at a single joint where `joint` (from
/// 1) is given, else of those with one value for all joints. A former id names the present row.
/// \throws Error for an id that the catalogue does not have
const Effect& effect(std::string_view id, std::size_t joint = 0);

/// An effect at its place. `joint` counts from 1; 0 where the effect is not at one joint.
struct EffectAt {
  EffectAt(const Effect& of, std::size_t at_joint = 0) : effect(&of), joint(at_joint) {}
  /// \throws Error for an id that the catalogue does not have
  EffectAt(const char* id, std::size_t at_joint = 0) : EffectAt(diagnose::effect(id, at_joint), at_joint) {}

  const Effect* effect;
  std::size_t joint;
  friend bool operator==(const EffectAt&, const EffectAt&) = default;

  /// As in files: "backlash(2)".
  [[nodiscard]] std::string label() const;
  /// As in reports for people, which distinguish the forms of an effect: "joint_stops (each its own)".
  [[nodiscard]] std::string name() const;
  /// "play in joint 2"
  [[nodiscard]] std::string in_words() const;
};

/// A set of effects that act together. Its parameters are those of its effects, one after the other.
struct Candidate {
  std::vector<EffectAt> effects;
  friend bool operator==(const Candidate&, const Candidate&) = default;

  /// "backlash(2) + gravity"
  [[nodiscard]] std::string label() const;
  [[nodiscard]] std::string name() const;
  [[nodiscard]] bool has(const EffectAt& at) const;
  /// Whether both have the same labels: one value for all joints and one at each are forms of one cause.
  [[nodiscard]] bool is_form_of(const Candidate& other) const;
  /// Whether its effects are a proper subset of the other's.
  [[nodiscard]] bool is_part_of(const Candidate& other) const;
  /// Whether it contains all manufacturing tolerances.
  [[nodiscard]] bool has_all_tolerances() const;
  /// Whether it contains all manufacturing tolerances, this effect among them.
  [[nodiscard]] bool has_as_tolerance(const EffectAt& at) const;
  /// Number of causes: all manufacturing tolerances together count as one.
  [[nodiscard]] std::size_t count() const;
};

/// A candidate and its fitted coordinates.
struct Instance {
  Candidate candidate;
  std::vector<double> parameters;
};

}  // namespace plumbline::diagnose
