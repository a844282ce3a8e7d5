#pragma once
/// \file
/// The columns of a table of an arm's poses, in SI.

#include <optional>
#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"
#include "diagnose/draft/sensor_columns.hpp"

namespace plumbline::diagnose {

struct ArmColumn {
  std::string name;  ///< as docs/arms.md has it
  std::vector<double> values;
  std::optional<Channel::Name> reads = {};  ///< the kind of channel; none where it is a command or a load
};

struct ArmRun {
  std::string id;
  std::vector<ArmColumn> columns;
  std::vector<std::vector<double>> commands;  ///< by reading, of all joints, rad or m
  std::vector<Eigen::Vector3d> places;    ///< by reading, NaN where nothing was read; in a unit of its own
  std::string unit_of_place;              ///< or empty
  std::vector<Eigen::Quaterniond> turns;  ///< by reading, or empty
  std::vector<SensorColumns> sensors;     ///< beside the tracker
  std::vector<std::size_t> used;          ///< columns of its source
  Guesses guesses;
};

/// \throws Error where some joint has neither a commanded nor a reached angle
ArmRun arm_run(const RunSource& source, const DraftModel& model);

}  // namespace plumbline::diagnose
