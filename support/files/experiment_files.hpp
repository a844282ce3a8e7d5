#pragma once
/// \file
/// The files that make up an experiment.

#include <filesystem>
#include <vector>

namespace plumbline::files {

/// What a diagnosis may see of an experiment, as paths inside its folder: experiment.toml and the samples
/// and the model of an arm that it names. Not what lies outside the folder (behind a link, too), is no plain
/// file, or is the label.
std::vector<std::filesystem::path> experiment_files(const std::filesystem::path& folder);

/// The same with the folder before each; none of no folder.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& folder);

/// Every file that a trial of this folder reads, by name: experiments, labels, seals. None of no folder.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder);

}  // namespace plumbline::files
