#pragma once
/// \file
/// The day of an experiment.

#include <chrono>
#include <filesystem>
#include <optional>

#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// The key `date`, a TOML date or a text like one; nothing without it.
/// \throws Error that names file, line and key where it is no day
std::optional<std::chrono::sys_days> read_date(const Section& root);

/// The day of the experiment in a folder; nothing, too, where its file cannot be read.
std::optional<std::chrono::sys_days> date_of(const std::filesystem::path& folder);

}  // namespace plumbline::diagnose
