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
    if (one.exactly) text += " (exactly alike)";
    if (!one.others.empty())
      text += fmt::format("{} mistaken for {}", one.effects.size() > 1 ? ", each" : ":",
                          fmt::join(names(one.others), ", "));
    text += "\n";
  }
  return text;
}

std::string runs(const Plan& plan) {
  if (plan.fewest.empty()) return "Which runs separate the rest?  There is nothing to separate\n";
  std::string text = fmt::format("Which runs separate the rest?  {} of {}{}\n", plan.fewest.size(),
                                 plan.candidates, plan.proved_minimal ? "; no fewer do" : "; fewer may do");
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
                             ? fmt::format("any {} of {} runs", few_runs, plan.candidates)
                             : fmt::format("all runs that it could make, {}", plan.candidates);
  text += fmt::format(
      "What can it never see?  Of what a lab calls sizeable, by {}\n"
      "  cannot act on this bench, or nothing shows it: {}\n"
      "  below the noise: {}\n\n",
      by, list(plan.impossible), list(plan.unidentifiable.undetectable));
  text += "What can it never tell apart?\n" + in_lines(plan.unidentifiable.indistinguishable, "  ") + "\n";
  if (plan.planned) {
    text += "What do the runs leave open as they are planned?\n";
    text += "  below the noise: " + list(plan.planned->undetectable) + "\n";
    text += "  not told apart:\n" + in_lines(plan.planned->indistinguishable, "    ") + "\n";
  }
  return text + runs(plan);
}

}  // namespace plumbline::diagnose
