#include "diagnose/motion/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnose/report/view.hpp"

namespace plumbline::motion {
namespace {

using diagnose::CauseVerdict;

bool has(const NamedCause& cause, const NamedEffect& effect) {
  return std::any_of(cause.effects.begin(), cause.effects.end(),
                     [&](const NamedEffect& one) { return one.id == effect.id; });
}

/// The words of the effects that `is_meant` is true of.
template <class Meant>
std::string words_of(const NamedCause& cause, const Meant& is_meant) {
  std::vector<std::string_view> words;
  for (const NamedEffect& one : cause.effects)
    if (is_meant(one)) words.push_back(one.words);
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string words_of(const NamedCause& cause) {
  return words_of(cause, [](const NamedEffect&) { return true; });
}

std::string with_unit(const Estimate& one) {
  const std::string unit = one.unit == "ratio" ? "" : " " + one.unit;
  if (one.at_bound) return fmt::format("{} = {:.4g}{} (at the end of its range)", one.name, one.value, unit);
  return fmt::format("{} = {:.4g}{} (95 %: {:.4g} to {:.4g})", one.name, one.value, unit, one.low, one.high);
}

std::string sizes_of(const NamedCause& cause) {
  std::string text;
  for (const NamedEffect& effect : cause.effects)
    for (const Estimate& one : effect.values) text += fmt::format("  {}: {}\n", effect.id, with_unit(one));
  return text;
}

/// Several causes: what all of them have, then what tells them apart.
std::string alternatives_text(const Diagnosis& d) {
  const auto is_common = [&](const NamedEffect& effect) {
    return std::all_of(d.causes.begin(), d.causes.end(),
                       [&](const NamedCause& cause) { return has(cause, effect); });
  };
  const std::string common = words_of(d.causes.front(), is_common);
  std::string text =
      common.empty() ? "Ambiguous: one of\n"
                     : fmt::format("{}: {}; and one of\n", d.rest.empty() ? "Identified" : "Mostly", common);
  for (const NamedCause& one : d.causes) {
    const std::string own = words_of(one, [&](const NamedEffect& effect) { return !is_common(effect); });
    text += fmt::format("  - {} (probability {})\n", own.empty() ? "nothing else" : own,
                        diagnose::probability_in_words(one.probability));
  }
  if (d.or_outside)
    text += fmt::format("  - a cause outside the catalogue (probability {})\n",
                        diagnose::probability_in_words(d.outside));
  return text;
}

std::string verdict_text(const Diagnosis& d) {
  switch (d.verdict) {
    case CauseVerdict::none:
      return "No gap: the model predicts the logs within the noise of their readings\n";
    case CauseVerdict::identified:
      return fmt::format("Identified: {}\n{}", words_of(d.causes.front()), sizes_of(d.causes.front()));
    case CauseVerdict::partial:
      return fmt::format("Mostly: {}\n{}", words_of(d.causes.front()), sizes_of(d.causes.front()));
    case CauseVerdict::ambiguous:
      return alternatives_text(d) + sizes_of(d.causes.front());
    case CauseVerdict::unknown:
      break;
  }
  return "Unknown: nothing in the catalogue explains the logs\n";
}

std::string error_text(const Diagnosis& d, bool held_out) {
  const LogError mean = d.mean(held_out);
  const auto count = std::count_if(d.errors.begin(), d.errors.end(),
                                   [&](const LogError& one) { return one.held_out == held_out; });
  if (count == 0) return "";
  return fmt::format("  {} logs {}: {:.4f} rad before, {:.4f} after ({:.2f})\n", count,
                     held_out ? "held out" : "fitted", mean.before, mean.after, mean.after / mean.before);
}

std::string look_text(const LogsLook& look) {
  std::string text = fmt::format(
      "The logs: {} with {} readings, every {:.4g} ms ({:.4g} to {:.4g}); position changes by {:.3g} rad at "
      "least\n",
      look.logs, look.readings, 1e3 * look.step, 1e3 * look.step_low, 1e3 * look.step_high, look.quantum);
  if (look.spikes > 0)
    text += fmt::format("  {} isolated readings are far from both neighbours and left out\n", look.spikes);
  if (look.off > 0) text += fmt::format("  the drive is off in {:.0f} % of them\n", 100 * look.off);
  if (look.saturated > 0)
    text += fmt::format("  the error asks for the whole duty in {:.1f} % of those with power\n",
                        100 * look.saturated);
  return text;
}

std::string channel_text(const ChannelLook& look) {
  const ChannelKind& kind = kind_of(look.channel);
  if (!look.left_out.empty()) return fmt::format("  {} is left out: {}\n", kind.name, look.left_out);
  return fmt::format("  {}: {:.3g} {} {:.0f} ms {} (R^2 {:.2f}); it changes every {:.2g} s\n", kind.name,
                     look.ratio, kind.of, 1e3 * std::abs(look.late), look.late < 0 ? "after" : "before",
                     look.explained, look.refresh);
}

std::string phase_text(const Diagnosis& d) {
  std::string text;
  for (const PhaseError& one : d.phases)
    text += fmt::format("  {} ({:.0f} % of the readings): {:.4f} rad before, {:.4f} after\n",
                        phase_words[static_cast<std::size_t>(one.phase)], 100 * one.readings, one.before,
                        one.after);
  return text;
}

std::string worst_logs(const Diagnosis& d) {
  std::vector<LogError> sorted = d.errors;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const LogError& a, const LogError& b) { return a.before > b.before; });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, sorted.size()); ++i)
    text += fmt::format("  {}: {:.4f} rad before, {:.4f} after\n", sorted[i].log, sorted[i].before,
                        sorted[i].after);
  return text;
}

