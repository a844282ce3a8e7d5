#pragma once
/// \file
/// What the noise of readings is, seen in the readings themselves: no model enters.

#include <vector>

#include "diagnose/noise/between.hpp"

namespace plumbline::diagnose {

/// Differences of the values of one series that a smooth curve hardly has, and noise wholly.
struct Differences {
  std::vector<double> sizes;   ///< noise of the declared sigma gives them a standard deviation of one
  std::vector<double> levels;  ///< how large the values themselves are, weighed as their noise enters

  Differences() = default;
  /// Third differences, which a parabola has not; its are the levels.
  /// \param values  in the order in which they were taken, of any length
  /// \param sigma   the declared noise
  Differences(const std::vector<double>& values, double sigma);
  /// Those of values from their neighbours on the path, which may be sampled as coarsely as it likes.
  Differences(const std::vector<double>& values, double sigma, const std::vector<Between>& between);

  /// Those of which `even` says so, by the first of the four values.
  [[nodiscard]] Differences where(const std::vector<bool>& even) const;
};

/// Both kinds of one series.
struct SeenNoise {
  Differences in_time;   ///< third differences
  Differences in_place;  ///< of values from their neighbours on the path
};

/// By reading, whether the command goes on alike from it to the next, to the one after and to the third:
/// there alone third differences are of noise, and not of a corner of the path, of steps and holds. \param
/// readings  their places in the run, ascending; three results fewer than these
std::vector<bool> goes_evenly(const Run& run, const std::vector<std::size_t>& readings);

/// Mean of the products of neighbours over the larger of their squares, so that a step in a curve counts no
/// more than noise does; those of independent noise alternate.
double alternation(const std::vector<Differences>& series);

/// How many there are.
std::size_t count_of(const std::vector<Differences>& series);

/// The largest level; zero of none.
double reach_of(const std::vector<Differences>& series);

/// Standard deviation of all sizes by their median, beside a share of themselves by which readings scatter as
/// well; zero where most of them are.
double spread(const std::vector<Differences>& series, double ratio = 0);

/// The differences without those that an outlier or a step enters: one reading that is off spoils four in a
/// row, the two in the middle most. Of what is large all along the noise is.
std::vector<Differences> without_steps(std::vector<Differences> series);

/// Sizes whose standard deviations are s sqrt(1 + r^2 level^2).
struct Proportion {
  double ratio = 0;             ///< r
  double common = 0;            ///< s, the one that is most likely
  double twice_likelihood = 0;  ///< with it, logarithmic
};

/// \param series  of which some size is not zero
Proportion in_proportion(const std::vector<Differences>& series, double r);

/// Of no proportion, and of all that readings up to `reach` can show, ascending.
std::vector<double> possible_ratios(double reach);

}  // namespace plumbline::diagnose
