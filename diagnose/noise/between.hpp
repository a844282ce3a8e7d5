#pragma once
/// \file
/// Readings that were taken close to each other on the path, at other times: what tells them apart is noise,
/// or what changes with time, and not the shape of a curve, however coarsely it was sampled.

#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// A value between two others of its series that were read at places of the path before and after its own, at
/// other times.
struct Between {
  std::size_t value, before, after;  ///< by their number in the series
  double share;                      ///< of `after` in the line between the two

  /// Sum of the squares of the three coefficients.
  [[nodiscard]] double squares() const;
  /// What it is off that line, over what it would be were the two exact.
  [[nodiscard]] double off(const double* values) const;
};

/// Values beside which others were read, on another way in the same direction; in either direction, where few
/// were.
/// \param readings  of the values, by their places in the run, ascending
std::vector<Between> between(const Run& run, const std::vector<std::size_t>& readings);

}  // namespace plumbline::diagnose
