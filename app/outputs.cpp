#include "app/outputs.hpp"

#include <fmt/ranges.h>

#include <plumbline/base/error.hpp>

#include "app/arguments.hpp"
#include "app/command.hpp"
#include "app/terminal.hpp"
#include "support/files/sha256.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

/// A terminal or /dev/null takes whatever comes.
bool is_device(const fs::path& path) {
  std::error_code ignored;
  return fs::is_character_file(path, ignored);
}

}  // namespace

Outputs::Outputs(const CLI::App& verb, std::vector<fs::path> inputs) : inputs_(std::move(inputs)) {
  std::erase(inputs_, fs::path());
  provenance_ = {program_name(), asked(verb, inputs_), ""};
  for (const fs::path& input : inputs_)
    if (!files::is_standard_input(input)) taken_.emplace(files::identity(input), "the input itself");
}

files::OutputFile* Outputs::open(const std::string& option, const fs::path& path) {
  if (path.empty()) return nullptr;
  const bool printed = files::is_standard_output(path);
  if (printed || !is_device(path)) {
    const std::string name = printed ? "standard output" : path.string();
    const auto take = [&](const files::FileIdentity& file) {
      const auto [other, free] = taken_.emplace(file, "the file of " + option + " too");
      if (!free) throw Error(option + " " + name, other->second, "another file for the output");
    };
    if (printed) take({0, 0, "-"});
    if (!printed || !is_device("/dev/stdout")) take(files::identity(printed ? "-" : path));
  }
  if (files_.empty() && !inputs_.empty()) provenance_.inputs = files::sha256(inputs_);
  if (!printed) written_.push_back(path.string());
  return &files_.emplace_back(path);
}

void Outputs::withdraw(const files::OutputFile* file) {
  std::erase(written_, file->path().string());
  files_.remove_if([&](const files::OutputFile& one) { return &one == file; });
}

void Outputs::commit() {
  for (files::OutputFile& file : files_) file.complete();
  for (files::OutputFile& file : files_) file.commit();
  if (terminal_columns(2) == 0) return;
  constexpr std::size_t most = 5;  // by name; of a whole folder the number says enough
  if (written_.size() > most)
    fmt::print(stderr, "plumbline: wrote {} files\n", written_.size());
  else if (!written_.empty())
    fmt::print(stderr, "plumbline: wrote {}\n", fmt::join(written_, ", "));
}

}  // namespace plumbline::app
