#include "diagnose/bench/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cctype>
#include <charconv>
#include <optional>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace quantity {

const Quantity length{"a length", {.length = 1}, "m", "m, mm, cm, um, in, ft"};
const Quantity force{"a force", {1, 1, -2, 0}, "N", "N, mN, kN, kgf, gf, lbf, ozf"};
const Quantity angle{"an angle", {.angle = 1}, "rad", "rad, mrad, deg, rev"};
const Quantity time{"a time", {.time = 1}, "s", "s, ms, us, min, h"};
const Quantity mass{"a mass", {.mass = 1}, "kg", "kg, g, lb, oz"};
const Quantity stiffness{"a stiffness of a joint",
                         {2, 1, -2, -1},
                         "N m/rad",
                         "N m/rad, N mm/rad, N mm/deg, mN m/rad, kgf cm/rad, lbf in/rad"};
const Quantity sliding_stiffness{
    "a stiffness of a joint that slides", {0, 1, -2, 0}, "N/m", "N/m, N/mm, N/um, kgf/mm, lbf/in"};
const Quantity torque{"a torque", {2, 1, -2, 0}, "N m", "N m, N mm, N cm, kgf cm, lbf in"};
const Quantity acceleration{"an acceleration", {.length = 1, .time = -2}, "m/s^2", "m/s^2, mm/s^2, ft/s^2"};
const Quantity pressure{"a pressure", {-1, 1, -2, 0}, "Pa", "Pa, kPa, MPa, bar, mbar, lbf/in^2"};
const Quantity volume{"a volume", {.length = 3}, "m^3", "m^3, cm^3, mm^3"};
const Quantity pixel{"a place in a picture", {.pixel = 1}, "px", "px"};

}  // namespace quantity
namespace {

struct Symbol {
  std::string_view name;
  std::string_view factor;  ///< an exact decimal
  Dimension dimension;
  int turns = 0;  ///< times pi: degrees and revolutions
};

constexpr std::array symbols = [] {
  constexpr Dimension length{1, 0, 0, 0}, mass{0, 1, 0, 0}, duration{0, 0, 1, 0}, angle{0, 0, 0, 1},
      force{1, 1, -2, 0}, torque{2, 1, -2, 0}, pressure{-1, 1, -2, 0}, picture{.pixel = 1};
  return std::array{
      Symbol{"m", "1", length},
      Symbol{"km", "1e3", length},
      Symbol{"dm", "1e-1", length},
      Symbol{"cm", "1e-2", length},
      Symbol{"mm", "1e-3", length},
      Symbol{"um", "1e-6", length},
      Symbol{"µm", "1e-6", length},  // micro sign
      Symbol{"μm", "1e-6", length},  // Greek mu
      Symbol{"in", "0.0254", length},
      Symbol{"inch", "0.0254", length},
      Symbol{"ft", "0.3048", length},
      Symbol{"N", "1", force},
      Symbol{"kN", "1e3", force},
      Symbol{"cN", "1e-2", force},
      Symbol{"mN", "1e-3", force},
      Symbol{"uN", "1e-6", force},
      Symbol{"µN", "1e-6", force},
      Symbol{"μN", "1e-6", force},
      Symbol{"dyn", "1e-5", force},
      Symbol{"kgf", "9.80665", force},
      Symbol{"kp", "9.80665", force},
      Symbol{"gf", "9.80665e-3", force},
      Symbol{"lbf", "4.4482216152605", force},
      Symbol{"ozf", "0.27801385095378125", force},  // lbf / 16
      Symbol{"Nm", "1", torque},
      Symbol{"Ncm", "1e-2", torque},
      Symbol{"Nmm", "1e-3", torque},
      Symbol{"mNm", "1e-3", torque},
      Symbol{"Pa", "1", pressure},
      Symbol{"kPa", "1e3", pressure},
      Symbol{"MPa", "1e6", pressure},
      Symbol{"bar", "1e5", pressure},
      Symbol{"mbar", "1e2", pressure},
      Symbol{"kg", "1", mass},
      Symbol{"g", "1e-3", mass},
      Symbol{"lb", "0.45359237", mass},
      Symbol{"oz", "0.028349523125", mass},  // lb / 16
      Symbol{"s", "1", duration},
      Symbol{"ms", "1e-3", duration},
      Symbol{"us", "1e-6", duration},
      Symbol{"µs", "1e-6", duration},
      Symbol{"μs", "1e-6", duration},
      Symbol{"min", "60", duration},
      Symbol{"h", "3600", duration},
      Symbol{"rad", "1", angle},
      Symbol{"mrad", "1e-3", angle},
      Symbol{"deg", "1", angle, 180},
      Symbol{"°", "1", angle, 180},
      Symbol{"degree", "1", angle, 180},
      Symbol{"degrees", "1", angle, 180},
      Symbol{"rev", "360", angle, 180},
      Symbol{"px", "1", picture},
  };
}();

/// The product of powers read so far.
struct Product {
  Mpfr50 factor = 1;
  Dimension dimension;

