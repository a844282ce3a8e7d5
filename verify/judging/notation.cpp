#include "verify/judging/notation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/judging/characters.hpp"

namespace plumbline::verify {
namespace {

const std::map<std::string, std::string>& greek() {
  static const std::map<std::string, std::string> letters{
      {"alpha", "α"}, {"phi", "φ"},   {"psi", "ψ"},     {"lambda", "λ"}, {"mu", "μ"}, {"delta", "δ"},
      {"Delta", "Δ"}, {"kappa", "κ"}, {"epsilon", "ε"}, {"theta", "θ"},  {"pi", "π"}};
  return letters;
}

/// Whether the hyphen at a place is a minus: it stands between spaces, before a term that it turns, or
/// between a variable, a number or a bracket and what is taken from it. It is none in words, names such as
/// eq-37, and 1e-6.
bool is_minus(const std::string& text, std::size_t place) {
  const char before = at(text, place - 1), after = at(text, place + 1);
  if (before == ' ' && after == ' ') return true;
  if (std::string_view(" ([{,=/|)*").find(before) != std::string_view::npos)
    return is_digit(after) || is_letter(after) || after == '(';
  std::size_t begin = place;
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  const std::string left = text.substr(begin, place - begin),
                    right = text.substr(place + 1, end_of_run(text, place + 1, is_letter) - place - 1);
  if (left == "e" && is_digit(at(text, begin - 1))) return false;
  const bool formula = is_digit(before) || !left.empty();
  if (formula && (after == '(' || greek().contains(left) || greek().contains(right))) return true;
  return is_digit(after) && (is_digit(before) || left.size() == 1);
}

std::string in_digits(std::string_view digits, const std::array<const char*, 10>& set) {
  std::string result;
  for (const char digit : digits) result += set.at(static_cast<std::size_t>(digit - '0'));
  return result;
}

std::string lowered(std::string_view digits) {
  return in_digits(digits, {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"});
}
std::string raised(std::string_view digits) {
  return in_digits(digits, {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"});
}

/// The exponent behind a "^" at a place, where it has signs of its own: a number, T or +. Moves the place
/// behind it.
std::string exponent(const std::string& text, std::size_t& place) {
  const bool negative = at(text, place + 1) == '-';
  const std::size_t begin = place + (negative ? 2 : 1), end = end_of_run(text, begin, is_digit);
  if (end > begin) {
    place = end;
    return (negative ? "⁻" : "") + raised(std::string_view(text).substr(begin, end - begin));
  }
  if (at(text, begin) != '+' && (at(text, begin) != 'T' || is_letter(at(text, begin + 1)))) return "";
  place = begin + 1;
  return text[begin] == '+' ? "⁺" : "ᵀ";
}

/// A word at a place, a Greek letter where it names one, with the digits behind it as its index; the sign of
/// a shape. Moves the place behind it.
std::string word(const std::string& text, std::size_t& place) {
  const std::size_t end = end_of_run(text, place, is_letter);
  const std::string name = text.substr(place, end - place);
  place = end;
  if (const auto letter = greek().find(name); letter != greek().end()) {
    const std::size_t index = end_of_run(text, place, is_digit);
    const std::string_view digits = std::string_view(text).substr(place, index - place);
    place = index;
    return letter->second + lowered(digits);
  }
  const char sign = at(text, place), after = at(text, place + 1);
  if ((name != "U" && name != "Z") || (sign != '+' && sign != '-') || is_digit(after) || is_letter(after))
    return name;
  ++place;
  return name + (sign == '+' ? "⁺" : "⁻");
}

}  // namespace

std::string in_notation(const std::string& text) {
  static const std::vector<std::pair<std::string_view, std::string_view>> signs{
      {"!=", "≠"}, {"<=", "≤"}, {">=", "≥"}, {"->", "→"}, {"*", "·"}, {"...", "…"}, {"sqrt(", "√("}};
  std::string result;
  for (std::size_t place = 0; place < text.size();) {
    const char c = text[place];
    const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& one) {
      return text.compare(place, one.first.size(), one.first) == 0;
    });
    const std::size_t index = end_of_run(text, place + 1, is_digit);
    if (sign != signs.end()) {
      result += sign->second;
      place += sign->first.size();
    } else if (is_letter(c)) {
      result += word(text, place);
    } else if (c == '_' && index > place + 1) {
      result += lowered(std::string_view(text).substr(place + 1, index - place - 1));
      place = index;
    } else if (const std::string power = c == '^' ? exponent(text, place) : ""; !power.empty()) {
      result += power;
    } else if (c == '-' && is_minus(text, place)) {
      result += "−", ++place;
    } else {
      result += c, ++place;
    }
  }
  return result;
}

}  // namespace plumbline::verify
