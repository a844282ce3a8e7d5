/// \file
/// What the paper says of its own sections, equations and symbols, by its headings and prints.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

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
                    fmt::format("they are sections {}, by their headings", fmt::join(found, ", ")),
                    {{EvidenceKind::exact, headings}});
}

/// printed: the sections on singular and non-singular initial configurations
Judgement on_configurations(const Printed& printed, int) {
  const auto [found, headings] = sections_on({"the non-straight", "the straight"});
  const bool next = found.size() == 1 && found.front() == "3";
  const std::string words = next ? "the following section that concentrates"
                                 : fmt::format("sections {} that concentrate", fmt::join(found, " and "));
  return judge_word(
      printed.at(0), words,
      fmt::format("non-straight and straight initial configurations are the matter of sections {}",
                  fmt::join(found, " and ")),
      {{EvidenceKind::exact, headings}});
}

/// The premises of a section's claims.
std::vector<Premise> premises_of(const std::string& section) {
  std::vector<Premise> all;
  for (const Claim& claim : in_section(paper().claims, section))
    all.insert(all.end(), claim.given.list().begin(), claim.given.list().end());
  return all;
}

/// printed: a section before 4.1 that considers the mechanism of Fig. 4, three links on a passive base
Judgement section_of_figure_4(const Printed& printed, int) {
  const std::string section = printed.at(0);
  const auto all = section < "4" ? premises_of(section) : std::vector<Premise>{};
  const bool considers = std::any_of(all.begin(), all.end(), [](const Premise& one) {
    const auto stiffness = one.parts.find("stiffness");
    return stiffness != one.parts.end() && stiffness->second.size() == 3 && stiffness->second.front() == "0";
  });
  const std::string defines = section_of(paper().claim("eq-4"));
  return judge_word(
      considers ? section : defines, section, "Fig. 4 and its equations stand in section " + defines,
      {{EvidenceKind::exact, fmt::format("claims of section {} are made of three links on a passive base: {}",
                                         section, considers)}});
}

/// What the chains of the section after 3.1 are made of, by the premises of its claims.
Judgement made_of(const Printed& printed, int) {
  std::set<std::string> chains;
  for (const Premise& one : premises_of("3.2"))
    if (one.parts.contains("stiffness")) chains.insert(one.id);
  return judge_word(printed.at(0), chains.empty() ? "the tensegrity mechanisms" : "elastic joints",
                    "the chains of section 3.2 are links with elastic joints",
                    {{EvidenceKind::exact, fmt::format("premises of section 3.2 with a stiffness a joint: {}",
                                                       fmt::join(chains, ", "))}});
}

}  // namespace

Checks claims::outline() {
  return {
      {"outline", contents},
      {"following-section", on_configurations},
      {"fig-4-section", section_of_figure_4},
      {"tensegrity", made_of},
  };
}

}  // namespace plumbline::verify
