#include "diagnose/rig/arm_rig.hpp"

#include <tuple>

namespace plumbline::diagnose {

ArmRig ArmRig::nominal(const Experiment& experiment) {
  ArmRig rig;
  rig.arm = experiment.arm->arm;
  const std::size_t n = rig.arm.size();
  for (std::vector<double>* list :
       {&rig.zero, &rig.scale, &rig.angle_bias, &rig.angle_scale, &rig.torque_bias, &rig.torque_scale})
    list->assign(n, 0.0);
  rig.ripple.assign(n, Eigen::Vector2d::Zero());
  rig.balance.assign(n, Eigen::Vector2d::Zero());
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

bool operator==(const ArmRig& a, const ArmRig& b) {
  const auto plain = [](const ArmRig& r) {
    return std::tie(r.arm, r.zero, r.scale, r.ripple, r.balance, r.expansion, r.compensated,
                    r.mount_compliance, r.tool_compliance, r.tool_play, r.tool_hinge, r.tracker_scale,
                    r.points, r.load, r.wrench_scale, r.wrench_bias, r.angle_bias, r.angle_scale,
                    r.torque_bias, r.torque_scale);
  };
  return plain(a) == plain(b) && a.tracker.matrix() == b.tracker.matrix();
}

}  // namespace plumbline::diagnose
