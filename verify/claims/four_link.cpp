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

std::string signs_of_mode(const CertifiedMode& mode) {
  std::string pattern;
  for (const Interval& angle : mode.q) pattern += sign_character(angle);
  return pattern;
}

/// The mode (index from 0) that has the paper's shape name.
std::size_t mode_of_shape(const Premises& given, const std::string& shape) {
  for (std::size_t m = 0; m < modes(given).size(); ++m) {
    if (shape_name(signs_of_mode(modes(given)[m])) == shape) return m;
  }
  throw Error("claim", "the shape '" + shape + "'", "U, Z or ZU");
}

Judgement polynomial(const Printed& printed, const Premises& given, int) {
  const proofs::Formulas none({});
  const proofs::Polynomial chi = proofs::characteristic_polynomial(unit_chain(given));
  std::vector<GiNaC::ex> computed;
  std::vector<std::string> names;
  ex factor = none.parse(printed.at(0));  // an equation may have any but zero
  if (factor.is_zero()) factor = 1;
  for (std::size_t i = chi.size(); i-- > 0;) {
    computed.push_back(factor * none.parse(chi.at(i).str()));
    names.push_back(fmt::format("coefficient of lambda^{}", i));
  }
  Judgement result = judge_formulas(none, printed, computed, names, "");
  result.evidence = {{EvidenceKind::exact, "det(lambda I - B^-1 A) in rationals"}};
  return result;
}

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

Judgement all_eigenvalues(const Printed& printed, const Premises& given, int digits) {
  Judgement result = listed(given, printed);
  std::vector<std::string> values;
  for (const CertifiedMode& mode : modes(given)) values.push_back(certified_decimal(mode.lambda, digits));
  result.value = fmt::format("{}", fmt::join(values, "; "));
  return result;
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

/// The rows of Table 3, in its order: three shapes with q1 < 0, and their mirror images.
const std::vector<std::string>& rows_of_table_3() {
  static const std::vector<std::string> rows{"U", "Z", "ZU", "U", "Z", "ZU"};
  return rows;
}

/// printed: signs and shape, row by row
Judgement patterns(const Printed& printed, const Premises& given, int) {
  std::vector<std::string> found;
  for (const char first : {'-', '+'}) {
    for (const char* shape : {"U", "Z", "ZU"}) {
      std::string pattern = signs_of_mode(modes(given).at(mode_of_shape(given, shape)));
      if (pattern.front() != first)
        for (char& c : pattern) c = c == '+' ? '-' : '+';
      found.push_back(pattern);
      found.emplace_back(shape);
    }
  }
  const std::string list = fmt::format("{}", fmt::join(found, " "));
  return judge_list(printed, found, list,
                    {{EvidenceKind::interval, "signs of the certified modes: " + list}});
}

/// Stability of the small bent shapes under an imposed end point: mode m has m - 1 negative directions.
Judgement stabilities(const Printed& printed, const Premises& given, int) {
  std::vector<std::string> found;
  for (const std::string& shape : rows_of_table_3()) {
    found.push_back(shape);
    found.emplace_back(mode_of_shape(given, shape) == 0 ? "stable" : "unstable");
  }
  const std::string list = fmt::format("{}", fmt::join(found, " "));
  return judge_list(
      printed, found, list,
      {Evidence::by_theorem(
           "Count of shapes",
           "the modes diagonalise E and delta_x together; at the small shape of mode m the second "
           "variation along mode j has the sign of F_j - F_m"),
       {EvidenceKind::interval, "lower modes by certified forces: " + list}});
}

/// A column of Table 3, shape and number row by row.
Judgement column_of_table_3(const Premises& given, const Printed& printed, int digits,
                            Interval CertifiedMode::*number, const std::string& symbol) {
  std::vector<Interval> computed;
  std::vector<std::string> names, values;
  Printed shapes, decimals;
  for (std::size_t i = 0; i < printed.size(); ++i) (i % 2 == 0 ? shapes : decimals).push_back(printed[i]);
  for (const std::string& shape : rows_of_table_3()) {
    computed.push_back(modes(given).at(mode_of_shape(given, shape)).*number);
    names.push_back(symbol + " of " + shape);
    values.push_back(certified_decimal(computed.back(), digits));
  }
  Judgement result = judge_decimals(decimals, computed, names, how);
  if (shapes != rows_of_table_3()) {
    result.verdict = Verdict::refuted;
    result.truth = fmt::format("the rows are {}", fmt::join(rows_of_table_3(), ", "));
  }
  values.resize(3);
  result.value = fmt::format("{}", fmt::join(values, "; "));
  return result;
}

Judgement factors(const Printed& printed, const Premises& given, int digits) {
  return column_of_table_3(given, printed, digits, &CertifiedMode::factor, "mu^0");
}

/// Where a force is wrong in its last places it may be the reciprocal of the rounded eigenvalue.
Judgement forces(const Printed& printed, const Premises& given, int digits) {
  Judgement result = column_of_table_3(given, printed, digits, &CertifiedMode::force, "F_x");
  Printed corrected = printed;
  std::vector<std::string> reciprocals;
  for (std::size_t i = 1; i < corrected.size(); i += 2) {
    const Interval lambda = modes(given).at(mode_of_shape(given, rows_of_table_3().at(i / 2))).lambda;
    const Rational rounded =
        proofs::parse_decimal(proofs::to_fixed(proofs::exactly(lambda.middle()), 4)).value();
    if (corrected[i] != proofs::to_fixed(Rational(-1 / rounded), 4)) continue;
    const std::string right = proofs::to_fixed(
        proofs::exactly(modes(given).at(mode_of_shape(given, rows_of_table_3().at(i / 2))).force.middle()),
        4);
    if (right == corrected[i]) continue;
    reciprocals.push_back(fmt::format("{} is -1/({}), the reciprocal of the rounded eigenvalue", corrected[i],
                                      proofs::to_fixed(rounded, 4)));
    corrected[i] = right;
  }
  if (result.verdict == Verdict::refuted && !reciprocals.empty() &&
      column_of_table_3(given, corrected, digits, &CertifiedMode::force, "F_x").verdict ==
          Verdict::confirmed) {
    result.truth += "; " + reciprocals.front();
  }
  return result;
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

Judgement shapes_total(const Printed& printed, const Premises& given, int) {
  const std::size_t count = 2 * proofs::distinct_critical_forces(unit_chain(given));
  return judge_word(printed.at(0), std::to_string(count), fmt::format("{} shapes", count),
                    {{EvidenceKind::exact, "two for each distinct root of det(A F + B), n = 4"}});
}

}  // namespace

Checks claims::four_link() {
  return {
      {"unit-norm", norms},
      {"four-link-polynomial", polynomial},
      {"four-link-roots", all_eigenvalues},
      {"three-nonzero-roots", nonzero_roots},
      {"four-link-shapes", shapes_total},
      {"four-link-stable-shapes", stable_count},
      {"straight-below-critical", straight_below},
      {"table-3-signs", patterns},
      {"table-3-stability", stabilities},
      {"table-3-factors", factors},
      {"table-3-forces", forces},
  };
}

}  // namespace plumbline::verify
