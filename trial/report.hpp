#pragma once
/// \file
/// The result of a trial as text, JSON and Markdown, failures first.

#include <string>

#include "trial/score.hpp"

namespace plumbline::trial {

/// The source of the experiments, and what was published before the diagnoses.
struct Circumstances {
  std::string command;       ///< that makes this report
  std::string seals_digest;  ///< SHA-256 of the seals; empty where nothing was sealed
  std::size_t sealed = 0;
  std::size_t compared = 0;  ///< rigs without effects that were compared with the nominal statics
  double median_error = 0;   ///< of the largest difference of each, in sigmas
  double worst_error = 0;
};

/// Durations are printed on the terminal only; files are reproducible to the byte.
enum class Style { terminal, markdown };
std::string as_text(const Circumstances& circumstances, const std::vector<Case>& cases, Style style);
nlohmann::ordered_json as_json(const Circumstances& circumstances, const std::vector<Case>& cases);

}  // namespace plumbline::trial
