#pragma once
/// \file
/// Whole text files: read or refused with a reason, written completely or not at all.

#include <filesystem>
#include <fstream>
#include <string>

namespace plumbline::files {

/// The content of a file.
/// \throws Error that names the file: missing, a directory, not readable, or empty
std::string read_text(const std::filesystem::path& path);

/// Makes a folder, and those around it, unless it is there. Best asked for before the work, so that a mistake
/// shows at once.
/// \throws Error that names it when it cannot be made
void make_folder(const std::filesystem::path& path);

/// A file that appears, complete, with `commit()`; without it nothing is left behind and what stood there
/// before still stands. "-" is standard output.
class OutputFile {
 public:
  /// \throws Error that names the file when it cannot be written
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(const std::string& text);
  /// \throws Error when not everything could be written
  void commit();

 private:
  [[noreturn]] void fail(const std::string& found) const;

  std::filesystem::path path_;     ///< as the user wrote it
  std::filesystem::path target_;   ///< the file behind symbolic links
  std::filesystem::path written_;  ///< a draft beside the target, or a device itself
  std::ofstream stream_;
};

/// A whole file at once. \throws Error as OutputFile does
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace plumbline::files
