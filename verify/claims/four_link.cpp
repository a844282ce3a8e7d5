/// \file
/// Section 4.2, the unit chain of four links: (40), its polynomial, Tables 2 and 3.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <plumbline/straight/critical_force.hpp>
#include <set>

#include "proofs/certified_modes.hpp"
#include "proofs/decimal.hpp"
#include "proofs/exact_chain.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/post_buckling.hpp"
#include "verify/claims/straight_chains.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

/// A mode whose every number is certified; (q, F_y) has norm 1 and q_1 > 0.
struct CertifiedMode {
  Interval force, lambda, factor, fy;
  std::vector<Interval> q;
};

/// Around a certified decimal.
Interval within_a_unit(const std::string& decimal, int digits) {
  const Rational x = proofs::parse_decimal(decimal).value(), unit = proofs::unit_in_digit(x, digits);
  return hull(Interval(x - unit), Interval(x + unit));
}

CertifiedMode certified_mode(const Chain<Interval>& chain, const proofs::ForceEnclosure& force,
                             const proofs::ShapeEnclosure& shape) {
  const Interval F = hull(Interval(force.low), Interval(force.high));
  std::vector<Interval> q;
  for (const std::string& angle : shape.q) q.push_back(within_a_unit(angle, shape.digits));
  const Interval fy = lateral_force(chain, F, q);
  Interval squares = sqr(fy);
  for (const Interval& angle : q) squares += sqr(angle);
  const Interval norm = certainly_negative(q[0]) ? -sqrt(squares) : sqrt(squares);
  for (Interval& angle : q) angle /= norm;
  return {F, Interval(-1) / F, energy_factor(chain, q), fy / norm, q};
}

/// The three modes of the unit chain, ascending in force; computed once.
const std::vector<CertifiedMode>& modes() {
  static const std::vector<CertifiedMode> instance = [] {
    const proofs::CertifiedModes certified = proofs::certify(four_link_chain(), 3, 3, 60);
    const Chain<Interval> chain = from_rational<Interval>(four_link_chain());
    std::vector<CertifiedMode> result;
    for (std::size_t m = 0; m < 3; ++m)
      result.push_back(certified_mode(chain, certified.forces[m], certified.shapes[m]));
    return result;
  }();
  return instance;
}

const std::string how =
    "counts of critical forces by exact recursion bound each F to 60 digits; lambda, q, F_y from it in "
    "intervals";

std::string signs(const CertifiedMode& mode) {
  std::string pattern;
  for (const Interval& angle : mode.q) pattern += sign_character(angle);
  return pattern;
}

/// The mode (index from 0) that has the paper's shape name.
std::size_t mode_of_shape(const std::string& shape) {
  for (std::size_t m = 0; m < modes().size(); ++m) {
    if (shape_name(signs(modes()[m])) == shape) return m;
  }
  throw Error("claim", "the shape '" + shape + "'", "U, Z or ZU");
}

Judgement matrices(const Printed& printed, int) {
  const proofs::Formulas none({});
  std::vector<GiNaC::ex> computed;
  std::vector<std::string> names;
  const Matrix<Rational> S1 = matrix_S1(four_link_chain());
  const Vector<Rational> S0 = matrix_S0(four_link_chain());
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      computed.push_back(none.parse(S1(i, j).str()));
      names.push_back(fmt::format("S1({},{})", i + 1, j + 1));
    }
  }
  for (Eigen::Index i = 0; i < 4; ++i) {
    computed.push_back(none.parse(S0(i).str()));
    names.push_back(fmt::format("S0({})", i + 1));
  }
  Judgement result = judge_formulas(none, printed, computed, names, "");
  result.evidence = {{EvidenceKind::exact, "(28) with L_i = 1 in rationals"}};
  return result;
}

Judgement polynomial(const Printed& printed, int) {
  const proofs::Formulas none({});
  const proofs::Polynomial chi = proofs::characteristic_polynomial(four_link_chain());
  std::vector<GiNaC::ex> computed;
  std::vector<std::string> names;
  for (std::size_t i = 6; i-- > 0;) {
    computed.push_back(none.parse(chi.at(i).str()));
    names.push_back(fmt::format("coefficient of lambda^{}", i));
  }
  Judgement result = judge_formulas(none, printed, computed, names, "");
  result.evidence = {{EvidenceKind::exact, "det(lambda I - B^-1 A) in rationals"}};
  return result;
}

