/// \file
/// Section 2: the two-link mechanism, equations (1) to (3), and the pseudoinverse quoted at (8).

#include <fmt/core.h>

#include <Eigen/LU>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/decimal.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/matrix_formula.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

/// Two equal links at the inclinations ±(alpha + q); the spring between them turns by 2q.
struct TwoLink {
  proofs::Formulas formulas{{"F", "L", "k", "q", "alpha"}};
  ex F = formulas.symbol("F"), L = formulas.symbol("L"), k = formulas.symbol("k"), q = formulas.symbol("q"),
     alpha = formulas.symbol("alpha");
  ex deflection = 2 * L * cos(alpha) - 2 * L * cos(alpha + q);
  ex strain_energy = k * pow(-2 * (alpha + q) + 2 * alpha, 2) / 2;
  ex potential = strain_energy - F * deflection;
  /// The force at which V' = 0; V' is linear in F.
  ex force =
      strain_energy.diff(GiNaC::ex_to<GiNaC::symbol>(q)) / deflection.diff(GiNaC::ex_to<GiNaC::symbol>(q));
  [[nodiscard]] ex derivative(const ex& e, unsigned order = 1) const {
    return e.diff(GiNaC::ex_to<GiNaC::symbol>(q), order);
  }
};

/// Sign of dF/dq = 2k [sin(a+q) - q cos(a+q)] / (L sin(a+q)^2), up to the positive factor.
Interval force_slope(const Interval& q, const Interval& alpha) {
  return sin(alpha + q) - q * cos(alpha + q);
}

/// The joint angles for which 0 < alpha + q < pi, but for a thousandth of it at either end.
std::pair<Interval, Interval> open_range(const Interval& alpha) {
  const Interval end = Interval::pi() * Interval(Rational(1, 1000));
  return {end - alpha, Interval::pi() - end - alpha};
}

std::string direction(std::optional<int> sign) {
  return !sign ? "not monotonic" : *sign > 0 ? "increasing" : "decreasing";
}

Judgement straight_curve(const Printed& printed, int) {
  const TwoLink m;
  // near q = 0 the slope is q^3/3 - ...: its series decides there, intervals decide beyond
  const ex slope = sin(m.q) - m.q * cos(m.q);
  const int order = proofs::leading_order(slope, m.q, 8);
  const ex leading = proofs::series_coefficient(slope, m.q, order);
  const Interval eighth(Rational(1, 8));
  const Interval end(Rational(25, 8));
  const auto away = certain_sign([](const Interval& q) { return force_slope(q, Interval(0)); }, eighth, end);
  const auto deflects = certain_sign([](const Interval& q) { return sin(q); }, eighth, end);
  const bool same = leading.info(GiNaC::info_flags::positive) && away == 1 && deflects == 1;
  return judge_word(
      printed.at(0), same ? "increasing" : direction(away), "F grows with Delta for 0 < q < pi",
      {Evidence::by_theorem("Two links",
                            "N(q) = sin q - q cos q has N(0) = 0 and N' = q sin q > 0 on (0, pi); "
                            "dF/dq = 2k N / (L sin^2 q), dDelta/dq = 2L sin q > 0"),
       {EvidenceKind::interval, fmt::format("N > 0 on [1/8, 25/8] by subdivision; N = {} q^{} + ... at 0",
                                            proofs::text(leading), order)}});
}

Judgement curved_monotonic(const Printed& printed, const Premises& given, int) {
  const Interval alpha = given.value("fig-3-angle");
  const auto [from, to] = open_range(alpha);
  const auto sign = certain_sign([&](const Interval& q) { return force_slope(q, alpha); }, from, to);
  const auto deflects = certain_sign([&](const Interval& q) { return sin(alpha + q); }, from, to);
  const std::string found = sign == 1 && deflects == 1 ? "monotonic" : "not monotonic";
  return judge_word(
      printed.at(0), found, "dF/dq has the sign of sin(alpha+q) - q cos(alpha+q), which is positive",
      {Evidence::by_theorem(
           "Two links",
           "N(q) = sin(alpha+q) - q cos(alpha+q) has N' = q sin(alpha+q), so its least "
           "value on 0 < alpha + q < pi is N(0) = sin alpha > 0; dDelta/dq = 2L sin(alpha+q) > 0"),
       {EvidenceKind::interval,
        fmt::format("alpha = {}: N and sin(alpha+q) for q in [{}, {}] by subdivision: {}",
                    given.at("fig-3-angle").parts.at("value").front(), from.text(4), to.text(4), found)}});
}

