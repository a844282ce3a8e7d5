#include "diagnose/bench/arm_sensor.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

Eigen::Vector2d distance(const Pose<double>& point) {
  return {point.translation().norm(), 0};
}

Eigen::Vector2d image(const Pose<double>& point) {
  return point.translation().head<2>() / point.translation().z();
}

Eigen::Vector2d rise_of_axes(const Pose<double>& point) {
  const auto rise = [&](Eigen::Index axis) {
    return std::asin(std::clamp(point.linear()(2, axis), -1.0, 1.0));
  };
  return {rise(0), rise(1)};
}

Eigen::Vector2d height(const Pose<double>& point) {
  return {point.translation().z(), 0};
}

}  // namespace

const std::array<ArmSensorKind, 4>& arm_sensor_kinds() {
  using Name = Channel::Name;
  static const std::array all{
      ArmSensorKind{Name::distance, "distance", 1, {"", ""}, {1, 1, 1, 0, 0, 0}, false, false, distance},
      ArmSensorKind{Name::pixel, "camera", 2, {"_u", "_v"}, {1, 1, 1, 1, 1, 1}, false, true, image},
      ArmSensorKind{
          Name::inclination, "inclinometer", 2, {"_x", "_y"}, {0, 0, 0, 1, 1, 0}, true, false, rise_of_axes},
      ArmSensorKind{Name::height, "plane", 1, {"", ""}, {0, 0, 1, 1, 1, 0}, false, false, height}};
  return all;
}

}  // namespace plumbline::diagnose
