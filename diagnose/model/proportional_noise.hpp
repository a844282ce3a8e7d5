#pragma once
/// \file
/// Noise that goes with the reading, as load cells and encoders with a gain that flickers have it, found in
/// the readings themselves: no model enters.

#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Third differences of the values of one series: a smooth curve hardly has any, noise is wholly in them.
struct ThirdDifferences {
  std::vector<double> sizes;  ///< noise of the declared sigma gives them a standard deviation of one
  /// Root mean square of the parabola nearest the four values, weighed as their noise enters.
  std::vector<double> levels;

  ThirdDifferences() = default;
  /// \param values  in the order in which they were taken, of any length
  /// \param sigma   the declared noise
  ThirdDifferences(const std::vector<double>& values, double sigma);

  /// Those of which `even` says so, by the first of the four values.
  [[nodiscard]] ThirdDifferences where(const std::vector<bool>& even) const;
};

/// By reading, whether the command goes on alike from it to the next, to the one after and to the third:
/// there alone third differences are of noise, and not of a corner of the path, of steps and holds. \param
/// readings  their places in the run, ascending; three results fewer than these
std::vector<bool> goes_evenly(const Run& run, const std::vector<std::size_t>& readings);

/// By what share of the reading the values of a channel scatter beside what they all scatter, over the
/// latter: their variance is s^2 (1 + r^2 value^2), and r is what is returned, per unit of the values. Zero
/// where uniform noise explains the third differences nearly as well, or where they are those of a curve: the
/// ones of independent noise alternate. Of the shares that explain them nearly alike, as all large ones do
/// where no value is small, it is the one with which s comes nearest to the declared sigma.
double proportional_noise(const std::vector<ThirdDifferences>& series);

}  // namespace plumbline::diagnose
