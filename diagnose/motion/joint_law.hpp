#pragma once
/// \file
/// A drive that was found, in the words of simulators: numbers of one joint and its servo.

#include "diagnose/motion/diagnosis.hpp"

namespace plumbline::motion {

struct JointLaw {
  double armature;       ///< kg m^2
  double friction;       ///< dry, N m
  double damping;        ///< N m s/rad, the motor's own included
  double stiffness;      ///< of a spring that is at ease where the joint is at zero, N m/rad
  double zero_moves;     ///< how far the joint's zero stands beside the encoder's, over the stated one, rad
  double gain;           ///< of the servo, N m/rad
  double gain_of_speed;  ///< of its derivative part, N m s/rad
  double command_moves;  ///< added to commands, rad
  double torque_limit;   ///< N m
  double delay;          ///< of the command, s
  double stall_torque, back_emf, viscous, zero;  ///< as Term has them
};

/// \param servo_gain  of the servo that the file models, duty per rad
JointLaw joint_law(const Bench& bench, const Drive<double>& drive, double servo_gain);

/// The gain of the servo that the model's file has: that of all logs, or the one that the file is said to
/// have.
/// \throws Error where the logs have several and none is said
double servo_gain(const Bench& bench);

}  // namespace plumbline::motion
