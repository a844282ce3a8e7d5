#pragma once
/// \file
/// Reads an experiment folder: experiment.toml and the sample files that it names.

#include <filesystem>
#include <functional>
#include <string>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/read_arm.hpp"
#include "diagnose/bench/sample_columns.hpp"

namespace plumbline::diagnose {

/// Reads format "chain-experiment/1".
/// \param model  replaces the table [nominal], which may then be absent
/// \param arm    reads the model's file that a table [arm] names
/// \throws Error, one line with the file, the line or key, what was found and what was expected: a missing
///         file or key, an unknown key or format, a wrong type or length, a field that is not a finite
///         number, a negative length or stiffness, a repeated run id, a sample file outside the folder,
///         readings that the chain cannot reach, too few of them to judge anything, or runs of several states
Experiment read_experiment(const std::filesystem::path& folder, const NominalChain* model = nullptr,
                           const ReadArm& arm = {});

/// The same, with these settings in place of those of experiment.toml.
Experiment read_experiment(const std::filesystem::path& folder, const toml::table& settings,
                           const NominalChain* model = nullptr, const ReadArm& arm = {});

/// The samples of a run, in one part or several.
/// \param run     its table: the key `samples` says which samples
/// \param format  that the experiment and the run declare
/// \throws Error that names the key, or the source
using ReadParts = std::function<std::vector<SamplePart>(const Section& run, const SampleFormat& format)>;

/// An experiment in memory: the same keys, checked by the same rules.
/// \param settings  the contents of experiment.toml
/// \param source    named in errors
/// \param arm       reads the model's file that a table [arm] names, wherever it is
Experiment read_experiment(const toml::table& settings, const std::string& source, const ReadParts& read,
                           const NominalChain* model = nullptr, const ReadArm& arm = {});

/// Reads the text of experiment.toml, or of a sample file that it names.
/// \throws Error at the place of the name, or that names the file
using ReadFile = std::function<std::string(const std::string& name, const std::string& place)>;

/// The same from any source of files.
/// \param folder  named in errors
Experiment read_experiment(const std::filesystem::path& folder, const ReadFile& read,
                           const NominalChain* model = nullptr);

/// The same before any measurement. A run without samples describes the bench by its control and rest shape,
/// and has no readings; of other runs the commands count. All channels with a noise are measured; their
/// values are empty, or taken as empty. Of an arm in space every run has its poses.
///
/// \throws Error likewise, and where a run measures nothing that has a noise
Experiment read_plan(const std::filesystem::path& folder, const NominalChain* model = nullptr,
                     const ReadArm& arm = {});
Experiment read_plan(const std::filesystem::path& folder, const ReadFile& read,
                     const NominalChain* model = nullptr);
Experiment read_plan(const toml::table& settings, const std::string& source, const ReadParts& read,
                     const NominalChain* model = nullptr);

}  // namespace plumbline::diagnose
