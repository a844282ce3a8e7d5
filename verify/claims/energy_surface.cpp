/// \file
/// Section 4.2, Fig. 16: the straight chain of four links held at 0.5 L, far beyond its critical force.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "proofs/census/census.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/loaded_chains.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

const proofs::Census& census() {
  static const proofs::Census instance =
      held_at(Chain<Interval>({1, 1, 1, 1}, {1, 1, 1, 1}, {0, 0, 0, 0}), Interval(Rational(35, 10)));
  return instance;
}

std::string kind(const proofs::CertifiedEquilibrium& one) {
  static const char* const names[] = {"minimum", "saddle", "maximum"};
  return names[one.negative_directions.value()];
}

/// The paper's word for a shape, by its signs or the mirrored ones: Table 3.
std::string word(const proofs::CertifiedEquilibrium& one) {
  std::string pattern = signs(one);
  if (pattern.front() == '+')
    for (char& c : pattern) c = c == '+' ? '-' : c == '-' ? '+' : c;
  static const std::map<std::string, std::string> names{{"-+++", "U"}, {"-+-+", "Z"}, {"-++-", "ZU"}};
  const auto found = names.find(pattern);
  return found == names.end() ? pattern : found->second;
}

std::string summary() {
  std::vector<std::string> list;
  for (const auto& one : census().equilibria)
    list.push_back(fmt::format("{} {} (E = {} k)", word(one), kind(one), certified_decimal(one.energy, 5)));
  return fmt::format("certified census at the end point (3.5, 0), {} boxes: {}", census().boxes,
                     fmt::join(list, ", "));
}

Judgement of_census(const std::string& printed, const std::string& found, const std::string& truth) {
  return judge_word(printed, found, truth, {{EvidenceKind::interval, summary()}});
}

/// What a function E(q1, q2) of a chain with two constraints has had eliminated.
Judgement excluded(const Printed& printed, int) {
  const std::set<std::string> arguments{"q1", "q2"};
  std::vector<std::string> rest;
  for (const char* angle : {"q1", "q2", "q3", "q4"}) {
    if (!arguments.contains(angle)) rest.emplace_back(angle);
  }
  const bool right = printed == rest;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? ""
                : fmt::format("the two constraints of (21) eliminate {}; q2 is an argument of E(q1, q2)",
                              fmt::join(rest, ", ")),
          {{EvidenceKind::exact, "four joint angles, two constraints, arguments q1 and q2"}},
          ""};
}

/// printed: kind of point, stability
Judgement stability(const Printed& printed, int) {
  std::string found;
  for (const auto& one : census().equilibria) {
    if (kind(one) == printed.at(0)) found = one.negative_directions == 0 ? "stable" : "unstable";
  }
  if (found.empty()) throw Error("claim", printed.at(0), "minimum, saddle or maximum");
  return judge_word(
      printed.at(1), found,
      "the minima (U) are the stable, the maxima (Z) the unstable equilibria: the words are interchanged",
      {Evidence::by_theorem(
           "Stability",
           "with the end point held, stable is where E has a strict minimum, and what has a negative "
           "direction is not"),
       {EvidenceKind::interval, summary()}});
}

Judgement kinds(const Printed& printed, int) {
  const std::string found = extrema(census());
  return of_census(printed.at(0), found, "there are " + found);
}

Judgement totals(const Printed& printed, int) {
  const std::string found = fmt::format("{}: {}", census().equilibria.size(), types(census()));
  return of_census(printed.at(0), found, found);
}

/// Equilibria on each of the two sheets of E(q1, q2).
Judgement sheets(const Printed& printed, int) {
  std::map<char, std::size_t> count;
  for (const auto& one : census().equilibria) ++count[sign_character(sin(one.q[3]))];
  const std::string total = std::to_string(census().equilibria.size()),
                    found = fmt::format("{} for q4 > 0, {} for q4 < 0", count['+'], count['-']);
  Judgement result =
      of_census(printed.at(0), found,
                "q1 and q2 leave the sign of q4 open: E(q1, q2) has two sheets, and of the equilibria " +
                    found + " (Figures 11 and 13 show the sheet q4 > 0 alone)");
  if (printed.at(0) == total) result.verdict = Verdict::imprecise;
  return result;
}

/// Whether the two minima, and the two maxima, have equal energy: all are global.
Judgement global(const Printed& printed, int) {
  std::map<std::string, std::vector<Interval>> energy;
  for (const auto& one : census().equilibria) energy[kind(one)].push_back(one.energy);
  bool equal = true;
  for (const char* extreme : {"minimum", "maximum"}) {
    const auto& values = energy[extreme];
    for (const Interval& e : values)
      equal = equal && !certainly_less(e, values.front()) && !certainly_less(values.front(), e);
  }
  return of_census(printed.at(0), equal ? "global" : "local", "some of them are only local");
}

/// Shape and stability, each shape once.
Judgement surface_shapes(const Printed& printed, int) {
  std::map<std::string, std::string> found;
  for (const auto& one : census().equilibria) {
    std::string& here = found[word(one)];
    const std::string kind = one.negative_directions == 0 ? "stable" : "unstable";
    here = here.empty() || here == kind ? kind : "either";
  }
  std::vector<std::string> list;
  for (const auto& [shape, kind] : found) list.insert(list.end(), {shape, kind});
  return judge_list(printed, list, fmt::format("the equilibria are {}", fmt::join(list, " ")),
                    {{EvidenceKind::interval, summary()}});
}

Judgement preferred(const Printed& printed, int) {
  return of_census(printed.at(0), word(census().equilibria.front()), "another shape has the least energy");
}

}  // namespace

Checks claims::energy_surface() {
  return {
      {"fig-16-excluded", excluded}, {"fig-16-maxima", stability}, {"fig-16-minima", stability},
      {"fig-16-saddles", stability}, {"fig-16-kinds", kinds},      {"fig-16-global", global},
      {"fig-16-count", totals},      {"fig-16-sheets", sheets},    {"fig-16-shapes", surface_shapes},
      {"fig-16-prefers", preferred},
  };
}

}  // namespace plumbline::verify
