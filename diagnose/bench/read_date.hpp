#pragma once
/// \file
/// The date of an experiment.

#include <chrono>
#include <filesystem>
#include <optional>

#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// The key `date`, a TOML date or a text of that form; nothing without it.
/// \throws Error that names file, line and key for another value
std::optional<std::chrono::sys_days> read_date(const Section& root);

/// The date of the experiment in a folder; nothing where it has none or cannot be read.
std::optional<std::chrono::sys_days> date_of(const std::filesystem::path& folder);

}  // namespace plumbline::diagnose
