#include "diagnose/bench/channel.hpp"

#include <array>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

namespace {

using Name = Channel::Name;

/// The place in a reading's list of points.
std::size_t place_in_points(const Channel& channel) {
  return 6 * (channel.joint / 3) + channel.joint % 3 + (channel.name == Name::turn ? 3 : 0);
}

}  // namespace

Sensor Channel::sensor() const {
  switch (name) {
    case Name::x:
    case Name::y:
    case Name::place:
      return Sensor::position;
    case Name::Fx:
    case Name::Fy:
      return Sensor::force;
    case Name::Fx_2:
    case Name::Fy_2:
      return Sensor::second_force;
    case Name::torque_2:
      return Sensor::second_torque;
    case Name::turn:
      return Sensor::orientation;
    case Name::torque:
    case Name::drive:
      return Sensor::torque;
    case Name::q:
    case Name::angle:
      break;
  }
  return Sensor::angle;
}

std::string label(Sensor sensor) {
  constexpr std::array words{"position", "force",        "angle",        "orientation",
                             "torque",   "second force", "second torque"};
  static_assert(words.size() == sensors);
  return words[place_of(sensor)];
}

std::string label(Channel::Name name) {
  constexpr std::array words{"x",     "y",      "Fx",       "Fy",    "Fx_2", "Fy_2",  "q",
                             "angle", "torque", "torque_2", "place", "r",    "torque"};
  static_assert(words.size() == channel_names);
  return words[static_cast<std::size_t>(name)];
}

std::string Channel::label() const {
  if (name == Name::q || name == Name::drive) return diagnose::label(name) + std::to_string(joint + 1);
  if (name != Name::place && name != Name::turn) return diagnose::label(name);
  return (name == Name::turn ? "r" : "") + std::string(1, "xyz"[joint % 3]) + std::to_string(joint / 3 + 1);
}

std::string_view Channel::unit() const {
  constexpr std::array<std::string_view, sensors> units{"m", "N", "rad", "rad", "N m", "N", "N m"};
  return units[place_of(sensor())];
}

double& Channel::in(Reading& reading) const {
  switch (name) {
    case Name::x:
    case Name::angle:
      return reading.x;
    case Name::y:
      return reading.y;
    case Name::Fx:
    case Name::torque:
      return reading.Fx;
    case Name::Fy:
      return reading.Fy;
    case Name::Fx_2:
    case Name::torque_2:
      return reading.second_load[0];
    case Name::Fy_2:
      return reading.second_load[1];
    case Name::place:
    case Name::turn:
      return reading.points[place_in_points(*this)];
    case Name::drive:
      return reading.torque[joint];
    case Name::q:
      break;
  }
  return reading.q[joint];
}

double Channel::of(const Reading& reading) const {
  return in(const_cast<Reading&>(reading));  // read alone
}

double Channel::sigma(const Noise& noise) const {
  const std::array all{noise.x, noise.y,  noise.Fx,   noise.Fy,    noise.Fx_2, noise.Fy_2,  noise.q,
                       noise.x, noise.Fx, noise.Fx_2, noise.place, noise.turn, noise.torque};
  static_assert(all.size() == channel_names);
  return all[static_cast<std::size_t>(name)];
}

}  // namespace plumbline::diagnose
