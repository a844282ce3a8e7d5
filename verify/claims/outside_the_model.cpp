/// \file
/// Section 5: what the paper leaves out and says a word on: coupled compliances, a torque at the end, a new
/// start after an unstable solution, tolerances.

#include <fmt/core.h>

#include <Eigen/LU>
#include <plumbline/loaded/equilibrium.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/expression.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

/// A clamped link under an axial force F whose yielding u and turning q are coupled, energy
/// kappa u^2/2 + c u q + k q^2/2: how far it turns, to first order in F.
ex turn_of_coupled_link(const ex& F, const ex& c) {
  const GiNaC::symbol u("u"), q("q");
  const GiNaC::possymbol kappa("kappa"), k("k"), L("L");
  const ex V = kappa * u * u / 2 + c * u * q + k * q * q / 2 + F * (L - u) * cos(q);
  const ex Vu = V.diff(u).subs(GiNaC::lst{u == 0, q == 0}), Vq = V.diff(q).subs(GiNaC::lst{u == 0, q == 0});
  const ex Vuu = kappa, Vuq = c, Vqq = k;  // the load's part is of second order in F and q
  return ((Vuq * Vu - Vuu * Vq) / (Vuu * Vqq - Vuq * Vuq)).normal();
}

Judgement coupled(const Printed& printed, int) {
  const ex F = GiNaC::possymbol("F"), c = GiNaC::realsymbol("c");
  const ex turn = turn_of_coupled_link(F, c);
  const bool straight_without = turn_of_coupled_link(F, 0).is_zero(), bends = !turn.is_zero();
  const std::string found = !bends ? "always" : straight_without ? "without coupling" : "never";
  Judgement result = judge_word(
      printed.at(0), found,
      "true where axial and bending compliance are not coupled: a link in which they are coupled turns by " +
          proofs::text(turn) + " under any axial force F, to first order",
      {{EvidenceKind::symbolic,
        "one link, energy kappa u^2/2 + c u q + k q^2/2 less the work of an axial force F: "
        "it turns by " +
            proofs::text(turn) + " to first order, and by 0 for c = 0"}});
  if (result.verdict == Verdict::refuted && printed.at(0) == "always" && straight_without)
    result.verdict = Verdict::imprecise;
  return result;
}

/// A torque at the end of a straight chain turns every elastic joint from the start.
Judgement end_torque(const Printed& printed, int) {
  const proofs::Formulas f({"k1", "k2", "q1", "q2", "m"});
  const ex work = f.parse("m*(q1+q2)"), energy = f.parse("k1*q1^2/2+k2*q2^2/2");
  bool straight = true;
  for (const char* const angle : {"q1", "q2"}) {
    const auto q = GiNaC::ex_to<GiNaC::symbol>(f.symbol(angle));
    straight = straight &&
               (energy - work).diff(q).subs(GiNaC::lst{f.symbol("q1") == 0, f.symbol("q2") == 0}).is_zero();
  }
  return judge_word(
      printed.at(0), straight ? "none" : "difficulties",
      "under a torque at its end the straight chain is no equilibrium",
      {{EvidenceKind::symbolic,
        "two links: the gradient of E - m (q_1 + q_2) at q = 0 is -m in each joint: the chain bends "
        "from the start"}});
}

using Unknowns = Eigen::Matrix<double, 5, 1>;  ///< three joint angles, F_x, F_y

