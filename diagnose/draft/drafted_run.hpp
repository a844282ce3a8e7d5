#pragma once
/// \file
/// One drafted run: the channels of its columns, their units, the imposed quantity and the rest.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/draft/column_words.hpp"
#include "diagnose/draft/draft.hpp"
#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

/// A column of a channel, as experiment.toml is to say it.
struct DraftColumn {
  std::size_t place = 0;  ///< among those of the source, from 0
  std::string unit;
  int sign = 1;
  double zero = 0;                      ///< in the unit
  std::optional<double> constant = {};  ///< instead of a column
};

/// The time, and the place and load that EndKind has: x, y, Fx, Fy; of a joint alone x and Fx stand for what
/// they are there.
enum : std::size_t { draft_t, draft_x, draft_y, draft_Fx, draft_Fy, draft_singles };

struct SingleChannel {
  std::string name;  ///< empty where the bench has none
  const Quantity* quantity;
};
const std::array<SingleChannel, draft_singles>& single_channels(Device device);

/// A column of a tendon's tension or of an actuator's pressure.
struct DraftedActuator {
  Kind kind;
  std::string name;  ///< as a covariate
  DraftColumn column;
};

struct DraftedRun {
  RunSource source;
  std::array<std::optional<DraftColumn>, draft_singles> singles;
  std::vector<DraftColumn> angles;                ///< of all joints, or none
  std::map<std::string, DraftColumn> covariates;  ///< by the names of their variables
  std::vector<DraftedActuator> actuators;         ///< in the order of their columns
  bool moved_by_actuators = false;                ///< by them alone: nothing else drives the run
  std::vector<DraftColumn> commands;              ///< of all joints, where the run imposes them; or none
  bool imposes_force = false;
  bool by_weights = false;  ///< the imposed load
  Device device = Device::chain;
  std::vector<std::size_t> further = {};  ///< columns that are used otherwise
  std::vector<double> rest;               ///< rad; empty where the model's serves
  Guesses guesses;
  std::string question;  ///< what a person has to say, in a line; or empty

  [[nodiscard]] const EndKind& end() const { return end_kind(device); }
  /// A channel in SI.
  [[nodiscard]] std::vector<double> values(const DraftColumn& column, const Quantity& quantity) const;
  [[nodiscard]] std::vector<double> values(std::size_t single) const;
  /// Whether a column has become one of the experiment's.
  [[nodiscard]] bool uses(std::size_t column) const;
};

/// A doubtful guess is asked, and an answer takes its place.
/// \returns the answer
std::optional<std::string> say_guess(DraftedRun& run, const Ask& ask, Guess guess);

/// The line that a script writes where the other quantity is imposed.
std::string line_of_control(const std::string& other);

/// What is imposed goes in even steps; what is measured scatters.
struct EvenSteps {
  bool load;  ///< whether the load is imposed
  bool sure;
  std::string reason;
};
/// \param roughness_of_place, roughness_of_load  as roughness() has them
EvenSteps even_steps(double roughness_of_place, double roughness_of_load, const char* places,
                     const char* loads);

/// Identifies columns by their titles; units, zeros, the imposed quantity and the rest by their numbers.
/// \throws Error where no column of a place, a force or an angle can be told
DraftedRun drafted_run(const RunSource& source, const DraftModel& model, const Ask& ask);

}  // namespace plumbline::diagnose
