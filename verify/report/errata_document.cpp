/// \file
/// The errata as a document to send, in Markdown and in LaTeX.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "verify/judging/characters.hpp"
#include "verify/judging/notation.hpp"
#include "verify/report/errata.hpp"
#include "verify/report/markup.hpp"

namespace plumbline::verify {
namespace {

/// How a document is marked up.
struct Markup {
  std::string (*text)(const std::string&);
  const char *title, *heading, *item, *paragraph, *emphasis;  ///< formats
  const char *begin, *end;
};

const Markup in_markdown{as_markdown, "# {}\n\n", "## {}\n\n", "**{}.** ", "{}\n\n", "*{}*", "", ""};
const Markup in_latex{as_latex,
                      "\\section*{{{}}}\n",
                      "\\subsection*{{{}}}\n",
                      "\\paragraph{{{}.}} ",
                      "{}\n\n",
                      "\\emph{{{}}}",
                      "\\documentclass[a4paper]{article}\n\\usepackage[margin=25mm]{geometry}\n"
                      "\\usepackage{amsmath}\n\\frenchspacing\\emergencystretch=3em\n\\begin{document}\n",
                      "\\end{document}\n"};

/// "(1) to (3), (5)" of numbers.
std::string ranges(const std::set<int>& numbers, const std::string& form) {
  std::vector<std::string> parts;
  for (auto first = numbers.begin(); first != numbers.end();) {
    auto last = first;
    while (std::next(last) != numbers.end() && *std::next(last) == *last + 1) ++last;
    const std::string from = fmt::format(fmt::runtime(form), *first),
                      to = fmt::format(fmt::runtime(form), *last);
    parts.push_back(first == last ? from : from + (*last == *first + 1 ? ", " : " to ") + to);
    first = std::next(last);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Numbers of what a claim is about, by a pattern in its place: "(12)", "Fig. 5", "(31) to (33)"; what stands
/// before or after something is not about it.
std::set<int> numbers_in(const std::string& where, const std::regex& pattern) {
  std::set<int> found;
  std::istringstream parts(where);
  for (std::string part; std::getline(parts, part, ',');) {
    if (part.find("before") != std::string::npos || part.find("after") != std::string::npos) continue;
    for (std::sregex_iterator one(part.begin(), part.end(), pattern), end; one != end; ++one) {
      const int first = std::stoi((*one)[1]), last = (*one)[2].length() > 0 ? std::stoi((*one)[2]) : first;
      for (int number = first; number <= last; ++number) found.insert(number);
    }
  }
  return found;
}

/// Things with numbers that claims are about.
struct Numbered {
  const char* name;
  std::regex number;
  const char* form;
};

}  // namespace

std::string confirmed_by_name(const std::vector<Judged>& judged) {
  static const std::vector<Numbered> kinds{
      {"Equations", std::regex(R"((?:^|[ ,])\((\d+)\)(?: to \((\d+)\))?)"), "({})"},
      {"Tables", std::regex(R"(Table (\d+)()?)"), "{}"},
      {"Figures, as far as the text says what they show,", std::regex(R"(Fig\. (\d+)()?)"), "{}"}};
  std::vector<std::string> parts;
  for (const Numbered& kind : kinds) {
    std::set<int> about, wrong;
    for (const Judged& one : judged) {
      const std::string where = one.claim.where.substr(one.claim.where.find(',') + 1);
      const std::set<int> numbers = numbers_in(where, kind.number);
      about.insert(numbers.begin(), numbers.end());
      const bool right = one.judgement && (one.judgement->verdict == Verdict::confirmed ||
                                           one.judgement->verdict == Verdict::convention);
      if (!right) wrong.insert(numbers.begin(), numbers.end());
    }
    std::set<int> whole;
    std::set_difference(about.begin(), about.end(), wrong.begin(), wrong.end(),
                        std::inserter(whole, whole.end()));
    if (!whole.empty()) parts.push_back(fmt::format("{} {}", kind.name, ranges(whole, kind.form)));
  }
  return fmt::format("{}.", fmt::join(parts, ". "));
}

namespace {

/// "Section 5, after (12)", where the section is a number.
std::string in_section(const std::string& place) {
  const bool number = !place.empty() && is_digit(place.front());
  return (number ? "Section " : "") + place;
}

/// "Section 5, after (12); also Section 6, sentence 2".
std::string places(const Claim& claim) {
  std::string all = in_section(claim.where);
  for (const std::string& other : claim.also)
    all += (&other == &claim.also.front() ? "; also " : "; ") + in_section(other);
  return all;
}

/// The claims of an item: each correction at its place, or the words that a remark is about.
std::vector<std::string> passages(const JudgedErratum& one, const Paper& paper, const Markup& m) {
  std::vector<std::string> parts;
  for (const Correction& each : one.corrections)
    parts.push_back(
        fmt::format("{}: {} {} {} {}.", m.text(with_marks(places(paper.claim(each.claim)))),
                    fmt::format(fmt::runtime(m.emphasis), "for"), m.text("“" + each.printed + "”"),
                    fmt::format(fmt::runtime(m.emphasis), "read"), m.text("“" + each.read + "”")));
  if (!one.corrections.empty()) return parts;
  for (const Judged& each : one.claims) {
    const std::string words = m.text(with_marks(places(each.claim) + ": “" + each.claim.quote + "”."));
    if (std::find(parts.begin(), parts.end(), words) == parts.end()) parts.push_back(words);
  }
  return parts;
}

std::string item(const JudgedErratum& one, const Paper& paper, const std::string& number, const Markup& m) {
  std::vector<std::string> parts = passages(one, paper, m);
  for (const std::string& each : one.reason) parts.push_back(m.text(each));
  const auto effect = [&](const std::string& what, const std::vector<std::string>& on) {
    if (!on.empty())
      parts.push_back(fmt::format(fmt::runtime(m.emphasis), what) + " " +
                      m.text(with_marks(fmt::format("{}.", fmt::join(on, "; ")))));
  };
  effect("Changed:", one.changes);
  effect("Unchanged:", one.stands);
  return fmt::format(fmt::runtime(m.paragraph),
                     fmt::format(fmt::runtime(m.item), number) + fmt::format("{}", fmt::join(parts, " ")));
}

std::string document(const Paper& paper, const std::vector<Judged>& judged, const Markup& m) {
  const Errata list = errata(paper, judged);
  const auto count = [&](Verdict verdict) {
    return std::count_if(judged.begin(), judged.end(), [&](const Judged& one) {
      return one.judgement && one.judgement->verdict == verdict;
    });
  };
  const auto paragraph = [&](const std::string& text) {
    return fmt::format(fmt::runtime(m.paragraph), m.text(text));
  };
  std::string all = m.begin + fmt::format(fmt::runtime(m.title), "Errata");
  all += paragraph(paper.reference() + (paper.doi.empty() ? "." : ", doi:" + paper.doi + "."));
  all += paragraph(fmt::format("This rests on {}. Of {} claims {} are confirmed as printed.", paper.read,
                               judged.size(), count(Verdict::confirmed)));
  std::size_t number = 0, remark = 0;
  bool remarks = false;
  for (const JudgedErratum& one : list.items) {
    if (one.remark && !remarks) all += fmt::format(fmt::runtime(m.heading), "Remarks");
    remarks = remarks || one.remark;
    all += item(one, paper, one.remark ? fmt::format("R{}", ++remark) : fmt::format("E{}", ++number), m);
  }
  all += fmt::format(fmt::runtime(m.heading), "Confirmed") + paragraph(confirmed_by_name(judged));
  return all + m.end;
}

}  // namespace

std::string errata_as_markdown(const Paper& paper, const std::vector<Judged>& judged) {
  return document(paper, judged, in_markdown);
}

std::string errata_as_latex(const Paper& paper, const std::vector<Judged>& judged) {
  return document(paper, judged, in_latex);
}

}  // namespace plumbline::verify
