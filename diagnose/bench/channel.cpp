#include "diagnose/bench/channel.hpp"

#include <algorithm>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

std::string label(Sensor sensor) {
  constexpr std::array words{"position",     "force",         "angle",    "orientation", "torque",
                             "second force", "second torque", "distance", "pixel"};
  static_assert(words.size() == sensors);
  return words[place_of(sensor)];
}

Sensor Channel::sensor() const {
  return kind().sensor;
}

std::string Channel::label() const {
  const std::string stem(kind().label);
  switch (kind().index) {
    case ChannelKind::Index::joint:
      return stem + std::to_string(joint + 1);
    case ChannelKind::Index::coordinate:
      return (sensor() == Sensor::orientation ? "r" : "") + std::string(1, "xyz"[joint % 3]) +
             std::to_string(joint / 3 + 1);
    case ChannelKind::Index::sensor: {
      const std::size_t blank = std::min(stem.find(' '), stem.size());
      return (joint % 2 == 0 ? stem.substr(0, blank) : stem.substr(blank + 1)) +
             std::to_string(joint / 2 + 1);
    }
    case ChannelKind::Index::none:
      break;
  }
  return stem;
}

std::string_view unit(Sensor sensor) {
  constexpr std::array<std::string_view, sensors> units{"m", "N", "rad", "rad", "N m", "N", "N m", "m", "px"};
  return units[place_of(sensor)];
}

std::string_view Channel::unit() const {
  return diagnose::unit(sensor());
}

double& Channel::in(Reading& reading) const {
  return reading[column];
}

double Channel::of(const Reading& reading) const {
  return reading[column];
}

double Channel::sigma(const Noise& noise) const {
  return noise[name];
}

}  // namespace plumbline::diagnose
