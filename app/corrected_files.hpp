#pragma once
/// \file
/// The files of `diagnose --corrected`.

#include "app/outputs.hpp"
#include "diagnose/exchange/corrected.hpp"

namespace plumbline::app {

class CorrectedFiles {
 public:
  /// \param path  of the file; without one none is written
  /// \throws Error for an ending of no format, and where the file could not be written
  CorrectedFiles(Outputs& outputs, std::filesystem::path path);

  /// Writes a file a model: at the path where there is one, beside it where there are several.
  void write(const std::vector<exchange::Corrected>& models);

  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  /// What was written and what became of each effect, for the report.
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
