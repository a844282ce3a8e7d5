#pragma once
/// \file
/// What the diagnosis knows of an effect, as one row, and sets of effects that act together.

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/rig/rig.hpp"
#include "diagnose/rig/sizes.hpp"

namespace plumbline::diagnose {

/// How a parameter is fitted: as it is, by its logarithm (a time constant), or by its reciprocal (a rigidity,
/// so that zero is the nominal model).
enum class Coordinate { plain, logarithm, reciprocal };

/// The value in the catalogue's units of a fitted coordinate, and back.
double catalogue_value(Coordinate coordinate, double fitted);
double fitted_value(Coordinate coordinate, double catalogue);

/// A parameter of an effect, in one experiment. `scale`, `low` and `high` are in the fitted coordinate.
struct ParameterRange {
  std::string_view name;
  std::string_view unit;  ///< "N m", or "ratio" for one
  Coordinate coordinate;
  double scale;      ///< what a lab would call a sizeable effect; the difference step is a share of it
  double low, high;  ///< physical bounds
  /// Standard deviation of its prior, a Gaussian about zero, where it is a tolerance; 0 where it is not.
  double tolerance = 0;
  /// With less than this its effect only says how a torque goes with the angle, as laws that nobody listed
  /// do.
  double shape_below = -std::numeric_limits<double>::infinity();

  /// Whether zero is the nominal model.
  [[nodiscard]] bool may_be_nothing() const { return coordinate == Coordinate::plain && low <= 0; }
  /// Whether it says where an effect sets in, as a stop does: nowhere near zero.
  [[nodiscard]] bool is_onset() const { return coordinate == Coordinate::plain && low > 0; }
};

/// A parameter that may have either sign, one that cannot be negative: zero is the nominal model.
ParameterRange both_ways(std::string_view name, std::string_view unit, double scale, double low, double high);
ParameterRange one_way(std::string_view name, std::string_view unit, double scale, double high);

/// Where an effect is asked about: an experiment's sizes, and a joint or link from 0 where it sits at one.
struct Place {
  const Sizes& sizes;
  std::size_t joint;
};

/// Parameter vectors from which to fit. All are looked at, the `basins` best are descended from.
struct Starts {
  std::vector<std::vector<double>> from;
  std::size_t basins;
};

/// What the rig looks like with so much of an effect.
struct Addition {
  Rig& rig;
  std::size_t joint;    ///< from 0
  const Sizes& sizes;   ///< of the experiment
  Vector2 down;         ///< direction of gravity
  const double* value;  ///< in catalogue units, one a parameter
};

/// How a forecast asks what little of an effect would do. A parameter that does not grow keeps the value of
/// each start (a stop's angle, a time constant). A large step is one as long as the start, where little of an
/// effect acts otherwise than much (which joints stick or hang in their play at a reversal).
struct Probing {
  std::vector<std::size_t> growing = {};  ///< parameters; all of them from nothing when empty
  bool large_step = false;
  std::size_t starts = 100;  ///< so many of the starts are probed
};

/// One row of the catalogue.
struct Effect {
  std::string id;           ///< as reports and labels spell it
  std::string words;        ///< can stand after "caused by"; {} is the joint or link
  bool at_joint = false;    ///< sits at one joint or link
  bool dissipates = false;  ///< gives back less than it took
  /// The names in the ranges live as long as the row.
  std::function<std::vector<ParameterRange>(const Place& at)> parameters;
  std::function<void(const Addition& to)> add;
  /// Whether it can change anything at this place of this bench; everywhere when not given.
  std::function<bool(const Place& at)> possible = [](const Place&) { return true; };
  /// Simpler rows that it is with certain parameters: it says more than they do only where it fits better.
  std::vector<std::string_view> special = {};
  /// Rows whose change its values can make, one for all joints or one at a single joint: where it has a
  /// tolerance, that alone tells it from them.
  std::vector<std::string_view> within_values = {};
  /// Where fits start; none: at zero, and at one scale to either side where there is one parameter.
  std::function<Starts(const Place& at, const Exercise& nominal)> starts = nullptr;
  Probing probing = {};
  /// So many of the parameters that are zero in the nominal model must not be zero: with fewer it is another,
  /// simpler row.
  std::size_t at_least = 1;
  /// So many parameters make one of several elements that may change places without changing anything: they
  /// are told in the order of the last of these, a turn or a time. None where nothing may.
  std::size_t element = 0;
  /// The rows of it with fewer elements and with more, itself among them, fewest first; null where their
  /// number is fixed.
  std::function<std::vector<const Effect*>()> numbers = nullptr;
  /// Says how a torque goes with the angle, as laws that nobody listed go too.
  bool of_shape = false;
  /// What machining leaves on every chain, and may stand beside any cause.
  bool of_machining = false;
};

/// All effects, ours and in the order of docs/effects.md.
const std::vector<Effect>& catalogue();

/// The row of that id, of two the one that sits at one joint if a joint is named, from 1, or the one that
/// does not; the one with a value for all joints, if another has one at each. \throws Error for a word that
/// is not in the catalogue
const Effect& effect(std::string_view id, std::size_t joint = 0);

/// An effect at its place. `joint` counts from 1; 0 where the effect is not at one joint.
struct EffectAt {
  EffectAt(const Effect& of, std::size_t at_joint = 0) : effect(&of), joint(at_joint) {}
  /// \throws Error for a word that is not in the catalogue
  EffectAt(const char* id, std::size_t at_joint = 0) : EffectAt(diagnose::effect(id, at_joint), at_joint) {}

  const Effect* effect;
  std::size_t joint;
  friend bool operator==(const EffectAt&, const EffectAt&) = default;

  /// "backlash(2)", as files have it
  [[nodiscard]] std::string label() const;
  /// The same for people, whom a value for all joints and one at each are two things:
  /// "joint_stops (each its own)"
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
  /// Whether it is named like the other: a value for all joints and one at each are forms of one cause.
  [[nodiscard]] bool is_form_of(const Candidate& other) const;
  /// Whether it has fewer effects than the other, which has them all.
  [[nodiscard]] bool is_part_of(const Candidate& other) const;
  /// Whether everything that machining leaves is in it.
  [[nodiscard]] bool machined() const;
  /// Whether this effect of it is a part of what machining leaves, which is one cause.
  [[nodiscard]] bool has_as_machining(const EffectAt& at) const;
  /// How many things came together: what machining leaves is one.
  [[nodiscard]] std::size_t count() const;
};

/// A candidate and its fitted coordinates.
struct Instance {
  Candidate candidate;
  std::vector<double> parameters;
};

}  // namespace plumbline::diagnose
