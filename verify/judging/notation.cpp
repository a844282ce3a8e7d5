#include "verify/judging/notation.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <regex>
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
  if (left.size() == 1 && right.size() == 1) return true;
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

/// A word at a place, a Greek letter where it names one, with the digits behind it as its index. Moves the
/// place behind it.
std::string word(const std::string& text, std::size_t& place) {
  const std::size_t end = end_of_run(text, place, is_letter);
  const std::string name = text.substr(place, end - place);
  place = end;
  const auto letter = greek().find(name);
  if (letter == greek().end()) return name;
  const std::size_t index = end_of_run(text, place, is_digit);
  const std::string_view digits = std::string_view(text).substr(place, index - place);
  place = index;
  return letter->second + lowered(digits);
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

std::string formula_in_print(const std::string& formula) {
  static const std::vector<std::pair<std::regex, std::string>> rules{
      {std::regex("\\binv\\(([^()]*)\\)"), "($1)^-1"},
      {std::regex("\\|lambda\\|"), "|lambda_i|"},
      {std::regex("\\b([A-Za-z])([xy])\\b"), "$1_$2"},                           // Fx
      {std::regex("\\b(sin|cos|tan)\\(([0-9]*)\\*?([A-Za-z]+)\\)"), "$1 $2$3"},  // of a simple angle
      {std::regex("\\*(sin|cos|tan)"), " $1"},
      {std::regex("([^(/*\\s^])([-+])"), "$1 $2 "},
      {std::regex("\\*"), ""},
  };
  std::string text = formula;
  for (const auto& [pattern, form] : rules) text = std::regex_replace(text, pattern, form);
  std::string result;
  for (std::size_t place = 0; place < text.size();) {  // letters with their digits as indices
    const bool index = place > 0 && is_digit(text[place]) && is_letter(text[place - 1]);
    const std::size_t end = end_of_run(text, place, is_digit);
    result += index ? lowered(std::string_view(text).substr(place, end - place)) : text.substr(place, 1);
    place = index ? end : place + 1;
  }
  std::string set = in_notation(result);
  for (const auto& [letter, sign] : greek()) {  // also where letters meet: "kphi"
    if (letter.size() < 3) continue;
    for (std::size_t at = set.find(letter); at != std::string::npos; at = set.find(letter))
      set.replace(at, letter.size(), sign);
  }
  return set;
}

std::string set_in_sentence(const std::string& entry, const std::vector<std::string>& words) {
  static const std::regex numbers("[-0-9.]+|\\([0-9]+\\)"), counts("[0-9]+ [a-z]+(, [0-9]+ [a-z]+)*"),
      comma(", ");
  if (std::find(words.begin(), words.end(), entry) != words.end()) return entry;
  if (std::regex_match(entry, numbers)) return entry;
  if (std::regex_match(entry, counts)) return std::regex_replace(entry, comma, " and ");
  return "`" + formula_in_print(entry) + "`";
}

std::string with_marks(const std::string& text) {
  static const std::regex indexed("[^\\s`(),;:“”]*[_^][^\\s`,;:“”]*");
  return std::regex_replace(text, indexed, "`$&`");
}

std::string as_sentence(const std::string& found) {
  static const std::regex word("[a-z]+[ ,][^]*");
  std::string text = with_marks(found);
  if (std::regex_match(text, word))
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.ends_with('.') ? text : text + ".";
}

}  // namespace plumbline::verify
