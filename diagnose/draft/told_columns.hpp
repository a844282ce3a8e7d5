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

/// The names of the channels, for whoever offers them.
std::vector<std::string> channel_words();

}  // namespace plumbline::diagnose
