#pragma once
/// \file
/// Rotations as URDF, SDF and experiment.toml write them: about the fixed axes x, y and z, one after the
/// other.

#include <Eigen/Core>

namespace plumbline::diagnose {

/// The rotation of three angles, rad.
Eigen::Matrix3d from_roll_pitch_yaw(const Eigen::Vector3d& angles);

/// Angles of a rotation, rad: right for every one, where the pitch is a quarter turn too.
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& turn);

}  // namespace plumbline::diagnose
