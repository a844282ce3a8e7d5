#include "diagnose/draft/unit_words.hpp"

#include <array>
#include <cctype>
#include <map>
#include <plumbline/base/error.hpp>
#include <set>

namespace plumbline::diagnose {
namespace {

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(" \t[(/"));
  text.erase(text.find_last_not_of(" \t])") + 1);
  return text;
}

/// By their spelling in small letters.
const std::map<std::string, std::string>& spelled() {
  static const std::map<std::string, std::string> all{{"degrees", "deg"},
                                                      {"degs", "deg"},
                                                      {"grad", "deg"},
                                                      {"grados", "deg"},
                                                      {"degres", "deg"},
                                                      {"\u5ea6", "deg"},
                                                      {"sec", "s"},
                                                      {"secs", "s"},
                                                      {"second", "s"},
                                                      {"seconds", "s"},
                                                      {"sekunden", "s"},
                                                      {"\u79d2", "s"},
                                                      {"msec", "ms"},
                                                      {"millis", "ms"},
                                                      {"usec", "us"},
                                                      {"newton", "N"},
                                                      {"newtons", "N"},
                                                      {"n", "N"},
                                                      {"kn", "kN"},
                                                      {"mn", "mN"},
                                                      {"radians", "rad"},
                                                      {"radian", "rad"},
                                                      {"urad", "0.001 mrad"},
                                                      {"\u00b5rad", "0.001 mrad"},
                                                      {"\u03bcrad", "0.001 mrad"},
                                                      {"pa", "Pa"},
                                                      {"kpa", "kPa"},
                                                      {"mpa", "MPa"},
                                                      {"hpa", "mbar"},
                                                      {"psi", "lbf/in^2"},
                                                      {"pascal", "Pa"},
                                                      {"nm", "Nm"},
                                                      {"n*m", "Nm"},
                                                      {"n.m", "Nm"},
                                                      {"n-m", "Nm"},
                                                      {"n-mm", "Nmm"},
                                                      {"nmm", "Nmm"},
                                                      {"ncm", "Ncm"},
                                                      {"mnm", "mNm"},
                                                      {"millimeters", "mm"},
                                                      {"millimetres", "mm"},
                                                      {"millimeter", "mm"},
                                                      {"meters", "m"},
                                                      {"metres", "m"},
                                                      {"inches", "in"},
                                                      {"\"", "in"},
                                                      {"lbs", "lb"},
                                                      {"pound", "lb"},
                                                      {"pounds", "lb"},
                                                      {"gram", "g"},
                                                      {"grams", "g"},
                                                      {"gramm", "g"},
                                                      {"gr", "g"},
                                                      {"kgs", "kg"},
                                                      {"kilograms", "kg"},
                                                      {"ounces", "oz"}};
  return all;
}

/// A force that is said as the mass that weighs so much.
std::string as_weight(const std::string& unit) {
  static const std::map<std::string, std::string> weights{
      {"g", "gf"}, {"kg", "kgf"}, {"lb", "lbf"}, {"oz", "ozf"}, {"mg", "0.001 gf"}};
  const auto found = weights.find(unit);
  return found == weights.end() ? unit : found->second;
}

std::string small(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string parsed(const std::string& text, const Quantity& quantity) {
  try {
    return text.empty() ? "" : parse_unit(text, quantity, "").name;
  } catch (const Error&) {
    return "";
  }
}

}  // namespace

std::string folded(const std::string& text) {
  // U+00C0 to U+00FF, whose second byte in UTF-8 is 0x80 to 0xBF.
  constexpr std::string_view plain = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == 0xC3 && i + 1 < text.size()) {
      result += plain[(static_cast<unsigned char>(text[++i]) - 0x80U) % plain.size()];
    } else {
      result += static_cast<char>(std::tolower(c));
    }
  }
  return result;
}

std::string unit_in(std::string text, const Quantity& quantity) {
  text = trimmed(std::move(text));
  const bool weighs = &quantity == &quantity::force;
  // As it is written first: "mN" is no "MN", and "Nm" is not "nm".
  for (std::string one : {text, folded(text), small(text)}) {
    if (const auto found = spelled().find(one); found != spelled().end()) one = found->second;
    if (std::string unit = parsed(weighs ? as_weight(one) : one, quantity); !unit.empty()) return unit;
  }
  return "";
}

std::string unit_among(const std::vector<std::string>& said, const Quantity& quantity) {
  for (const std::string& text : said)
    if (std::string unit = unit_in(text, quantity); !unit.empty()) return unit;
  return "";
}

bool is_temperature_unit(const std::string& text) {
  static const std::set<std::string> units{"c", "\u00b0c", "degc", "deg c", "celsius"};
  return units.contains(small(trimmed(text)));
}

bool is_current_unit(const std::string& text) {
  static const std::set<std::string> units{"A", "mA", "amp", "amps", "ampere"};
  return units.contains(trimmed(text));
}

}  // namespace plumbline::diagnose
