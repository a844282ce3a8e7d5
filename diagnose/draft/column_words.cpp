#include "diagnose/draft/column_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <plumbline/base/error.hpp>
#include <set>
#include <vector>

#include "diagnose/draft/actuator_words.hpp"

namespace plumbline::diagnose {
namespace {

using Words = std::vector<std::string>;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Letters and digits that stand together, in small letters: "tipX_mm" is tip, x, mm; "q12" is q, 12.
Words split(const std::string& title) {
  Words words(1);
  const auto kind_of = [](unsigned char c) {
    return std::isdigit(c) != 0 ? 'd' : std::isalpha(c) != 0 || c >= 0x80 ? 'a' : ' ';
  };
  char before = ' ';
  bool small = false;
  for (const char letter : title) {
    const auto c = static_cast<unsigned char>(letter);
    const char kind = kind_of(c);
    if (kind != before || (small && std::isupper(c) != 0)) words.emplace_back();
    if (kind != ' ') words.back() += letter;
    before = kind;
    small = std::islower(c) != 0;
  }
  std::erase(words, "");
  for (std::string& word : words) word = lower(word);
  return words;
}

/// What stands in brackets, or behind a slash.
std::string bracketed(const std::string& title) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')'), std::pair('{', '}')}) {
    const std::size_t from = title.find(open), to = title.find(close, from + 1);
    if (from != std::string::npos && to != std::string::npos) return title.substr(from + 1, to - from - 1);
  }
  const std::size_t slash = title.find('/');
  return slash == std::string::npos || slash == 0 ? "" : title.substr(slash + 1);
}

/// The letters at the end, as they are written: "kPa" of "pressure_kPa" and of "p1kPa"; nothing of one word.
std::string last_letters(const std::string& name) {
  std::size_t from = name.size();
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80; };
  while (from > 0 && is_letter(static_cast<unsigned char>(name[from - 1]))) --from;
  return from == 0 ? "" : name.substr(from);
}

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(" \t[(/"));
  text.erase(text.find_last_not_of(" \t])") + 1);
  return text;
}

/// As the unit is spelled here, where it is one of the quantity.
std::string unit_in(std::string text, const Quantity& quantity) {
  text = trimmed(std::move(text));
  static const std::array<std::pair<const char*, const char*>, 14> spelled{{{"degrees", "deg"},
                                                                            {"grad", "deg"},
                                                                            {"sec", "s"},
                                                                            {"seconds", "s"},
                                                                            {"msec", "ms"},
                                                                            {"newton", "N"},
                                                                            {"n", "N"},
                                                                            {"radians", "rad"},
                                                                            {"pa", "Pa"},
                                                                            {"kpa", "kPa"},
                                                                            {"mpa", "MPa"},
                                                                            {"hpa", "mbar"},
                                                                            {"psi", "lbf/in^2"},
                                                                            {"pascal", "Pa"}}};
  for (const auto& [theirs, ours] : spelled)
    if (lower(text) == theirs) text = ours;
  try {
    return text.empty() ? "" : parse_unit(text, quantity, "").name;
  } catch (const Error&) {
    return "";
  }
}

/// The first of some texts that is a unit of the quantity; or empty.
std::string unit_among(const Words& said, const Quantity& quantity) {
  for (const std::string& text : said)
    if (std::string unit = unit_in(text, quantity); !unit.empty()) return unit;
  return "";
}

bool any(const Words& words, const std::set<std::string>& of) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return of.contains(word); });
}

std::string last_axis(const Words& words) {
  for (auto word = words.rbegin(); word != words.rend(); ++word) {
    if (*word == "x" || *word == "y" || *word == "z") return *word;
    if (word->size() == 2 && word->front() == 'f' &&
        std::string("xyz").find(word->back()) != std::string::npos)
      return word->substr(1);
  }
  return "";
}

/// Whether a unit is one of temperature.
bool is_temperature(const std::string& unit) {
  static const std::set<std::string> units{"c", "\u00b0c", "degc", "deg c", "celsius"};
  return units.contains(lower(trimmed(unit)));
}

/// The tension of a tendon or the pressure in an actuator.
/// \param said  what may be a unit
Kind actuation_in(const Words& words, const Words& said) {
  // volts of a sensor that nobody has calibrated
  for (const std::string& text : said)
    if (any({lower(trimmed(text))}, {"v", "mv", "volt", "volts"})) return Kind::none;
  if (const Kind kind = actuation_of(words); kind != Kind::none) return kind;
  const Kind kind = actuation_with_unit(words);
  return kind != Kind::none && !unit_among(said, *quantity_of(kind)).empty() ? kind : Kind::none;
}

