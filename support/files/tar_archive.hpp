#pragma once
/// \file
/// Files in one: an archive as every system opens it (POSIX.1-1988, ustar).

#include <string>

namespace plumbline::files {

class TarArchive {
 public:
  /// A plain file that its owner may write and everybody read.
  /// \throws Error where the name is longer than 100 bytes or the text than 8 GB
  void add(const std::string& name, const std::string& text);
  /// The archive with all that was added.
  [[nodiscard]] std::string bytes() const;

 private:
  std::string blocks_;
};

}  // namespace plumbline::files
