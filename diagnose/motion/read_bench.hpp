#pragma once
/// \file
/// Reads an experiment of motion: experiment.toml, the table of its logs, and the logs.

#include <filesystem>

#include "diagnose/motion/bench.hpp"

namespace plumbline::motion {

/// Whether experiment.toml in this folder is of the format "motion/1".
bool is_motion(const std::filesystem::path& folder);

/// Reads format "motion/1" (docs/motion.md).
/// \throws Error, one line with the file, the line or key, what was found and what was expected
Bench read_bench(const std::filesystem::path& folder);

/// The same rig with the motions that `[[motion]]` plans, whether or not it has logs: commands without
/// readings.
/// \throws Error as read_bench() does
Bench read_planned_bench(const std::filesystem::path& folder);

}  // namespace plumbline::motion
