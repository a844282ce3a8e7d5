#pragma once
/// \file
/// What counts as slow in a series of readings: its first cosine components.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::diagnose {

/// How many components of a series of so many readings are slow: six, a third of a short one.
inline std::size_t slow_components(std::size_t count) {
  return std::min<std::size_t>(6, (count + 2) / 3);
}

/// Orthonormal cosine wave k of a series of so many readings.
inline Eigen::VectorXd cosine_wave(std::size_t count, std::size_t k) {
  const auto m = static_cast<double>(count);
  const Eigen::ArrayXd middle = Eigen::ArrayXd::LinSpaced(static_cast<Eigen::Index>(count), 0.5, m - 0.5);
  return (middle * (std::numbers::pi * static_cast<double>(k) / m)).cos() *
         std::sqrt((k == 0 ? 1.0 : 2.0) / m);
}

}  // namespace plumbline::diagnose
