#include "trial/sealed_folder.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "support/files/json_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/sha256.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::trial {
namespace {

namespace fs = std::filesystem;

Label label_in(const std::string& text, const fs::path& file) {
  return label_from(files::parse_json(text, file.string()), file.string());
}

}  // namespace

SealedFolder::SealedFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code ignored;
  if (!fs::is_directory(folder_, ignored))
    throw Error(folder_.string(), "no such folder", "a folder of experiments");
  for (const auto& entry : fs::directory_iterator(folder_))
    if (fs::exists(entry.path() / "experiment.toml", ignored))
      names_.push_back(entry.path().filename().string());
  std::sort(names_.begin(), names_.end());
  for (const std::string& name : names_) files::require_printable(name, folder_.string());
  if (names_.empty()) throw Error(folder_.string(), "no experiment", "subfolders with experiment.toml");
  if (const fs::path file = folder_ / "seals.json"; fs::exists(file)) {
    const std::string text = files::read_text(file);
    seals_ = parse_seals(text, file.string());
    digest_ = files::sha256(text);
  }
  for (const std::string& name : names_) {
    if (!seals_.contains(name) && !fs::exists(folder_ / name / "label.json"))
      throw Error((folder_ / name).string(), "neither a seal in seals.json nor a label.json", "one of them");
  }
}

Case SealedFolder::open(const std::string& name) const {
  Case result;
  const auto sealed = seals_.find(name);
  const fs::path file =
      sealed == seals_.end() ? folder_ / name / "label.json" : folder_ / "labels" / (name + ".json");
  if (sealed == seals_.end()) {
    result.label = label_in(files::read_text(file), file);
  } else {
    const Envelope opened = parse_envelope(files::read_text(file), file.string());
    result.seal_holds = seal(opened) == sealed->second;
    result.label = label_in(opened.label, file);
  }
  result.label.name = name;
  return result;
}

}  // namespace plumbline::trial
