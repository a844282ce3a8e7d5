/// \file
/// What the paper says of its own sections, equations and symbols, by its headings and prints.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/judge.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

/// The sections whose headings have one of these words, and the headings.
std::pair<std::vector<std::string>, std::string> sections_on(const std::vector<std::string>& subjects) {
  std::vector<std::string> found, headings;
  for (const std::string& subject : subjects) {
    for (const PaperSection& section : paper().sections) {
      if (section.title.find(subject) == std::string::npos) continue;
      found.push_back(section.number);
      headings.push_back(section.number + " “" + section.title + "”");
    }
  }
  return {found, fmt::format("headings: {}", fmt::join(headings, ", "))};
}

/// printed: the sections on buckling, on non-straight and straight configurations, and the summary
Judgement contents(const Printed& printed, int) {
  const auto [found, headings] = sections_on({"Buckling", "the non-straight", "the straight", "Conclusions"});
  return judge_list(printed, found,
                    fmt::format("they are {}: section 5 is the discussion", fmt::join(found, ", ")),
                    {{EvidenceKind::exact, headings}});
}

/// printed: the sections on singular and non-singular initial configurations
Judgement on_configurations(const Printed& printed, int) {
  const auto [found, headings] = sections_on({"the non-straight", "the straight"});
  return judge_list(printed, found, fmt::format("they are sections {}", fmt::join(found, " and ")),
                    {{EvidenceKind::exact, headings}});
}

/// printed: the section that has the mechanism of Fig. 4
Judgement section_of_figure_4(const Printed& printed, int) {
  const std::string found = section_of(paper().claim("eq-4"));
  return judge_word(printed.at(0), found, "Fig. 4 and its equations stand in section " + found,
                    {{EvidenceKind::exact, "(4), the end point of Fig. 4, stands in section " + found}});
}

/// How many things a symbol is: sine in (7), vector in (28), where both print it.
Judgement meanings_of_s0(const Printed& printed, int) {
  std::size_t meanings = 0;
  for (const char* const where : {"eq-7-names", "eq-31-33"}) {
    const Printed& symbols = printed_in_paper(where);
    meanings += std::count(symbols.begin(), symbols.end(), "S0") > 0 ? 1 : 0;
  }
  const std::string found = std::to_string(meanings);
  return {printed.at(0) == found ? Verdict::confirmed : Verdict::convention,
          printed.at(0) == found ? "" : "S_0 is sin phi in (7), and a vector in (28) to (33)",
          {{EvidenceKind::exact, "the symbol is printed among those of (7), and in (33)"}},
          ""};
}

}  // namespace

Checks claims::outline() {
  return {
      {"outline", contents},
      {"following-section", on_configurations},
      {"fig-4-section", section_of_figure_4},
      {"symbol-s0", meanings_of_s0},
  };
}

}  // namespace plumbline::verify