/// (6) and the end point on the x axis, for three links, with the derivatives.
std::pair<Unknowns, Eigen::Matrix<double, 5, 5>> equations(const HeldChain& held, double x,
                                                           const Unknowns& at) {
  const auto number = [](const Interval& i) { return static_cast<double>(i.middle()); };
  Unknowns f = Unknowns::Zero();
  Eigen::Matrix<double, 5, 5> D = Eigen::Matrix<double, 5, 5>::Zero();
  double theta[3], sum = 0;
  for (int i = 0; i < 3; ++i) theta[i] = sum += at(i);
  f(3) = -x;
  for (std::size_t j = 3; j-- > 0;) {
    const double L = number(held.chain.length()[j]), s = L * std::sin(theta[j]), c = L * std::cos(theta[j]);
    f(3) += c, f(4) += s;
    for (Eigen::Index i = 0; i <= static_cast<Eigen::Index>(j); ++i) {
      f(i) += -s * at(3) + c * at(4);
      D(i, 3) -= s, D(i, 4) += c;
      D(3, i) -= s, D(4, i) += c;
      for (Eigen::Index m = 0; m <= static_cast<Eigen::Index>(j); ++m) D(i, m) += -c * at(3) - s * at(4);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double k = number(held.chain.stiffness()[i]);
    f(static_cast<Eigen::Index>(i)) += k * (at(static_cast<Eigen::Index>(i)) - number(held.chain.rest()[i]));
    D(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += k;
  }
  return {f, D};
}

/// Starts disturbed by 0.01 rad around each unstable equilibrium, solved again by Newton's method: how many
/// come back to it.
Judgement restart(const Printed& printed, const Premises& given, int) {
  const HeldChain chain = held(given, "fig-7-chain");
  const Rational d(1, 10);
  const double x = static_cast<double>(chain.reach.middle()) - from_rational<double>(d);
  constexpr int starts = 100;
  constexpr double off = 0.01;
  std::size_t back = 0, all = 0;
  for (const auto& one : chain.at(d).equilibria) {
    if (one.negative_directions == std::size_t{0}) continue;
    Unknowns at_rest;
    for (Eigen::Index i = 0; i < 3; ++i)
      at_rest(i) = static_cast<double>(one.q[static_cast<std::size_t>(i)].middle());
    const PaperForce<Interval> force = paper_force(one);
    at_rest(3) = static_cast<double>(force.x.middle()), at_rest(4) = static_cast<double>(force.y.middle());
    for (int start = 0; start < starts; ++start) {
      Unknowns at = at_rest;
      const double turn =
          2 * 3.14159265358979 * start / starts;  // in all directions of two angles, and the third
      at(0) += off * std::cos(turn), at(1) += off * std::sin(turn), at(2) += off * std::cos(3 * turn);
      for (int step = 0; step < 30; ++step) {
        const auto [f, D] = equations(chain, x, at);
        at -= D.partialPivLu().solve(f);
      }
      ++all;
      back += (at - at_rest).norm() < 1e-9 ? 1 : 0;
    }
  }
  const std::string found = all > 0 && 2 * back > all ? "by minimising" : "by any routine";
  Judgement result = judge_word(
      printed.at(0), found,
      fmt::format(
          "true where the energy is minimised: of {} starts of Newton's iteration on (5), (6), each {} rad "
          "from an unstable state of the chain of Fig. 7 at {} L, {} lead back to it",
          all, off, proofs::to_exact(d), back),
      {Evidence::by_theorem("Stability",
                            "where a direction is negative the energy falls away from the state"),
       {EvidenceKind::real64,
        fmt::format(
            "chain of Fig. 7 at {} L, its unstable equilibria disturbed by {} rad in {} directions each, "
            "Newton's method on (5), (6): {} of {} starts lead back",
            proofs::to_exact(d), off, starts, back, all)}});
  if (result.verdict == Verdict::refuted && found == "by minimising") result.verdict = Verdict::imprecise;
  return result;
}

/// How far one percent of every stiffness moves the critical force.
Judgement tolerance(const Printed& printed, const Premises& given, int) {
  const Chain<Rational> nominal = given.exact_chain("unit-chain");
  std::vector<Rational> stiffness = nominal.stiffness();
  for (Rational& k : stiffness) k *= Rational(101, 100);
  const auto lowest = [](const Chain<Rational>& chain) {
    return proofs::enclose_critical_forces(chain, 1, 20).front();
  };
  const auto before = lowest(nominal), after = lowest(Chain<Rational>(nominal.length(), stiffness));
  return judge_word(printed.at(0), after.low > before.high ? "some" : "none", "it is exact",
                    {Evidence::by_checked_theorem("Scaling", {"scaling.stiffness_scaled"},
                                                  "all stiffnesses times c: the forces times c"),
                     {EvidenceKind::interval,
                      "the chain of the example with all stiffnesses one percent higher: "
                      "its lowest force is certainly higher"}});
}

}  // namespace

Checks claims::outside_the_model() {
  return {
      {"coupled-links", coupled},
      {"end-torque", end_torque},
      {"restart", restart},
      {"tolerance", tolerance},
  };
}

}  // namespace plumbline::verify
