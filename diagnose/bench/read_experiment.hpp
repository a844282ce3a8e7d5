#pragma once
/// \file
/// Reading an experiment folder: experiment.toml and the sample files that it names.

#include <filesystem>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Reads format "chain-experiment/1".
/// \throws Error, one line with the file, the line or key, what was found and what was expected: a missing
///         file or key, an unknown key or format, a wrong type or length, a field that is not a finite
///         number, a negative length or stiffness, a repeated run id, a sample file outside the folder,
///         readings that the chain cannot reach, or too few of them to judge anything
Experiment read_experiment(const std::filesystem::path& folder);

}  // namespace plumbline::diagnose
