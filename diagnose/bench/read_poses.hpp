#pragma once
/// \file
/// The table of an arm's poses: a line a reading.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/read_samples.hpp"
#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// The format of a table of poses.
struct PoseFormat {
  SampleFormat table;
  bool motor_side;  ///< q is what is commanded
};

/// Columns by their names: t; q_command1 …; q1 …; torque1 …; NAME_x, NAME_y, NAME_z of a point, NAME_rx … or
/// NAME_qw, NAME_qx … of its orientation; Fx … Mz or weight at the load; temperature. [columns] has one key for
/// those of a point: NAME, NAME_r, NAME_q.
/// \param experiment  with its arm and bench
/// \param units       of all columns of a kind
PoseFormat pose_format(const Experiment& experiment, const Section& units, bool motor_side);

/// Orientations become rotations from the nominal ones, weights wrenches.
/// \throws Error that names the source and the line: what read_samples() refuses, a quaternion that is none, two
///         orientations of a point, a weight beside a wrench
Samples read_poses(std::vector<SamplePart> parts, const PoseFormat& format, const Experiment& experiment);

}  // namespace plumbline::diagnose