/// The minima of V over -pi < alpha + q < pi at a force F, k = L = 1.
std::size_t number_of_minima(const Interval& alpha, const Interval& F) {
  const auto slope = [&](const Interval& q) { return Interval(2) * q - F * sin(alpha + q); };
  const auto curvature = [&](const Interval& q) { return Interval(2) - F * cos(alpha + q); };
  std::size_t count = 0;
  for (const Interval& q : isolate_zeros(slope, curvature, -Interval::pi() - alpha, Interval::pi() - alpha)) {
    count += certainly_positive(curvature(q)) ? 1 : 0;
  }
  return count;
}

Judgement single_minimum(const Printed& printed, const Premises& given, int digits) {
  const Interval alpha = given.value("fig-3-angle");
  // mirrored shape alpha + q = -u: F = 2 (alpha + u) / sin u, least where tan u = alpha + u
  const auto fold = [&](const Interval& u) { return sin(u) - (alpha + u) * cos(u); };
  const auto fold_slope = [&](const Interval& u) { return (alpha + u) * sin(u); };
  Interval u = isolate_zeros(fold, fold_slope, Interval(Rational(1, 10)), Interval(Rational(3, 2))).at(0);
  for (int i = 0; i < 12; ++i) {  // interval Newton
    const Interval m(u.middle(), u.middle());
    u = intersection(u, m - fold(m) / fold_slope(u)).value();
  }
  const Interval threshold = Interval(2) / cos(u);
  const Rational less(99, 100), more(101, 100);
  const std::size_t below = number_of_minima(alpha, threshold * Interval(less));
  const std::size_t above = number_of_minima(alpha, threshold * Interval(more));
  const std::string limit = certified_decimal(threshold, 6);
  Judgement result;
  const std::string found = std::to_string(below),
                    always = below == above ? found : found + " up to the fold";
  result.verdict = printed.at(0) == always  ? Verdict::confirmed
                   : printed.at(0) == found ? Verdict::convention
                                            : Verdict::refuted;
  if (result.verdict != Verdict::confirmed)
    result.truth = fmt::format(
        "one minimum as long as F < 2k/(L cos u), tan u = alpha + u, which is {} k/L; above it the mirrored "
        "shape "
        "is a second minimum",
        limit);
  result.evidence = {
      {EvidenceKind::interval,
       fmt::format(
           "zeros of V' for -pi < alpha + q < pi isolated at {} and {} of that force: {} and {} minima",
           proofs::to_exact(less), proofs::to_exact(more), below, above)}};
  result.value = certified_decimal(threshold, digits) + " k/L";
  return result;
}

/// "minimum" or "maximum" of V, and whether a small displacement from it is driven back, for k = L = 1, alpha
/// = 0.
std::pair<std::string, std::string> character(const Rational& F) {
  const Rational curvature = 4 - 2 * F;  // V''(0)
  const Rational q(1, 1000);
  // -V'(q) = -4q + 2F sin q with q - q^3/6 < sin q < q: the bounds have one sign
  const Rational upper = -4 * q + 2 * F * q;
  const Rational lower = -4 * q + 2 * F * (q - q * q * q / 6);
  if ((upper > 0) != (lower > 0))
    throw Error("two links", "an undecided torque", "a force away from the critical one");
  return {curvature > 0 ? "minimum" : "maximum", upper < 0 ? "stable" : "unstable"};
}

Judgement energy_extrema(const Printed& printed, int) {
  const auto below = character(1);
  const auto above = character(3);
  const std::string computed = below.first == printed.at(0) ? below.second : above.second;
  return judge_word(
      printed.at(1), computed,
      fmt::format("a {} of the potential energy is {}, a {} is {}: the words are interchanged", below.first,
                  below.second, above.first, above.second),
      {Evidence::by_theorem(
           "Stability",
           "a strict minimum of the potential energy is stable, what has a negative direction is "
           "not"),
       {EvidenceKind::exact, fmt::format("k = L = 1, q = 0: F = 1 is a {} and drives q = 1/1000 back ({}); "
                                         "F = 3 is a {} and drives it away ({})",
                                         below.first, below.second, above.first, above.second)}});
}

