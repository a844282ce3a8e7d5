#include "diagnose/draft/column_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "diagnose/draft/actuator_words.hpp"
#include "diagnose/draft/unit_words.hpp"
#include "diagnose/draft/word_table.hpp"

namespace plumbline::diagnose {
namespace {

using Words = std::vector<std::string>;

/// Letters, digits and scripts without blanks; what is of one sort stands together.
char sort_of(const std::string& text, std::size_t at) {
  const auto c = static_cast<unsigned char>(text[at]);
  if (std::isdigit(c) != 0) return 'd';
  if (c < 0x80) return std::isalpha(c) != 0 ? 'a' : ' ';
  // U+3000 and above begin with the bytes E3 and more; what follows in a letter is of its sort.
  std::size_t first = at;
  while (first > 0 && (static_cast<unsigned char>(text[first]) & 0xC0U) == 0x80U) --first;
  return static_cast<unsigned char>(text[first]) >= 0xE3 ? 'h' : 'a';
}

/// In small letters, without accents: "tipX_mm" is tip, x, mm; "q12" is q, 12.
Words split(const std::string& title) {
  Words words(1);
  char before = ' ';
  bool small = false;
  for (std::size_t i = 0; i < title.size(); ++i) {
    const char sort = sort_of(title, i);
    const auto c = static_cast<unsigned char>(title[i]);
    if (sort != before || (small && std::isupper(c) != 0)) words.emplace_back();
    if (sort != ' ') words.back() += title[i];
    before = sort;
    small = std::islower(c) != 0;
  }
  std::erase(words, "");
  for (std::string& word : words) word = folded(word);
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

bool any(const Words& words, std::initializer_list<const char*> of) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(of.begin(), of.end(), word) != of.end();
  });
}

bool is_axis(char letter) {
  return letter == 'x' || letter == 'y' || letter == 'z';
}

/// Of "x", "Fx" or "My", the last one; or a blank.
char last_axis(const Words& words) {
  for (auto word = words.rbegin(); word != words.rend(); ++word) {
    const bool alone = word->size() == 1,
               behind = word->size() == 2 && (word->front() == 'f' || word->front() == 'm');
    if ((alone || behind) && is_axis(word->back())) return word->back();
  }
  return ' ';
}

Kind along(char axis, Kind x, Kind y, Kind z) {
  return axis == 'x' ? x : axis == 'y' ? y : z;
}

/// The tension of a tendon or the pressure in an actuator.
/// \param said  what may be a unit
Kind actuation_in(const Words& words, const Words& said) {
  // volts of a sensor that nobody has calibrated
  for (const std::string& text : said)
    if (any(split(text), {"v", "mv", "volt", "volts"}) && text.size() < 6) return Kind::none;
  if (const Kind kind = actuation_of(words); kind != Kind::none) return kind;
  const Kind kind = actuation_with_unit(words);
  return kind != Kind::none && !unit_among(said, *quantity_of(kind)).empty() ? kind : Kind::none;
}

/// 'W', 'X', 'Y', 'Z' of a quaternion, 'r', 'p', 'y' of roll, pitch, yaw; or a blank.
char rotation_axis(const Words& words) {
  for (const std::string& word : words)
    if (word == "roll" || word == "pitch" || word == "yaw") return word.front();
  for (const std::string& word : words)
    if (word.size() == 2 && word.front() == 'q' && (is_axis(word[1]) || word[1] == 'w'))
      return static_cast<char>(std::toupper(word[1]));
  if (!any(words, {"quat", "quaternion", "orientation", "rotation", "rot"})) return ' ';
  if (any(words, {"w"})) return 'W';
  const char axis = last_axis(words);
  return axis == ' ' ? ' ' : static_cast<char>(std::toupper(axis));
}

/// Where words and unit say different things, the unit is right: "position [deg]" is an angle.
Kind kind_by_unit(Kind by_words, char axis, const Words& said) {
  static const std::array kinds{Kind::time,   Kind::x,    Kind::force,   Kind::angle,
                                Kind::torque, Kind::mass, Kind::pressure};
  const auto is = [&](Kind kind) { return !unit_among(said, *quantity_of(kind)).empty(); };
  if (by_words == Kind::none) {
    for (const std::string& text : said)
      if (is_current_unit(text)) return Kind::current;
    const auto found = std::find_if(kinds.begin(), kinds.end(), is);
    if (found == kinds.end()) return Kind::none;
    const bool weighs =
        *found == Kind::force && is(Kind::mass);  // grams are a mass where no word says a force
    return weighs ? Kind::mass : *found;
  }
  const bool place = by_words == Kind::x || by_words == Kind::y || by_words == Kind::z;
  if (place && is(Kind::angle)) return Kind::angle;
  if (by_words == Kind::angle && is(Kind::x))
    return axis == ' ' ? Kind::x : along(axis, Kind::x, Kind::y, Kind::z);
  if (is_force(by_words) && is(Kind::torque) && !is(Kind::force)) return Kind::torque;
  return by_words;
}

