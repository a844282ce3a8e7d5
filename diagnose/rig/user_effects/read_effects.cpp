#include "diagnose/rig/user_effects/read_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <plumbline/base/error.hpp>
#include <regex>

#include "diagnose/bench/section.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

bool is_variable(const std::string& name, const StatedEffect& effect) {
  const auto among = [&](const auto& all) { return std::find(all.begin(), all.end(), name) != all.end(); };
  return among(torque_variables) || among(reading_variables) || among(effect.covariates);
}

StatedParameter read_parameter(const Section& parameters, const std::string& name,
                               const StatedEffect& effect) {
  if (!can_be_named(name) || is_variable(name, effect))
    throw Error(parameters.place(name), "a parameter of that name",
                "letters, digits and _, no variable and no function of expressions");
  const Section section = parameters.table(name);
  section.allow_only({"unit", "scale", "low", "high", "tolerance"});
  StatedParameter one{name,
                      section.text("unit", "a unit such as \"N m\", or \"ratio\""),
                      section.number("scale", "the typical size of the effect"),
                      section.number("low", "the lowest value it can have"),
                      section.number("high", "the highest value it can have"),
                      section.has("tolerance") ? section.number("tolerance", "a standard deviation") : 0};
  if (!(one.scale > 0)) throw Error(section.place("scale"), fmt::format("{}", one.scale), "a positive size");
  if (!(one.low < one.high))
    throw Error(section.place("high"), fmt::format("{} above low = {}", one.high, one.low), "low < high");
  if (!(one.high > 0))
    throw Error(section.place("high"), fmt::format("{}", one.high),
                "bounds that include zero and more, or are both positive");
  if (section.has("tolerance") && !(one.tolerance > 0 && one.grows()))
    throw Error(section.place("tolerance"), fmt::format("{}", one.tolerance),
                "a positive standard deviation of a parameter that may be zero");
  return one;
}

std::vector<StatedParameter> read_parameters(const Section& of, const StatedEffect& effect) {
  const Section section = of.table("parameters");
  if (section.keys().empty()) throw Error(of.place("parameters"), "an empty table", "a parameter or more");
  std::vector<StatedParameter> all;
  for (const std::string& key : section.keys()) all.push_back(read_parameter(section, key, effect));
  constexpr std::size_t most = 8;
  if (all.size() > most)
    throw Error(of.place("parameters"), fmt::format("{} parameters", all.size()),
                fmt::format("at most {}: more follow anything", most));
  if (std::none_of(all.begin(), all.end(), [](const StatedParameter& one) { return one.grows(); }))
    throw Error(of.place("parameters"), "none that may be zero",
                "a parameter whose bounds include zero, where the chain is nominal");
  return all;
}

std::shared_ptr<const Formula> read_formula(const Section& section, const std::string& key,
                                            std::vector<std::string> variables, const StatedEffect& effect) {
  variables.insert(variables.end(), effect.covariates.begin(), effect.covariates.end());
  for (const StatedParameter& one : effect.parameters) variables.push_back(one.name);
  return std::make_shared<Formula>(section.text(key, "an expression"), variables, section.place(key));
}

StatedReading read_reading(const Section& section, const std::string& key, const StatedEffect& effect) {
  static const std::regex angle("q([1-9][0-9]{0,6})?");
  static const std::vector<std::string> others{"x", "y", "Fx", "Fy", "angle", "torque"};
  std::vector<std::string> variables(reading_variables.begin(), reading_variables.end());
  if (std::smatch found; std::regex_match(key, found, angle)) {
    const auto joint = found[1].matched ? std::optional(std::stoul(found[1]) - 1) : std::nullopt;
    variables.insert(variables.end(), angle_variables.begin(), angle_variables.end());
    return {Channel::Name::q, joint, key, read_formula(section, key, variables, effect)};
  }
  const auto place = std::find(others.begin(), others.end(), key);
  if (place == others.end())
    throw Error(section.place(key), "a reading of that name",
                "x, y, Fx, Fy, angle, torque, q or, of joint 2, q2");
  using Name = Channel::Name;
  constexpr Name names[]{Name::x, Name::y, Name::Fx, Name::Fy, Name::angle, Name::torque};
  return {names[place - others.begin()], std::nullopt, key, read_formula(section, key, variables, effect)};
}

