#pragma once
/// \file
/// The files of `diagnose --corrected`.

#include "app/outputs.hpp"
#include "diagnose/exchange/corrected.hpp"

namespace plumbline::app {

/// A corrected model that was written: its file, and what became of each effect.
std::string as_text(const std::filesystem::path& file, const exchange::Written& model);

class CorrectedFiles {
 public:
  /// \param path  of the file; without one none is written
  /// \throws Error for an ending of no format, and where the file could not be written
  CorrectedFiles(Outputs& outputs, std::filesystem::path path);

  /// Writes one file a model: at the path, or beside it for several.
  void write(const std::vector<exchange::Corrected>& models);

  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  /// The files that were written and the fate of each effect, for the report.
  [[nodiscard]] nlohmann::ordered_json as_json() const;
  [[nodiscard]] std::string as_text() const;

 private:
  struct Named {
    std::filesystem::path path;
    exchange::Written model;
  };
  Outputs& outputs_;
  std::filesystem::path path_;
  files::OutputFile* alone_ = nullptr;
  std::vector<Named> written_;
};

}  // namespace plumbline::app
