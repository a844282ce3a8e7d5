#pragma once
/// \file
/// Files written completely or not at all.

#include <filesystem>
#include <string>

namespace plumbline::files {

/// A file that appears, complete, with `commit()`; without it what stood there before still stands, and
/// nothing is left behind, however the process ends: the draft has no name (open(2), O_TMPFILE) where the
/// file system can do that. Mode and links of a file that is replaced stay. What cannot be replaced whole (a
/// device, a pipe, a file with further names or of another owner) is written in place. "-" is standard
/// output.
class OutputFile {
 public:
  /// Finds out, before any work, whether the file can be written.
  /// \throws Error that names the file when it cannot
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// As the user wrote it.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void write(const std::string& text) { text_ += text; }
  /// Puts the draft on the disk.
  /// \throws Error when it does not fit
  void complete();
  /// Lets the file appear.
  /// \throws Error when not everything could be written
  void commit();

 private:
  [[noreturn]] void fail(const std::string& found) const;
  void open_in_place();
  void open_draft();
  void write_in_place();
  void give_name();

  std::filesystem::path path_;    ///< as the user wrote it
  std::filesystem::path target_;  ///< the file behind symbolic links
  std::filesystem::path draft_;   ///< its name, where the file system knows no file without one
  std::string text_;
  int file_ = -1;
  bool in_place_ = false, completed_ = false;
};

/// A whole file at once.
/// \throws Error as OutputFile does
void write_text(const std::filesystem::path& path, const std::string& text);

/// Makes a folder, and those around it, unless it is there.
/// \throws Error that names it when it cannot be made
void make_folder(const std::filesystem::path& path);

/// Finds out, before any work, whether a folder can be written into, or made.
/// \throws Error that names it when it cannot
void require_folder(const std::filesystem::path& path);

}  // namespace plumbline::files