  void times(const Mpfr50& by, const Dimension& of, int power) {
    factor *= pow(by, power);
    dimension.length += power * of.length;
    dimension.mass += power * of.mass;
    dimension.time += power * of.time;
    dimension.angle += power * of.angle;
    dimension.pixel += power * of.pixel;
  }
};

Mpfr50 factor_of(const Symbol& symbol) {
  const Mpfr50 factor{std::string(symbol.factor)};
  return symbol.turns == 0 ? factor : factor * boost::math::constants::pi<Mpfr50>() / Mpfr50(symbol.turns);
}

/// Removes "^2" or "²" from the end of a word; 0 where no digit follows "^".
int take_power(std::string_view& word) {
  for (const auto& [text, power] : {std::pair<std::string_view, int>{"²", 2}, {"³", 3}})
    if (word.ends_with(text)) {
      word.remove_suffix(text.size());
      return power;
    }
  const std::size_t at = word.find('^');
  if (at == std::string_view::npos) return 1;
  const std::string_view digit = word.substr(at + 1);
  word = word.substr(0, at);
  return digit.size() == 1 && digit[0] >= '1' && digit[0] <= '9' ? digit[0] - '0' : 0;
}

/// Multiplies the unit by one word.
/// \returns whether it is one
bool multiply(Product& product, std::string_view word, int sign) {
  const int power = take_power(word);
  if (power == 0 || word.empty()) return false;
  const auto* const symbol =
      std::find_if(symbols.begin(), symbols.end(), [&](const Symbol& s) { return s.name == word; });
  if (symbol != symbols.end()) {
    product.times(factor_of(*symbol), symbol->dimension, sign * power);
    return true;
  }
  double number = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (fault != std::errc() || end != word.data() + word.size() || !(number > 0) || !std::isfinite(number))
    return false;
  product.times(Mpfr50(std::string(word)), {}, sign * power);
  return true;
}

/// Words separated by blanks, "*", "·" and "/"; words after a slash divide.
std::optional<Product> parse(std::string text) {
  for (std::size_t at; (at = text.find("·")) != std::string::npos;)
    text.replace(at, std::string_view("·").size(), "*");
  Product product;
  int sign = 1;
  bool wanted = true;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ') {
      ++at;
    } else if (text[at] == '*' || text[at] == '/') {
      if (wanted) return {};
      if (text[at] == '/') sign = -1;
      wanted = true;
      ++at;
    } else {
      const std::size_t end = std::min(text.find_first_of(" */", at), text.size());
      if (!multiply(product, std::string_view(text).substr(at, end - at), sign)) return {};
      wanted = false;
      at = end;
    }
  }
  return wanted ? std::nullopt : std::optional(product);
}

}  // namespace

Unit parse_unit(const std::string& text, const Quantity& quantity, const std::string& place) {
  const std::optional<Product> product = parse(text);
  if (!product || product->dimension != quantity.dimension) {
    throw Error(place, "\"" + files::shown(text) + "\"",
                std::string("a unit of ") + quantity.name + ": " + quantity.examples);
  }
  return {text, product->factor};
}

Unit si_unit(const Quantity& quantity) {
  return {quantity.si, 1};
}

double in_si(std::string_view decimal, const Unit& unit) {
  return Mpfr50(Mpfr50(std::string(decimal)) * unit.factor).convert_to<double>();
}

double in_si(double value, const Unit& unit) {
  return unit.factor == 1 ? value : in_si(fmt::format("{}", value), unit);
}

}  // namespace plumbline::diagnose