Judgement nonzero_roots(const Printed& printed, int) {
  const proofs::Polynomial chi = proofs::characteristic_polynomial(four_link_chain());
  const std::size_t nonzero = proofs::distinct_negative_roots(chi) + proofs::distinct_positive_roots(chi);
  const auto listed_zeros =
      static_cast<std::size_t>(std::count(printed.begin() + 1, printed.end(), std::string("0")));
  const bool count_right = printed.at(0) == std::to_string(nonzero);
  const bool list_right = printed.size() - 1 == nonzero;
  return {!count_right                      ? Verdict::refuted
          : !list_right && listed_zeros > 0 ? Verdict::imprecise
                                            : Verdict::confirmed,
          count_right && list_right
              ? ""
              : fmt::format("there are {} non-zero roots; the set that is printed lists "
                            "all five eigenvalues, {} of them zero",
                            nonzero, listed_zeros),
          {{EvidenceKind::exact,
            fmt::format("Sturm's theorem on the polynomial: {} negative and {} positive roots, 0 with "
                        "multiplicity {}",
                        proofs::distinct_negative_roots(chi), proofs::distinct_positive_roots(chi),
                        proofs::multiplicity_of_zero(chi))}},
          ""};
}

Judgement all_eigenvalues(const Printed& printed, int digits) {
  std::vector<Interval> computed;
  std::vector<std::string> values;
  for (const CertifiedMode& mode : modes()) {
    computed.push_back(mode.lambda);
    values.push_back(certified_decimal(mode.lambda, digits));
  }
  Judgement result = judge_decimals(printed, computed, {"lambda_1", "lambda_2", "lambda_3"}, how);
  result.value = fmt::format("{}", fmt::join(values, "; "));
  return result;
}

/// A row of Table 2: lambda and the five components of the unit eigenvector.
Judgement table_2_row(const Printed& printed, int digits) {
  const std::size_t m = std::stoul(printed.at(0)) - 1;
  const CertifiedMode& mode = modes().at(m);
  std::vector<Interval> computed{mode.lambda};
  computed.insert(computed.end(), mode.q.begin(), mode.q.end());
  computed.push_back(mode.fy);
  Judgement result = judge_decimals({printed.begin() + 1, printed.end()}, computed,
                                    {"lambda", "v_1", "v_2", "v_3", "v_4", "v_5"}, how);
  std::vector<std::string> values;
  values.reserve(computed.size());
  for (const Interval& x : computed) values.push_back(certified_decimal(x, digits));
  result.value = fmt::format("{}", fmt::join(values, "; "));
  return result;
}

/// "The classical analysis assumes norm 1": whether the printed vectors have the printed norm.
Judgement norms(const Printed& printed, int) {
  const std::optional<Rational> norm = proofs::parse_decimal(printed.at(0));
  if (!norm) throw Error("claim", printed.at(0), "a norm");
  bool all = true;
  std::string found;
  for (std::size_t row = 1; row < printed.size(); row += 5) {
    Rational square = 0;
    Rational slack = 0;  // half a unit of the fourth place in each component
    for (std::size_t i = row; i < row + 5; ++i) {
      const Rational x = proofs::parse_decimal(printed.at(i)).value();
      square += x * x;
      slack += (x < 0 ? Rational(-x) : x) / 10000;
    }
    const Rational off = square - *norm * *norm;
    all = all && off <= slack && -off <= slack;
    found += fmt::format("{}{}", found.empty() ? "" : ", ", proofs::to_decimal(square, 6));
  }
  return {
      all ? Verdict::convention : Verdict::refuted,
      "an eigenvector has no norm of its own; the printed ones, F_y included, have norm 1 within rounding",
      {{EvidenceKind::exact, "squared norms of the printed vectors of Table 2: " + found}},
      ""};
}

