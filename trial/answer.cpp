#include "trial/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <plumbline/base/error.hpp>

namespace plumbline::trial {
namespace {

using files::JsonValue;
using Names = std::vector<std::string>;

std::string parameter_key(const std::string& effect, const std::string& name) {
  return fmt::format("{}/{}", effect, name);
}

std::string without_joint(const std::string& key) {
  return key.substr(0, key.find('('));
}

/// Whether the effects that were said are the true ones, in any order; a truth without a joint accepts any
/// joint.
bool same(Names said, const Names& truth) {
  if (said.size() != truth.size()) return false;
  for (const std::string& one : truth) {
    const auto hit = std::find_if(said.begin(), said.end(), [&](const std::string& word) {
      return word == one || (without_joint(one) == one && without_joint(word) == one);
    });
    if (hit == said.end()) return false;
    said.erase(hit);
  }
  return true;
}

bool share_one(const Names& said, const Names& truth) {
  return std::any_of(said.begin(), said.end(), [&](const std::string& word) {
    return std::find(truth.begin(), truth.end(), word) != truth.end();
  });
}

/// The true effects by key; an unknown cause without its joint.
Names truth_of(const Label& label) {
  if (outside_catalogue(label)) return {"unknown"};
  Names truth;
  for (const TrueEffect& effect : label.effects) truth.push_back(effect_key(effect.id, effect.joint));
  return truth;
}

const char* const expected = "a report in the format \"gap-diagnosis/2\"";

JsonValue at(const JsonValue& object, const char* key) {
  return object.at(key, expected);
}

double number(const JsonValue& object, const char* key) {
  return at(object, key).number(expected);
}

/// The entry of a list with the largest share.
std::optional<JsonValue> largest(const JsonValue& list) {
  std::optional<JsonValue> best;
  for (const JsonValue& one : list.list(expected))
    if (!best || number(one, "share") > number(*best, "share")) best = one;
  return best;
}

void read_bounds(const JsonValue& effect, const std::string& key, Report& report) {
  for (const auto& [name, value] : at(effect, "parameters").members(expected)) {
    if (!at(value, "low").json().is_number() || !at(value, "high").json().is_number()) continue;
    const auto [low, high] = std::minmax({number(value, "low"), number(value, "high")});
    report.bounds[parameter_key(key, name)] = {low, high, number(value, "value"),
                                               value.text_or("unit", "ratio")};
  }
}

void read_cause(const JsonValue& cause, Report& report) {
  report.verdict = at(cause, "verdict").text(expected);
  for (const JsonValue& effect : at(cause, "effects").list(expected)) {
    report.effects.push_back(effect_key(effect));
    read_bounds(effect, report.effects.back(), report);
  }
  for (const JsonValue& alternative : at(cause, "equivalent").list(expected))
    report.equivalent.push_back(effect_keys(alternative));
  for (const JsonValue& one : at(cause, "ranking").list(expected))
    report.ranking.push_back({effect_keys(at(one, "effects")), number(one, "probability")});
}

std::string words(const Report& report) {
  std::string text = report.verdict;
  if (!report.effects.empty()) text += fmt::format(" {}", fmt::join(report.effects, "+"));
  for (const Names& other : report.equivalent) text += fmt::format(" | {}", fmt::join(other, "+"));
  return text;
}

/// Ids in alphabetical order.
std::string kinds(const Names& effects) {
  Names ids;
  for (const std::string& effect : effects) ids.push_back(without_joint(effect));
  std::sort(ids.begin(), ids.end());
  return fmt::format("{}", fmt::join(ids, "+"));
}

Answer answer_without_effect(const Report& report) {
  return report.verdict == "none" ? Answer::right : Answer::false_alarm;
}

Answer answer_outside(const Report& report) {
  if (report.verdict == "unknown") return Answer::right;
  if (report.verdict == "none") return Answer::missed_gap;
  if (report.verdict == "identified") return Answer::wrong_sure;
  return report.effects == Names{"unknown"} ? Answer::in_class : Answer::wrong_ambiguous;
}

Answer answer_in_catalogue(const Names& truth, const Report& report, const std::vector<Names>& listed,
                           const std::function<bool(const Names&)>& right) {
  if (report.verdict == "none") return Answer::missed_gap;
  if (report.verdict == "unknown") return Answer::unknown;
  const bool sure = report.verdict == "identified";
  if (std::any_of(listed.begin(), listed.end(), right)) return sure ? Answer::right : Answer::in_class;
  const bool partly = truth.size() > 1 && std::any_of(listed.begin(), listed.end(), [&](const Names& said) {
                        return share_one(said, truth);
                      });
  if (partly) return Answer::part;
  return sure ? Answer::wrong_sure : Answer::wrong_ambiguous;
}

/// Whether the joint or channel with the largest share is right; nothing where the label names none.
std::optional<bool> place_right(const Label& label, const Report& report) {
  const std::size_t joint = label.effects.front().joint;
  if (joint > 0) return report.joint == joint;
  if (label.channel.empty() || report.channel.empty()) return std::nullopt;
  return (label.channel + ",").find(report.channel + ",") != std::string::npos;
}

/// A truth with more elements than the answer has no parameters to compare.
void judge_parameters(const Label& label, const Report& report, Judgement& judgement) {
  for (const TrueEffect& effect : label.effects) {
    const auto bounds_of = [&](const std::string& name) {
      return report.bounds.find(parameter_key(effect_key(effect.id, effect.joint), name));
    };
    if (std::any_of(effect.parameters.begin(), effect.parameters.end(),
                    [&](const auto& one) { return bounds_of(one.first) == report.bounds.end(); }))
      continue;
    for (const auto& [name, value] : effect.parameters) {
      const auto& [key, bounds] = *bounds_of(name);
      judgement.covered.emplace_back(key, bounds.low <= value && value <= bounds.high);
    }
  }
}

/// A truth outside the ranking counts as one on which no probability was placed.
void judge_probabilities(const Report& report, const std::function<bool(const Names&)>& right,
                         Judgement& judgement) {
  if (report.ranking.empty() || report.verdict == "none") return;
  const Report::Ranked& first = *std::max_element(
      report.ranking.begin(), report.ranking.end(),
      [](const auto& one, const auto& other) { return one.probability < other.probability; });
  judgement.stated = {first.probability, right(first.effects)};
  bool found = false;
  for (const Report::Ranked& one : report.ranking) {
    const bool is = !found && right(one.effects);
    found = found || is;
    judgement.brier += (one.probability - is) * (one.probability - is);
  }
  if (!found) judgement.brier += 1;
}

}  // namespace

Report report_from(const nlohmann::json& json, const std::string& source) {
  const JsonValue file(json, source);
  Report report;
  read_cause(at(file, "cause"), report);
  const JsonValue where = at(file, "where");
  if (const auto joint = largest(at(where, "joints")))
    report.joint = static_cast<std::size_t>(number(*joint, "joint"));
  if (const auto channel = largest(at(where, "channels")))
    report.channel = at(*channel, "channel").text(expected);
  if (const JsonValue shrink = at(file, "shrink"); shrink.json().is_object()) {
    const double floor = shrink.number_or("noise_floor_ratio", 0.0);
    if (floor > 0) report.shrunk = number(shrink, "ratio") / floor;
  }
  return report;
}

const char* answer_word(Answer answer) {
  switch (answer) {
    case Answer::right:
      return "right";
    case Answer::in_class:
      return "in the class";
    case Answer::part:
      return "part";
    case Answer::unknown:
      return "unknown";
    case Answer::missed_gap:
      return "missed gap";
    case Answer::wrong_ambiguous:
      return "wrong, ambiguous";
    case Answer::wrong_sure:
      return "wrong, sure";
    case Answer::false_alarm:
      return "false alarm";
    case Answer::no_report:
      break;
  }
  return "no report";
}

Judgement judge(const Label& label, const Report& report) {
  const Names truth = truth_of(label);
  const auto right = [&](const Names& said) {
    return same(said, truth) || std::any_of(label.equivalent.begin(), label.equivalent.end(),
                                            [&](const Names& other) { return same(said, other); });
  };
  std::vector<Names> listed = report.equivalent;
  if (!report.effects.empty()) listed.insert(listed.begin(), report.effects);
  Judgement judgement;
  judgement.said = words(report);
  judgement.best = report.effects.empty() ? report.verdict : kinds(report.effects);
  judgement.class_size = listed.size();
  if (truth.empty()) {
    judgement.answer = answer_without_effect(report);
    judge_probabilities(report, right, judgement);
    return judgement;
  }
  if (outside_catalogue(label)) {
    judgement.answer = answer_outside(report);
    judgement.place_right = place_right(label, report);
  } else {
    judgement.answer = answer_in_catalogue(truth, report, listed, right);
  }
  const bool found = judgement.answer == Answer::right || judgement.answer == Answer::in_class;
  if (judgement.answer == Answer::right) judge_parameters(label, report, judgement);
  if (found && !outside_catalogue(label)) judgement.shrunk = report.shrunk;
  judgement.oversized_class = found && listed.size() > 1 + label.equivalent.size();
  judge_probabilities(report, right, judgement);
  return judgement;
}

}  // namespace plumbline::trial