/// \param said  what may be a unit
Kind kind_of(const Words& words, const Words& said) {
  static const std::set<std::string> times{"t",         "time",  "zeit", "temps",   "tiempo",
                                           "timestamp", "stamp", "secs", "seconds", "ts"},
      forces{"f", "fx", "fy", "fz", "force", "kraft", "load", "last", "fuerza", "wrench", "ft"},
      places{"x", "y", "z"},
      angles{"q", "joint", "angle", "theta", "winkel", "phi", "gelenk", "encoder", "enc", "jnt", "servo"},
      runs{"run", "trial", "versuch", "essai", "experiment", "lauf", "rep", "repetition", "cycle"},
      torques{"torque", "tau", "drehmoment", "moment"},
      speeds{"v", "vel", "velocity", "dq", "qd", "speed", "acc", "accel", "effort", "current"},
      temperatures{"temp", "temperature", "temperatur"}, humidities{"humidity", "humid", "feuchte", "rh"};
  if (any(words, temperatures)) return Kind::temperature;
  if (any(words, humidities)) return Kind::humidity;
  if (any(words, torques)) return Kind::torque;
  if (any(words, speeds)) return Kind::none;
  const std::string axis = last_axis(words);
  if (const Kind kind = axis.empty() ? actuation_in(words, said) : Kind::none; kind != Kind::none)
    return kind;
  if (any(words, forces))
    return axis == "x"   ? Kind::force_x
           : axis == "y" ? Kind::force_y
           : axis == "z" ? Kind::force_z
                         : Kind::force;
  if (any(words, times)) return Kind::time;
  if (any(words, angles)) return Kind::angle;
  if (any(words, runs)) return Kind::run;
  if (any(words, places)) return axis == "x" ? Kind::x : axis == "y" ? Kind::y : Kind::z;
  static const std::set<std::string> ways{"traverse", "crosshead",    "travel",
                                          "weg",      "displacement", "extension"};
  return any(words, ways) ? Kind::x : Kind::none;
}

}  // namespace

std::vector<ColumnWords> words_of_standard(std::size_t columns, std::size_t joints) {
  constexpr std::array order{Kind::time, Kind::x, Kind::y, Kind::force_x, Kind::force_y};
  if (columns != order.size() && columns != order.size() + joints) return {};
  std::vector<ColumnWords> words(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    words[c].kind = c < order.size() ? order[c] : Kind::angle;
    if (c >= order.size()) words[c].joint = c - order.size() + 1;
  }
  return words;
}

bool is_force(Kind kind) {
  return kind == Kind::force || kind == Kind::force_x || kind == Kind::force_y || kind == Kind::force_z;
}

bool is_place(Kind kind) {
  return kind == Kind::x || kind == Kind::y || kind == Kind::z || kind == Kind::angle;
}

bool is_actuation(Kind kind) {
  return kind == Kind::tension || kind == Kind::pressure;
}

const Quantity* quantity_of(Kind kind) {
  switch (kind) {
    case Kind::time:
      return &quantity::time;
    case Kind::x:
    case Kind::y:
    case Kind::z:
      return &quantity::length;
    case Kind::force_x:
    case Kind::force_y:
    case Kind::force_z:
    case Kind::force:
    case Kind::tension:
      return &quantity::force;
    case Kind::pressure:
      return &quantity::pressure;
    case Kind::angle:
      return &quantity::angle;
    case Kind::none:
    case Kind::run:
    case Kind::temperature:
    case Kind::humidity:
    case Kind::torque:
      break;
  }
  return nullptr;
}

ColumnWords words_of(const std::string& title, const std::string& below,
                     const std::vector<std::string>& joints) {
  static const std::set<std::string> commands{"cmd",      "command", "commanded", "des",  "desired", "set",
                                              "setpoint", "soll",    "target",    "goal", "ref"};
  ColumnWords result;
  const std::string in_brackets = bracketed(title);
  const std::string name = in_brackets.empty() ? title : title.substr(0, title.find_first_of("[({/"));
  const Words words = split(name);
  const std::string letters = last_letters(name), last = words.size() > 1 ? words.back() : "";
  const Words said{in_brackets, below, letters, last};
  result.kind =
      is_temperature(in_brackets) || is_temperature(below) ? Kind::temperature : kind_of(words, said);
  const auto named = std::find_if(joints.begin(), joints.end(), [&](const std::string& joint) {
    return !joint.empty() && lower(name).find(lower(joint)) != std::string::npos;
  });
  if (named != joints.end() && (result.kind == Kind::none || result.kind == Kind::angle)) {
    result.kind = Kind::angle;
    result.joint = static_cast<std::size_t>(named - joints.begin()) + 1;
  } else if (result.kind == Kind::angle) {
    for (const std::string& word : words)
      if (std::isdigit(static_cast<unsigned char>(word.front())) != 0 && word.size() < 4)
        result.joint = std::stoul(word);
  }
  result.commanded = any(words, commands);
  const Quantity* const quantity = quantity_of(result.kind);
  if (quantity == nullptr) return result;
  result.unit = unit_among(said, *quantity);
  if (!is_actuation(result.kind)) return result;
  const bool has_unit = !unit_in(letters, *quantity).empty();
  Words own = split(has_unit ? name.substr(0, name.size() - letters.size()) : name);
  std::erase_if(own, [](const std::string& word) { return commands.contains(word); });
  result.variable = variable_of(own);
  return result;
}

}  // namespace plumbline::diagnose