/// Sign patterns of Table 3: shape, pattern, …; the pattern of a mode or its mirror image.
Judgement patterns(const Printed& printed, int) {
  std::vector<std::string> wrong;
  std::vector<std::string> found;
  for (std::size_t i = 0; i + 1 < printed.size(); i += 2) {
    const std::string pattern = signs(modes().at(mode_of_shape(printed[i])));
    std::string mirrored = pattern;
    for (char& c : mirrored) c = c == '+' ? '-' : '+';
    found.push_back(fmt::format("{}: {} or {}", printed[i], pattern, mirrored));
    if (printed[i + 1] != pattern && printed[i + 1] != mirrored) wrong.push_back(found.back());
  }
  return {wrong.empty() ? Verdict::confirmed : Verdict::refuted,
          fmt::format("{}", fmt::join(wrong, "; ")),
          {{EvidenceKind::interval, fmt::format("signs of the certified modes: {}", fmt::join(found, "; "))}},
          ""};
}

/// Stability of the small bent shapes under an imposed end point: mode m has m - 1 negative directions.
Judgement stabilities(const Printed& printed, int) {
  std::vector<std::string> wrong;
  std::vector<std::string> found;
  for (std::size_t i = 0; i + 1 < printed.size(); i += 2) {
    const std::size_t m = mode_of_shape(printed[i]);
    const std::string word = m == 0 ? "stable" : "unstable";
    found.push_back(fmt::format("{}: {} lower modes", printed[i], m));
    if (printed[i + 1] != word) wrong.push_back(printed[i] + " is " + word);
  }
  return {wrong.empty() ? Verdict::confirmed : Verdict::refuted,
          fmt::format("{}", fmt::join(wrong, "; ")),
          {{EvidenceKind::theorem,
            "Count of shapes: the modes diagonalise E and delta_x together; at the small shape of mode m the "
            "second variation along mode j has the sign of F_j - F_m"},
           {EvidenceKind::interval, fmt::format("{}", fmt::join(found, "; "))}},
          ""};
}

Judgement column_of_table_3(const Printed& printed, int digits, Interval CertifiedMode::*number,
                            const std::string& symbol) {
  std::vector<Interval> computed;
  std::vector<std::string> names;
  std::vector<std::string> values;
  Printed decimals;
  for (std::size_t i = 0; i + 1 < printed.size(); i += 2) {
    computed.push_back(modes().at(mode_of_shape(printed[i])).*number);
    names.push_back(symbol + " of " + printed[i]);
    decimals.push_back(printed[i + 1]);
    values.push_back(certified_decimal(computed.back(), digits));
  }
  Judgement result = judge_decimals(decimals, computed, names, how);
  result.value = fmt::format("{}", fmt::join(values, "; "));
  return result;
}

Judgement factors(const Printed& printed, int digits) {
  return column_of_table_3(printed, digits, &CertifiedMode::factor, "mu^0");
}
Judgement forces(const Printed& printed, int digits) {
  return column_of_table_3(printed, digits, &CertifiedMode::force, "F_x");
}

Judgement straight_below(const Printed& printed, int) {
  std::vector<std::string> found;
  bool above = true;
  const auto chain = from_rational<Interval>(four_link_chain());
  for (const CertifiedMode& mode : modes()) {
    const Interval curvature = post_buckling_curvature(chain, {mode.force, mode.q, mode.fy});
    above = above && certainly_positive(curvature);
    found.push_back(certified_decimal(curvature, 6));
  }
  return judge_word(
      printed.at(0), above ? "below" : "above", {"below", "above"},
      "near the straight shape each bent shape exists only above its critical force",
      {{EvidenceKind::theorem,
        "Stable below the lowest force: the straight chain is stable exactly there; and by "
        "Supercritical the sign of F_2 decides on which side bent shapes exist"},
       {EvidenceKind::interval, fmt::format("F = F_m + F_2 a^2 + … along theta = a phi, |v| = 1: F_2 = {}; "
                                            "near the straight shape only",
                                            fmt::join(found, ", "))}});
}

Judgement stable_count(const Printed& printed, int) {
  std::size_t lowest = 0;
  for (const CertifiedMode& mode : modes()) {
    bool least = true;
    for (const CertifiedMode& other : modes())
      least = least && (&other == &mode || certainly_less(mode.force, other.force));
    lowest += least ? 2 : 0;  // a shape and its mirror image
  }
  return judge_word(printed.at(0), std::to_string(lowest), {"1", "2", "3", "4", "6"},
                    fmt::format("{} shapes have the least energy", lowest),
                    {{EvidenceKind::interval,
                      "E_i = F_i delta_x to leading order; the three certified forces are distinct, and "
                      "q and -q share one"}});
}

