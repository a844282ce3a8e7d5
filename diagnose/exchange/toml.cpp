#include "diagnose/exchange/toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/exchange/carried.hpp"

namespace plumbline::exchange {
namespace {

bool any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v != 0; });
}

std::string list(const char* key, const std::vector<double>& values) {
  return fmt::format("{} = [{}]\n", key, fmt::join(values, ", "));
}

/// Deflections and torques of knots.
std::array<std::vector<double>, 2> columns(const std::vector<diagnose::FreeLaw::Knot>& knots) {
  std::array<std::vector<double>, 2> both;
  for (const auto& knot : knots) both[0].push_back(knot.deflection), both[1].push_back(knot.torque);
  return both;
}

std::string slider_table(const diagnose::FreeLaw::Slider& one) {
  if (one.profile.empty())
    return fmt::format("{{ slips_at = {}, {} = {} }}", one.slips_at, one.growth > 0 ? "growth" : "torque",
                       one.growth > 0 ? one.growth : one.torque);
  const auto [deflection, torque] = columns(one.profile);
  return fmt::format("{{ slips_at = {}, deflection = [{}], torque = [{}] }}", one.slips_at,
                     fmt::join(deflection, ", "), fmt::join(torque, ", "));
}

std::string law_table(const diagnose::FreeLaw& law) {
  const auto [deflection, torque] = columns(law.knots);
  std::string text = fmt::format("\n[[nominal.torque_law]]\njoint = {}\n", law.joint), sliders, arms;
  text += list("deflection", deflection) + list("torque", torque);
  for (const auto& one : law.sliders) sliders += (sliders.empty() ? "" : ", ") + slider_table(one);
  for (const auto& one : law.arms)
    arms += fmt::format("{}{{ time_constant = {}, stiffness = {} }}", arms.empty() ? "" : ", ",
                        one.time_constant, one.stiffness);
  if (!sliders.empty()) text += "sliders = [" + sliders + "]\n";
  return arms.empty() ? text : text + "arms = [" + arms + "]\n";
}

/// The links, or the joint that is alone.
std::string what_it_is(const diagnose::NominalChain& chain) {
  if (chain.has_links()) return list("link_length", chain.link_length);
  return fmt::format("joint = \"{}\"\n", chain.slides(0) ? "prismatic" : "revolute");
}

}  // namespace

Written to_toml(const Model& model) {
  const diagnose::NominalChain& chain = model.experiment;
  Written file;
  for (const diagnose::NominalEffect& effect : chain.effects)
    file.effects.push_back({effect.label(), true,
                            of_catalogue(effect) ? "as [[nominal.effect]]"
                                                 : "as [[nominal.effect]], to be read with --effects again"});
  for (const diagnose::FreeLaw& law : chain.laws)
    file.effects.push_back({fmt::format("torque_law({})", law.joint), true, "as [[nominal.torque_law]]"});
  for (const std::string& line : head_lines(model, file.effects)) file.text += "# " + line + "\n";
  file.text += "\n[nominal]\n" + what_it_is(chain) + list("joint_stiffness", chain.joint_stiffness);
  if (any(chain.link_mass)) file.text += list("link_mass", chain.link_mass);
  if (chain.gravity != std::array<double, 2>{0, 0})
    file.text += list("gravity", {chain.gravity.begin(), chain.gravity.end()});
  if (!chain.rest.empty()) file.text += list("rest", chain.rest);
  for (const diagnose::NominalEffect& effect : chain.effects) file.text += nominal_effect_table(effect);
  for (const diagnose::FreeLaw& law : chain.laws) file.text += law_table(law);
  return file;
}

}  // namespace plumbline::exchange
