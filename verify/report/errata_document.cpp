/// \file
/// The errata as a document, in Markdown and in LaTeX.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <plumbline/base/error.hpp>
#include <utility>

#include "verify/report/errata.hpp"

namespace plumbline::verify {
namespace {

constexpr const char* paper_reference =
    "W. Zhao, A. Klimchik, A. Pashkevich, D. Chablat, Non-linear stiffness behavior of planar serial robotic "
    "manipulators, Mechanism and Machine Theory 172 (2022) 104783, doi:10.1016/j.mechmachtheory.2022.104783, "
    "hal-03578506";

/// How a document is marked up.
struct Markup {
  std::string (*text)(const std::string&);  ///< plain text, escaped
  std::string (*strong)(const std::string&);
  const char *title, *heading, *erratum, *item;  ///< formats of one line each
  const char *items, *items_end, *begin, *end;
};

std::string strong_markdown(const std::string& text) {
  return "**" + text + "**";
}

/// Markdown's own marks as they are.
std::string markdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("*_`|<>").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string latex(const std::string& text) {
  static const std::vector<std::pair<std::string, std::string>> signs{{"α", "$\\alpha$"},
                                                                      {"φ", "$\\varphi$"},
                                                                      {"λ", "$\\lambda$"},
                                                                      {"μ", "$\\mu$"},
                                                                      {"ε", "$\\varepsilon$"},
                                                                      {"δ", "$\\delta$"},
                                                                      {"Δ", "$\\Delta$"},
                                                                      {"Σ", "$\\Sigma$"},
                                                                      {"κ", "$\\kappa$"},
                                                                      {"π", "$\\pi$"},
                                                                      {"⁺", "$^+$"},
                                                                      {"⁻", "$^-$"},
                                                                      {"⁰", "$^0$"},
                                                                      {"¹", "$^1$"},
                                                                      {"²", "$^2$"},
                                                                      {"³", "$^3$"},
                                                                      {"⁴", "$^4$"},
                                                                      {"⁵", "$^5$"},
                                                                      {"ᵀ", "$^T$"},
                                                                      {"₀", "$_0$"},
                                                                      {"₁", "$_1$"},
                                                                      {"₂", "$_2$"},
                                                                      {"₃", "$_3$"},
                                                                      {"₄", "$_4$"},
                                                                      {"−", "$-$"},
                                                                      {"±", "$\\pm$"},
                                                                      {"≤", "$\\le$"},
                                                                      {"≥", "$\\ge$"},
                                                                      {"≠", "$\\ne$"},
                                                                      {"→", "$\\to$"},
                                                                      {"√", "$\\surd$"},
                                                                      {"†", "$^\\dagger$"},
                                                                      {"‖", "$\\|$"},
                                                                      {"∈", "$\\in$"},
                                                                      {"·", "$\\cdot$"},
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
                                                                      {"$", "\\$"},
                                                                      {"{", "\\{"},
                                                                      {"}", "\\}"},
                                                                      {"~", "\\~{}"},
                                                                      {"<", "$<$"},
                                                                      {">", "$>$"},
                                                                      {"|", "$|$"}};
  std::string set;
  for (std::size_t at = 0; at < text.size();) {
    const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& one) {
      return text.compare(at, one.first.size(), one.first) == 0;
    });
    if (sign == signs.end() && static_cast<unsigned char>(text[at]) >= 0x80)
      throw Error("errata", "a letter that LaTeX is not told of in '" + text.substr(at, 4) + "'",
                  "one that it is");
    set += sign == signs.end() ? text.substr(at, 1) : sign->second;
    at += sign == signs.end() ? 1 : sign->first.size();
  }
  return set;
}

std::string strong_latex(const std::string& text) {
  return "\\textbf{" + text + "}";
}

const Markup in_markdown{
    markdown, strong_markdown, "# {}\n\n", "## {}\n\n", "### {}. {}\n\n", "- {}\n", "", "\n", "", ""};
