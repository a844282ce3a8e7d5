#pragma once
/// \file
/// Experiment folders in the format "chain-experiment/1".

#include <filesystem>

#include "trial/simulator/make_experiment.hpp"

namespace plumbline::simulator {

/// Writes experiment.toml and a sample file a run: all that the lab knows, and nothing of the label. The
/// folder is made.
void write_experiment(const Experiment& experiment, const std::filesystem::path& folder);

}  // namespace plumbline::simulator
