/// \file
/// Section 4.2, the unit chain of four links: (40), its polynomial, Tables 2 and 3.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <map>
#include <plumbline/straight/critical_force.hpp>
#include <set>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_chain.hpp"
#include "proofs/exact/exactly.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/post_buckling.hpp"
#include "verify/chains/straight_modes.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

Chain<Rational> unit_chain(const Premises& given) {
  return given.exact_chain("unit-chain");
}

/// The modes of the unit chain, ascending in force.
const std::vector<CertifiedMode>& modes(const Premises& given) {
  return certified_modes(unit_chain(given));
}

const std::string how =
    "counts of critical forces by exact recursion bound each F to 60 digits; lambda, q, F_y from it in "
    "intervals";

/// The eigenvalues in the paper's order: three of the modes and two zeros.
Judgement listed(const Premises& given, const Printed& printed) {
  std::vector<Interval> computed;
  std::vector<std::string> names;
  for (const CertifiedMode& mode : modes(given)) computed.push_back(mode.lambda);
  computed.resize(
      computed.size() + proofs::multiplicity_of_zero(proofs::characteristic_polynomial(unit_chain(given))),
      Interval(0));
  for (std::size_t i = 1; i <= computed.size(); ++i) names.push_back(fmt::format("lambda_{}", i));
  return judge_decimals(printed, computed, names, how);
}

/// printed: how many roots are not zero, and the list of roots
Judgement nonzero_roots(const Printed& printed, const Premises& given, int) {
  const proofs::Polynomial chi = proofs::characteristic_polynomial(unit_chain(given));
  const std::size_t nonzero = proofs::distinct_negative_roots(chi) + proofs::distinct_positive_roots(chi);
  Printed list(printed.begin() + 1, printed.end());
  const bool without_zeros = list.size() == nonzero;
  if (without_zeros) list.insert(list.end(), proofs::multiplicity_of_zero(chi), "0");
  const bool right =
      printed.at(0) == std::to_string(nonzero) && listed(given, list).verdict == Verdict::confirmed;
  return {!right          ? Verdict::refuted
          : without_zeros ? Verdict::confirmed
                          : Verdict::convention,
          right && without_zeros
              ? ""
              : fmt::format("there are {} non-zero roots; the set that is printed is that of all five "
                            "eigenvalues, {} of them zero",
                            nonzero, proofs::multiplicity_of_zero(chi)),
          {{EvidenceKind::exact,
            fmt::format("Sturm's theorem on the polynomial: {} negative and {} positive roots, 0 with "
                        "multiplicity {}",
                        proofs::distinct_negative_roots(chi), proofs::distinct_positive_roots(chi),
                        proofs::multiplicity_of_zero(chi))},
           {EvidenceKind::interval, how}},
          ""};
}

/// Whether the vectors of Table 2 have the printed norm.
Judgement norms(const Printed& printed, int) {
  const std::optional<Rational> norm = proofs::parse_decimal(printed.at(0));
  if (!norm) throw Error("claim", printed.at(0), "a norm");
  bool all = *norm > 0;
  std::vector<std::string> found;
  for (const char* row : {"table-2-row-1", "table-2-row-2", "table-2-row-3"}) {
    const Printed& entries = printed_in_paper(row);
    Rational square = 0;
    Rational slack = 0;  // half a unit of the fourth place in each component
    for (std::size_t i = 1; i < entries.size(); ++i) {
      const Rational x = proofs::parse_decimal(entries[i]).value();
      square += x * x;
      slack += (x < 0 ? Rational(-x) : x) / 10000;
    }
    const Rational off = square - *norm * *norm;
    all = all && off <= slack && -off <= slack;
    found.push_back(proofs::to_decimal(square, 6));
  }
  return {
      all ? Verdict::convention : Verdict::refuted,
      "an eigenvector has no norm of its own; the printed ones, F_y included, have norm 1 within rounding",
      {{EvidenceKind::exact,
        fmt::format("squared norms of the printed vectors of Table 2: {}", fmt::join(found, ", "))}},
      ""};
}

/// Whether bent shapes exist above their critical forces only: near the straight shape, by the initial slope
/// of the force, and far from it, by a census.
Judgement straight_below(const Printed& printed, const Premises& given, int) {
  std::vector<std::string> found;
  bool above = true;
  const auto chain = given.chain("unit-chain");
  for (const CertifiedMode& mode : modes(given)) {
    const Interval curvature = post_buckling_curvature(chain, {mode.force, mode.q, mode.fy});
    above = above && certainly_positive(curvature);
    found.push_back(certified_decimal(curvature, 6));
  }
  const Interval lowest = modes(given).front().force;
  const Rational deep(335, 100);
  std::string below;
  for (const auto& one : held(given, "unit-chain").at(deep).equilibria) {
    const Interval force = paper_force(one).x;
    if (below.empty() && certainly_positive(force) && certainly_less(force, lowest) &&
        one.negative_directions == std::size_t{0})
      below = certified_decimal(force, 5);
  }
  const std::string word = !above ? "above" : below.empty() ? "below" : "below, near the straight shape";
  Judgement result = judge_word(
      printed.at(0), word,
      fmt::format("so near the straight shape; a U-shape compressed by {} L is held by {} k/L, less than "
                  "F_x^0 = {} k/L",
                  proofs::to_exact(deep), below, certified_decimal(lowest, 5)),
      {Evidence::by_theorem("Stable below the lowest force",
                            "the straight chain is stable exactly there; and by "
                            "Supercritical the sign of F_2 decides on which side bent shapes exist"),
       {EvidenceKind::interval,
        fmt::format("F = F_m + F_2 a^2 + … along theta = a phi, |v| = 1: F_2 = {}", fmt::join(found, ", "))},
       {EvidenceKind::interval, fmt::format("certified census at {} L: a stable shape that needs {} k/L",
                                            proofs::to_exact(deep), below)}});
  if (result.verdict == Verdict::refuted && word.starts_with(printed.at(0) + ","))
    result.verdict = Verdict::imprecise;
  return result;
}

Judgement stable_count(const Printed& printed, const Premises& given, int) {
  std::size_t lowest = 0;
  for (const CertifiedMode& mode : modes(given)) {
    bool least = true;
    for (const CertifiedMode& other : modes(given))
      least = least && (&other == &mode || certainly_less(mode.force, other.force));
    lowest += least ? 2 : 0;  // a shape and its mirror image
  }
  return judge_word(printed.at(0), std::to_string(lowest),
                    fmt::format("{} shapes have the least energy", lowest),
                    {{EvidenceKind::interval,
                      "E_i = F_i delta_x to leading order; the three certified forces are distinct, and "
                      "q and -q share one"}});
}

}  // namespace

Checks claims::four_link() {
  return {
      {"unit-norm", norms},
      {"three-nonzero-roots", nonzero_roots},
      {"four-link-stable-shapes", stable_count},
      {"straight-below-critical", straight_below},
  };
}

}  // namespace plumbline::verify