/// \param said  what may be a unit
Kind kind_of(const Words& words, const Words& said, char rotation) {
  const char axis = last_axis(words);
  if (says(words, Meaning::temperature)) return Kind::temperature;
  if (says(words, Meaning::humidity)) return Kind::humidity;
  if (says(words, Meaning::current)) return Kind::current;
  if (rotation != ' ') return Kind::rotation;
  if (any(words, {"mx", "my", "mz"}) || (says(words, Meaning::torque) && axis != ' '))
    return along(axis, Kind::moment_x, Kind::moment_y, Kind::moment_z);
  if (says(words, Meaning::torque)) return Kind::torque;
  if (says(words, Meaning::speed)) return Kind::none;
  if (says(words, Meaning::force_with_axis) && axis == ' ') return Kind::torque;
  if (const Kind kind = axis == ' ' ? actuation_in(words, said) : Kind::none; kind != Kind::none) return kind;
  if (says(words, Meaning::force) || says(words, Meaning::force_with_axis))
    return axis == ' ' ? Kind::force : along(axis, Kind::force_x, Kind::force_y, Kind::force_z);
  if (says(words, Meaning::mass)) return Kind::mass;
  if (says(words, Meaning::time)) return Kind::time;
  if (says(words, Meaning::angle)) return Kind::angle;
  if (says(words, Meaning::run)) return Kind::run;
  if (axis != ' ') return along(axis, Kind::x, Kind::y, Kind::z);
  return says(words, Meaning::place) ? Kind::x : Kind::none;
}

std::size_t number_in(const Words& words) {
  std::size_t number = 0;
  for (const std::string& word : words)
    if (std::isdigit(static_cast<unsigned char>(word.front())) != 0 && word.size() < 4)
      number = std::stoul(word);
  return number;
}

bool is_of_a_joint(Kind kind) {
  return kind == Kind::angle || kind == Kind::torque || kind == Kind::current;
}

/// The joint that a title names; or 0.
std::size_t named_joint(const std::string& name, const std::vector<std::string>& joints) {
  std::size_t found = 0, longest = 0;
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].size() > longest && folded(name).find(folded(joints[j])) != std::string::npos)
      found = j + 1, longest = joints[j].size();
  return found;
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

bool is_missed(const ColumnWords& words) {
  const Kind kind = words.kind;
  const bool of_bench = is_force(kind) || is_place(kind) || is_of_a_joint(kind) || is_actuation(kind) ||
                        kind == Kind::mass || kind == Kind::temperature || kind == Kind::rotation ||
                        kind == Kind::moment_x || kind == Kind::moment_y || kind == Kind::moment_z;
  return of_bench && words.treatment == Treatment::none;
}

const char* name_of(Kind kind) {
  if (kind == Kind::current) return "a current";
  if (kind == Kind::temperature) return "a temperature";
  if (kind == Kind::humidity) return "a humidity";
  if (kind == Kind::rotation) return "an orientation";
  if (kind == Kind::run) return "a run";
  if (kind == Kind::number) return "a number of its line";
  const Quantity* const quantity = quantity_of(kind);
  return quantity == nullptr ? "a quantity that its name does not say" : quantity->name;
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
    case Kind::rotation:
      return &quantity::angle;
    case Kind::torque:
    case Kind::moment_x:
    case Kind::moment_y:
    case Kind::moment_z:
      return &quantity::torque;
    case Kind::mass:
      return &quantity::mass;
    case Kind::none:
    case Kind::run:
    case Kind::temperature:
    case Kind::humidity:
    case Kind::current:
    case Kind::number:
    case Kind::doubled:
    case Kind::left_out:
      break;
  }
  return nullptr;
}

ColumnWords words_of(const std::string& title, const std::string& below,
                     const std::vector<std::string>& joints) {
  ColumnWords result;
  const std::string in_brackets = bracketed(title);
  const std::string name = in_brackets.empty() ? title : title.substr(0, title.find_first_of("[({/"));
  const Words words = split(name);
  const std::string letters = last_letters(name), last = words.size() > 1 ? words.back() : "";
  const Words said{in_brackets, below, letters, last};
  result.axis = rotation_axis(words);
  const bool warm = is_temperature_unit(in_brackets) || is_temperature_unit(below);
  result.kind = warm ? Kind::temperature : kind_of(words, said, result.axis);
  const std::size_t named = named_joint(name, joints);
  if (named > 0 && result.kind == Kind::none && !says(words, Meaning::speed)) result.kind = Kind::angle;
  if (!says(words, Meaning::speed)) result.kind = kind_by_unit(result.kind, last_axis(words), said);
  result.commanded = says(words, Meaning::command);
  if (result.kind == Kind::none && !says(words, Meaning::speed))
    result.kind = result.commanded || says(words, Meaning::reached) ? Kind::angle
                  : says(words, Meaning::number)                    ? Kind::number
                                                                    : Kind::none;
  if (is_of_a_joint(result.kind)) result.joint = named > 0 ? named : number_in(words);
  result.at_motor = result.kind == Kind::angle && says(words, Meaning::motor);
  result.treatment = says(words, Meaning::raw)        ? Treatment::raw
                     : says(words, Meaning::filtered) ? Treatment::filtered
                                                      : Treatment::none;
  const Quantity* const quantity = quantity_of(result.kind);
  if (quantity == nullptr) return result;
  result.unit = unit_among(said, *quantity);
  if (!is_actuation(result.kind)) return result;
  const bool has_unit = !unit_in(letters, *quantity).empty();
  Words own = split(has_unit ? name.substr(0, name.size() - letters.size()) : name);
  std::erase_if(own, [](const std::string& word) { return says({word}, Meaning::command); });
  result.variable = variable_of(own);
  return result;
}

}  // namespace plumbline::diagnose
