#include "diagnose/bench/channel.hpp"

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

Sensor Channel::sensor() const {
  if (name == Name::q) return Sensor::angle;
  return name == Name::x || name == Name::y ? Sensor::position : Sensor::force;
}

std::string label(Sensor sensor) {
  if (sensor == Sensor::position) return "position";
  return sensor == Sensor::force ? "force" : "angle";
}

std::string label(Channel::Name name) {
  switch (name) {
    case Channel::Name::x:
      return "x";
    case Channel::Name::y:
      return "y";
    case Channel::Name::Fx:
      return "Fx";
    case Channel::Name::Fy:
      return "Fy";
    case Channel::Name::q:
      break;
  }
  return "q";
}

std::string Channel::label() const {
  return diagnose::label(name) + (name == Name::q ? std::to_string(joint + 1) : "");
}

std::string_view Channel::unit() const {
  switch (sensor()) {
    case Sensor::position:
      return "m";
    case Sensor::force:
      return "N";
    case Sensor::angle:
      break;
  }
  return "rad";
}

double& Channel::in(Reading& reading) const {
  switch (name) {
    case Name::x:
      return reading.x;
    case Name::y:
      return reading.y;
    case Name::Fx:
      return reading.Fx;
    case Name::Fy:
      return reading.Fy;
    case Name::q:
      break;
  }
  return reading.q[joint];
}

double Channel::of(const Reading& reading) const {
  return in(const_cast<Reading&>(reading));  // read alone
}

double Channel::sigma(const Noise& noise) const {
  switch (name) {
    case Name::x:
      return noise.x;
    case Name::y:
      return noise.y;
    case Name::Fx:
      return noise.Fx;
    case Name::Fy:
      return noise.Fy;
    case Name::q:
      break;
  }
  return noise.q;
}

}  // namespace plumbline::diagnose
