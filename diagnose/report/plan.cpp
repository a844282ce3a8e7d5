#include "diagnose/report/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> labels(const std::vector<EffectAt>& effects) {
  std::vector<std::string> all;
  for (const EffectAt& at : effects) all.push_back(at.label());
  return all;
}

Json unidentifiable(const Unidentifiable& left) {
  Json alike = Json::array();
  for (const Indistinguishable& one : left.indistinguishable)
    alike.push_back(
        {{"effects", labels(one.effects)}, {"exactly", one.exactly}, {"others", labels(one.others)}});
  return {{"undetectable", labels(left.undetectable)}, {"indistinguishable", alike}};
}

std::vector<std::string> names(const std::vector<EffectAt>& effects) {
  std::vector<std::string> all;
  for (const EffectAt& at : effects) all.push_back(at.name());
  return all;
}

std::string list(const std::vector<EffectAt>& effects) {
  return effects.empty() ? "none" : fmt::format("{}", fmt::join(names(effects), ", "));
}

std::string in_lines(const std::vector<Indistinguishable>& alike, const std::string& indent) {
  if (alike.empty()) return indent + "none\n";
  std::string text;
  for (const Indistinguishable& one : alike) {
    text += indent + fmt::format("{}", fmt::join(names(one.effects), " | "));
    if (one.exactly) text += " (identical readings)";
    if (!one.others.empty())
      text += fmt::format("{} confused with {}", one.effects.size() > 1 ? ", each" : ":",
                          fmt::join(names(one.others), ", "));
    text += "\n";
  }
  return text;
}

std::string runs(const Plan& plan) {
  if (plan.fewest.empty()) return "Which runs distinguish the rest?  There is nothing to distinguish\n";
  std::string text =
      fmt::format("Which runs distinguish the rest?  {} of {}{}\n", plan.fewest.size(), plan.candidates,
                  plan.proved_minimal ? "; no fewer suffice" : "; fewer may suffice");
  for (const std::string& run : plan.fewest) text += "  " + run + "\n";
  return text;
}

}  // namespace

Json as_json(const Plan& plan) {
  Json report = {{"format", "experiment-plan/2"},
                 {"experiment", plan.experiment},
                 {"candidates", plan.candidates},
                 {"impossible", labels(plan.impossible)},
                 {"unidentifiable", unidentifiable(plan.unidentifiable)},
                 {"runs", plan.fewest},
                 {"proved_minimal", plan.proved_minimal},
                 {"separated", plan.separated}};
  if (plan.planned) report["planned"] = unidentifiable(*plan.planned);
  return report;
}

std::string as_text(const Plan& plan) {
  std::string text = fmt::format("{}, before any data\n\n", plan.experiment);
  const std::string by = plan.candidates > few_runs
                             ? fmt::format("any {} of {} feasible runs", few_runs, plan.candidates)
                             : fmt::format("all {} feasible runs", plan.candidates);
  text += fmt::format(
      "Which effects can it not detect?  At their typical size, with {}\n"
      "  without effect on any channel of this bench: {}\n"
      "  below the noise: {}\n\n",
      by, list(plan.impossible), list(plan.unidentifiable.undetectable));
  text += "Which effects can it not distinguish?\n" + in_lines(plan.unidentifiable.indistinguishable, "  ") +
          "\n";
  if (plan.planned) {
    text += "What do the planned runs leave open?\n";
    text += "  below the noise: " + list(plan.planned->undetectable) + "\n";
    text += "  not distinguished:\n" + in_lines(plan.planned->indistinguishable, "    ") + "\n";
  }
  return text + runs(plan);
}

}  // namespace plumbline::diagnose
