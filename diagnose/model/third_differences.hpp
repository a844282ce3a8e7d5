#pragma once
/// \file
/// What the noise of readings is, seen in the readings themselves: no model enters.

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

/// Mean of the products of neighbours over the larger of their squares, so that a step in a curve counts no
/// more than noise does; those of independent noise alternate.
double alternation(const std::vector<ThirdDifferences>& series);

/// Standard deviation of all sizes by their median; zero where most of them are.
double spread(const std::vector<ThirdDifferences>& series);

/// The differences without those that an outlier or a step enters: one reading that is off spoils four in a
/// row, the two in the middle most. Of what is large all along the noise is.
std::vector<ThirdDifferences> without_steps(std::vector<ThirdDifferences> series);

/// Sizes whose standard deviations are s sqrt(1 + r^2 level^2).
struct Proportion {
  double ratio = 0;             ///< r
  double common = 0;            ///< s, the one that is most likely
  double twice_likelihood = 0;  ///< with it, logarithmic
};

/// \param series  of which some size is not zero
Proportion in_proportion(const std::vector<ThirdDifferences>& series, double r);

/// Of no proportion, and of all that readings up to `reach` can show, ascending.
std::vector<double> possible_ratios(double reach);

}  // namespace plumbline::diagnose
