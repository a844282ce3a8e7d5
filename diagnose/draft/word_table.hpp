#pragma once
/// \file
/// Words of column titles, by what they say, in six languages.

#include <string>
#include <vector>

namespace plumbline::diagnose {

/// What a word says of its column.
enum class Meaning {
  time,
  force,
  force_with_axis,  ///< a force along an axis; a torque without one: the French force, the ROS torque
  place,            ///< along the only axis there is
  angle,
  torque,
  mass,
  temperature,
  humidity,
  current,
  speed,
  run,
  number,
  command,
  reached,
  motor,
  raw,
  filtered
};

/// Whether one of the words, without capitals and accents, says so. Chinese and Japanese words may stand
/// within longer ones, as nothing separates them.
bool says(const std::vector<std::string>& words, Meaning meaning);

}  // namespace plumbline::diagnose
