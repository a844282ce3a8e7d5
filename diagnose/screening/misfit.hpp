#pragma once
/// \file
/// How far readings are from a prediction, in any unit.

#include <algorithm>
#include <vector>

#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

/// Sums of squares of a measured column of one run, from the unloaded state on, and of its prediction.
struct ColumnSums {
  Channel channel{};
  double measured = 0, predicted = 0, product = 0;
  std::size_t count = 0;

  [[nodiscard]] double energy() const { return measured + predicted; }
  [[nodiscard]] double difference() const { return std::max(0.0, energy() - 2 * product); }
};

using RunSums = std::vector<ColumnSums>;  ///< of one run

/// By run, the columns that hold readings.
std::vector<RunSums> compare(const Experiment& experiment, const Prediction& prediction);

/// The sum of squares of all columns of one's sensor.
double energy_of_sensor(const RunSums& columns, const ColumnSums& one);

/// Misfit of a column in any unit: 0 for agreement, 1 for no relation, 2 for a mirror image. A column that is
/// small beside the others of its sensor counts less.
double misfit(const RunSums& columns, const ColumnSums& one);

/// The largest misfit of a run's columns.
double worst(const RunSums& columns);

}  // namespace plumbline::diagnose
