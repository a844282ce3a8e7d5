#pragma once
/// \file
/// Columns of sensors that measure an arm beside a tracker: distances, pictures, levels, heights.

#include <string>
#include <vector>

#include "diagnose/bench/arm_sensor.hpp"
#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

struct SensorColumns {
  std::string name;  ///< of the sensor: its title, as a column can have it
  const ArmSensorKind* kind;
  std::vector<std::size_t> columns;  ///< as many as it reads numbers
};

/// The sensors whose columns a table has, by their titles: a distance, or two of one name that end in u and
/// v, or in x and y.
std::vector<SensorColumns> sensor_columns(const RunSource& source);

}  // namespace plumbline::diagnose
