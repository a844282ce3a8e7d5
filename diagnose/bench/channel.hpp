#pragma once
/// \file
/// A channel of the readings: a column of a sample file, with its sensor and its unit. All that differs
/// between the kinds of channels is a row of one table.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace plumbline::diagnose {

struct Noise;
struct Reading;

/// The kind of sensor of a value; each kind shares one correction of its declared noise.
enum class Sensor {
  position,
  force,
  angle,
  orientation,
  torque,
  second_force,
  second_torque,
  distance,
  pixel
};
inline constexpr std::array all_sensors{Sensor::position,      Sensor::force,    Sensor::angle,
                                        Sensor::orientation,   Sensor::torque,   Sensor::second_force,
                                        Sensor::second_torque, Sensor::distance, Sensor::pixel};
inline constexpr std::size_t sensors = all_sensors.size();

/// Index in arrays by sensor.
constexpr std::size_t place_of(Sensor sensor) {
  return static_cast<std::size_t>(sensor);
}

/// "m", "N", "rad", "N m" or "px".
std::string_view unit(Sensor sensor);
/// "position", "force", "angle", "orientation", "torque", "second force", "second torque", "distance" or
/// "pixel".
std::string label(Sensor sensor);

/// The columns of readings and of traces that every bench has: those of the end point, or of a joint alone,
/// and the first of the joints' angles. The drives' torques follow these, then six coordinates a point, then
/// two numbers a sensor beside the tracker.
enum ChannelColumn : std::ptrdiff_t {
  column_x,
  column_y,
  column_Fx,
  column_Fy,
  column_Fx_2,
  column_Fy_2,
  column_q
};

struct Channel {
  /// Fx_2 and Fy_2 are those of a second sensor of the load. Angle and torques are those of a joint alone. A
  /// tilt is the angle of a link against x, as an inclinometer on it reads.
  /// The last seven are of arms in space: coordinates of a point, components of its rotation vector, torque
  /// of a drive, and what sensors beside the tracker read (arm_sensor.hpp). The number is that of the row in
  /// channel_kinds.
  enum class Name {
    x,
    y,
    Fx,
    Fy,
    q,
    Fx_2,
    Fy_2,
    angle,
    torque,
    torque_2,
    tilt,
    place,
    turn,
    drive,
    distance,
    pixel,
    inclination,
    height
  } name;
  /// 0-based, for what there is at each joint or link; 3 p + axis for a coordinate of point p; 2 s + i for
  /// number i of sensor s
  std::size_t joint = 0;
  std::ptrdiff_t column;  ///< in readings and traces

  /// \param joints  of the arm, for what stands behind its joints' angles
  constexpr explicit Channel(Name of = Name::x, std::size_t index = 0, std::size_t joints = 0);
  /// A number of a sensor beside the tracker. \param joints, points  of the arm, which stand before it
  static constexpr Channel of_sensor(Name of, std::size_t sensor, std::size_t number, std::size_t joints,
                                     std::size_t points);

  bool operator==(const Channel&) const = default;
  [[nodiscard]] constexpr const struct ChannelKind& kind() const;
  [[nodiscard]] Sensor sensor() const;
  [[nodiscard]] std::string label() const;      ///< "Fx", "q3", of point 1 "z1" and "rz1", of sensor 1 "u1"
  [[nodiscard]] std::string_view unit() const;  ///< "m", "N", "rad", "N m" or "px"
  [[nodiscard]] double of(const Reading& reading) const;
  /// The same for writing.
  [[nodiscard]] double& in(Reading& reading) const;
  [[nodiscard]] double sigma(const Noise& noise) const;
};

/// A row of the table of channels.
struct ChannelKind {
  enum class Index { none, joint, coordinate, sensor };
  /// What has it: an end point or a joint alone (EndKind says which), all joints, those of a chain in the
  /// plane, an arm in space.
  enum class Of { end, joints, chain, arm };

