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
enum class Sensor { position, force, angle, orientation, torque, second_force, second_torque };
inline constexpr std::array all_sensors{Sensor::position,     Sensor::force,  Sensor::angle,
                                        Sensor::orientation,  Sensor::torque, Sensor::second_force,
                                        Sensor::second_torque};
inline constexpr std::size_t sensors = all_sensors.size();

/// Index in arrays by sensor.
constexpr std::size_t place_of(Sensor sensor) {
  return static_cast<std::size_t>(sensor);
}

/// "m", "N", "rad" or "N m".
std::string_view unit(Sensor sensor);
/// "position", "force", "angle", "orientation", "torque", "second force" or "second torque".
std::string label(Sensor sensor);

/// The columns of readings and of traces that every bench has: those of the end point, or of a joint alone,
/// and the first of the joints' angles. The drives' torques follow these, then six coordinates a point.
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
  /// The last three are of arms in space: coordinates of a point, components of its rotation vector, torque
  /// of a drive. The number is that of the row in channel_kinds.
  enum class Name { x, y, Fx, Fy, q, Fx_2, Fy_2, angle, torque, torque_2, tilt, place, turn, drive } name;
  std::size_t joint =
      0;  ///< 0-based, for what there is at each joint or link; 3 p + axis for a coordinate of point p
  std::ptrdiff_t column;  ///< in readings and traces

  /// \param joints  of the arm, for what stands behind its joints' angles
  constexpr explicit Channel(Name of = Name::x, std::size_t index = 0, std::size_t joints = 0);

  bool operator==(const Channel&) const = default;
  [[nodiscard]] constexpr const struct ChannelKind& kind() const;
  [[nodiscard]] Sensor sensor() const;
  [[nodiscard]] std::string label() const;      ///< "Fx", "q3" or, of point 1, "z1" and "rz1"
  [[nodiscard]] std::string_view unit() const;  ///< "m", "N", "rad" or "N m"
  [[nodiscard]] double of(const Reading& reading) const;
  /// The same for writing.
  [[nodiscard]] double& in(Reading& reading) const;
  [[nodiscard]] double sigma(const Noise& noise) const;
};

/// A row of the table of channels.
struct ChannelKind {
  enum class Index { none, joint, coordinate };
  /// What has it: an end point or a joint alone (EndKind says which), all joints, those of a chain in the
  /// plane, an arm in space.
  enum class Of { end, joints, chain, arm };

  Channel::Name name;
  std::string_view label;      ///< "q" for all joint angles, "r" for all rotation vectors
  std::string_view noise_key;  ///< in the table [noise]
  Sensor sensor;
  Of of;
  Index index;            ///< over which there are several of the kind
  std::ptrdiff_t column;  ///< of the first; of drives and points, behind the joints' angles
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
      ChannelKind{Name::drive, "torque", "torque", Sensor::torque, Of::arm, Index::joint, column_q}};
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

/// The order of the labels, in which reports list channels.
inline bool operator<(const Channel& a, const Channel& b) {
  return a.label() < b.label();
}

}  // namespace plumbline::diagnose
