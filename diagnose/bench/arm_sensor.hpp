#pragma once
/// \file
/// Sensors of an arm beside the tracker. Each reads one or two numbers of a point: a function of the point's
/// pose in the frame of the sensor. All that differs between the kinds of sensors is a row of one table.

#include <Eigen/Core>
#include <array>
#include <plumbline/arm/arm_kinematics.hpp>
#include <string>
#include <string_view>

#include "diagnose/bench/channel.hpp"

namespace plumbline::diagnose {

/// A row of the table of sensors. Motions of a frame are three shifts along its axes and three turns.
struct ArmSensorKind {
  Channel::Name reads;
  std::string_view key;                                ///< in experiment.toml
  std::size_t numbers;                                 ///< that it reads, one or two
  std::array<std::string_view, 2> column;              ///< behind its name in the tables
  std::array<bool, 6> sees_own;                        ///< the motions of its frame that change a reading
  bool sees_turns;                                     ///< of the point; else the point's place alone
  bool has_focal_length;                               ///< its numbers are times that, px
  Eigen::Vector2d (*read)(const Pose<double>& point);  ///< in the frame of the sensor
};

/// "distance": from the origin, m. "camera": the place of the image, px, of a camera that looks along z.
/// "inclinometer": by how much the point's axes x and y rise above the horizon, rad, with z upwards.
/// "plane": the height above the plane z = 0, m.
const std::array<ArmSensorKind, 4>& arm_sensor_kinds();

struct ArmSensor {
  std::string name;
  const ArmSensorKind* kind;
  std::size_t point = 0;                       ///< number of the point that it reads
  Pose<double> at = Pose<double>::Identity();  ///< its frame in the world
  double focal_length = 1;                     ///< px; 1 for what is no camera
  bool knows_focal_length = true;

  /// Its numbers for a point that has this pose in the world; of one number the second is zero.
  [[nodiscard]] Eigen::Vector2d of(const Pose<double>& pose) const {
    return focal_length * kind->read(at.inverse(Eigen::Isometry) * pose);
  }
  [[nodiscard]] Channel channel(std::size_t sensor, std::size_t number, std::size_t joints,
                                std::size_t points) const {
    return Channel::of_sensor(kind->reads, sensor, number, joints, points);
  }

  friend bool operator==(const ArmSensor& a, const ArmSensor& b) {
    return a.name == b.name && a.kind == b.kind && a.point == b.point && a.at.matrix() == b.at.matrix() &&
           a.focal_length == b.focal_length && a.knows_focal_length == b.knows_focal_length;
  }
};

}  // namespace plumbline::diagnose