  Channel::Name name;
  std::string_view label;  ///< "q" for all joint angles, "r" for all rotation vectors, "u v" for both numbers
  std::string_view noise_key;  ///< in the table [noise]
  Sensor sensor;
  Of of;
  Index index;            ///< over which there are several of the kind
  std::ptrdiff_t column;  ///< of the first; of drives, points and sensors, behind the joints' angles
  bool along_y = false;   ///< the command along y moves it, not that along x
};

inline constexpr auto channel_kinds = [] {
  using Name = Channel::Name;
  using Index = ChannelKind::Index;
  using Of = ChannelKind::Of;
  return std::array{
      ChannelKind{Name::x, "x", "x", Sensor::position, Of::end, Index::none, column_x},
      ChannelKind{Name::y, "y", "y", Sensor::position, Of::end, Index::none, column_y, true},
      ChannelKind{Name::Fx, "Fx", "Fx", Sensor::force, Of::end, Index::none, column_Fx},
      ChannelKind{Name::Fy, "Fy", "Fy", Sensor::force, Of::end, Index::none, column_Fy, true},
      ChannelKind{Name::q, "q", "q", Sensor::angle, Of::joints, Index::joint, column_q},
      ChannelKind{Name::Fx_2, "Fx_2", "Fx_2", Sensor::second_force, Of::end, Index::none, column_Fx_2},
      ChannelKind{Name::Fy_2, "Fy_2", "Fy_2", Sensor::second_force, Of::end, Index::none, column_Fy_2, true},
      ChannelKind{Name::angle, "angle", "angle", Sensor::angle, Of::end, Index::none, column_x},
      ChannelKind{Name::torque, "torque", "torque", Sensor::torque, Of::end, Index::none, column_Fx},
      ChannelKind{Name::torque_2, "torque_2", "torque_2", Sensor::second_torque, Of::end, Index::none,
                  column_Fx_2},
      ChannelKind{Name::tilt, "tilt", "tilt", Sensor::orientation, Of::chain, Index::joint, column_q},
      ChannelKind{Name::place, "place", "place", Sensor::position, Of::arm, Index::coordinate, column_q},
      ChannelKind{Name::turn, "r", "turn", Sensor::orientation, Of::arm, Index::coordinate, column_q + 3},
      ChannelKind{Name::drive, "torque", "torque", Sensor::torque, Of::arm, Index::joint, column_q},
      ChannelKind{Name::distance, "d", "distance", Sensor::distance, Of::arm, Index::sensor, column_q},
      ChannelKind{Name::pixel, "u v", "pixel", Sensor::pixel, Of::arm, Index::sensor, column_q},
      ChannelKind{Name::inclination, "tilt_x tilt_y", "inclination", Sensor::orientation, Of::arm,
                  Index::sensor, column_q},
      ChannelKind{Name::height, "h", "height", Sensor::distance, Of::arm, Index::sensor, column_q}};
}();
/// Number of channel names.
inline constexpr std::size_t channel_names = channel_kinds.size();

constexpr const ChannelKind& kind_of(Channel::Name name) {
  return channel_kinds[static_cast<std::size_t>(name)];
}

constexpr const ChannelKind& Channel::kind() const {
  return kind_of(name);
}

constexpr Channel::Channel(Name of, std::size_t index, std::size_t joints)
    : name(of), joint(index), column(kind_of(of).column) {
  const bool of_point = kind().index == ChannelKind::Index::coordinate,
             behind = kind().of == ChannelKind::Of::chain || kind().of == ChannelKind::Of::arm;
  const std::size_t before = of_point ? 2 * joints + 3 * (joint / 3) : behind ? joints : 0;
  column += static_cast<std::ptrdiff_t>(before + joint);
}

constexpr Channel Channel::of_sensor(Name of, std::size_t sensor, std::size_t number, std::size_t joints,
                                     std::size_t points) {
  Channel channel(of, 2 * sensor + number);
  channel.column = kind_of(of).column + static_cast<std::ptrdiff_t>(2 * joints + 6 * points + channel.joint);
  return channel;
}

/// The order of the labels, in which reports list channels.
inline bool operator<(const Channel& a, const Channel& b) {
  return a.label() < b.label();
}

}  // namespace plumbline::diagnose
