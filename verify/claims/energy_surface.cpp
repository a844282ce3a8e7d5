/// \file
/// Section 4.2, Fig. 16: the straight chain of four links held at 0.5 L, far beyond its critical force.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "proofs/census/census.hpp"
#include "proofs/exact/decimal.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

const proofs::Census& landscape(const Premises& given) {
  return held(given, "unit-chain").at(given.exact("fig-16-deflection"));
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

std::string summary(const Premises& given) {
  std::vector<std::string> list;
  for (const auto& one : landscape(given).equilibria)
    list.push_back(fmt::format("{} {} (E = {} k)", word(one), kind(one), certified_decimal(one.energy, 5)));
  return fmt::format("certified census at {} L, {} boxes: {}",
                     proofs::to_exact(given.exact("fig-16-deflection")), landscape(given).boxes,
                     fmt::join(list, ", "));
}

Judgement of_census(const Premises& given, const std::string& printed, const std::string& found,
                    const std::string& truth) {
  return judge_word(printed, found, truth, {{EvidenceKind::interval, summary(given)}});
}

/// What a function E(q1, q2) of a chain with two constraints has had eliminated.
Judgement excluded(const Printed& printed, int) {
  const std::set<std::string> arguments{"q1", "q2"};
  std::vector<std::string> rest, named;
  for (const char* angle : {"q1", "q2", "q3", "q4"}) {
    if (arguments.contains(angle)) continue;
    rest.emplace_back(angle);
    named.push_back(fmt::format("q_{}", angle + 1));
  }
  const bool right = printed == rest;
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? ""
                : fmt::format("the two constraints of (21) eliminate {}, the angles that are no arguments of "
                              "E(q_1, q_2)",
                              fmt::join(named, " and ")),
          {{EvidenceKind::exact, "four joint angles, two constraints, arguments q1 and q2"}},
          ""};
}

/// Equilibria on each of the two sheets of E(q1, q2).
Judgement sheets(const Printed& printed, const Premises& given, int) {
  std::map<char, std::size_t> count;
  for (const auto& one : landscape(given).equilibria) ++count[sign_character(sin(one.q[3]))];
  const std::string total = std::to_string(landscape(given).equilibria.size()),
                    found = fmt::format("{} for q4 > 0, {} for q4 < 0", count['+'], count['-']);
  Judgement result =
      of_census(given, printed.at(0), found,
                "q1 and q2 leave the sign of q4 open: E(q1, q2) has two sheets, and of the equilibria " +
                    found + " (Figures 11 and 13 show the sheet q4 > 0 alone)");
  if (printed.at(0) == total) result.verdict = Verdict::imprecise;
  return result;
}

/// Whether all points of a kind have equal energy: then they are global.
bool equal_energies(const proofs::Census& points, const std::string& extreme) {
  std::vector<Interval> energies;
  for (const auto& one : points.equilibria)
    if (kind(one) == extreme) energies.push_back(one.energy);
  return !energies.empty() && std::all_of(energies.begin(), energies.end(), [&](const Interval& e) {
    return !certainly_less(e, energies.front()) && !certainly_less(energies.front(), e);
  });
}

/// Whether the two minima, and the two maxima, have equal energy.
Judgement global(const Printed& printed, const Premises& given, int) {
  const bool equal =
      equal_energies(landscape(given), "minimum") && equal_energies(landscape(given), "maximum");
  return of_census(given, printed.at(0), equal ? "global" : "local", "some of them are only local");
}

/// The same of the minima at a small deflection.
Judgement globally_stable(const Printed& printed, const Premises& given, int) {
  const Rational small = given.exact("small-deflection");
  const proofs::Census& points = held(given, "unit-chain").at(small);
  return judge_word(
      printed.at(0), equal_energies(points, "minimum") ? "global" : "local", "one of them has more energy",
      {{EvidenceKind::interval, fmt::format("certified census at {} L: {}, both minima of one energy",
                                            proofs::to_exact(small), extrema(points))}});
}

}  // namespace

Checks claims::energy_surface() {
  return {
      {"fig-16-excluded", excluded},
      {"fig-16-global", global},
      {"fig-16-sheets", sheets},
      {"four-link-globally-stable", globally_stable},
  };
}

}  // namespace plumbline::verify
