#include "verify/report/latex.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <utility>
#include <vector>

#include "verify/judging/characters.hpp"

namespace plumbline::verify {
namespace {

using Signs =
    std::vector<std::pair<std::string, std::string>>;  // the longer before those that it begins with

std::string replaced_signs(const std::string& text, const Signs& signs) {
  std::string result;
  for (std::size_t place = 0; place < text.size();) {
    const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& one) {
      return text.compare(place, one.first.size(), one.first) == 0;
    });
    result += sign == signs.end() ? text.substr(place, 1) : sign->second;
    place += sign == signs.end() ? 1 : sign->first.size();
  }
  return result;
}

const Signs& raised() {
  static const Signs signs{{"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},        {"⁴", "4"},
                           {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"},        {"⁹", "9"},
                           {"⁺", "+"}, {"⁻", "-"}, {"ᵀ", "T"}, {"†", "\\dagger "}};
  return signs;
}

const Signs& lowered() {
  static const Signs signs{{"₀", "0"}, {"₁", "1"}, {"₂", "2"}, {"₃", "3"}, {"₄", "4"},
                           {"₅", "5"}, {"₆", "6"}, {"₇", "7"}, {"₈", "8"}, {"₉", "9"}};
  return signs;
}

/// What the run of raised or lowered signs at a place says; nothing where there is none. Moves the place
/// behind it.
std::string run_of(const std::string& text, std::size_t& place, const Signs& signs) {
  std::string said;
  for (;;) {
    const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& one) {
      return text.compare(place, one.first.size(), one.first) == 0;
    });
    if (sign == signs.end()) return said;
    said += sign->second;
    place += sign->first.size();
  }
}

/// The index or exponent behind its mark, at a place: in braces, or signs, letters and digits; but of
/// "k_nq_n" the n. Moves the place behind it.
std::string argument(const std::string& text, std::size_t& place) {
  const std::size_t begin = place;
  if (at(text, place) == '{') {
    place = std::min(text.find('}', place), text.size() - 1) + 1;
    return text.substr(begin + 1, place - begin - 2);
  }
  if (at(text, place) == '+' || at(text, place) == '-') ++place;
  const std::size_t letters = end_of_run(text, place, is_letter);
  if (letters > place)
    place = at(text, letters) == '_' ? place + 1 : letters;
  else
    place = end_of_run(text, place, is_digit);
  return text.substr(begin, place - begin);
}

/// What one sign is in LaTeX.
std::string sign_in_latex(const std::string& text, std::size_t& place) {
  static const Signs signs{{"α", "$\\alpha$"},
                           {"φ", "$\\varphi$"},
                           {"ψ", "$\\psi$"},
                           {"λ", "$\\lambda$"},
                           {"μ", "$\\mu$"},
                           {"ε", "$\\varepsilon$"},
                           {"δ", "$\\delta$"},
                           {"Δ", "$\\Delta$"},
                           {"Σ", "$\\Sigma$"},
                           {"κ", "$\\kappa$"},
                           {"θ", "$\\theta$"},
                           {"π", "$\\pi$"},
                           {"−", "$-$"},
                           {"±", "$\\pm$"},
                           {"≤", "$\\le$"},
                           {"≥", "$\\ge$"},
                           {"≠", "$\\ne$"},
                           {"→", "$\\to$"},
                           {"√", "$\\surd$"},
                           {"‖", "$\\|$"},
                           {"∈", "$\\in$"},
                           {"·", "$\\cdot$\\allowbreak{}"},
                           {"½", "$\\frac12$"},
                           {"…", "\\ldots{}"},
                           {"“", "``"},
                           {"”", "''"},
                           {"’", "'"},
                           {"‘", "`"},
                           {"–", "--"},
                           {"ö", "\\\"o"},
                           {"\\", "\\textbackslash{}"},
                           {"_", "\\_"},
                           {"^", "\\^{}"},
                           {"&", "\\&"},
                           {"%", "\\%"},
                           {"#", "\\#"},
                           {"$", "\\textdollar{}"},
                           {"{", "\\{"},
                           {"}", "\\}"},
                           {"~", "\\~{}"},
                           {"<", "$<$"},
                           {">", "$>$"},
                           {"/", "/\\allowbreak{}"},
                           {"|", "$|$"}};
  const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& one) {
    return text.compare(place, one.first.size(), one.first) == 0;
  });
  if (sign == signs.end() && static_cast<unsigned char>(text[place]) >= 0x80)
    throw Error("errata", "a letter that LaTeX is not told of in '" + text.substr(place, 4) + "'",
                "one that it is");
  const std::string set = sign == signs.end() ? text.substr(place, 1) : sign->second;
  place += sign == signs.end() ? 1 : sign->first.size();
  return set;
}

}  // namespace

std::string as_latex(const std::string& text) {
  std::string set;
  for (std::size_t place = 0; place < text.size();) {
    if (const std::string exponent = run_of(text, place, raised()); !exponent.empty())
      set += "$^{" + exponent + "}$";
    else if (const std::string index = run_of(text, place, lowered()); !index.empty())
      set += "$_{" + index + "}$";
    else if ((text[place] == '_' || text[place] == '^') && at(text, place + 1) != ' ') {
      const char mark = text[place++];
      set += fmt::format("${}{{{}}}$", mark, replaced_signs(argument(text, place), {{"−", "-"}}));
    } else
      set += sign_in_latex(text, place);
  }
  // what follows each other in mathematics is one formula
  return replaced_signs(set, {{"$$", ""}});
}

}  // namespace plumbline::verify
