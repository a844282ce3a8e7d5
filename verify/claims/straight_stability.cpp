/// \file
/// Section 4: up to which force the straight chain is stable, and how bent shapes begin.

#include <fmt/core.h>

#include <plumbline/chain/strain_energy.hpp>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "verify/chains/post_buckling.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

/// Negative directions of E - F delta_x on the shapes with delta_y = 0, by exact elimination.
std::size_t negative_directions(const Chain<Rational>& chain, const Rational& F) {
  const Vector<Rational> z = matrix_S0(chain);
  const Eigen::Index free = z.size() - 1;
  Matrix<Rational> form = F * matrix_S1(chain);
  for (Eigen::Index i = 0; i < z.size(); ++i) form(i, i) += chain.stiffness()[static_cast<std::size_t>(i)];
  Matrix<Rational> basis = Matrix<Rational>::Zero(free + 1, free);
  for (Eigen::Index j = 0; j < free; ++j) {
    basis(0, j) = -z(j + 1) / z(0);
    basis(j + 1, j) = 1;
  }
  Matrix<Rational> reduced = basis.transpose() * form * basis;
  std::size_t negative = 0;
  for (Eigen::Index i = 0; i < free; ++i) {
    if (reduced(i, i) == 0) throw Error("elimination", "a zero pivot", "a force that makes none");
    negative += reduced(i, i) < 0 ? 1 : 0;
    for (Eigen::Index j = i + 1; j < free; ++j) {
      const Rational factor = reduced(j, i) / reduced(i, i);
      for (Eigen::Index c = i; c < free; ++c) reduced(j, c) -= factor * reduced(i, c);
    }
  }
  return negative;
}

/// A force below the lowest critical one, one between each two that differ, and one beyond them.
std::vector<Rational> forces_between(const Chain<Rational>& chain) {
  constexpr int digits = 12;
  const auto critical = proofs::enclose_critical_forces(chain, chain.size() - 1, digits);
  std::vector<Rational> list{critical.front().low * Rational(99, 100)};
  for (std::size_t i = 1; i < critical.size(); ++i)
    if (critical[i - 1].high < critical[i].low) list.push_back((critical[i - 1].high + critical[i].low) / 2);
  list.push_back(critical.back().high * Rational(101, 100));
  return list;
}

std::string six_digits(const Rational& F) {
  return proofs::to_decimal(F, 6);
}

Judgement buckles_at(const Printed& printed, const Premises& given, int) {
  const Chain<Rational> chain = given.exact_chain("unit-chain");
  std::string found;
  bool first = true;
  std::size_t expected = 0;
  for (const Rational& F : forces_between(chain)) {
    const std::size_t negative = negative_directions(chain, F);
    if (negative != count_below(chain, F))
      throw Error("count", "different results of recursion and elimination", "agreement");
    first = first && (expected == 0 ? negative == 0 : negative >= expected);
    found += fmt::format("{}F = {}: {}", found.empty() ? "" : ", ", six_digits(F), negative);
    ++expected;
  }
  return judge_word(
      printed.at(0), first ? "lowest" : "another",
      "the straight shape loses its stability at the lowest critical force",
      {Evidence::by_checked_theorem("Stable below the lowest force",
                                    {"stability.stable_exactly_below", "stability.unstable_above"},
                                    "E - F delta_x on delta_y = 0 is a strict minimum to second order "
                                    "exactly below the lowest critical force, "
                                    "and falls along a mode beyond it"),
       {EvidenceKind::exact,
        "negative directions by elimination, under forces between the critical ones: " + found}});
}

/// How the force of mode 1 begins along its bent shapes, for L = (2, 1), k = (1, k2).
Rational initial_curvature(const Rational& k2) {
  const Chain<Rational> chain({2, 1}, {1, k2});
  const std::vector<Rational> q{1, -3};  // delta_y = 3 q_1 + q_2 = 0
  const Rational F = energy_factor(chain, q);
  return post_buckling_curvature(chain, Mode<Rational>{F, q, lateral_force(chain, F, q)});
}

/// printed: what the straight shape is below the critical force, and beyond it
Judgement straight_until(const Printed& printed, const Premises& given, int) {
  const Chain<Rational> chain = given.exact_chain("unit-chain");
  const auto word = [&](const Rational& F) {
    return std::string(negative_directions(chain, F) == 0 ? "stable" : "unstable");
  };
  const std::vector<Rational> forces = forces_between(chain);
  const std::string below = word(forces[0]), above = word(forces[1]);
  const Rational stiff = initial_curvature(1), soft = initial_curvature(Rational(1, 10));
  return judge_list(
      printed, {below, above}, fmt::format("it is {} below and {} beyond", below, above),
      {Evidence::by_checked_theorem(
           "Stable below the lowest force", {"stability.stable_exactly_below", "stability.unstable_above"},
           "the second variation at the straight chain is positive under F exactly for F < F_1, and negative "
           "somewhere for F > F_1"),
       {EvidenceKind::exact,
        fmt::format(
            "elimination at F = {} and {}, on either side of the lowest critical force: {}, {}. Bent shapes "
            "can exist below F_1 as well, on an elastic base: F = F_1 + F_2 a^2 + … for L = (2, 1) has F_2 = "
            "{} with k = (1, 1), {} with k = (1, 1/10)",
            six_digits(forces[0]), six_digits(forces[1]), below, above, stiff.str(), soft.str())}});
}

Judgement negative_stiffness(const Printed& printed, int) {
  const Rational soft = initial_curvature(Rational(1, 10));
  return judge_word(
      printed.at(0), soft < 0 ? "feasible" : "unfeasible", "no such state was found",
      {Evidence::by_theorem("Supercritical",
                            "on an elastic base the force can fall along the bent shapes of mode 1"),
       Evidence::by_theorem("Count of shapes", "with the end point held those of mode 1 are stable"),
       {EvidenceKind::exact,
        "L = (2, 1), k = (1, 1/10): F = F_1 + F_2 a^2 + … with F_2 = " + soft.str() +
            ", so the bent shapes next to the straight one have a negative stiffness, are "
            "unstable under a dead force, and stable with the end point held"}});
}

}  // namespace

Checks claims::straight_stability() {
  return {
      {"buckles-at-lowest", buckles_at},
      {"straight-until-critical", straight_until},
      {"negative-stiffness", negative_stiffness},
  };
}

}  // namespace plumbline::verify
