#include "exchange/model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plumbline::exchange {
namespace {

/// A law as numbers.
void add_law(const diagnose::LawPicture& law, std::vector<std::string>& lines) {
  lines.push_back(fmt::format("torque law of joint{} {} ({}): deflection in rad, torque in N m",
                              law.joints.size() > 1 ? "s" : "", fmt::join(law.joints, ", "), law.words));
  for (const auto& knot : law.knots)
    lines.push_back(fmt::format("  {:.6g} {:.6g}", knot.deflection, knot.torque));
  for (const auto& one : law.sliders)
    lines.push_back(
        fmt::format("  a slider that slips after {:.6g} rad at {:.6g} N m, growing by {:.6g} N m/rad",
                    one.slips_at, one.torque, one.growth));
  for (const auto& one : law.arms)
    lines.push_back(fmt::format("  a Maxwell arm of {:.6g} N m/rad, time constant {:.6g} s", one.stiffness,
                                one.time_constant));
}

}  // namespace

std::vector<std::string> head_lines(const Model& model, const std::vector<Carried>& effects,
                                    const std::vector<std::string>& remarks) {
  std::vector<std::string> lines{model.title};
  for (const std::string& remark : remarks) lines.push_back(remark);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    lines.push_back(fmt::format("{}{}: {}", effects[e].carried ? "" : "NOT CARRIED: ", effects[e].effect,
                                effects[e].how));
    if (effects[e].carried || e >= model.experiment.effects.size()) continue;
    for (const auto& [name, value] : model.experiment.effects[e].parameters)
      lines.push_back(fmt::format("  {} = {:.6g}", name, value));
  }
  for (const diagnose::LawPicture& law : model.laws) add_law(law, lines);
  return lines;
}

}  // namespace plumbline::exchange
