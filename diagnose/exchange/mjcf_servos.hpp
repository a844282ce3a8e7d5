#pragma once
/// \file
/// Position servos of an MJCF. In statics a position servo is a spring about its command.

#include "diagnose/exchange/mjcf_scene.hpp"

namespace plumbline::exchange {

/// At rest MuJoCo's force of an actuator is gain · control + bias[0] + bias[1] · length, with length = gear ·
/// angle, and turns the joint by gear · force.
struct MjcfServo {
  pugi::xml_node element;
  std::string name;
  std::size_t joint;  ///< number
  double gear, gain;
  std::vector<double> bias;  ///< three or more; the third is of the speed, or MuJoCo's damping ratio
  double control = 0;        ///< that of the keyframe `home`, or of the only one; 0 without
  std::string special = {};  ///< an attribute that <position> alone has, and that <general> cannot say

  [[nodiscard]] double stiffness() const { return -gear * gear * bias[1]; }  ///< N m/rad
  /// The joint's coordinate at which it is at ease.
  [[nodiscard]] double rest() const { return -(gain * control + bias[0]) / (gear * bias[1]); }
};

struct MjcfActuators {
  std::size_t count = 0;  ///< of all kinds
  std::vector<MjcfServo> servos;
  std::vector<std::string> notes;     ///< which command was taken
  std::vector<std::string> left_out;  ///< the actuators that are no springs
};

MjcfActuators actuators_of(const MjcfScene& scene);

}  // namespace plumbline::exchange
