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
enum class Sensor { position, force, angle, torque };
inline constexpr std::size_t sensors = 4;
inline constexpr std::array<Sensor, sensors> every_sensor{Sensor::position, Sensor::force, Sensor::angle,
                                                          Sensor::torque};

/// Index in arrays by sensor.
constexpr std::size_t place_of(Sensor sensor) {
  return static_cast<std::size_t>(sensor);
}

/// "position", "force", "angle" or "torque".
std::string label(Sensor sensor);

/// Number of channel names.
inline constexpr std::size_t channel_names = 7;

struct Channel {
  /// Angle and torque are those of a joint alone: they stand in the places of x and Fx.
  enum class Name { x, y, Fx, Fy, q, angle, torque } name;
  std::size_t joint = 0;  ///< 0-based; meaningful for q

  bool operator==(const Channel&) const = default;
  [[nodiscard]] Sensor sensor() const;
  [[nodiscard]] std::string label() const;      ///< "Fx", or "q3" (1-based)
  [[nodiscard]] std::string_view unit() const;  ///< "m", "N", "rad" or "N m"
  [[nodiscard]] double of(const Reading& reading) const;
  /// The same for writing.
  [[nodiscard]] double& in(Reading& reading) const;
  [[nodiscard]] double sigma(const Noise& noise) const;
};

/// The name alone, "q" for all joint angles.
std::string label(Channel::Name name);

/// The order of the labels, in which reports list channels.
inline bool operator<(const Channel& a, const Channel& b) {
  return a.label() < b.label();
}

}  // namespace plumbline::diagnose
