#pragma once
/// \file
/// A place for files that nobody is to keep.

#include <filesystem>
#include <string>

namespace plumbline::files {

/// A new, empty folder of our own that goes, with all that is in it, when its owner goes.
class TemporaryFolder {
 public:
  /// \throws Error when it cannot be made
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace plumbline::files
