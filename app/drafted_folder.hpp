#pragma once
/// \file
/// Folder of a drafted experiment.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"

namespace plumbline::app {

/// The files of the folder by name, the schema for editors among them.
std::vector<diagnose::DraftFile> files_of(const diagnose::Draft& draft);
/// Writes them. \throws Error where one cannot be written
void write_draft(const diagnose::Draft& draft, const std::filesystem::path& folder);

}  // namespace plumbline::app
