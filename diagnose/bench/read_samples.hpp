#pragma once
/// \file
/// Reads the samples of one run.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/sample_columns.hpp"

namespace plumbline::diagnose {

/// The contents of a sample file.
struct Samples {
  std::vector<Reading> readings;  ///< in SI; an empty measured field is NaN
  std::vector<Origin> origins;    ///< of each column
  /// By reading, the columns that say neither channel nor command, and the place of its line.
  std::vector<std::vector<double>> further;
  std::vector<std::string> where;
};

/// Parts that have the same channels follow one another. Parts that have different ones were taken at the
/// same times and are joined by these. Time, the imposed channels and commanded joint angles may not be
/// empty; the run ends where all its columns but the time are empty to the end.
/// \param parts  at least one
/// \throws Error that names the source and the line
Samples read_samples(const std::vector<SamplePart>& parts, Control control);

}  // namespace plumbline::diagnose
