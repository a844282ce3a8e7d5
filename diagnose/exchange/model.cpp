#include "diagnose/exchange/model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plumbline::exchange {
namespace {

/// A law as numbers.
void add_law(const diagnose::FreeLaw& law, std::vector<std::string>& lines) {
  lines.push_back(fmt::format(
      "torque law of joint {}, beside its spring, straight between: deflection in rad, torque in N m",
      law.joint));
  for (const auto& knot : law.knots)
    lines.push_back(fmt::format("  {:.6g} {:.6g}", knot.deflection, knot.torque));
  for (const auto& one : law.sliders) {
    if (!one.profile.empty()) {
      lines.push_back(
          fmt::format("  a slider that slips after {:.6g} rad, at a torque that goes with the deflection:",
                      one.slips_at));
      for (const auto& knot : one.profile)
        lines.push_back(fmt::format("    {:.6g} {:.6g}", knot.deflection, knot.torque));
      continue;
    }
    lines.push_back(
        one.growth > 0
            ? fmt::format("  a slider along d^2/2 that slips from {:.6g} rad on at {:.6g} N m/rad",
                          one.slips_at, one.growth)
            : fmt::format("  a slider that slips after {:.6g} rad at {:.6g} N m", one.slips_at, one.torque));
  }
  for (const auto& one : law.arms)
    lines.push_back(fmt::format("  a Maxwell arm of {:.6g} N m/rad, time constant {:.6g} s", one.stiffness,
                                one.time_constant));
}

}  // namespace

std::vector<std::string> head_lines(const Model& model, const std::vector<Carried>& effects,
                                    const std::vector<std::string>& remarks) {
  std::vector<std::string> lines{model.title};
  for (const std::string& remark : remarks) lines.push_back(remark);
  const std::size_t known = model.experiment.effects.size();
  for (std::size_t e = 0; e < effects.size(); ++e) {
    lines.push_back(fmt::format("{}{}: {}", effects[e].carried ? "" : "NOT CARRIED: ", effects[e].effect,
                                effects[e].how));
    if (effects[e].carried) continue;
    if (e >= known) {
      add_law(model.experiment.laws[e - known], lines);
      continue;
    }
    for (const auto& [name, value] : model.experiment.effects[e].parameters)
      lines.push_back(fmt::format("  {} = {:.6g}", name, value));
  }
  return lines;
}

}  // namespace plumbline::exchange
