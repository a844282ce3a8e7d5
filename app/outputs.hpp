#pragma once
/// \file
/// The files that a verb writes: none is an input, no two are the same, and all are writable before the work
/// begins.

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

  /// \param option  the option of the file, for messages
  /// \param path    "-" for standard output
  /// \returns nothing for an empty path
  /// \throws Error where the file is read or written already, by whatever name or link, or cannot be written
  files::OutputFile* open(const std::string& option, const std::filesystem::path& path);

  /// The digest of the inputs when the first file was opened.
  [[nodiscard]] const page::Provenance& provenance() const { return provenance_; }

  /// Releases a file without writing it.
  void withdraw(const files::OutputFile* file);

  /// Publishes all files once they are on the disk, and says so to a terminal.
  /// \throws Error when one does not fit; then none is published
  void commit();

 private:
  std::vector<std::filesystem::path> inputs_;
  page::Provenance provenance_;
  std::map<files::FileIdentity, std::string> taken_;  ///< and what for
  std::list<files::OutputFile> files_;
  std::vector<std::string> written_;  ///< their names, but for standard output
};

}  // namespace plumbline::app
