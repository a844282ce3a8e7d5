#pragma once
/// \file
/// The folder for the results of long work.

#include <filesystem>
#include <optional>
#include <string>

#include "support/files/temporary_folder.hpp"
#include "support/work/journal.hpp"

namespace plumbline::app {

/// The folder that the user names, with a journal, or else a temporary one.
class ResultsFolder {
 public:
  /// \param option   the option of the folder
  /// \param wanted   the folder; empty for a temporary one
  /// \param command  the work, as the user would type it
  /// \throws Error where ranks of mpirun have no common folder, or as work::Journal does
  ResultsFolder(const std::string& option, const std::string& wanted, const std::string& command);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Null for a temporary folder.
  [[nodiscard]] work::Journal* journal() { return journal_ ? &*journal_ : nullptr; }

 private:
  std::optional<files::TemporaryFolder> temporary_;
  std::filesystem::path path_;
  std::optional<work::Journal> journal_;
};

}  // namespace plumbline::app
