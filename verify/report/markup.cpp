#include "verify/report/markup.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <utility>
#include <vector>

#include "verify/judging/characters.hpp"

namespace plumbline::verify {
namespace {

using Signs = std::vector<std::pair<std::string, std::string>>;

/// The sign that begins at a place; none where the list has none.
Signs::const_iterator sign_at(const std::string& text, std::size_t place, const Signs& signs) {
  return std::find_if(signs.begin(), signs.end(),
                      [&](const auto& one) { return text.compare(place, one.first.size(), one.first) == 0; });
}

const Signs superscripts{{"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},        {"⁴", "4"},
                         {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"},        {"⁹", "9"},
                         {"⁺", "+"}, {"⁻", "-"}, {"ᵀ", "T"}, {"†", "\\dagger "}};
const Signs subscripts{{"₀", "0"}, {"₁", "1"}, {"₂", "2"}, {"₃", "3"}, {"₄", "4"},
                       {"₅", "5"}, {"₆", "6"}, {"₇", "7"}, {"₈", "8"}, {"₉", "9"}};

/// What the run of raised or lowered signs at a place says; moves the place behind it.
std::string run_of(const std::string& text, std::size_t& place, const Signs& signs) {
  std::string said;
  for (auto sign = sign_at(text, place, signs); sign != signs.end(); sign = sign_at(text, place, signs)) {
    said += sign->second;
    place += sign->first.size();
  }
  return said;
}

/// The index or exponent behind its mark: one letter, a number, or what braces hold. Moves the place behind
/// it.
std::string argument(const std::string& text, std::size_t& place) {
  const std::size_t begin = place;
  if (at(text, place) == '{') {
    place = std::min(text.find('}', place), text.size() - 1) + 1;
    return text.substr(begin + 1, place - begin - 2);
  }
  place = is_digit(at(text, place)) ? end_of_run(text, place, is_digit) : std::min(place + 1, text.size());
  return text.substr(begin, place - begin);
}

const Signs in_formula{
    {"α", "\\alpha "}, {"φ", "\\varphi "},     {"ψ", "\\psi "},   {"λ", "\\lambda "},  {"μ", "\\mu "},
    {"θ", "\\theta "}, {"ε", "\\varepsilon "}, {"δ", "\\delta "}, {"Δ", "\\Delta "},   {"Σ", "\\sum "},
    {"κ", "\\kappa "}, {"π", "\\pi "},         {"ν", "\\nu "},    {"−", "-"},          {"±", "\\pm "},
    {"≤", "\\le "},    {"≥", "\\ge "},         {"≠", "\\ne "},    {"→", "\\to "},      {"√", "\\surd "},
    {"‖", "\\|"},      {"∈", "\\in "},         {"·", "\\cdot "},  {"½", "\\tfrac12 "}, {"…", "\\dots "},
    {"%", "\\%"},      {"{", "\\{"},           {"}", "\\}"},      {"∞", "\\infty "},   {"×", "\\times "},
    {" ", " "}};

const Signs in_text{{"“", "``"},   {"”", "''"},        {"’", "'"},
                    {"‘", "`"},    {"–", "--"},        {"ö", "\\\"o"},
                    {"é", "\\'e"}, {"…", "\\ldots{}"}, {"\\", "\\textbackslash{}"},
                    {"_", "\\_"},  {"^", "\\^{}"},     {"&", "\\&"},
                    {"%", "\\%"},  {"#", "\\#"},       {"$", "\\textdollar{}"},
                    {"{", "\\{"},  {"}", "\\}"},       {"~", "\\~{}"},
                    {"<", "$<$"},  {">", "$>$"},       {"|", "$|$"},
                    {"−", "$-$"},  {"ü", "\\\"u"}};

/// A sign of a sentence; of mathematics, as a formula of its own. Moves the place behind it.
std::string sign_in_sentence(const std::string& text, std::size_t& place);

/// One sign by its list, or itself in ASCII; moves the place behind it.
std::string one_sign(const std::string& text, std::size_t& place, const Signs& signs) {
  const auto sign = sign_at(text, place, signs);
  if (sign != signs.end()) {
    place += sign->first.size();
    return sign->second;
  }
  if (static_cast<unsigned char>(text[place]) >= 0x80)
    throw Error("errata", "a letter that LaTeX is not told of in '" + text.substr(place, 8) + "'",
                "one that it is");
  return {text[place++]};
}

/// A name in a formula: a letter, a function of LaTeX's own, or a word set upright.
std::string word_in_latex(const std::string& word) {
  static const std::vector<std::string> own{"sin", "cos", "tan", "max", "min", "arg", "det", "lim"};
  if (word.size() == 1) return word;
  if (std::find(own.begin(), own.end(), word) != own.end()) return "\\" + word + " ";
  return "\\operatorname{" + word + "}";
}

std::string sign_in_sentence(const std::string& text, std::size_t& place) {
  if (const std::string exponent = run_of(text, place, superscripts); !exponent.empty())
    return "$^{" + exponent + "}$";
  if (const std::string index = run_of(text, place, subscripts); !index.empty()) return "$_{" + index + "}$";
  const bool plain = text[place] == ' ' || sign_at(text, place, in_text) != in_text.end() ||
                     sign_at(text, place, in_formula) == in_formula.end();
  return plain ? one_sign(text, place, in_text) : "$" + one_sign(text, place, in_formula) + "$";
}

std::string formula_in_latex(const std::string& formula) {
  std::string set;
  for (std::size_t place = 0; place < formula.size();) {
    if (const std::string exponent = run_of(formula, place, superscripts); !exponent.empty()) {
      set += "^{" + exponent + "}";
    } else if (const std::string index = run_of(formula, place, subscripts); !index.empty()) {
      set += "_{" + index + "}";
    } else if (formula[place] == '_' || formula[place] == '^') {
      const char mark = formula[place++];
      set += mark + ("{" + formula_in_latex(argument(formula, place)) + "}");
    } else if (is_letter(formula[place])) {
      std::size_t end = end_of_run(formula, place, is_letter);
      if (at(formula, end) == '_' && end > place + 1) --end;  // the index belongs to the last letter
      const std::string word = formula.substr(place, end - place);
      // two letters are a product, as in kq, three and more a word
      set += word.size() == 2 ? word : word_in_latex(word);
      place = end;
    } else {
      set += one_sign(formula, place, in_formula);
    }
  }
  return set;
}

std::string escaped(const std::string& text, std::string_view marks) {
  std::string result;
  for (const char c : text) {
    if (marks.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string formula_in_markdown(const std::string& formula) {
  std::string set;
  for (std::size_t place = 0; place < formula.size();) {
    const char c = formula[place];
    if (c == '_' || c == '^') {
      ++place;
      const std::string tag = c == '_' ? "sub" : "sup";
      set += "<" + tag + ">" + argument(formula, place) + "</" + tag + ">";
    } else {
      set += c == '<' ? "&lt;" : c == '*' ? "\\*" : std::string(1, c);
      ++place;
    }
  }
  return set;
}

/// What stands outside and inside of backticks, each set its own way.
template <class Text, class Formula>
std::string by_parts(const std::string& text, const Text& outside, const Formula& inside) {
  std::string result;
  bool formula = false;
  for (std::size_t begin = 0; begin <= text.size(); formula = !formula) {
    const std::size_t end = std::min(text.find('`', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    result += formula ? inside(part) : outside(part);
    begin = end + 1;
  }
  return result;
}

}  // namespace

std::string as_latex(const std::string& text) {
  std::string whole = by_parts(
      text,
      [](const std::string& part) {
        std::string set;
        for (std::size_t place = 0; place < part.size();) set += sign_in_sentence(part, place);
        return set;
      },
      [](const std::string& formula) { return "$" + formula_in_latex(formula) + "$"; });
  // signs of mathematics and formulas that meet are one formula
  for (std::size_t at = whole.find("$$"); at != std::string::npos; at = whole.find("$$")) whole.erase(at, 2);
  return whole;
}

std::string as_markdown(const std::string& text) {
  return by_parts(
      text, [](const std::string& part) { return escaped(part, "*_<|"); }, formula_in_markdown);
}

std::string as_plain(std::string text) {
  std::erase(text, '`');
  return text;
}

}  // namespace plumbline::verify
