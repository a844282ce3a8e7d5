#pragma once
/// \file
/// The meaning of a column title: quantity, joint, unit.

#include <string>
#include <vector>

#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {

/// The content of a column.
enum class Kind {
  none,
  time,
  x,
  y,
  z,
  force_x,
  force_y,
  force_z,
  force,
  angle,
  run,
  temperature,
  humidity,
  torque,    ///< of a drive, or on a joint
  moment_x,  ///< on the end point, about an axis
  moment_y,
  moment_z,
  mass,      ///< that hangs somewhere
  current,   ///< of a motor
  rotation,  ///< of a point: roll, pitch, yaw, or the numbers of a quaternion, by the axis
  tension,   ///< of a tendon
  pressure,  ///< in an actuator
  number,    ///< of the line, the pose, the sample
  doubled,   ///< a quantity that another column has
  left_out   ///< by a person
};

/// Other than the reading itself.
enum class Treatment { none, raw, filtered };

struct ColumnWords {
  Kind kind = Kind::none;
  std::size_t joint = 0;      ///< of an angle, a torque or a current, from 1; 0 where no number says it
  bool commanded = false;     ///< "x_cmd": what was asked for, not what was reached
  std::string unit = {};      ///< "mm", where the words have one that is one; else empty
  std::string variable = {};  ///< of a tension or a pressure: its title as the name of a covariate
  bool at_motor = false;      ///< an angle before the gear
  Treatment treatment = Treatment::none;
  char axis = ' ';  ///< of a rotation: 'r', 'p', 'y' of roll, pitch, yaw; 'W', 'X', 'Y', 'Z' of a quaternion
  int sign = 1;     ///< of the readings, where a person says it
};

/// \param title   "Traverse [mm]", "F_x (N)", "joint_2_pos"
/// \param below   what a line of units has under it; or empty
/// \param joints  the names of the joints, from 1
ColumnWords words_of(const std::string& title, const std::string& below,
                     const std::vector<std::string>& joints);

/// The meaning of columns without a word, as the format has them: t, x, y, Fx, Fy, and the angles of so many
/// joints or none; empty for another number of columns.
std::vector<ColumnWords> words_of_standard(std::size_t columns, std::size_t joints);

bool is_force(Kind kind);
/// Whether a column says where the chain is: a place or an angle.
bool is_place(Kind kind);
/// Whether a column says how hard something along the chain pulls or presses: a tension or a pressure.
bool is_actuation(Kind kind);
/// Whether a column that is not used may be one that the diagnosis should have.
bool is_missed(const ColumnWords& words);

/// In words: "a torque".
const char* name_of(Kind kind);
/// The quantity of a kind; nothing of a run, a current or a temperature.
const Quantity* quantity_of(Kind kind);

}  // namespace plumbline::diagnose
