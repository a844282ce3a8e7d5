#pragma once
/// \file
/// Folder of a drafted experiment.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"

namespace plumbline::app {

struct ReadForDraft {
  diagnose::DraftModel model;
  std::vector<std::string> notes;  ///< what was read of the model, what assumed, what left out
};

/// \param joints  that make the chain; empty: all
/// \throws Error as exchange::read_model() does
ReadForDraft read_for_draft(const std::filesystem::path& model, const std::vector<std::string>& joints);

/// The files of the folder by name, the schema for editors among them.
std::vector<diagnose::DraftFile> files_of(const diagnose::Draft& draft);
/// Writes them. \throws Error where one cannot be written
void write_draft(const diagnose::Draft& draft, const std::filesystem::path& folder);

}  // namespace plumbline::app
