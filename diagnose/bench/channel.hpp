#pragma once
/// \file
/// A channel of the readings: a column of a sample file, with its sensor and its unit.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace plumbline::diagnose {

struct Noise;
struct Reading;

/// The kind of sensor of a value; each kind shares one correction of its declared noise.
enum class Sensor { position, force, angle, orientation, torque, second_force, second_torque };
inline constexpr std::array all_sensors{Sensor::position,     Sensor::force,  Sensor::angle,
                                        Sensor::orientation,  Sensor::torque, Sensor::second_force,
                                        Sensor::second_torque};
inline constexpr std::size_t sensors = all_sensors.size();

/// Index in arrays by sensor.
constexpr std::size_t place_of(Sensor sensor) {
  return static_cast<std::size_t>(sensor);
}

/// "position", "force", "angle", "orientation", "torque", "second force" or "second torque".
std::string label(Sensor sensor);

/// Number of channel names.
inline constexpr std::size_t channel_names = 13;

struct Channel {
  /// Fx_2 and Fy_2 are those of a second sensor of the load. Angle and torques are those of a joint alone:
  /// they stand in the places of x, Fx and Fx_2. The last three are of arms in space: coordinates of a point,
  /// components of its rotation vector, torque of a drive.
  enum class Name { x, y, Fx, Fy, Fx_2, Fy_2, q, angle, torque, torque_2, place, turn, drive } name;
  std::size_t joint = 0;  ///< 0-based, for q and drives; 3 p + axis for a coordinate of point p

  bool operator==(const Channel&) const = default;
  [[nodiscard]] Sensor sensor() const;
  [[nodiscard]] std::string label() const;      ///< "Fx", "q3" or, of point 1, "z1" and "rz1"
  [[nodiscard]] std::string_view unit() const;  ///< "m", "N", "rad" or "N m"
  [[nodiscard]] double of(const Reading& reading) const;
  /// The same for writing.
  [[nodiscard]] double& in(Reading& reading) const;
  [[nodiscard]] double sigma(const Noise& noise) const;
};

/// The name alone, "q" for all joint angles, "r" for all rotation vectors.
std::string label(Channel::Name name);

/// The order of the labels, in which reports list channels.
inline bool operator<(const Channel& a, const Channel& b) {
  return a.label() < b.label();
}

}  // namespace plumbline::diagnose
