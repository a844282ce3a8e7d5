#include "diagnose/draft/actuator_words.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

namespace plumbline::diagnose {
namespace {

using WordSet = std::set<std::string>;

bool has_one(const std::vector<std::string>& words, const WordSet& of) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return of.contains(word); });
}

bool names_tendon(const std::vector<std::string>& words) {
  static const WordSet tendons{"tendon", "tendons",  "cable", "wire",  "rope",  "string", "cord",
                               "flexor", "extensor", "seil",  "sehne", "kabel", "draht",  "bowden"};
  return has_one(words, tendons);
}

bool names_chamber(const std::vector<std::string>& words) {
  static const WordSet chambers{"p",    "chamber", "muscle", "actuator", "pam",   "bellow",   "bellows",
                                "balg", "kammer",  "muskel", "aktor",    "valve", "mckibben", "regulator"};
  return has_one(words, chambers);
}

/// As German joins words: "Seilkraft", "Sehnenkraft", "Zugkraft".
bool is_force_of_tendon(const std::string& word) {
  static const WordSet stems{"seil", "sehne", "zug", "kabel", "draht", "bowden"};
  return word.ends_with("kraft") && std::any_of(stems.begin(), stems.end(), [&](const std::string& stem) {
           return word.starts_with(stem);
         });
}

bool says_tension(const std::vector<std::string>& words) {
  static const WordSet tensions{"tension", "seilspannung", "sehnenspannung", "tension"},
      forces{"f", "force", "kraft", "load", "last", "fuerza", "pull", "zug"};
  return has_one(words, tensions) || std::any_of(words.begin(), words.end(), is_force_of_tendon) ||
         (names_tendon(words) && has_one(words, forces));
}

bool says_pressure(const std::vector<std::string>& words) {
  static const WordSet pressures{"pressure", "pression", "presion"};
  return has_one(words, pressures) || std::any_of(words.begin(), words.end(), [](const std::string& word) {
           return word.ends_with("druck");
         });
}

/// The weather presses on no joint.
bool says_weather(const std::vector<std::string>& words) {
  return has_one(words, {"ambient", "atmospheric", "barometric", "room", "umgebungsdruck"});
}

}  // namespace

Kind actuation_of(const std::vector<std::string>& words) {
  if (says_tension(words)) return Kind::tension;
  return says_pressure(words) && !says_weather(words) ? Kind::pressure : Kind::none;
}

Kind actuation_with_unit(const std::vector<std::string>& words) {
  if (names_tendon(words)) return Kind::tension;
  return names_chamber(words) ? Kind::pressure : Kind::none;
}

std::string variable_of(const std::vector<std::string>& words) {
  constexpr std::size_t longest = 36;  // of the 40 letters of a variable, some are for a number behind it
  std::string name;
  for (const std::string& word : words) {
    if (!name.empty()) name += '_';
    // a variable has letters of ASCII alone
    std::copy_if(word.begin(), word.end(), std::back_inserter(name),
                 [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; });
  }
  const bool begins_well = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0;
  return (begins_well ? name : "load_" + name).substr(0, longest);
}

}  // namespace plumbline::diagnose
