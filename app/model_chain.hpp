#pragma once
/// \file
/// Chain files: TOML, the output of `plumbline chain`, and simulators' models.

#include <filesystem>
#include <string>

namespace plumbline::app {

/// Whether a file of this name has a chain: ours, or a simulator's model.
bool names_chain_file(const std::filesystem::path& path);

/// The text of a chain file; of a simulator's model that of its chain. A chain weighs nothing: that the file
/// has weights is said on standard error. \throws Error as files::read_text() and exchange::read_model() do
std::string read_chain_text(const std::filesystem::path& path);

}  // namespace plumbline::app