const Markup in_latex{latex,
                      strong_latex,
                      "\\section*{{{}}}\n",
                      "\\subsection*{{{}}}\n",
                      "\\paragraph{{{}. {}}}~\n",
                      "\\item {}\n",
                      "\\begin{itemize}\n",
                      "\\end{itemize}\n",
                      "\\documentclass{article}\n\\begin{document}\n",
                      "\\end{document}\n"};

/// The first words, as many as about two lines hold.
std::string two_lines(const std::string& text) {
  constexpr std::size_t most = 300;
  if (text.size() <= most) return text;
  return text.substr(0, text.rfind(' ', most)) + " …";
}

std::string heading(Severity severity) {
  static constexpr std::array<const char*, 4> headings{"What changes a result", "What changes a number",
                                                       "What changes the wording",
                                                       "What fixes a convention, or a name"};
  return headings.at(static_cast<std::size_t>(severity));
}

std::string title(const Erratum& erratum) {
  const Claim& first = erratum.claims.front().claim;
  return erratum.cause.title.empty() ? first.where + ": " + first.reading : erratum.cause.title;
}

/// The strongest evidence of the gravest claim.
std::string evidence(const Erratum& erratum) {
  const auto grave = std::find_if(erratum.claims.begin(), erratum.claims.end(), [&](const Judged& one) {
    return severity(one.claim, one.judgement->verdict) == erratum.severity;
  });
  const Evidence& best = grave->judgement->evidence.front();
  return fmt::format("{}{}: {}", name(best.kind), best.theorem.empty() ? "" : " “" + best.theorem + "”",
                     two_lines(best.detail));
}

/// What does not depend on the erratum, by verdict: it is said to stand only where it was found to.
std::string unchanged(const Erratum& erratum) {
  std::vector<std::string> hold, others;
  for (const Judged& one : erratum.unchanged) {
    const bool confirmed = one.judgement && one.judgement->verdict == Verdict::confirmed;
    (confirmed ? hold : others).push_back(one.claim.where);
  }
  for (auto* list : {&hold, &others}) list->erase(std::unique(list->begin(), list->end()), list->end());
  std::string text;
  if (!hold.empty()) text += fmt::format(" Confirmed as printed: {}.", fmt::join(hold, "; "));
  if (!others.empty()) text += fmt::format(" Not confirmed: {}.", fmt::join(others, "; "));
  return text;
}

std::string document(const std::vector<Judged>& judged, const Markup& m) {
  const std::vector<Erratum> list = errata(judged);
  std::string all =
      m.begin + fmt::format(fmt::runtime(m.title), "Errata") + m.text(paper_reference) + ".\n\n" +
      m.text(fmt::format("{} claims were judged. {}. Places are sections, equations, figures and tables, "
                         "as journal and preprint number their pages otherwise.",
                         judged.size(), count_of(list))) +
      "\n\n";
  std::optional<Severity> before;
  std::size_t number = 0;
  for (const Erratum& erratum : list) {
    if (before != erratum.severity)
      all += fmt::format(fmt::runtime(m.heading), m.text(heading(erratum.severity)));
    before = erratum.severity;
    all += fmt::format(fmt::runtime(m.erratum), ++number, m.text(title(erratum))) + m.items;
    const auto item = [&](const std::string& label, const std::string& text) {
      all += fmt::format(fmt::runtime(m.item), m.strong(m.text(label)) + " " + m.text(text));
    };
    for (const Judged& one : erratum.claims)
      item(one.claim.where + ":",
           fmt::format("printed “{}”; true: {} [{}]", one.claim.quote, one.judgement->truth, one.claim.id));
    if (!erratum.cause.correction.empty()) item("Correction:", erratum.cause.correction);
    item("Evidence,", evidence(erratum));
    const std::string effect = erratum.cause.effect + unchanged(erratum);
    if (!effect.empty()) item("Effect:", effect);
    all += m.items_end;
  }
  return all + m.end;
}

}  // namespace

std::string errata_as_markdown(const std::vector<Judged>& judged) {
  return document(judged, in_markdown);
}

std::string errata_as_latex(const std::vector<Judged>& judged) {
  return document(judged, in_latex);
}

}  // namespace plumbline::verify
