#include "app/corrected_files.hpp"

#include <fmt/core.h>

namespace plumbline::app {
namespace {

constexpr const char* option = "--corrected";

}  // namespace

std::string as_text(const std::filesystem::path& file, const exchange::Written& model) {
  std::string text = fmt::format("\nCorrected model: {}\n", file.string());
  if (!model.note.empty()) text += "  " + model.note + "\n";
  for (const exchange::Carried& one : model.effects)
    text += fmt::format("  {}{}: {}\n", one.carried ? "" : "not carried: ", one.effect, one.how);
  return text;
}

CorrectedFiles::CorrectedFiles(Outputs& outputs, std::filesystem::path path)
    : outputs_(outputs), path_(std::move(path)) {
  if (!wanted()) return;
  static_cast<void>(exchange::format_of(path_));
  alone_ = outputs_.open(option, path_);
}

void CorrectedFiles::write(const std::vector<exchange::Corrected>& models) {
  if (!wanted()) return;
  if (models.size() > 1) outputs_.withdraw(alone_);
  for (const exchange::Corrected& one : models) {
    std::filesystem::path path = path_;
    if (!one.cause.empty())
      path.replace_filename(path_.stem().string() + "-" + one.cause + path_.extension().string());
    files::OutputFile* const file = models.size() > 1 ? outputs_.open(option, path) : alone_;
    exchange::Written model = exchange::written(one.model, exchange::format_of(path_));
    file->write(model.text);
    written_.push_back({path, std::move(model)});
  }
}

nlohmann::ordered_json CorrectedFiles::as_json() const {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Named& file : written_) {
    nlohmann::ordered_json effects = nlohmann::ordered_json::array();
    for (const exchange::Carried& one : file.model.effects)
      effects.push_back({{"effect", one.effect}, {"carried", one.carried}, {"how", one.how}});
    nlohmann::ordered_json entry{{"file", file.path.string()}, {"effects", effects}};
    if (!file.model.note.empty()) entry["note"] = file.model.note;
    all.push_back(std::move(entry));
  }
  return all;
}

std::string CorrectedFiles::as_text() const {
  std::string text;
  for (const Named& file : written_) text += app::as_text(file.path, file.model);
  return text;
}

}  // namespace plumbline::app
