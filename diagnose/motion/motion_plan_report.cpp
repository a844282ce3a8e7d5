#include "diagnose/motion/motion_plan_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plumbline::motion {

std::string as_text(const MotionPlan& plan) {
  std::string text = fmt::format(
      "{}, before any log\n\n"
      "Which effects can it not detect?  At their typical size, with all {} motions\n"
      "  below the noise: {}\n\n"
      "Which effects can it not distinguish?\n",
      plan.name, plan.motions,
      plan.undetectable.empty() ? "none" : fmt::format("{}", fmt::join(plan.undetectable, ", ")));
  for (const AlikeEffects& one : plan.indistinguishable) {
    text += fmt::format("  {}{}", fmt::join(one.effects, " | "), one.exactly ? " (identical readings)" : "");
    if (!one.others.empty())
      text += fmt::format("{} confused with {}", one.effects.size() > 1 ? ", each" : ":",
                          fmt::join(one.others, ", "));
    text += "\n";
  }
  if (plan.indistinguishable.empty()) text += "  none\n";
  text += fmt::format("\nWhich motions distinguish the rest?  {} of {}{}\n", plan.fewest.size(), plan.motions,
                      plan.proved_minimal ? "; no fewer suffice" : "; fewer may suffice");
  for (const std::string& motion : plan.fewest) text += "  " + motion + "\n";
  return text;
}

nlohmann::ordered_json as_json(const MotionPlan& plan) {
  nlohmann::ordered_json alike = nlohmann::ordered_json::array();
  for (const AlikeEffects& one : plan.indistinguishable)
    alike.push_back({{"effects", one.effects}, {"exactly", one.exactly}, {"others", one.others}});
  return {{"format", "motion-plan/1"},
          {"name", plan.name},
          {"motions", plan.motions},
          {"undetectable", plan.undetectable},
          {"indistinguishable", alike},
          {"fewest", plan.fewest},
          {"proved_minimal", plan.proved_minimal},
          {"separated", plan.separated}};
}

}  // namespace plumbline::motion
