#pragma once
/// \file
/// Where a verb with much to do leaves its results.

#include <filesystem>
#include <optional>
#include <string>

#include "support/files/temporary_folder.hpp"
#include "support/work/journal.hpp"

namespace plumbline::app {

/// The folder that the user names, with a journal of what is done in it, or one for a while, without.
class ResultsFolder {
 public:
  /// \param option   that names the folder
  /// \param wanted   the folder; empty where none is named
  /// \param command  what is done, as the user would say it
  /// \throws Error where ranks of mpirun have no folder that all of them see, or as work::Journal does
  ResultsFolder(const std::string& option, const std::string& wanted, const std::string& command);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Nothing of a folder for a while.
  [[nodiscard]] work::Journal* journal() { return journal_ ? &*journal_ : nullptr; }

 private:
  std::optional<files::TemporaryFolder> temporary_;
  std::filesystem::path path_;
  std::optional<work::Journal> journal_;
};

}  // namespace plumbline::app
