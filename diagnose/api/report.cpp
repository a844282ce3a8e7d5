#include "diagnose/api/report.hpp"

#include <utility>

#include "diagnose/calibration/calibration.hpp"
#include "diagnose/report/report.hpp"
#include "diagnose/screening/conventions.hpp"

namespace plumbline::diagnose {
namespace {

Study studied(const Study& read, const Wishes& wishes) {
  if (!wishes.as_is) require_conventions(read);
  return calibrated(read);
}

}  // namespace

Report::Report(const Study& read, const Wishes& wishes)
    : study_(studied(read, wishes)), diagnosis_(diagnose(study_, wishes.progress, wishes.next)) {}

std::string Report::text() const {
  return as_text(diagnosis_);
}

nlohmann::ordered_json Report::json() const {
  return as_json(diagnosis_);
}

std::string Report::html() const {
  return as_html(study_, diagnosis_);
}

std::vector<exchange::Corrected> Report::corrected(const std::filesystem::path& source) const {
  return exchange::corrected_models(study_, diagnosis_, source);
}

}  // namespace plumbline::diagnose