/// Braces stand for the joint in reports.
std::string read_words(const Section& section, bool at_joint) {
  const std::string words = section.text("words", "what can stand after \"caused by\"");
  const std::size_t braces = words.find("{}");
  const std::string rest =
      at_joint && braces != std::string::npos ? words.substr(0, braces) + words.substr(braces + 2) : words;
  if ((at_joint && braces == std::string::npos) || rest.find_first_of("{}") != std::string::npos)
    throw Error(section.place("words"), "\"" + files::shown(words) + "\"",
                at_joint ? "one {} where the joint's number goes" : "no braces");
  return words;
}

bool read_where(const Section& section) {
  const std::string expected = "\"every joint\" or \"one joint\"", word = section.text("where", expected);
  if (word != "every joint" && word != "one joint")
    throw Error(section.place("where"), "\"" + files::shown(word) + "\"", expected);
  return word == "one joint";
}

std::string read_id(const Section& section) {
  static const std::regex form("[a-z][a-z0-9_]{0,59}");
  const std::string id = section.text("id", "a name of the effect");
  if (!std::regex_match(id, form))
    throw Error(section.place("id"), "\"" + files::shown(id) + "\"", "lower-case letters, digits and _");
  constexpr std::array reserved{"none", "unknown", "torque_law"};
  if (std::find(reserved.begin(), reserved.end(), id) != reserved.end())
    throw Error(section.place("id"), "\"" + id + "\"",
                "a word that reports have no meaning of their own for");
  const auto& known = catalogue();
  if (std::any_of(known.begin(), known.end(), [&](const Effect& row) { return row.id == id; }))
    throw Error(section.place("id"), "\"" + id + "\"", "an id that no effect of the catalogue has");
  return id;
}

void require_all_used(const Section& section, const StatedEffect& effect) {
  for (const StatedParameter& one : effect.parameters)
    if (!effect.uses(one.name))
      throw Error(section.place("parameters"), "the parameter " + one.name + ", which no expression uses",
                  "parameters of the expressions alone");
}

StatedEffect read_effect(const Section& section, const std::vector<std::string>& covariates) {
  section.allow_only({"id", "words", "where", "torque", "reading", "parameters"});
  StatedEffect effect;
  effect.place = section.where();
  effect.id = read_id(section);
  effect.covariates = covariates;
  effect.parameters = read_parameters(section, effect);
  if (section.has("torque") == section.has("reading"))
    throw Error(effect.place, section.has("torque") ? "torque and reading" : "neither torque nor reading",
                "one of them");
  if (section.has("torque")) {
    effect.at_joint = read_where(section);
    effect.torque =
        read_formula(section, "torque", {torque_variables.begin(), torque_variables.end()}, effect);
  } else {
    if (section.has("where"))
      throw Error(section.place("where"), "a place", "none for a correction of readings");
    const Section readings = section.table("reading");
    if (readings.keys().empty()) throw Error(section.place("reading"), "an empty table", "a reading or more");
    for (const std::string& key : readings.keys())
      effect.readings.push_back(read_reading(readings, key, effect));
  }
  effect.words = read_words(section, effect.at_joint);
  require_all_used(section, effect);
  return effect;
}

}  // namespace

std::vector<StatedEffect> parse_effects(const std::string& text, const std::string& source,
                                        const std::vector<std::string>& covariates) {
  for (const std::string& name : covariates)
    if (!can_be_named(name))
      throw Error("columns.covariate." + name, "the name of a function of expressions", "another name");
  const toml::table table = files::parse_toml(text, source);
  const Section root(table, source);
  root.allow_only({"format", "effect"});
  if (const std::string format = root.text("format", "\"user-effects/1\""); format != "user-effects/1")
    throw Error(root.place("format"), "\"" + files::shown(format) + "\"", "\"user-effects/1\"");
  const std::vector<Section> sections = root.tables("effect");
  if (sections.empty()) throw Error(root.place("effect"), "no [[effect]]", "at least one");
  std::vector<StatedEffect> effects;
  for (const Section& section : sections) {
    StatedEffect one = read_effect(section, covariates);
    for (const StatedEffect& other : effects)
      if (other.id == one.id)
        throw Error(section.place("id"), "\"" + one.id + "\" again", "an id that no other effect has");
    effects.push_back(std::move(one));
  }
  return effects;
}

std::vector<StatedEffect> read_effects(const std::filesystem::path& file,
                                       const std::vector<std::string>& covariates) {
  return parse_effects(files::read_text(file), files::source_name(file), covariates);
}

}  // namespace plumbline::diagnose
