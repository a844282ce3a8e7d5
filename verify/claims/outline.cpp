/// \file
/// Section 1: what the other sections are about, by their headings.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "verify/claims/claims.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

/// printed: the sections on buckling, on non-straight and straight configurations, and the summary
Judgement contents(const Printed& printed, int) {
  std::vector<std::string> found, headings;
  for (const char* const subject : {"Buckling", "the non-straight", "the straight", "Conclusions"}) {
    for (const PaperSection& section : paper().sections) {
      if (section.title.find(subject) == std::string::npos) continue;
      found.push_back(section.number);
      headings.push_back(section.number + " “" + section.title + "”");
    }
  }
  const bool right = printed == found;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : fmt::format("they are {}: section 5 is the discussion", fmt::join(found, ", ")),
          {{EvidenceKind::exact, fmt::format("headings: {}", fmt::join(headings, ", "))}},
          ""};
}

}  // namespace

Checks claims::outline() {
  return {{"outline", contents}};
}

}  // namespace plumbline::verify
