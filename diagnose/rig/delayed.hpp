#pragma once
/// \file
/// What drives impose, as they follow their commands.

#include <optional>
#include <vector>

#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The readings of a run with what its drives impose in place of their commands: joint angles, a place, or a
/// force by a load cell; and with covariates in place of what is told of them. Between readings commands are
/// interpolated; before the first one they stood still, or came along the line of a run that begins moving.
/// Weights hang without delay.
std::vector<Reading> led_by(const Drive& drive, const Run& run);

/// A stop on the way: a reading, or a place between two of them, by their numbers.
struct Stop {
  const Reading& reading;  ///< as commanded
  std::optional<std::size_t> from = std::nullopt, to = std::nullopt;
  double share = 1;  ///< of the way between them
};

/// What drives impose at the stops of a run.
class LedCommand {
 public:
  LedCommand(const Run& run, const Drive& drive);
  /// The command at a stop; it lasts until the next one is asked for.
  [[nodiscard]] const Reading& at(const Stop& stop);

 private:
  std::vector<Reading> behind_;  ///< the readings as the drive leads them; none where it is exact
  Reading on_the_way_{};         ///< between two of them
};

}  // namespace plumbline::diagnose
