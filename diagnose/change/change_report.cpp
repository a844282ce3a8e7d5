#include "diagnose/change/change_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "diagnose/report/report.hpp"
#include "diagnose/report/view.hpp"

namespace plumbline::diagnose {
namespace {

/// Speeds of one path that differ by less are those of one drive.
constexpr double same_rate = 0.2;

std::string answer(const Change& change) {
  const Cause& cause = change.diagnosis.cause;
  const double p = change.diagnosis.gap.probability;
  if (!change.diagnosis.gap.present)
    return fmt::format("{}: the two differ by noise (probability of a change that shows {})\n",
                       check(change) == Check::same ? "No change" : "No change is sure",
                       probability_in_words(change.diagnosis.gap.seen));
  if (!cause.is_explained())
    return fmt::format("Changed (probability {}), by a cause outside the catalogue\n",
                       probability_in_words(p));
  const std::string words = in_words(cause.ranking.front().cause) + senses(change.sense);
  const std::size_t others = cause.named - 1 + (cause.or_unknown ? 1 : 0) + change.otherwise.size();
  const char* const verdict = cause.verdict == CauseVerdict::partial     ? "Changed, mostly by"
                              : cause.verdict == CauseVerdict::ambiguous ? "Changed, ambiguous"
                                                                         : "Changed";
  return fmt::format("{}: {}{}\n", verdict, words,
                     others == 0   ? ""
                     : others == 1 ? ", or the alternative below"
                                   : fmt::format(", or one of {} alternatives below", others)) +
         values_as_text(change.diagnosis);
}

std::string compared(const PairedRun& run) {
  if (run.reference.empty())
    return fmt::format("  {}: no run of the other state took this path; repeat it there\n", run.run);
  std::string text = fmt::format("  {}: {} of {} readings", run.run, run.paired, run.of);
  if (run.reference != run.run) text += ", against " + run.reference;
  if (std::isfinite(run.rate) && std::abs(std::log(run.rate)) > same_rate)
    text += fmt::format(
        "; {:.2g} times as fast, which is no change of the device but shows in effects of time", run.rate);
  return text + "\n";
}

nlohmann::ordered_json as_json(const PairedRun& run) {
  nlohmann::ordered_json json = {
      {"run", run.run}, {"reference", run.reference}, {"paired", run.paired}, {"of", run.of}};
  json["rate"] = std::isfinite(run.rate) ? nlohmann::ordered_json(run.rate) : nlohmann::ordered_json();
  return json;
}

}  // namespace

std::string senses(Sense sense) {
  if (sense == Sense::either) return "";
  return sense == Sense::added ? ", there now and not before" : ", there before and not now";
}

const char* sense_word(Sense sense) {
  if (sense == Sense::either) return "either";
  return sense == Sense::added ? "added" : "removed";
}

const char* check_word(Check check) {
  return check == Check::same ? "same" : check == Check::changed ? "changed" : "cannot_tell";
}

std::string as_text(const Change& change) {
  std::string text = fmt::format("{} against {}\n\n{}", change.after, change.before, answer(change));
  for (const RankedCause& one : change.otherwise)
    text += fmt::format("  or {}{}\n", in_words(one.cause),
                        senses(change.sense == Sense::removed ? Sense::added : Sense::removed));
  text += "\nCompared at the same commands\n";
  for (const PairedRun& run : change.runs) text += compared(run);
  text += fmt::format("\nBelow, the nominal model is the device as it was {}, and the gap is the change.\n\n",
                      change.sense == Sense::removed ? "after" : "before");
  return text + questions_as_text(change.diagnosis);
}

nlohmann::ordered_json as_json(const Change& change) {
  nlohmann::ordered_json report = as_json(change.diagnosis);
  nlohmann::ordered_json runs = nlohmann::ordered_json::array(), otherwise = runs;
  for (const PairedRun& run : change.runs) runs.push_back(as_json(run));
  for (const RankedCause& one : change.otherwise) {
    nlohmann::ordered_json labels = nlohmann::ordered_json::array();
    for (const EffectAt& at : one.cause.effects) labels.push_back(at.label());
    otherwise.push_back(std::move(labels));
  }
  report["against"] = {{"before", change.before},
                       {"after", change.after},
                       {"check", check_word(check(change))},
                       {"sense", sense_word(change.sense)},
                       {"sense_probability", change.sense_probability},
                       {"otherwise", otherwise},
                       {"runs", runs}};
  return report;
}

}  // namespace plumbline::diagnose