Judgement stable_up_to(const Printed& printed, int) {
  const TwoLink m;
  const ex straight = m.potential.subs(m.alpha == 0).subs(m.F == m.formulas.parse(printed.at(0)));
  const ex quadratic = proofs::series_coefficient(straight, m.q, 2);
  const ex quartic = proofs::series_coefficient(straight, m.q, 4);
  const ex boundary = proofs::series_coefficient(m.potential.subs(m.alpha == 0), m.q, 2);
  const bool right = quadratic.is_zero() && (quartic / m.k).info(GiNaC::info_flags::positive);
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "V''(0)/2 = " + proofs::text(boundary) + " vanishes at F = 2k/L",
          {Evidence::by_theorem(
               "Two links",
               "for F <= 2k/L V = 2kq^2 - 2FL(1 - cos q) >= (2k - FL) q^2 >= 0 since 1 - cos q <= "
               "q^2/2, with equality at q = 0 only; for F > 2k/L: V''(0) < 0"),
           {EvidenceKind::symbolic, "at the printed force V = (" + proofs::text(quadratic) + ") q^2 + (" +
                                        proofs::text(quartic) + ") q^4 + ..., in general V = (" +
                                        proofs::text(boundary) + ") q^2 + ..."}},
          ""};
}

/// Whether the deflection jumps when F passes F_c, for alpha = 0: its limit from above, and its slope.
Judgement onset(const Printed& printed, int) {
  const TwoLink m;
  const ex deflection = m.deflection.subs(m.alpha == 0);
  const ex excess = m.force.subs(m.alpha == 0) - 2 * m.k / m.L;
  const ex limit = proofs::limit_at_zero(deflection, m.q);
  const ex slope = proofs::limit_at_zero(deflection / excess, m.q);
  const bool continuous = limit.is_zero();
  const Verdict verdict = printed.at(0) == (continuous ? "continuous" : "jump") ? Verdict::confirmed
                          : printed.at(0) == "sudden"                           ? Verdict::imprecise
                                                                                : Verdict::refuted;
  return {
      verdict,
      verdict == Verdict::confirmed
          ? ""
          : "the shape changes continuously: of the two links of Fig. 1 with alpha = 0 the deflection grows "
            "from zero as Delta = (" +
                proofs::text(slope) +
                ") (F - F_c) just above F_c. The stiffness changes suddenly, from infinite to the reciprocal "
                "of "
                "that slope",
      {{EvidenceKind::symbolic, "two links, alpha = 0: limits for q -> 0 of Delta, " + proofs::text(limit) +
                                    ", and of Delta / (F - F_c), " + proofs::text(slope)}},
      ""};
}

/// A formula for the pseudoinverse of J^T, by the Penrose conditions.
Judgement pseudoinverse(const Printed& printed, int) {
  Matrix<Rational> J(2, 3);
  J << 1, 2, 3, -1, 4, 2;
  const Matrix<Rational> G = J.transpose();
  const std::optional<Matrix<Rational>> P = evaluated(printed.at(0), {{"J", J}});
  bool penrose = P && P->rows() == G.cols() && P->cols() == G.rows();
  if (penrose) {
    const Matrix<Rational> GP = G * *P, PG = *P * G;
    penrose = GP * G == G && PG * *P == *P && GP == Matrix<Rational>(GP.transpose()) &&
              PG == Matrix<Rational>(PG.transpose());
  }
  const Matrix<Rational> square = G * J;
  return {penrose ? Verdict::confirmed : Verdict::refuted,
          penrose
              ? ""
              : "J^T J is 3 x 3 and has the rank of J, 2 at most: it has no inverse; J J^T has one where the "
                "shape is not straight",
          {{EvidenceKind::exact,
            fmt::format("J = (1 2 3; -1 4 2): J^T J is {} x {} of rank {}; {}", square.rows(), square.cols(),
                        Eigen::FullPivLU<Matrix<Rational>>(square).rank(),
                        !P        ? "the printed formula has no value"
                        : penrose ? "the four Penrose conditions hold"
                                  : "the Penrose conditions do not hold")}},
          ""};
}

}  // namespace

Checks claims::two_link() {
  return {
      {"straight-curve", straight_curve},        {"energy-extrema", energy_extrema},
      {"straight-stable", stable_up_to},         {"curved-monotonic", curved_monotonic},
      {"curved-single-minimum", single_minimum}, {"sudden-change", onset},
      {"pseudoinverse", pseudoinverse},
  };
}

}  // namespace plumbline::verify