Judgement shapes_total(const Printed& printed, int) {
  const std::size_t count = 2 * proofs::distinct_critical_forces(four_link_chain());
  return judge_word(printed.at(0), std::to_string(count), {"3", "4", "6", "8"},
                    fmt::format("{} shapes", count),
                    {{EvidenceKind::exact, "two for each distinct root of det(A F + B), n = 4"}});
}

}  // namespace

std::vector<Claim> claims::four_link() {
  const std::array<Printed, 3> table_2{
      Printed{"1", "-1.0822", "0.5185", "-0.0902", "-0.6156", "-0.5721", "-0.1296"},
      Printed{"2", "-0.4337", "0.3863", "-0.6009", "-0.2026", "0.6628", "-0.0966"},
      Printed{"3", "-0.2841", "0.2062", "-0.5713", "0.6623", "-0.4356", "-0.0516"}};
  Printed unit_norm{"1"};
  for (const Printed& row : table_2) unit_norm.insert(unit_norm.end(), row.begin() + 2, row.end());
  return {
      {"unit-norm", "4.2, before (35)", "classical eigenvalue analysis assumes |v_i| = 1", unit_norm, norms},
      {"eq-40",
       "4.2, (40)",
       "S1 and S0 of the unit chain of four links",
       {"-4", "-3", "-2", "-1", "-3", "-3", "-2", "-1", "-2", "-2",
        "-2", "-1", "-1", "-1", "-1", "-1", "4",  "3",  "2",  "1"},
       matrices},
      {"four-link-polynomial",
       "4.2, after (40)",
       "lambda^5 + 9/5 lambda^4 + 9/10 lambda^3 + 2/15 lambda^2 = 0",
       {"1", "9/5", "9/10", "2/15", "0", "0"},
       polynomial},
      {"four-link-roots",
       "4.2, after (40)",
       "lambda_i = -1.0822, -0.4337, -0.2841",
       {"-1.0822", "-0.4337", "-0.2841"},
       all_eigenvalues},
      {"three-nonzero-roots",
       "4.2, after (40)",
       "three non-zero roots {-1.0822, -0.4337, -0.2841, 0, 0}",
       {"3", "-1.0822", "-0.4337", "-0.2841", "0", "0"},
       nonzero_roots},
      {"table-2-row-1", "4.2, Table 2", "lambda_1 and its unit eigenvector", table_2[0], table_2_row},
      {"table-2-row-2", "4.2, Table 2", "lambda_2 and its unit eigenvector", table_2[1], table_2_row},
      {"table-2-row-3", "4.2, Table 2", "lambda_3 and its unit eigenvector", table_2[2], table_2_row},
      {"four-link-shapes",
       "4.2, after Table 2",
       "the total number of equilibrium shapes is 2(n-1) = 6",
       {"6"},
       shapes_total},
      {"four-link-stable-shapes",
       "4.2, after Table 2",
       "two of the shapes have the minimum energy",
       {"2"},
       stable_count},
      {"straight-below-critical",
       "4.2, after Table 2",
       "below the critical force the chain stays straight",
       {"below"},
       straight_below},
      {"table-3-signs",
       "4.2, Table 3",
       "signs of q1 … q4: U -+++, Z -+-+, ZU -++- and their mirror images",
       {"U", "-+++", "Z", "-+-+", "ZU", "-++-", "U", "+---", "Z", "+-+-", "ZU", "+--+"},
       patterns},
      {"table-3-stability",
       "4.2, Table 3",
       "U is stable, Z and ZU are unstable",
       {"U", "stable", "Z", "unstable", "ZU", "unstable"},
       stabilities},
      {"table-3-factors",
       "4.2, Table 3",
       "energy factors U 0.9240, Z 3.5203, ZU 2.3057",
       {"U", "0.9240", "Z", "3.5203", "ZU", "2.3057"},
       factors},
      {"table-3-forces",
       "4.2, Table 3",
       "axial forces U 0.9240, Z 3.5199, ZU 2.3057",
       {"U", "0.9240", "Z", "3.5199", "ZU", "2.3057"},
       forces},
  };
}

}  // namespace plumbline::verify
