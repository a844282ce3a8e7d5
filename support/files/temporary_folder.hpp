#pragma once
/// \file
/// A place for files that nobody is to keep.

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace plumbline::files {

/// A new, empty folder of our own that goes, with all that is in it, when its owner goes: also where the
/// process is killed, for then a process that waits for just that removes it.
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
  void watch();
  void dismiss() const;

  std::filesystem::path path_;
  pid_t guard_ = -1;  ///< the process that waits
  int alive_ = -1;    ///< the end of a pipe that the system closes when this process dies
};

}  // namespace plumbline::files
