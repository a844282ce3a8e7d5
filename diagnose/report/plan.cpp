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

Json blindness(const Blindness& left) {
  Json alike = Json::array();
  for (const Alike& one : left.alike)
    alike.push_back(
        {{"effects", labels(one.effects)}, {"exactly", one.exactly}, {"others", labels(one.others)}});
  return {{"unseen", labels(left.unseen)}, {"alike", alike}};
}

std::vector<std::string> names(const std::vector<EffectAt>& effects) {
  std::vector<std::string> all;
  for (const EffectAt& at : effects) all.push_back(at.name());
  return all;
}

std::string list(const std::vector<EffectAt>& effects) {
  return effects.empty() ? "none" : fmt::format("{}", fmt::join(names(effects), ", "));
}

std::string in_lines(const std::vector<Alike>& alike, const std::string& indent) {
  if (alike.empty()) return indent + "none\n";
  std::string text;
  for (const Alike& one : alike) {
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
                                 plan.candidates, plan.fewest_proved ? "; no fewer do" : "; fewer may do");
  for (const std::string& run : plan.fewest) text += "  " + run + "\n";
  return text;
}

}  // namespace

Json as_json(const Plan& plan) {
  Json report = {{"format", "experiment-plan/1"},  {"experiment", plan.experiment},
                 {"candidates", plan.candidates},  {"impossible", labels(plan.impossible)},
                 {"never", blindness(plan.never)}, {"runs", plan.fewest},
                 {"fewest", plan.fewest_proved},   {"separated", plan.separated}};
  if (plan.planned) report["planned"] = blindness(*plan.planned);
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
      by, list(plan.impossible), list(plan.never.unseen));
  text += "What can it never tell apart?\n" + in_lines(plan.never.alike, "  ") + "\n";
  if (plan.planned) {
    text += "What do the runs leave open as they are planned?\n";
    text += "  below the noise: " + list(plan.planned->unseen) + "\n";
    text += "  not told apart:\n" + in_lines(plan.planned->alike, "    ") + "\n";
  }
  return text + runs(plan);
}

}  // namespace plumbline::diagnose
