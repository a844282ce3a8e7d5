#pragma once
/// \file
/// Reads the table of an arm's poses: a line a reading.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/sample_table.hpp"

namespace plumbline::diagnose {

/// The units of the columns, which all columns of a kind share.
struct PoseUnits {
  Unit place, angle, force, moment, mass;
};

/// The format of a table of poses.
struct PoseFormat {
  SampleFormat csv;  ///< of the file
  PoseUnits units;
  std::vector<std::string> ignored;  ///< names of columns that are left out
  bool motor_side;                   ///< q is what is commanded
};

/// Columns, by their names in the header: t; q_command1 …; q1 …; NAME_x, NAME_y, NAME_z of a point, NAME_rx …
/// or NAME_qw, NAME_qx … of its orientation; Fx … Mz or weight at the load; torque1 …; temperature, the only
/// covariate.
/// \param experiment  with its arm and bench
/// \param before      number of readings before these: without a column t they are counted on
/// \throws Error that names the source and the line: a column of no meaning or of a point that there is not, one
///         without the others of its kind, a field that is no number, no command, a quaternion that is none
std::vector<Reading> read_poses(const SampleTable& table, const std::string& source, const PoseFormat& format,
                                const Experiment& experiment, std::size_t before);

}  // namespace plumbline::diagnose
