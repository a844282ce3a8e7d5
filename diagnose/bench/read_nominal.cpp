#include "diagnose/bench/read_nominal.hpp"

#include <fmt/format.h>

#include <plumbline/base/error.hpp>

namespace plumbline::diagnose {
namespace {

NominalEffect read_nominal_effect(const Section& section) {
  section.allow_only({"id", "joint", "parameters"});
  return {section.text("id", "an id of the effect catalogue"), section.count("joint"),
          section.named_numbers("parameters")};
}

std::vector<FreeLaw::Knot> read_knots(const Section& section) {
  const std::vector<double> deflection = section.numbers("deflection", 0),
                            torque = section.numbers("torque", deflection.size());
  std::vector<FreeLaw::Knot> knots;
  for (std::size_t k = 0; k < deflection.size(); ++k) {
    if (k > 0 && !(deflection[k] > deflection[k - 1])) section.refuse("deflection", "numbers that rise");
    knots.push_back({deflection[k], torque[k]});
  }
  return knots;
}

FreeLaw::Slider read_slider(const Section& section) {
  section.allow_only({"slips_at", "torque", "growth", "deflection"});
  const std::string positive = "a positive number", one = "either torque or growth";
  FreeLaw::Slider slider{section.number("slips_at", positive), 0, 0};
  if (!(slider.slips_at > 0)) section.refuse("slips_at", positive);
  if (section.has("torque") == section.has("growth"))
    throw Error(section.where(), section.has("torque") ? "both" : "neither", one);
  if (section.has("deflection")) {
    slider.profile = read_knots(section);
    return slider;
  }
  const std::string key = section.has("torque") ? "torque" : "growth";
  double& own = section.has("torque") ? slider.torque : slider.growth;
  own = section.number(key, positive);
  if (!(own > 0)) section.refuse(key, positive);
  return slider;
}

FreeLaw::Arm read_arm(const Section& section) {
  section.allow_only({"time_constant", "stiffness"});
  const FreeLaw::Arm arm{section.number("time_constant", "a positive number of seconds"),
                         section.number("stiffness", "a positive stiffness")};
  if (!(arm.time_constant > 0)) section.refuse("time_constant", "a positive number of seconds");
  if (!(arm.stiffness > 0)) section.refuse("stiffness", "a positive stiffness");
  return arm;
}

FreeLaw read_law(const Section& section, std::size_t joints) {
  section.allow_only({"joint", "deflection", "torque", "sliders", "arms"});
  FreeLaw law{section.count("joint"), {}, {}, {}};
  if (law.joint == 0 || law.joint > joints)
    throw Error(section.place("joint"), law.joint == 0 ? "no such key" : std::to_string(law.joint),
                "a joint from 1 to " + std::to_string(joints));
  law.knots = read_knots(section);
  for (const Section& one : section.tables("sliders")) law.sliders.push_back(read_slider(one));
  for (const Section& one : section.tables("arms")) law.arms.push_back(read_arm(one));
  return law;
}

/// The key as in experiments or as in chain files, whichever is present.
std::string spelling(const Section& nominal, const std::string& here, const std::string& in_chain_files) {
  if (!nominal.has(in_chain_files)) return here;
  if (nominal.has(here))
    throw Error(nominal.place(in_chain_files), "both " + here + " and " + in_chain_files,
                "one of the two, which mean the same");
  return in_chain_files;
}

/// Whether the file has a joint alone in place of a chain, and which.
/// \param lengths  the key of a chain's links
Device read_device(const Section& nominal, const std::string& lengths) {
  if (!nominal.has("joint") && !nominal.has(lengths))
    throw Error(nominal.where(), "neither link_length nor joint",
                "the lengths of a chain, or \"revolute\" or \"prismatic\" for a joint alone");
  if (!nominal.has("joint")) return Device::chain;
  const std::string word = nominal.one_of("joint", {"revolute", "prismatic"});
  for (const char* key : {"link_length", "lengths", "link_mass", "gravity"})
    if (nominal.has(key)) nominal.refuse(key, "nothing beside nominal.joint: a joint alone has no link");
  return word == "revolute" ? Device::turning_joint : Device::sliding_joint;
}

}  // namespace

NominalChain read_nominal(const Section& nominal) {
  nominal.allow_only(
      {"joint", "link_length", "joint_stiffness", "link_mass", "gravity", "rest", "effect", "torque_law"},
      {"lengths", "stiffness"});
  const std::string lengths = spelling(nominal, "link_length", "lengths"),
                    stiffness = spelling(nominal, "joint_stiffness", "stiffness");
  NominalChain chain;
  chain.device = read_device(nominal, lengths);
  chain.link_length = chain.has_links()
                          ? nominal.numbers(lengths, 0, "a positive length", [](double v) { return v > 0; })
                          : std::vector{1.0};
  const std::size_t n = chain.link_length.size();
  const auto not_negative = [](double v) { return v >= 0; };
  chain.joint_stiffness =
      nominal.numbers(stiffness, n, "zero (passive) or a positive stiffness", not_negative);
  chain.link_mass.assign(n, 0.0);
  if (nominal.has("link_mass"))
    chain.link_mass = nominal.numbers("link_mass", n, "zero or a positive mass", not_negative);
  if (nominal.has("gravity")) chain.gravity = nominal.pair("gravity");
  if (nominal.has("rest")) chain.rest = nominal.numbers("rest", n);
  for (const Section& effect : nominal.tables("effect")) chain.effects.push_back(read_nominal_effect(effect));
  for (const Section& law : nominal.tables("torque_law")) chain.laws.push_back(read_law(law, n));
  return chain;
}

std::string nominal_effect_table(const NominalEffect& effect) {
  std::string text = fmt::format("\n[[nominal.effect]]\nid = \"{}\"\n", effect.id), parameters;
  if (effect.joint > 0) text += fmt::format("joint = {}\n", effect.joint);
  for (const auto& [name, value] : effect.parameters)
    parameters += fmt::format("{}{} = {}", parameters.empty() ? "" : ", ", name, value);
  return text + "parameters = { " + parameters + " }\n";
}

NominalChain parse_nominal(const std::string& text, const std::string& source) {
  const toml::table table = files::parse_toml(text, source);
  const Section root(table, source);
  root.allow_only({"nominal"});
  return read_nominal(root.table("nominal"));
}

}  // namespace plumbline::diagnose
