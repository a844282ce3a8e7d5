#include "diagnose/rig/arm_rig.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "diagnose/rig/tube.hpp"

namespace plumbline::diagnose {

ArmRig ArmRig::nominal(const Experiment& experiment) {
  ArmRig rig;
  rig.arm = experiment.arm->arm;
  for (const MeasuredPoint& point : experiment.arm_bench.points) rig.points.push_back(point.at);
  rig.load = experiment.arm_bench.load;
  rig.sensors = experiment.arm_bench.sensors;
  return rig;
}

SerialArm<double> ArmRig::at(double growth, const std::vector<double>& command, double flexibility) const {
  constexpr double shortest = 1e-6;  // m, that has slid out: as many freedoms wherever it stands
  const Vector3<double> origin = Vector3<double>::Zero();
  SerialArm<double> now = arm;
  now.tip.translation() *= growth;
  for (ArmLink<double>& link : now.links) link.frame.translation() *= growth, link.centre *= growth;
  for (std::size_t i = 0; i < now.size(); ++i) {
    ArmLink<double>& link = now.links[i];
    const Vector3<double> end = now.far_end(i).translation();
    if (flexibility > 0 && link.kind == JointKind::prismatic) {
      const Vector3<double> out =
          std::copysign(std::max(std::abs(command[i]), shortest), command[i]) * link.axis;
      link.compliance += carried_on(tube_compliance(out, flexibility), end);
      part_mass(link, -out, origin);
    } else if (yields(link)) {
      part_mass(link, origin, end);
    }
  }
  return now;
}

Vector3<double> ArmRig::tool_turn(const Vector3<double>& moment) const {
  Vector3<double> turn = tool_compliance * moment;
  if (const double size = moment.norm(); size > 0) turn += tool_play / size * moment;
  if (const double side = moment.dot(tool_hinge); side != 0) turn += std::copysign(1.0, side) * tool_hinge;
  return turn;
}

void ArmRig::read_sensors(const std::vector<Pose<double>>& of_points, Eigen::Ref<Eigen::ArrayXd> row) const {
  for (std::size_t s = 0; s < sensors.size(); ++s)
    row.segment<2>(sensors[s].channel(s, 0, arm.size(), of_points.size()).column) =
        sensors[s].of(of_points[sensors[s].point]).array();
}

void ArmRig::bend(std::size_t link, double flexibility) {
  if (arm.far_end(link).translation().isZero(0)) return;
  arm.links[link].compliance += tube_compliance(arm.far_end(link).translation(), flexibility);
}

void ArmRig::stretch(std::size_t link, double strain) {
  if (arm.far_end(link).translation().isZero(0)) return;
  arm.links[link].compliance += bar_compliance(arm.far_end(link).translation(), strain);
}

void add_mass(ArmLink<double>& link, double added, const Vector3<double>& at) {
  const double sum = link.mass + added;
  if (sum != 0) link.centre = (link.mass * link.centre + added * at) / sum;
  link.mass = sum;
}

bool operator==(const ArmRig& a, const ArmRig& b) {
  const auto plain = [](const ArmRig& r) {
    return std::tie(r.arm, r.expansion, r.mount_compliance, r.tool_compliance, r.tool_play, r.tool_hinge,
                    r.points, r.load, r.sensors);
  };
  return plain(a) == plain(b);
}

}  // namespace plumbline::diagnose
