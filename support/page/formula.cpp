#include "support/page/formula.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>

namespace plumbline::page {
namespace {

/// What has been set, and how tightly its outermost operator binds: 1 a sum, 2 a product, 3 neither.
struct Set {
  std::string mathml;
  int binding = 3;
  std::string unbracketed = {};  ///< the same where a fraction makes its brackets idle; else empty
};

struct NoFormula : std::runtime_error {
  NoFormula() : std::runtime_error("no formula") {}
};

const std::map<std::string, std::string>& letters() {
  static const std::map<std::string, std::string> known{{"alpha", "α"}, {"phi", "φ"},   {"lambda", "λ"},
                                                        {"mu", "μ"},    {"Delta", "Δ"}, {"epsilon", "ε"}};
  return known;
}

bool is_function(const std::string& name) {
  return name == "sin" || name == "cos" || name == "atan2" || name == "max" || name == "min" ||
         name == "sqrt";
}

/// A letter with its index.
std::string name_in_mathml(const std::string& name) {
  std::string letter = name.substr(0, 1), index = name.substr(1);
  for (const auto& [word, sign] : letters()) {
    if (name.starts_with(word)) letter = sign, index = name.substr(word.size());
  }
  if ((name == "dx" || name == "dy" || name == "Dx") && index.size() == 1)
    letter = name[0] == 'd' ? "δ" : "Δ";
  const auto letters_in_index =
      std::count_if(index.begin(), index.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
  if (index.size() > 3 || letters_in_index > 1) throw NoFormula();  // a word
  if (index.empty()) return fmt::format("<mi>{}</mi>", letter);
  const char* const tag = std::isdigit(static_cast<unsigned char>(index[0])) != 0 ? "mn" : "mi";
  return fmt::format("<msub><mi>{}</mi><{}>{}</{}></msub>", letter, tag, index, tag);
}

/// As tall as a fraction where there is one: fonts without a table for formulas stretch them beyond measure.
std::string in_brackets(const std::string& mathml) {
  const bool tall = mathml.find("<mfrac>") != std::string::npos;
  const char* const kind = tall ? "<mo>" : "<mo stretchy=\"false\">";
  return fmt::format("<mrow>{}(</mo>{}{})</mo></mrow>", kind, mathml, kind);
}

/// Above or below the line of a fraction.
std::string in_fraction(const Set& one) {
  return "<mrow>" + (one.unbracketed.empty() ? one.mathml : one.unbracketed) + "</mrow>";
}

std::string bound(const Set& one, int at_least) {
  return one.binding < at_least ? in_brackets(one.mathml) : "<mrow>" + one.mathml + "</mrow>";
}

class Setter {
 public:
  explicit Setter(std::string text) : text_(std::move(text)) {}

  std::string whole() {
    const Set all = sum();
    if (at_ != text_.size()) throw NoFormula();
    return all.mathml;
  }

 private:
  bool next(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void need(char c) {
    if (!next(c)) throw NoFormula();
  }

  Set sum() {
    const bool negative = next('-');
    if (!negative) next('+');
    Set all = product();
    if (negative) all = {"<mo>−</mo>" + bound(all, 2), 1};
    for (;;) {
      const bool plus = next('+');
      if (!plus && !next('-')) return all;
      all = {all.mathml + (plus ? "<mo>+</mo>" : "<mo>−</mo>") + bound(product(), 2), 1};
    }
  }

  Set product() {
    Set all = power();
    for (;;) {
      if (next('*'))
        all = {bound(all, 2) + "<mo>&#x2062;</mo>" + bound(power(), 2), 2};
      else if (next('/'))
        all = {fmt::format("<mfrac>{}{}</mfrac>", in_fraction(all), in_fraction(power())), 3};
      else
        return all;
    }
  }

  Set power() {
    Set base = factor();
    while (next('^'))
      base = {fmt::format("<msup>{}<mrow>{}</mrow></msup>", bound(base, 3), factor().mathml), 3};
    return base;
  }

  Set factor() {
    if (next('(')) {
      const Set inner = sum();
      need(')');
      return inner.binding == 3 ? inner : Set{in_brackets(inner.mathml), 3, inner.mathml};
    }
    std::string token;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.'))
      token += text_[at_++];
    if (token.empty()) throw NoFormula();
    if (std::isdigit(static_cast<unsigned char>(token[0])) != 0) {
      if (token.find_first_not_of("0123456789.") != std::string::npos) throw NoFormula();
      return {"<mn>" + token + "</mn>", 3};
    }
    return at_ < text_.size() && text_[at_] == '(' ? call(token) : Set{name_in_mathml(token), 3};
  }

  Set call(const std::string& name) {
    need('(');
    const Set first = sum();
    std::string arguments = first.mathml;
    while (next(',')) arguments += "<mo>,</mo>" + sum().mathml;
    need(')');
    if (name == "inv" || name == "pinv")
      return {fmt::format("<msup>{}<mrow>{}</mrow></msup>", bound(first, 3),
                          name == "inv" ? "<mo>−</mo><mn>1</mn>" : "<mo>†</mo>"),
              3};
    if (name == "sqrt") return {"<msqrt>" + arguments + "</msqrt>", 3};
    if (!is_function(name)) throw NoFormula();
    return {fmt::format("<mi>{}</mi><mo>&#x2061;</mo>{}", name, in_brackets(arguments)), 3};
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<std::string> as_mathml(const std::string& formula) {
  try {
    return "<math>" + Setter(formula).whole() + "</math>";
  } catch (const NoFormula&) {
    return std::nullopt;
  }
}

}  // namespace plumbline::page
