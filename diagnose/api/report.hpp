#pragma once
/// \file
/// The diagnosis of a study as a report: in words, in JSON, as a page, and as corrected models.

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/exchange/corrected.hpp"

namespace plumbline::diagnose {

/// How a study is to be diagnosed.
struct Wishes {
  bool as_is = false;  ///< accept numbers that look like another unit, sign or axis
  bool next = false;   ///< propose the next run even where the cause is clear
  /// Called now and then with the share of the work that is done, from 0 to 1; may throw to end the work.
  std::function<void(double)> progress = {};
};

/// The answer to a study. An example: docs/library.md.
class Report {
 public:
  /// Diagnoses the study. An arm is calibrated before.
  /// \throws Error where numbers look like another unit, sign or axis, unless they are accepted; and where
  ///         the nominal model cannot follow the experiment
  explicit Report(const Study& read, const Wishes& wishes = {});

  /// The experiment as it was diagnosed: of an arm, beside its calibration.
  [[nodiscard]] const Study& study() const { return study_; }
  /// The answer as an object.
  [[nodiscard]] const Diagnosis& diagnosis() const { return diagnosis_; }

  /// The answer first, then the questions in order: gap, where, what, how far, what next.
  [[nodiscard]] std::string text() const;
  /// The format "gap-diagnosis/2", without provenance.
  [[nodiscard]] nlohmann::ordered_json json() const;
  /// A page, self-contained, without provenance.
  [[nodiscard]] std::string html() const;
  /// The nominal model with what was found, for every candidate that is left.
  /// \param source  the file that the nominal model was read from, if any: its format keeps what it says
  /// \throws Error where the file cannot be read again
  [[nodiscard]] std::vector<exchange::Corrected> corrected(const std::filesystem::path& source = {}) const;

 private:
  Study study_;
  Diagnosis diagnosis_;
};

}  // namespace plumbline::diagnose
