#include "diagnose/stated/read_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <regex>

#include "files/printable.hpp"
#include "files/text_file.hpp"
#include "files/toml_file.hpp"

namespace plumbline::diagnose {
namespace {

/// A table of the file, and how errors name its keys.
class Table {
 public:
  Table(const toml::table& table, std::string source, std::string path)
      : table_(table), source_(std::move(source)), path_(std::move(path)) {}

  void allow_only(const std::vector<std::string_view>& keys) const {
    files::refuse_unknown_keys(table_, keys, source_);
  }
  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }
  [[nodiscard]] const toml::table& entries() const { return table_; }
  [[nodiscard]] std::string line() const { return files::place(table_, source_); }

  [[nodiscard]] std::string place(const std::string& key) const {
    const toml::node* node = table_.get(key);
    return files::place(node != nullptr ? *node : table_, source_) + ": " + path_ + files::shown(key);
  }

  [[nodiscard]] std::string text(const std::string& key, const std::string& expected) const {
    const toml::node& node = required(key, expected);
    if (!node.is_string() || node.as_string()->get().empty())
      throw Error(place(key), node.is_string() ? "an empty text" : "no text", expected);
    files::require_printable(node.as_string()->get(), place(key));
    return node.as_string()->get();
  }

  [[nodiscard]] double number(const std::string& key, const std::string& expected) const {
    const toml::node& node = required(key, expected);
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) throw Error(place(key), "no finite number", expected);
    return *value;
  }

  [[nodiscard]] Table table(const std::string& key) const {
    const std::string expected = "a table [effect." + key + "]";
    const toml::node& node = required(key, expected);
    if (!node.is_table() || node.as_table()->empty())
      throw Error(place(key), node.is_table() ? "an empty table" : "no table", expected);
    return {*node.as_table(), source_, path_ + key + "."};
  }

 private:
  [[nodiscard]] const toml::node& required(const std::string& key, const std::string& expected) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) throw Error(place(key), "no such key", expected);
    return *node;
  }

  const toml::table& table_;
  std::string source_, path_;
};

bool is_variable(const std::string& name) {
  const auto among = [&](const auto& all) { return std::find(all.begin(), all.end(), name) != all.end(); };
  return among(torque_variables) || among(reading_variables);
}

