#pragma once
/// \file
/// Both sides of the balance of torque, as means over stretches of a log.

#include <Eigen/Core>
#include <vector>

#include "diagnose/motion/balance/torque_log.hpp"

namespace plumbline::motion {

/// Means of the balance over stretches of a log: columns, and torques for each lead that is tried.
struct Stretches {
  std::vector<double> time;
  std::vector<Eigen::MatrixXd> columns;              ///< joints by terms
  std::vector<std::vector<Eigen::VectorXd>> torque;  ///< by lead, then by stretch
};

/// Leads of the torque ahead of the motion that are tried, s.
const std::vector<double>& leads();

/// Duration of a stretch, s, and of blocks of them that are independent of each other, s.
inline constexpr double mean_of_balance = 0.1, block_duration = 0.5;

Stretches stretches_of(const diagnose::NominalArm& arm, const TorqueLog& log);

}  // namespace plumbline::motion
