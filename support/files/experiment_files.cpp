#include "support/files/experiment_files.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "support/files/text_file.hpp"
#include "support/files/toml_file.hpp"

namespace plumbline::files {
namespace {

namespace fs = std::filesystem;

/// The names in `samples`: one, or a list of names and of tables with a key `file`.
void add_names(const toml::node_view<const toml::node>& samples, std::vector<std::string>& names) {
  if (const auto name = samples.value<std::string>()) names.push_back(*name);
  const toml::array* parts = samples.as_array();
  for (std::size_t i = 0; parts != nullptr && i < parts->size(); ++i) {
    const toml::table* const part = parts->get(i)->as_table();
    const auto name =
        part != nullptr ? (*part)["file"].value<std::string>() : parts->get(i)->value<std::string>();
    if (name) names.push_back(*name);
  }
}

/// The names of sample files and of an arm's model; none where the file is not one that the diagnosis can
/// read, which it will say.
std::vector<std::string> named_files(const fs::path& settings) {
  std::vector<std::string> names;
  try {
    const toml::table table = parse_toml(read_text(settings), settings.string());
    if (const auto model = table["arm"]["model"].value<std::string>()) names.push_back(*model);
    const toml::array* runs = table["run"].as_array();
    for (std::size_t i = 0; runs != nullptr && i < runs->size(); ++i)
      if (const toml::table* run = runs->get(i)->as_table()) add_names((*run)["samples"], names);
  } catch (const Error&) {
    return {};
  }
  return names;
}

bool leads_out(const fs::path& relative) {
  return relative.empty() || relative.is_absolute() || *relative.begin() == "..";
}

/// Whether the file, behind its links, lies inside the folder and is a plain file other than the label.
bool may_be_seen(const fs::path& folder, const fs::path& name) {
  std::error_code error;
  const fs::path file = fs::canonical(folder / name, error);
  if (error || leads_out(name.lexically_normal())) return false;
  if (leads_out(file.lexically_relative(fs::canonical(folder, error)))) return false;
  return fs::is_regular_file(file, error) && !fs::equivalent(file, folder / "label.json", error);
}

}  // namespace

std::vector<fs::path> experiment_files(const fs::path& folder) {
  std::vector<fs::path> files;
  const fs::path settings = "experiment.toml";
  if (!may_be_seen(folder, settings)) return files;
  files.push_back(settings);
  for (const std::string& name : named_files(folder / settings))
    if (may_be_seen(folder, name)) files.emplace_back(name);
  return files;
}

std::vector<fs::path> files_read(const fs::path& folder) {
  std::vector<fs::path> files;
  if (folder.empty()) return files;
  for (const fs::path& file : experiment_files(folder)) files.push_back(folder / file);
  return files;
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!fs::exists(entry.path() / "experiment.toml", error)) continue;
    for (const fs::path& file : files_read(entry.path())) files.push_back(file);
    files.push_back(entry.path() / "label.json");
  }
  files.push_back(folder / "seals.json");
  for (const auto& entry : fs::directory_iterator(folder / "labels", error)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return folder.empty() ? std::vector<fs::path>() : files;
}

}  // namespace plumbline::files
