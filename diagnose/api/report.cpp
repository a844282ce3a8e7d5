#include "diagnose/api/report.hpp"

#include <utility>

#include "diagnose/calibration/calibration_text.hpp"
#include "diagnose/report/report.hpp"
#include "diagnose/screening/conventions.hpp"

namespace plumbline::diagnose {
namespace {

/// Of an arm whose frames are unknown, its calibration.
std::optional<Calibration> calibration_of(const Study& read, const Wishes& wishes) {
  const auto& arm = read.experiment().arm;
  std::optional<Calibration> calibration = arm && !arm->frames_known ? calibrated(read) : std::nullopt;
  if (!wishes.as_is && !calibration) require_conventions(read);
  return calibration;
}

}  // namespace

Report::Report(Study read, const Wishes& wishes) : Report(calibration_of(read, wishes), read, wishes) {}

Report::Report(std::optional<Calibration> calibration, const Study& read, const Wishes& wishes)
    : calibration_(std::move(calibration)),
      study_(calibration_ ? read.of(calibration_->experiment) : read),
      diagnosis_(diagnose(study_, wishes.progress, wishes.next)) {}

std::string Report::text() const {
  return as_text(diagnosis_) + (calibration_ ? "\n" + calibration_as_text(*calibration_) : "");
}

nlohmann::ordered_json Report::json() const {
  nlohmann::ordered_json report = as_json(diagnosis_);
  if (calibration_) report["calibration"] = calibration_as_json(*calibration_);
  return report;
}

std::string Report::html() const {
  return as_html(study_, diagnosis_);
}

std::vector<exchange::Corrected> Report::corrected(const std::filesystem::path& source) const {
  if (!calibration_) return exchange::corrected_models(study_, diagnosis_, source);
  const bool named = diagnosis_.cause.is_explained();
  std::vector<exchange::Corrected> models =
      exchange::corrected_models(named ? study_ : study_.of(calibration_->with_all()), diagnosis_, source);
  for (exchange::Corrected& one : models)
    one.model.title += " The nominal model is the calibrated one: every joint is corrected.";
  return models;
}

}  // namespace plumbline::diagnose
