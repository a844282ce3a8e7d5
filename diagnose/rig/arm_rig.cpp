#include "diagnose/rig/arm_rig.hpp"

#include <tuple>

namespace plumbline::diagnose {
namespace {

/// Compliance of a round tube that bends and twists along a vector: EI = 1 / flexibility, GJ = EI / 1.3.
Matrix6<double> tube(const Vector3<double>& along, double flexibility) {
  const double length = along.norm();
  const Vector3<double> axis = along / length;
  const Eigen::Matrix3d beside = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  Eigen::Matrix3d cross;  // (cross F) = axis x F
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  constexpr double twist = 1.3;
  Matrix6<double> all;
  all.topLeftCorner<3, 3>() = length * length * length / 3 * beside;
  all.bottomLeftCorner<3, 3>() = length * length / 2 * cross;
  all.topRightCorner<3, 3>() = -length * length / 2 * cross;
  all.bottomRightCorner<3, 3>() = length * (beside + twist * axis * axis.transpose());
  const Matrix6<double> compliance = flexibility * all;
  return (compliance + compliance.transpose()) / 2;  // to the last bit
}

}  // namespace

ArmRig ArmRig::nominal(const Experiment& experiment) {
  ArmRig rig;
  rig.arm = experiment.arm->arm;
  for (const MeasuredPoint& point : experiment.arm_bench.points) rig.points.push_back(point.at);
  rig.load = experiment.arm_bench.load;
  return rig;
}

Vector3<double> ArmRig::tool_turn(const Vector3<double>& moment) const {
  Vector3<double> turn = tool_compliance * moment;
  if (const double size = moment.norm(); size > 0) turn += tool_play / size * moment;
  if (const double side = moment.dot(tool_hinge); side != 0) turn += std::copysign(1.0, side) * tool_hinge;
  return turn;
}

void ArmRig::bend(std::size_t link, double flexibility) {
  if (arm.far_end(link).translation().isZero(0)) return;
  arm.links[link].compliance += tube(arm.far_end(link).translation(), flexibility);
}

void add_mass(ArmLink<double>& link, double added, const Vector3<double>& at) {
  const double sum = link.mass + added;
  if (sum != 0) link.centre = (link.mass * link.centre + added * at) / sum;
  link.mass = sum;
}

bool operator==(const ArmRig& a, const ArmRig& b) {
  const auto plain = [](const ArmRig& r) {
    return std::tie(r.arm, r.expansion, r.compensated, r.mount_compliance, r.tool_compliance, r.tool_play,
                    r.tool_hinge, r.points, r.load);
  };
  return plain(a) == plain(b);
}

}  // namespace plumbline::diagnose