StatedParameter read_parameter(const Table& parameters, const std::string& name) {
  if (!can_be_named(name) || is_variable(name))
    throw Error(parameters.place(name), "a parameter of that name",
                "letters, digits and _, no variable and no function of expressions");
  const Table section = parameters.table(name);
  section.allow_only({"unit", "scale", "low", "high", "tolerance"});
  StatedParameter one{name,
                      section.text("unit", "a unit such as \"N m\", or \"ratio\""),
                      section.number("scale", "the size of a sizeable effect"),
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

std::vector<StatedParameter> read_parameters(const Table& effect) {
  const Table section = effect.table("parameters");
  std::vector<StatedParameter> all;
  for (const auto& [key, value] : section.entries())
    all.push_back(read_parameter(section, std::string(key.str())));
  constexpr std::size_t most = 8;
  if (all.size() > most)
    throw Error(effect.place("parameters"), fmt::format("{} parameters", all.size()),
                fmt::format("at most {}: more follow anything", most));
  if (std::none_of(all.begin(), all.end(), [](const StatedParameter& one) { return one.grows(); }))
    throw Error(effect.place("parameters"), "none that may be zero",
                "a parameter whose bounds include zero, where the chain is nominal");
  return all;
}

std::shared_ptr<const Formula> read_formula(const Table& section, const std::string& key,
                                            std::vector<std::string> variables, const StatedEffect& effect) {
  for (const StatedParameter& one : effect.parameters) variables.push_back(one.name);
  return std::make_shared<Formula>(section.text(key, "an expression"), variables, section.place(key));
}

StatedReading read_reading(const Table& section, const std::string& key, const StatedEffect& effect) {
  static const std::regex angle("q([1-9][0-9]{0,6})?");
  static const std::vector<std::string> others{"x", "y", "Fx", "Fy"};
  std::vector<std::string> variables(reading_variables.begin(), reading_variables.end());
  if (std::smatch found; std::regex_match(key, found, angle)) {
    const auto joint = found[1].matched ? std::optional(std::stoul(found[1]) - 1) : std::nullopt;
    return {Channel::Name::q, joint, key, read_formula(section, key, variables, effect)};
  }
  const auto place = std::find(others.begin(), others.end(), key);
  if (place == others.end())
    throw Error(section.place(key), "a reading of that name", "x, y, Fx, Fy, q or, of joint 2, q2");
  variables.pop_back();  // the angle
  constexpr Channel::Name names[]{Channel::Name::x, Channel::Name::y, Channel::Name::Fx, Channel::Name::Fy};
  return {names[place - others.begin()], std::nullopt, key, read_formula(section, key, variables, effect)};
}

/// Reports put the joint where the braces are.
std::string read_words(const Table& section, bool at_joint) {
  const std::string words = section.text("words", "what can stand after \"caused by\"");
  const std::size_t braces = words.find("{}");
  const std::string rest =
      at_joint && braces != std::string::npos ? words.substr(0, braces) + words.substr(braces + 2) : words;
  if ((at_joint && braces == std::string::npos) || rest.find_first_of("{}") != std::string::npos)
    throw Error(section.place("words"), "\"" + files::shown(words) + "\"",
                at_joint ? "one {} where the joint's number goes" : "no braces");
  return words;
}

bool read_where(const Table& section) {
  const std::string expected = "\"every joint\" or \"one joint\"", word = section.text("where", expected);
  if (word != "every joint" && word != "one joint")
    throw Error(section.place("where"), "\"" + files::shown(word) + "\"", expected);
  return word == "one joint";
}

std::string read_id(const Table& section) {
  static const std::regex form("[a-z][a-z0-9_]{0,59}");
  const std::string id = section.text("id", "a name of the effect");
  if (!std::regex_match(id, form) || id == "unknown")
    throw Error(section.place("id"), "\"" + files::shown(id) + "\"", "lower-case letters, digits and _");
  const auto& known = catalogue();
  if (std::any_of(known.begin(), known.end(), [&](const Effect& row) { return row.id == id; }))
    throw Error(section.place("id"), "\"" + id + "\"", "an id that no effect of the catalogue has");
  return id;
}

void require_all_used(const Table& section, const StatedEffect& effect) {
  for (const StatedParameter& one : effect.parameters)
    if (!effect.uses(one.name))
      throw Error(section.place("parameters"), "the parameter " + one.name + ", which no expression uses",
                  "parameters of the expressions alone");
}

StatedEffect read_effect(const Table& section) {
  section.allow_only({"id", "words", "where", "torque", "reading", "parameters"});
  StatedEffect effect;
  effect.place = section.line();
  effect.id = read_id(section);
  effect.parameters = read_parameters(section);
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
    const Table readings = section.table("reading");
    for (const auto& [key, value] : readings.entries())
      effect.readings.push_back(read_reading(readings, std::string(key.str()), effect));
  }
  effect.words = read_words(section, effect.at_joint);
  require_all_used(section, effect);
  return effect;
}

}  // namespace

std::vector<StatedEffect> parse_effects(const std::string& text, const std::string& source) {
  const toml::table table = files::parse_toml(text, source);
  const Table root(table, source, "");
  root.allow_only({"format", "effect"});
  if (const std::string format = root.text("format", "\"user-effects/1\""); format != "user-effects/1")
    throw Error(root.place("format"), "\"" + files::shown(format) + "\"", "\"user-effects/1\"");
  const toml::array* list = table.get_as<toml::array>("effect");
  if (list == nullptr || list->empty() || !list->is_homogeneous<toml::table>())
    throw Error(root.place("effect"), "no [[effect]]", "at least one");
  std::vector<StatedEffect> effects;
  for (const toml::node& node : *list) {
    const Table section(*node.as_table(), source, fmt::format("effect[{}].", effects.size() + 1));
    StatedEffect one = read_effect(section);
    for (const StatedEffect& other : effects)
      if (other.id == one.id)
        throw Error(section.place("id"), "\"" + one.id + "\" again", "an id that no other effect has");
    effects.push_back(std::move(one));
  }
  return effects;
}

std::shared_ptr<const std::vector<Effect>> read_effects(const std::filesystem::path& file,
                                                        const Study& study) {
  std::vector<Effect> rows;
  for (const StatedEffect& one : parse_effects(files::read_text(file), files::source_name(file))) {
    require_defined(one, study);
    rows.push_back(row_of(std::make_shared<StatedEffect>(one)));
  }
  return std::make_shared<const std::vector<Effect>>(std::move(rows));
}

}  // namespace plumbline::diagnose
