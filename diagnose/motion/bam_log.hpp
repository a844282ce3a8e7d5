#pragma once
/// \file
/// Logs as BAM (better actuator models) records them: JSON with numbers of the rig, and a list of entries.

#include <nlohmann/json.hpp>

#include "diagnose/motion/log_table.hpp"

namespace plumbline::motion {

struct BamLog {
  nlohmann::json rig;  ///< "kp", "mass", "length", "arm_mass", "vin", ...
  LogTable entries;    ///< columns "timestamp", "position", "goal_position", "torque_enable" (1 or 0), ...
};

/// \throws Error that names the source: no JSON, no list "entries", or entries that have not the same keys
BamLog bam_log(const std::string& text, const std::string& source);

}  // namespace plumbline::motion
