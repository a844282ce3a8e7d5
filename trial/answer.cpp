#include "trial/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <plumbline/base/error.hpp>

namespace plumbline::trial {
namespace {

using campaign::parameter_key;
using campaign::StatedReport;
using Names = std::vector<std::string>;

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

std::string words(const StatedReport& report) {
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

Answer answer_without_effect(const StatedReport& report) {
  return report.verdict == "none" ? Answer::right : Answer::false_alarm;
}

Answer answer_outside(const StatedReport& report) {
  if (report.verdict == "unknown") return Answer::right;
  if (report.verdict == "none") return Answer::missed_gap;
  if (report.verdict == "identified") return Answer::wrong_sure;
  return report.effects == Names{"unknown"} ? Answer::in_class : Answer::wrong_ambiguous;
}

Answer answer_in_catalogue(const Names& truth, const StatedReport& report, const std::vector<Names>& listed,
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
std::optional<bool> place_right(const Label& label, const StatedReport& report) {
  const std::size_t joint = label.effects.front().joint;
  if (joint > 0) return report.joint == joint;
  if (label.channel.empty() || report.channel.empty()) return std::nullopt;
  return (label.channel + ",").find(report.channel + ",") != std::string::npos;
}

/// A truth with more elements than the answer has no parameters to compare.
void judge_parameters(const Label& label, const StatedReport& report, Judgement& judgement) {
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
void judge_probabilities(const StatedReport& report, const std::function<bool(const Names&)>& right,
                         Judgement& judgement) {
  if (report.ranking.empty() || report.verdict == "none") return;
  const StatedReport::Ranked& first = *std::max_element(
      report.ranking.begin(), report.ranking.end(),
      [](const auto& one, const auto& other) { return one.probability < other.probability; });
  judgement.stated = {first.probability, right(first.effects)};
  bool found = false;
  for (const StatedReport::Ranked& one : report.ranking) {
    const bool is = !found && right(one.effects);
    found = found || is;
    judgement.brier += (one.probability - is) * (one.probability - is);
  }
  if (!found) judgement.brier += 1;
}

}  // namespace

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

Judgement judge(const Label& label, const StatedReport& report) {
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
