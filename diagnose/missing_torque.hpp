#pragma once
/// \file
/// The torque that the nominal statics miss at each joint, and which joints it points at.

#include "diagnose/where.hpp"

namespace plumbline {

/// What a reading with measured joint angles misses at one joint: k_i d_i - [J^T F]_i, less what the nominal
/// weight of the links gives.
struct MissingTorque {
  std::size_t run, reading;
  double angle;   ///< measured joint angle
  double torque;  ///< N m
  double sigma;   ///< of the torque, from the declared noise of force and angles
};

/// By joint. Empty lists where no run measures all joint angles together with the force.
std::vector<std::vector<MissingTorque>> missing_torques(const Experiment& experiment);

/// Whether some reading has the force and all joint angles.
bool torques_measured(const Experiment& experiment);

/// Shares of the joints: of the missing torque beyond its noise where joint angles are measured. Else each
/// elastic joint's chance to be the one place of an unknown torque, free at every reading: it may change the
/// measured channels only along one direction, and what that leaves is compared.
std::vector<JointShare> joint_shares(const Experiment& experiment, const Measurements& measurements,
                                     const std::vector<double>& residual, const NoiseModel& noise);

}  // namespace plumbline
