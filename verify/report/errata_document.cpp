/// \file
/// The errata as a document, in Markdown and in LaTeX.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "verify/report/errata.hpp"
#include "verify/report/latex.hpp"

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

std::string strong_latex(const std::string& text) {
  return "\\textbf{" + text + "}";
}

const Markup in_markdown{
    markdown, strong_markdown, "# {}\n\n", "## {}\n\n", "### {}. {}\n\n", "- {}\n", "", "\n", "", ""};
const Markup in_latex{as_latex,
                      strong_latex,
                      "\\section*{{{}}}\n",
                      "\\subsection*{{{}}}\n",
                      "\\paragraph{{{}. {}}}~\n",
                      "\\item {}\n",
                      "\\begin{itemize}\n",
                      "\\end{itemize}\n",
                      "\\documentclass[a4paper]{article}\n\\usepackage[margin=28mm]{geometry}\n"
                      "\\renewcommand\\labelitemi{$\\bullet$}\n\\frenchspacing\\emergencystretch=3em\n"
                      "\\begin{document}\n",
                      "\\end{document}\n"};

/// A place in the paper, such as "2, (6)", as a reader looks for it.
std::string place(const std::string& where) {
  return (std::isdigit(static_cast<unsigned char>(where[0])) != 0 ? "Section " : "") + where;
}

/// All places of a claim.
std::string places(const Claim& claim) {
  std::string all = place(claim.where);
  for (const std::string& other : claim.also) all += "; " + place(other);
  return all;
}

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
  return erratum.cause.title.empty() ? place(first.where) + ": " + first.reading : erratum.cause.title;
}

/// Neighbours with the same words in the same place and the same truth together.
std::vector<std::vector<Judged>> of_one_passage(const std::vector<Judged>& claims) {
  std::vector<std::vector<Judged>> groups;
  for (const Judged& one : claims) {
    const auto same = [&](const Judged& other) {
      return other.claim.where == one.claim.where && other.claim.quote == one.claim.quote &&
             other.judgement->truth == one.judgement->truth;
    };
    if (groups.empty() || !same(groups.back().front())) groups.emplace_back();
    groups.back().push_back(one);
  }
  return groups;
}

/// The strongest evidence of the gravest claim.
std::string evidence(const Erratum& erratum) {
  const auto grave = std::find_if(erratum.claims.begin(), erratum.claims.end(), [&](const Judged& one) {
    return severity(one.claim, one.judgement->verdict) == erratum.severity;
  });
  const Evidence& best = grave->judgement->evidence.front();
  const std::string coq = best.coq.empty() ? "" : fmt::format(" ({})", fmt::join(best.coq, ", "));
  return fmt::format("{}{}{}: {}", name(best.kind), best.theorem.empty() ? "" : " “" + best.theorem + "”",
                     coq, two_lines(best.detail));
}

/// What does not depend on the erratum, by verdict: it is said to stand only where it was found to.
std::string unchanged(const Erratum& erratum) {
  std::vector<std::string> hold, others;
  for (const Judged& one : erratum.unchanged) {
    const bool confirmed = one.judgement && one.judgement->verdict == Verdict::confirmed;
    (confirmed ? hold : others).push_back(place(one.claim.where));
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
      m.text(fmt::format("{} claims were judged. {}. Places are section, equation, figure and table: the "
                         "text that was read has no page numbers.",
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
    for (const std::vector<Judged>& same : of_one_passage(erratum.claims)) {
      const Judged& one = same.front();
      std::vector<std::string> ids;
      for (const Judged& claim : same) ids.push_back(claim.claim.id);
      item(places(one.claim) + ":", fmt::format("printed “{}”; true: {} [{}]", one.claim.quote,
                                                one.judgement->truth, fmt::join(ids, ", ")));
    }
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
