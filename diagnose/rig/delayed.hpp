#pragma once
/// \file
/// Commands that a drive follows with a delay.

#include <optional>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The readings of a run with what its drives impose as it was commanded so much earlier: joint angles, a
/// place, or a force by a load cell. Between readings commands are interpolated; before the first one they
/// stood still, or came along the line of a run that begins moving. Weights hang without delay.
/// \param delay  s, zero or more
std::vector<Reading> delayed(const Run& run, double delay);

/// A stop on the way: a reading, or a place between two of them, by their numbers.
struct Stop {
  const Reading& reading;  ///< as commanded
  std::optional<std::size_t> from = std::nullopt, to = std::nullopt;
  double share = 1;  ///< of the way between them
};

/// What drives impose at the stops of a run, as late as they follow it.
class LedCommand {
 public:
  /// \param delay  s, zero or more
  LedCommand(const Run& run, double delay);
  /// The command at a stop; it lasts until the next one is asked for.
  [[nodiscard]] const Reading& at(const Stop& stop);

 private:
  std::vector<Reading> behind_;  ///< the readings with delayed commands; none without delay
  Reading on_the_way_{};         ///< between two of them
};

}  // namespace plumbline::diagnose
