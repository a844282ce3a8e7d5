#pragma once
/// \file
/// A diagnosis compared with the truth.

#include <optional>

#include "diagnose/campaign/stated_report.hpp"
#include "trial/label.hpp"

namespace plumbline::trial {

/// How an answer counts.
enum class Answer {
  right,            ///< the cause; none without an effect; unknown for a cause outside the catalogue
  in_class,         ///< ambiguous, and the cause is in the listed class (or unknown is its best)
  part,             ///< one of two causes
  unknown,          ///< a gap seen, its cause not named
  missed_gap,       ///< a gap not seen
  wrong_ambiguous,  ///< ambiguous, and the cause is not in the class
  wrong_sure,       ///< identified, and wrong
  false_alarm,      ///< a gap seen where there is none
  no_report         ///< crash, timeout or invalid JSON
};
const char* answer_word(Answer answer);

struct Judgement {
  Answer answer = Answer::no_report;
  std::string said;            ///< verdict and effects, or what went wrong
  std::string best;            ///< the best explanation without its joints: "none", "unknown", "id", "id+id"
  std::size_t class_size = 0;  ///< explanations in the class
  bool oversized_class = false;  ///< right, with a class larger than the experiment's own
  std::vector<std::pair<std::string, bool>>
      covered;                      ///< parameters, and whether they are inside their bounds
  std::optional<bool> place_right;  ///< outside the catalogue: the true joint, or else channel, named first
  std::optional<double> shrunk;     ///< where the cause was found
  /// Probability of the most probable explanation and whether it is the truth, where a gap was seen.
  std::optional<std::pair<double, bool>> stated;
  double brier = 0;  ///< of the whole ranking, 0 to 2; meaningful with `stated`
};

Judgement judge(const Label& label, const campaign::StatedReport& report);

}  // namespace plumbline::trial
