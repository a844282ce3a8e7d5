#include "diagnose/bench/roll_pitch_yaw.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace plumbline::diagnose {

using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::Vector3d;

Matrix3d from_roll_pitch_yaw(const Vector3d& angles) {
  return (AngleAxisd(angles.z(), Vector3d::UnitZ()) * AngleAxisd(angles.y(), Vector3d::UnitY()) *
          AngleAxisd(angles.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

Vector3d roll_pitch_yaw(const Matrix3d& turn) {
  // The roll is taken of what the yaw leaves: together they are right where each alone is not determined.
  const double yaw = std::atan2(turn(1, 0), turn(0, 0));
  const Matrix3d rest = AngleAxisd(-yaw, Vector3d::UnitZ()) * turn;
  return {std::atan2(-rest(1, 2), rest(1, 1)), std::atan2(-rest(2, 0), rest(0, 0)), yaw};
}

}  // namespace plumbline::diagnose
