#include "diagnose/screening/misfit.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// Values missing in the prediction count as unloaded; values that a conversion could not read are left out.
ColumnSums compare(const Channel& channel, const Run& run, const Trace& predicted, double unloaded) {
  ColumnSums column{channel};
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const double m = channel.of(run.readings[i]) - unloaded;
    if (!std::isfinite(m)) continue;
    ++column.count;
    const double value = predicted(static_cast<Eigen::Index>(i), channel.column);
    const double p = std::isfinite(value) ? value - unloaded : 0;
    column.measured += m * m;
    column.predicted += p * p;
    column.product += m * p;
  }
  return column;
}

double unloaded_value(const Channel& channel, const Vector2& end, const std::vector<double>& rest) {
  if (channel.column == column_x) return end.x();
  if (channel.column == column_y) return end.y();
  return channel.name == Channel::Name::q ? rest[channel.joint] : 0;
}

}  // namespace

std::vector<RunSums> compare(const Experiment& experiment, const Prediction& prediction) {
  std::vector<RunSums> runs(experiment.runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    for (const Channel& channel : run.measured()) {
      const double unloaded = unloaded_value(channel, unloaded_end(experiment, run.rest), run.rest);
      const ColumnSums column = compare(channel, run, prediction.runs[r], unloaded);
      if (column.count > 0) runs[r].push_back(column);
    }
  }
  return runs;
}

double energy_of_sensor(const RunSums& columns, const ColumnSums& one) {
  double sum = 0;
  for (const ColumnSums& other : columns)
    if (other.channel.sensor() == one.channel.sensor()) sum += other.energy();
  return sum;
}

double misfit(const RunSums& columns, const ColumnSums& one) {
  constexpr double beside = 0.05;
  const double sensor = energy_of_sensor(columns, one);
  return sensor > 0 ? one.difference() / (one.energy() + beside * sensor) : 0;
}

double worst(const RunSums& columns) {
  double most = 0;
  for (const ColumnSums& one : columns) most = std::max(most, misfit(columns, one));
  return most;
}

}  // namespace plumbline::diagnose
