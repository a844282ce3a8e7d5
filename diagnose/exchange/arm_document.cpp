#include "diagnose/exchange/arm_document.hpp"

#include <cmath>
#include <numbers>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/format.hpp"

namespace plumbline::exchange {

std::unique_ptr<ArmDocument> arm_document(const std::filesystem::path& file, const ArmEnds& ends) {
  switch (format_of(file)) {
    case Format::mjcf:
      return arm_in_mjcf(file, ends);
    case Format::urdf:
      return arm_in_urdf(file, ends);
    case Format::sdf:
      return arm_in_sdf(file, ends);
    case Format::toml:
      break;
  }
  throw Error(file.string(), "a file of ours", "a simulator's model: .xml (MJCF), .urdf or .sdf");
}

std::vector<Eigen::Isometry3d> link_frames(const SerialArm<double>& arm,
                                           const std::vector<double>& coordinates) {
  std::vector<Eigen::Isometry3d> all;
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmLink<double>& link = arm.links[i];
    at = at * link.frame;
    if (link.kind == JointKind::revolute)
      at.rotate(Eigen::AngleAxisd(coordinates[i], link.axis));
    else
      at.translate(coordinates[i] * link.axis);
    all.push_back(at);
  }
  return all;
}

Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& turn) {
  // The roll is taken of what the yaw leaves: together they are right where each alone is not determined.
  const double yaw = std::atan2(turn(1, 0), turn(0, 0));
  const Eigen::Matrix3d rest = Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()) * turn;
  return {std::atan2(-rest(1, 2), rest(1, 1)), std::atan2(-rest(2, 0), rest(0, 0)), yaw};
}

double moment_of_ball(double mass) {
  constexpr double water = 1000;  // kg/m^3
  const double radius = std::cbrt(3 * mass / (4 * std::numbers::pi * water));
  return 0.4 * mass * radius * radius;
}

}  // namespace plumbline::exchange
