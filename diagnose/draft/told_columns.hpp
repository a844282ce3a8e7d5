#pragma once
/// \file
/// What a person says of columns: `x=Traverse:mm,Fx=-3:kgf,ignore=humidity`.

#include <string>
#include <vector>

#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

/// Entries `CHANNEL=COLUMN` or `CHANNEL=COLUMN:UNIT` with commas between them. A channel is t, x, y, z, Fx,
/// Fy, Fz, F, Mx, My, Mz, angle, q1 …, q_command, q_command1 …, torque, torque1 …, weight, temperature,
/// tension, pressure, qw, qx, qy, qz, roll, pitch, yaw, run, or ignore; a column is its title, or its number
/// from 1, with a minus before it where its sign is the other one. A comma or colon in a title is written
/// twice.
/// \throws Error for anything else
std::vector<ToldColumn> told_columns(const std::string& text);

/// The option of the command that says so: `--columns "Fx=-Kraft:kgf"`.
std::string columns_option(const std::vector<ToldColumn>& told);

/// A meaning that a person may give to a column.
struct ChannelChoice {
  std::string word;                ///< "q_command"
  std::string means;               ///< "commanded angle"
  bool numbered;                   ///< of one of several joints: "q_command2"
  std::vector<std::string> units;  ///< usual ones; none where it has no unit
};
std::vector<ChannelChoice> channel_choices();
/// The one that says these words: "q_command2"; empty where none does.
std::string channel_word(const ColumnWords& words);

}  // namespace plumbline::diagnose
