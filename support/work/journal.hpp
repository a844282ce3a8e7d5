#pragma once
/// \file
/// What is done of an unfinished work, on disk.

#include <filesystem>
#include <map>
#include <string>

namespace plumbline::work {

/// The name that it has in a folder of results.
inline constexpr const char* unfinished_name = "unfinished.jsonl";

/// The results that the text of a journal holds, by the digest of the item.
/// \param header  the first line of a journal of the work that is to go on
/// \param source  names the text in errors
/// \throws Error where it is none, or that of another work or build; a line that is none counts for nothing
std::map<std::string, std::string> unfinished_results(const std::string& text, const std::string& header,
                                                      const std::string& source);

/// A file with the result of every item that is done, written as they come, so that the same command, begun
/// again after it was cut off, goes on where it was. It is there as long as the work is unfinished. Lines of
/// JSON: first {"format": "plumbline-unfinished/1", "program": SHA-256 of the executable, "work": …}, then
/// {"item": SHA-256 of the item, "result": …} each; a last line that is not whole counts for nothing.
class Journal {
 public:
  /// Opens the file or begins it.
  /// \param work  says what is done, as the user would
  /// \throws Error where it holds another work, or that of another build of the program, is no such file, is
  ///         in use, or cannot be written
  Journal(std::filesystem::path file, const std::string& work);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  /// The result of an item that is done; nothing for another.
  [[nodiscard]] const std::string* find(const std::string& item) const;
  /// \throws Error when it cannot be written
  void add(const std::string& item, const std::string& result);
  /// The work is done: removes the file.
  void finish();

 private:
  void read(const std::string& header);
  void write_line(const std::string& line);
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;

  std::filesystem::path path_;
  int file_ = -1;
  std::map<std::string, std::string> results_;  ///< by the digest of the item
};

}  // namespace plumbline::work
