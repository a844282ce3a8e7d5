#pragma once
/// \file
/// The files that a verb writes: none is one that it reads, no two are the same, and all are found to be
/// writable before the work.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <list>
#include <map>
#include <string>
#include <vector>

#include "support/files/file_identity.hpp"
#include "support/files/output_file.hpp"
#include "support/page/provenance.hpp"

namespace plumbline::app {

class Outputs {
 public:
  /// \param inputs  every file that the verb reads; an empty path is none
  Outputs(const CLI::App& verb, std::vector<std::filesystem::path> inputs);

  /// \param option  that names the file, for messages
  /// \param path    "-" for standard output
  /// \returns nothing for an empty path
  /// \throws Error where the file is read or written already, by whatever name or link, or cannot be written
  files::OutputFile* open(const std::string& option, const std::filesystem::path& path);

  /// Of what is written: the inputs as they were when the first file was opened.
  [[nodiscard]] const page::Provenance& provenance() const { return provenance_; }

  /// Lets go of a file that was opened: it will not be written.
  void withdraw(const files::OutputFile* file);

  /// Lets all files appear, once all are on the disk, and says so to a terminal. \throws Error when one does
  /// not fit: then none does
  void commit();

 private:
  std::vector<std::filesystem::path> inputs_;
  page::Provenance provenance_;
  std::map<files::FileIdentity, std::string> taken_;  ///< and what for
  std::list<files::OutputFile> files_;
  std::vector<std::string> written_;  ///< their names, but for standard output
};

}  // namespace plumbline::app
