#include "diagnose/bench/channel.hpp"

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

Sensor Channel::sensor() const {
  switch (name) {
    case Name::x:
    case Name::y:
      return Sensor::position;
    case Name::Fx:
    case Name::Fy:
      return Sensor::force;
    case Name::torque:
      return Sensor::torque;
    case Name::q:
    case Name::angle:
      break;
  }
  return Sensor::angle;
}

std::string label(Sensor sensor) {
  switch (sensor) {
    case Sensor::position:
      return "position";
    case Sensor::force:
      return "force";
    case Sensor::torque:
      return "torque";
    case Sensor::angle:
      break;
  }
  return "angle";
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
    case Channel::Name::angle:
      return "angle";
    case Channel::Name::torque:
      return "torque";
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
    case Sensor::torque:
      return "N m";
    case Sensor::angle:
      break;
  }
  return "rad";
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
    case Name::angle:
      return noise.x;
    case Name::y:
      return noise.y;
    case Name::Fx:
    case Name::torque:
      return noise.Fx;
    case Name::Fy:
      return noise.Fy;
    case Name::q:
      break;
  }
  return noise.q;
}

}  // namespace plumbline::diagnose