nlohmann::ordered_json as_json(const Estimate& one) {
  nlohmann::ordered_json json{{"name", one.name}, {"unit", one.unit}, {"value", one.value}};
  if (!one.at_bound) json["interval_95"] = {one.low, one.high};
  return json;
}

nlohmann::ordered_json as_json(const NamedCause& cause) {
  nlohmann::ordered_json json{{"probability", cause.probability},
                              {"effects", nlohmann::ordered_json::array()}};
  for (const NamedEffect& effect : cause.effects) {
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (const Estimate& one : effect.values) values.push_back(as_json(one));
    json["effects"].push_back({{"effect", effect.id}, {"words", effect.words}, {"parameters", values}});
  }
  return json;
}

nlohmann::ordered_json as_json(const LogError& one) {
  return {{"log", one.log}, {"held_out", one.held_out}, {"before", one.before}, {"after", one.after}};
}

nlohmann::ordered_json as_json(const MinorEffect& one) {
  return {{"effect", one.id}, {"words", one.words}, {"probability", one.probability}};
}

nlohmann::ordered_json as_json(const PhaseError& one) {
  return {{"phase", phase_words[static_cast<std::size_t>(one.phase)]},
          {"readings", one.readings},
          {"before", one.before},
          {"after", one.after}};
}

nlohmann::ordered_json as_json(const ChannelLook& one) {
  nlohmann::ordered_json json{{"channel", kind_of(one.channel).name},
                              {"refresh", one.refresh},
                              {"ratio", one.ratio},
                              {"late", one.late},
                              {"explained", one.explained}};
  if (!one.left_out.empty()) json["left_out"] = one.left_out;
  return json;
}

template <class Entry>
nlohmann::ordered_json list_of(const std::vector<Entry>& entries) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Entry& one : entries) list.push_back(as_json(one));
  return list;
}

}  // namespace

std::string next_text(const Diagnosis& d) {
  if (!d.next) return "\nWhat next?  No motion tells the explanations apart\n";
  return fmt::format(
      "\nWhat next?  {}, gain {:.3g} duty per rad: there the first two explanations are {:.2g} rad apart\n",
      d.next->words, d.next->gain, d.next->apart);
}

std::string as_text(const Diagnosis& d) {
  std::string text = fmt::format("{}\n\n{}", d.name, verdict_text(d));
  if (!d.rest.empty()) text += fmt::format("  {}\n", d.rest);
  for (const MinorEffect& one : d.beside)
    text += fmt::format("  beside it, and far smaller: {} (probability {})\n", one.words,
                        diagnose::probability_in_words(one.probability));
  text += "  mean error of position, each log predicted whole from its first reading:\n";
  text += error_text(d, true) + error_text(d, false);
  if (d.repeatability)
    text += fmt::format("  logs that were commanded alike: {:.4f} rad apart\n", *d.repeatability);
  text +=
      fmt::format("\nIs there a gap?  {} (probability of a gap {}; of a cause outside the catalogue {})\n",
                  d.gap > 0.5 ? "Yes" : "No", diagnose::probability_in_words(d.gap),
                  diagnose::probability_in_words(d.outside));
  text += "\nWhich explanations are probable?\n";
  for (const NamedCause& one : d.ranking)
    text += fmt::format("  {:>7}  {}\n", diagnose::probability_in_words(one.probability), words_of(one));
  text += "\nWhere?  Logs with the largest errors, and phases of motion\n" + worst_logs(d) + phase_text(d);
  if (!d.after.empty()) {
    text += "\nThe drive's unknown numbers, beside the cause\n";
    for (const Estimate& one : d.after) text += fmt::format("  {}\n", with_unit(one));
  }
  text += "\n" + look_text(d.look);
  for (const ChannelLook& one : d.channels) text += channel_text(one);
  return text;
}

nlohmann::ordered_json as_json(const Diagnosis& d) {
  nlohmann::ordered_json json{{"format", "motion-report/1"},
                              {"name", d.name},
                              {"verdict", verdict_word(d.verdict)},
                              {"probability_of_gap", d.gap},
                              {"probability_outside", d.outside},
                              {"causes", list_of(d.causes)},
                              {"beside", list_of(d.beside)},
                              {"ranking", list_of(d.ranking)},
                              {"drive_without_cause", list_of(d.before)},
                              {"drive", list_of(d.after)},
                              {"errors", list_of(d.errors)},
                              {"phases", list_of(d.phases)}};
  if (d.repeatability) json["repeatability"] = *d.repeatability;
  if (d.next) json["next"] = {{"motion", d.next->words}, {"gain", d.next->gain}, {"apart", d.next->apart}};
  json["look"] = {{"logs", d.look.logs},
                  {"readings", d.look.readings},
                  {"step", {{"median", d.look.step}, {"low", d.look.step_low}, {"high", d.look.step_high}}},
                  {"quantum", d.look.quantum},
                  {"saturated", d.look.saturated},
                  {"off", d.look.off},
                  {"spikes", d.look.spikes},
                  {"channels", list_of(d.channels)}};
  return json;
}

}  // namespace plumbline::motion
