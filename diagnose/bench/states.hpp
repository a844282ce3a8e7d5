#pragma once
/// \file
/// States of a device whose runs stand in one experiment.toml: `[[run]] state = "before"`.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// The states that the runs name, in the order in which they first stand there; empty where none does.
std::vector<std::string> states_in(const std::filesystem::path& folder);

/// The settings of experiment.toml with the runs of one state alone.
/// \throws Error where no run has the state
toml::table settings_of(const std::filesystem::path& folder, const std::string& state);

/// Runs of a device before and after something changed are no one experiment.
/// \throws Error where runs name several states
void require_one_state(const Section& root);

}  // namespace plumbline::diagnose
