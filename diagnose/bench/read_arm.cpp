#include "diagnose/bench/read_arm.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

Vector3<double> vector_or(const Section& section, const char* key, const Vector3<double>& otherwise) {
  if (!section.has(key)) return otherwise;
  const std::vector<double> numbers = section.numbers(key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

/// Place and fixed-axis angles, as URDF has them.
Pose<double> pose(const Section& section, const char* place, const char* turn) {
  const Vector3<double> angles = vector_or(section, turn, Vector3<double>::Zero());
  if (constexpr double most = 6.3; angles.cwiseAbs().maxCoeff() > most)
    throw Error(section.place(turn), fmt::format("{:.4g} rad", angles.cwiseAbs().maxCoeff()),
                "angles within a turn, in radians");
  Pose<double> result = Pose<double>::Identity();
  result.translation() = vector_or(section, place, Vector3<double>::Zero());
  result.linear() = from_roll_pitch_yaw(angles);
  return result;
}

ArmLink<double> read_link(const Section& joint) {
  joint.allow_only({"name", "link", "kind", "xyz", "rpy", "axis", "stiffness", "mass", "centre", "limits"});
  ArmLink<double> link;
  if (joint.has("kind") && joint.one_of("kind", {"revolute", "prismatic"}) == "prismatic")
    link.kind = JointKind::prismatic;
  link.frame = pose(joint, "xyz", "rpy");
  link.axis = vector_or(joint, "axis", Vector3<double>(0, 0, 1));
  if (!(link.axis.norm() > 0)) joint.refuse("axis", "a direction, which is not zero");
  link.axis.normalize();
  if (joint.has("stiffness")) {
    const double stiffness = joint.number("stiffness", "N m/rad or N/m");
    if (!(stiffness > 0)) joint.refuse("stiffness", "a positive number, or no such key for a rigid joint");
    link.joint_compliance = 1 / stiffness;
  }
  link.mass = joint.non_negative("mass");
  link.centre = vector_or(joint, "centre", Vector3<double>::Zero());
  return link;
}

NominalArm read_joints(const Section& section) {
  NominalArm nominal;
  nominal.base = "base", nominal.tip = "tip";
  std::set<std::string> names;
  for (const Section& joint : section.tables("joint")) {
    const std::string number = std::to_string(nominal.joint.size() + 1);
    nominal.arm.links.push_back(read_link(joint));
    nominal.joint.push_back(joint.has("name") ? joint.name("name", "a name") : "joint " + number);
    nominal.link.push_back(joint.has("link") ? joint.name("link", "a name") : "link " + number);
    for (const std::string& name : {nominal.joint.back(), nominal.link.back()})
      if (!names.insert(name).second)
        throw Error(joint.where(), "\"" + files::shown(name) + "\" again", "a name that nothing else has");
    constexpr double endless = std::numeric_limits<double>::infinity();
    nominal.limits.push_back(joint.has("limits") ? joint.pair("limits") : std::array{-endless, endless});
    if (!(nominal.limits.back()[0] < nominal.limits.back()[1]))
      joint.refuse("limits", "two angles, the lower one first");
  }
  return nominal;
}

/// Stiffnesses beside a model's file, which may have none; 0 is rigid.
void read_stiffness(const Section& section, NominalArm& nominal) {
  if (!section.has("joint_stiffness")) return;
  const std::vector<double> stiffness = section.numbers("joint_stiffness", nominal.arm.size());
  for (std::size_t j = 0; j < stiffness.size(); ++j) {
    if (stiffness[j] < 0) section.refuse("joint_stiffness", "numbers that are not negative; 0 is rigid");
    nominal.arm.links[j].joint_compliance = stiffness[j] > 0 ? 1 / stiffness[j] : 0;
  }
}

NominalArm read_nominal_arm(const Section& section, const ReadArm& read) {
  if (section.has("model") == section.has("joint"))
    throw Error(section.where(),
                section.has("model") ? "arm.model and arm.joint" : "neither arm.model nor arm.joint",
                "one of them");
  NominalArm nominal;
  if (section.has("joint")) {
    nominal = read_joints(section);
    nominal.arm.tip = pose(section, "tip_xyz", "tip_rpy");
  } else {
    const auto end = [&](const char* key) {
      return section.has(key) ? section.text(key, "a name") : std::string();
    };
    const std::string file = section.text("model", "the name of a file");
    if (!read)
      throw Error(section.place("model"), "a model's file", "arm.joint, for no models are read here");
    nominal = read(file, end("base"), end("tip"));
  }
  read_stiffness(section, nominal);
  nominal.arm.gravity = vector_or(section, "gravity", nominal.arm.gravity);
  if (section.has("base_xyz") || section.has("base_rpy"))
    nominal.arm.base = pose(section, "base_xyz", "base_rpy");
  return nominal;
}

/// A frame with an offset in the axes of the body that carries it.
OnLink<double> on_body(const Section& section, const NominalArm& nominal) {
  section.allow_only({"name", "body", "offset", "rpy"});
  const std::string body = section.has("body") ? section.text("body", "a name") : nominal.tip;
  const Pose<double> offset = pose(section, "offset", "rpy");
  if (body == nominal.tip) return {nominal.arm.size() - 1, nominal.arm.tip * offset};
  const auto found = std::find(nominal.link.begin(), nominal.link.end(), body);
  if (found == nominal.link.end()) {
    std::string names = nominal.tip;
    for (const std::string& name : nominal.link) names += ", " + name;
    throw Error(section.place("body"), "\"" + files::shown(body) + "\"", "one of " + files::shown(names));
  }
  return {static_cast<std::size_t>(found - nominal.link.begin()), offset};
}

std::vector<MeasuredPoint> read_points(const Section& section, const NominalArm& nominal) {
  std::vector<MeasuredPoint> points;
  std::set<std::string> names;
  for (const Section& one : section.tables("point")) {
    points.push_back({one.name("name", "a name"), on_body(one, nominal)});
    if (!names.insert(points.back().name).second)
      throw Error(one.place("name"), "\"" + points.back().name + "\" again",
                  "a name that no other point has");
  }
  if (points.empty()) points.push_back({"tip", {nominal.arm.size() - 1, nominal.arm.tip}});
  return points;
}

/// The orientation of a sensor that nothing is said of: z upwards.
Eigen::Matrix3d upright(const Vector3<double>& gravity) {
  if (gravity.isZero(0)) return Eigen::Matrix3d::Identity();
  return Eigen::Quaterniond::FromTwoVectors(Vector3<double>::UnitZ(), -gravity).toRotationMatrix();
}

ArmSensor read_sensor(const Section& section, const ReadArmBench& read) {
  section.allow_only({"name", "kind", "point", "xyz", "rpy", "focal_length"});
  std::vector<std::string> kinds;
  for (const ArmSensorKind& kind : arm_sensor_kinds()) kinds.emplace_back(kind.key);
  const std::string key = section.one_of("kind", kinds);
  ArmSensor sensor{section.name("name", "a name"),
                   &*std::ranges::find(arm_sensor_kinds(), key, &ArmSensorKind::key)};
  const std::vector<MeasuredPoint>& points = read.bench.points;
  if (section.has("point")) {
    const auto found = std::ranges::find(points, section.text("point", "a name"), &MeasuredPoint::name);
    if (found == points.end()) section.refuse("point", "the name of an [[arm.point]], or no such key");
    sensor.point = static_cast<std::size_t>(found - points.begin());
  }
  sensor.at = pose(section, "xyz", "rpy");
  if (!section.has("rpy")) sensor.at.linear() = upright(read.arm.arm.gravity);
  if (section.has("focal_length")) {
    if (!sensor.kind->has_focal_length) section.refuse("focal_length", "such a key of a camera alone");
    sensor.focal_length = section.number("focal_length", "px");
    if (!(sensor.focal_length > 0)) section.refuse("focal_length", "a positive number, px");
  } else if (sensor.kind->has_focal_length) {
    if (read.bench.frames == ArmBench::Frames::known)
      throw Error(section.place("focal_length"), "no such key", "px, or arm.frames = \"unknown\"");
    sensor.knows_focal_length = false;
  }
  return sensor;
}

std::vector<ArmSensor> read_sensors(const Section& section, const ReadArmBench& read) {
  std::vector<ArmSensor> sensors;
  std::set<std::string> names;
  for (const MeasuredPoint& point : read.bench.points) names.insert(point.name);
  for (const Section& one : section.tables("sensor")) {
    sensors.push_back(read_sensor(one, read));
    if (!names.insert(sensors.back().name).second)
      throw Error(one.place("name"), "\"" + sensors.back().name + "\" again",
                  "a name that no other sensor or point has");
  }
  return sensors;
}

}  // namespace

ReadArmBench read_arm(const Section& section, const ReadArm& read) {
  section.allow_only({"model", "base", "tip", "joint", "tip_xyz", "tip_rpy", "base_xyz", "base_rpy",
                      "gravity", "joint_stiffness", "point", "load", "encoder", "frames", "sensor"});
  ReadArmBench result{read_nominal_arm(section, read), {}};
  const NominalArm& nominal = result.arm;
  require_physical(nominal.arm);
  result.bench.points = read_points(section, nominal);
  result.bench.load = section.has("load") ? on_body(section.table("load"), nominal)
                                          : OnLink<double>{nominal.arm.size() - 1, nominal.arm.tip};
  if (section.has("frames") && section.one_of("frames", {"known", "unknown"}) == "unknown")
    result.bench.frames = ArmBench::Frames::unknown;
  result.bench.sensors = read_sensors(section, result);
  if (section.has("encoder")) result.motor_side = section.one_of("encoder", {"link", "motor"}) == "motor";
  return result;
}

NominalChain chain_of(const NominalArm& nominal) {
  NominalChain chain;
  chain.device = Device::arm;
  const SerialArm<double>& arm = nominal.arm;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const double soft = arm.links[i].joint_compliance, long_enough = 1e-3;  // for links whose axes meet
    chain.link_length.push_back(std::max(long_enough, arm.far_end(i).translation().norm()));
    chain.joint_stiffness.push_back(soft > 0 ? 1 / soft : 0);
    chain.link_mass.push_back(arm.links[i].mass);
  }
  chain.arm = std::make_shared<const NominalArm>(nominal);
  return chain;
}

}  // namespace plumbline::diagnose
