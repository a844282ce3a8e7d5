#include "diagnose/exchange/arm_toml.hpp"

#include <fmt/format.h>

#include <cmath>

#include "diagnose/bench/roll_pitch_yaw.hpp"

namespace plumbline::exchange {
namespace {

/// Without what turning and adding leaves behind the twelfth digit.
std::string rounded(double value) {
  constexpr double last = 1e-12;
  return std::abs(value) < last ? "0" : fmt::format("{:.12g}", value);
}

std::string list(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", rounded(v.x()), rounded(v.y()), rounded(v.z()));
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return text + "\"";
}

std::string pose(const std::string& prefix, const Eigen::Isometry3d& at) {
  return fmt::format("{0}xyz = {1}\n{0}rpy = {2}\n", prefix, list(at.translation()),
                     list(diagnose::roll_pitch_yaw(at.linear())));
}

std::string joint(const diagnose::NominalArm& nominal, std::size_t i) {
  const ArmLink<double>& link = nominal.arm.links[i];
  const bool slides = link.kind == JointKind::prismatic;
  std::string text = fmt::format("\n[[arm.joint]]\nname = {}\nlink = {}\nkind = \"{}\"\n{}axis = {}\n",
                                 quoted(nominal.joint[i]), quoted(nominal.link[i]),
                                 slides ? "prismatic" : "revolute", pose("", link.frame), list(link.axis));
  if (link.joint_compliance > 0)
    text +=
        fmt::format("stiffness = {}  # {}\n", rounded(1 / link.joint_compliance), slides ? "N/m" : "N m/rad");
  text += fmt::format("mass = {}\ncentre = {}\n", rounded(link.mass), list(link.centre));
  const auto [lower, upper] = nominal.limits[i];
  if (std::isfinite(lower) && std::isfinite(upper))
    text += fmt::format("limits = [{}, {}]\n", rounded(lower), rounded(upper));
  return text;
}

}  // namespace

std::string arm_toml(const diagnose::NominalArm& nominal) {
  std::string text = fmt::format("[arm]\ngravity = {}\n{}{}", list(nominal.arm.gravity),
                                 pose("base_", nominal.arm.base), pose("tip_", nominal.arm.tip));
  for (std::size_t i = 0; i < nominal.arm.size(); ++i) text += joint(nominal, i);
  return text;
}

}  // namespace plumbline::exchange
