#pragma once
/// \file
/// Loads along the chain: known loads that act elsewhere than at the end point. Their values are covariates
/// of the readings.

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {

/// A tendon or a pressure that turns joints, or a force on a link.
struct Load {
  enum class Kind { tendon, pressure, force } kind;
  std::size_t covariate =
      0;  ///< the tension, N, or the pressure, Pa; of a force that along x, before that along y
  std::vector<double> moment_arm = {};  ///< by joint, moment over value, m or m³; empty for a force
  std::size_t link = 0;                 ///< on which a force acts, from 0
  double at = 1;                        ///< share of the link's length at which it does

  /// Number of its values, and what they are.
  [[nodiscard]] std::size_t values() const { return kind == Kind::force ? 2 : 1; }
  [[nodiscard]] const Quantity& quantity() const {
    return kind == Kind::pressure ? quantity::pressure : quantity::force;
  }
};

/// One value of a load, as part of what a run commands.
struct LoadChannel {
  std::size_t covariate;
  std::string name, unit;
  Eigen::Vector2d moves;  ///< by how much one unit of it moves Run::command()
};

/// The values of all loads. Each moves the command by the force on the end point that turns a joint as much.
/// \param names  of the covariates
std::vector<LoadChannel> load_channels(const std::vector<Load>& loads, const std::vector<double>& link_length,
                                       const std::vector<std::string>& names);

}  // namespace plumbline::diagnose
