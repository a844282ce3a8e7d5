#include "diagnose/exchange/catalogue_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/model_gravity.hpp"
#include "diagnose/exchange/xml_document.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::FreeLaw, diagnose::NominalEffect;
using pugi::xml_node;

constexpr const char* target = "plumbline";

std::string instruction(const std::vector<std::pair<std::string, std::string>>& says) {
  std::string text = std::string("<?") + target;
  for (const auto& [name, value] : says) text += " " + name + "=\"" + escaped(value) + "\"";
  return text + "?>\n";
}

std::string instruction_of(const NominalEffect& effect) {
  std::vector<std::pair<std::string, std::string>> says{{"effect", effect.id}};
  if (effect.joint > 0) says.emplace_back("joint", std::to_string(effect.joint));
  for (const auto& [name, value] : effect.parameters) says.emplace_back(name, fmt::format("{}", value));
  return instruction(says);
}

std::string instruction_of(const FreeLaw& law) {
  std::vector<double> knots, sliders, arms;
  for (const auto& one : law.knots) knots.insert(knots.end(), {one.deflection, one.torque});
  for (const auto& one : law.sliders) sliders.insert(sliders.end(), {one.slips_at, one.torque, one.growth});
  for (const auto& one : law.arms) arms.insert(arms.end(), {one.time_constant, one.stiffness});
  const auto list = [](const std::vector<double>& all) { return fmt::format("{}", fmt::join(all, " ")); };
  return instruction({{"torque_law", std::to_string(law.joint)},
                      {"knots", list(knots)},
                      {"sliders", list(sliders)},
                      {"arms", list(arms)}});
}

std::size_t joint_in(const pugi::xml_attribute& said, const std::string& place) {
  const double joint = said ? number_in(said.value(), place) : 0;
  if (joint < 0 || joint != std::floor(joint)) throw Error(place, said.value(), "the number of a joint");
  return static_cast<std::size_t>(joint);
}

NominalEffect effect_in(xml_node said, const std::string& place) {
  NominalEffect effect{said.attribute("effect").value(), joint_in(said.attribute("joint"), place), {}};
  for (const pugi::xml_attribute one : said.attributes())
    if (const std::string name = one.name(); name != "effect" && name != "joint")
      effect.parameters[name] = number_in(one.value(), place + ": " + name);
  return effect;
}

FreeLaw law_in(xml_node said, const std::string& place) {
  const auto list = [&](const char* name, std::size_t width) {
    constexpr std::size_t most = 10000;
    const std::vector<double> all = numbers_in(said.attribute(name).value(), place + ": " + name, 0, most);
    if (all.size() % width != 0)
      throw Error(place + ": " + name, fmt::format("{} numbers", all.size()),
                  fmt::format("a multiple of {}", width));
    return all;
  };
  FreeLaw law{joint_in(said.attribute("torque_law"), place), {}, {}, {}};
  const std::vector<double> knots = list("knots", 2), sliders = list("sliders", 3), arms = list("arms", 2);
  for (std::size_t i = 0; i < knots.size(); i += 2) law.knots.push_back({knots[i], knots[i + 1]});
  for (std::size_t i = 0; i < sliders.size(); i += 3)
    law.sliders.push_back({sliders[i], sliders[i + 1], sliders[i + 2]});
  for (std::size_t i = 0; i < arms.size(); i += 2) {
    FreeLaw::Arm& one = law.arms.emplace_back();
    one.time_constant = arms[i], one.stiffness = arms[i + 1];
  }
  return law;
}

/// \param use  of what it says, as attributes, and of its place in the file
template <class Use>
void for_each_instruction(const pugi::xml_document& document, const std::string& file, const Use& use) {
  for (const xml_node one : document.children()) {
    if (one.type() != pugi::node_pi || std::string(one.name()) != target) continue;
    const std::string place = fmt::format("{}: <?{} {}?>", file, target, files::shown(one.value()));
    pugi::xml_document inside;
    parse(std::string("<row ") + one.value() + "/>", place, inside);
    use(inside.document_element(), place);
  }
}

void add_names(xml_node element, std::set<std::string>& names) {
  if (const auto name = element.attribute("name")) names.insert(name.value());
  for (const xml_node child : element.children()) add_names(child, names);
}

std::set<std::string> names_in(const std::string& text) {
  pugi::xml_document document;
  parse(text, "corrected model", document);
  std::set<std::string> names;
  add_names(document, names);
  return names;
}

/// A declaration stands before all else, and before that the mark of an encoding.
std::string with_head(const std::string& text, std::string head) {
  std::size_t at = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  if (text.compare(at, 6, "<?xml ") == 0) {
    at = text.find("?>", at) + 2;
    const std::size_t line = text.find_first_not_of(" \t\r", at);
    if (line != std::string::npos && text[line] == '\n')
      at = line + 1;
    else
      head.insert(0, "\n");
  }
  return text.substr(0, at) + head + text.substr(at);
}

}  // namespace

CatalogueRows catalogue_rows_in(const pugi::xml_document& document, const std::string& file) {
  CatalogueRows rows;
  for_each_instruction(document, file, [&](xml_node said, const std::string& place) {
    if (said.attribute("effect"))
      rows.effects.push_back(effect_in(said, place));
    else if (said.attribute("torque_law"))
      rows.laws.push_back(law_in(said, place));
    else if (const auto name = said.attribute("added"))
      rows.added.insert(files::shown(name.value()));
    else if (!said.attribute("gravity"))
      throw Error(place, "no row of the catalogue", "effect=, torque_law=, added= or gravity=");
  });
  return rows;
}

std::string with_catalogue_rows(const std::string& text, const CatalogueRows& rows, const std::string& bare) {
  std::string head;
  for (const NominalEffect& one : rows.effects) head += instruction_of(one);
  for (const FreeLaw& one : rows.laws) head += instruction_of(one);
  const std::set<std::string> known = names_in(bare);
  for (const std::string& name : names_in(text))
    if (!known.contains(name)) head += instruction({{"added", name}});
  return with_head(text, head);
}

std::optional<Eigen::Vector3d> gravity_in(const pugi::xml_document& document, const std::string& file) {
  std::optional<Eigen::Vector3d> gravity;
  for_each_instruction(document, file, [&](xml_node said, const std::string& place) {
    if (const auto own = said.attribute("gravity")) gravity = vector_in(own.value(), place);
  });
  return gravity;
}

std::string with_gravity(const std::string& text, const Eigen::Vector3d& gravity) {
  return with_head(text, instruction({{"gravity", numbers_of(gravity)}}));
}

}  // namespace plumbline::exchange
