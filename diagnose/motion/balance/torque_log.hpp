#pragma once
/// \file
/// Logs of an arm whose torques were read: angles and torques of every joint over time.

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_arm.hpp"

namespace plumbline::motion {

/// Rows are readings, columns joints.
struct TorqueLog {
  std::string name;
  std::vector<double> time;  ///< s, ascending
  Eigen::MatrixXd angle;     ///< rad
  Eigen::MatrixXd torque;    ///< N m, of the drives on the joints
};

/// An experiment as it was read: format torque/1.
struct TorqueBench {
  std::string name;
  diagnose::NominalArm arm;
  std::vector<Eigen::Matrix3d> inertia;  ///< by link, about the origin of its frame, kg m^2
  std::vector<TorqueLog> logs, held_out;
};

/// Whether an experiment is one of torques, by the format that its file names.
bool is_torque_bench(const std::filesystem::path& folder);

/// \throws Error with the file, and the key or the line and column
TorqueBench read_torque_bench(const std::filesystem::path& folder);

}  // namespace plumbline::motion
