#pragma once
/// \file
/// Experiments with their labels, as folders.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::bench {
using namespace diagnose;

/// Writes experiment.toml, a sample file a run, and label.json.
void write_labelled(const std::filesystem::path& folder, const Experiment& experiment,
                    const nlohmann::json& label);

}  // namespace plumbline::bench
