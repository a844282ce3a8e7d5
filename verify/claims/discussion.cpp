/// \file
/// Section 5: what the discussion says about straight chains in space, prismatic joints and gravity.

#include <fmt/core.h>

#include <Eigen/LU>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/decimal.hpp"
#include "proofs/exact_chain.hpp"
#include "proofs/exact_matrix.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

/// A straight spatial chain: joint i turns about the second axis (plane 1) or the third (plane 2).
struct SpatialChain {
  std::vector<Rational> length{2, 3, 1, 4, 2, 1}, stiffness{1, 2, 3, 1, 2, 4};
  std::vector<int> plane{1, 2, 1, 2, 2, 1};
};

/// det of the bordered form K + F S, S the second-order shortening of both planes together, two end-point
/// constraints.
Rational spatial_determinant(const SpatialChain& chain, const Rational& F) {
  const auto n = static_cast<Eigen::Index>(chain.length.size());
  const Vector<Rational> z = matrix_S0(Chain<Rational>(chain.length, chain.stiffness));
  Matrix<Rational> M = Matrix<Rational>::Zero(n + 2, n + 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int plane = chain.plane[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) {
      if (chain.plane[static_cast<std::size_t>(j)] == plane) M(i, j) = -F * z(std::max(i, j));
    }
    M(i, i) += chain.stiffness[static_cast<std::size_t>(i)];
    M(i, n + plane - 1) = M(n + plane - 1, i) = z(i);
  }
  return proofs::determinant(M);
}

/// The joints of one plane, the links between them merged.
Chain<Rational> planar_part(const SpatialChain& chain, int plane) {
  std::vector<Rational> length;
  std::vector<Rational> stiffness;
  for (std::size_t i = 0; i < chain.length.size(); ++i) {
    if (chain.plane[i] == plane) {
      length.emplace_back(0);
      stiffness.push_back(chain.stiffness[i]);
    }
    if (!length.empty()) length.back() += chain.length[i];
  }
  return Chain<Rational>(length, stiffness);
}

Judgement spatial(const Printed& printed, int) {
  const SpatialChain chain;
  const proofs::Polynomial first = proofs::bordered_determinant(planar_part(chain, 1));
  const proofs::Polynomial second = proofs::bordered_determinant(planar_part(chain, 2));
  bool factors = true;
  // both sides have degree 4 in F: five points would do
  for (int point = 1; point <= 7; ++point) {
    const Rational F(point, 2);
    factors =
        factors && spatial_determinant(chain, F) == proofs::evaluate(first, F) * proofs::evaluate(second, F);
  }
  return judge_word(
      printed.at(0), factors ? "minimum" : "another", {"minimum", "maximum", "sum", "another"},
      "the critical forces of the spatial chain are those of its planar parts together; the lowest counts",
      {{EvidenceKind::theorem, "Decomposition: to second order the two planes do not couple"},
       {EvidenceKind::exact,
        fmt::format("six links, joint axes in two orthogonal planes: the bordered determinant "
                    "is the product of the planar ones at seven forces: {}",
                    factors)}});
}

/// The unit chain of two links on a passive base whose links yield axially with stiffness kappa: determinant
/// of the second variation at the straight equilibrium under F, in (theta_1, theta_2, u_1, u_2), bordered by
/// the end-point constraint.
ex prismatic_determinant(const ex& F, const ex& kappa) {
  const GiNaC::symbol t1("t1"), t2("t2"), u1("u1"), u2("u2"), lateral("Fy");
  const ex x = (1 - u1) * cos(t1) + (1 - u2) * cos(t2);
  const ex y = (1 - u1) * sin(t1) + (1 - u2) * sin(t2);
  const ex W = pow(t2 - t1, 2) / 2 + kappa * (pow(u1, 2) + pow(u2, 2)) / 2 + F * x + lateral * y;
  const std::vector<GiNaC::symbol> unknowns{t1, t2, u1, u2, lateral};
  const GiNaC::lst straight{t1 == 0, t2 == 0, u1 == F / kappa, u2 == F / kappa, lateral == 0};
  GiNaC::matrix H(5, 5);
  for (unsigned i = 0; i < 5; ++i) {
    for (unsigned j = 0; j < 5; ++j) H(i, j) = W.diff(unknowns[i]).diff(unknowns[j]).subs(straight);
  }
  return H.determinant().normal();
}

Judgement prismatic(const Printed& printed, int) {
  const bool rigid_vanishes = prismatic_determinant(2, GiNaC::numeric(9)).is_zero();
  const bool compliant_vanishes = prismatic_determinant(3, GiNaC::numeric(9)).is_zero();
  const std::string word = compliant_vanishes && !rigid_vanishes ? "changed" : "unchanged";
  return judge_word(
      printed.at(0), word, {"changed", "unchanged"},
      "axial compliance changes the critical force by a relative amount of first order in F/(kappa L): it "
      "solves F = F_c(L_j - F/kappa_j); two links on a passive base buckle where F (L - F/kappa) = 2k, above "
      "the rigid chain's 2k/L, and not at all when kappa < 8k/L^2; on an elastic base the force can also "
      "fall",
      {{EvidenceKind::theorem,
        "Prismatic joints: at the straight shape axial and angular variations do not couple, "
        "and the links are shorter by F/kappa_j"},
       {EvidenceKind::symbolic,
        fmt::format(
            "two links, k = L = 1, kappa = 9: the second variation of the full potential is singular at F "
            "= 3: {}, at the rigid chain's F = 2: {}",
            compliant_vanishes, rigid_vanishes)}});
}

Judgement prismatic_deflection(const Printed& printed, int) {
  const Rational kappa = 9;
  const Rational F = 1;  // below both critical forces, the chain is straight
  const Rational compliant = 2 * F / kappa;
  return judge_word(printed.at(0), compliant > 0 ? "higher" : "equal", {"higher", "equal", "lower"},
                    "the links shorten by F/kappa_j each",
                    {{EvidenceKind::exact, "two links, k = L = 1, kappa = 9, F = 1: shortening " +
                                               compliant.str() + " against 0 of the rigid chain"}});
}

/// Two links clamped at the base, k = L = 1, each of weight w (towards the base) at its middle: the Hessian
/// in absolute orientations under the axial force F.
Matrix<Rational> heavy_hessian(const Rational& w, const Rational& F) {
  Matrix<Rational> H(2, 2);
  // drops of the middles: theta_1^2/4; theta_1^2/2 + theta_2^2/4
  H << 2 - F - w * 3 / 2, -1, -1, 1 - F - w / 2;
  return H;
}

Judgement gravity_stiffness(const Printed& printed, int) {
  const auto lateral = [](const Rational& w) {
    const Matrix<Rational> compliance = heavy_hessian(w, 0).inverse();
    return Rational(1 / compliance.sum());
  };
  const Rational light = lateral(0);
  const Rational heavy = lateral(Rational(1, 10));
  return judge_word(printed.at(0), light == heavy ? "unchanged" : "changed", {"changed", "unchanged"},
                    "gravity along the axis changes the stiffness against lateral motion, as it changes the "
                    "critical force; it "
                    "leaves only the straight chain's axial stiffness (infinite) as it is",
                    {{EvidenceKind::theorem, "Axial gravity"},
                     {EvidenceKind::exact,
                      fmt::format("two clamped links, k = L = 1: lateral stiffness dF_y/dy of the straight "
                                  "chain {} without, {} with link weights of 1/10",
                                  light.str(), heavy.str())}});
}

Judgement gravity_critical(const Printed& printed, int) {
  // on the constraint theta_2 = -theta_1 the form is linear in F
  const auto critical = [](const Rational& w) {
    const auto form = [&](const Rational& F) {
      const Matrix<Rational> H = heavy_hessian(w, F);
      return Rational(H(0, 0) - H(0, 1) - H(1, 0) + H(1, 1));
    };
    return Rational(form(0) / (form(0) - form(1)));
  };
  const Rational light = critical(0);
  const Rational heavy = critical(Rational(1, 10));
  if (count_below(Chain<Rational>({1, 1}, {1, 1}), light) != 0)
    throw Error("two links", "another critical force", "5/2");
  return judge_word(printed.at(0), light == heavy ? "unchanged" : "changed", {"changed", "unchanged"},
                    "weights along the axis change the critical force",
                    {{EvidenceKind::theorem,
                      "Axial gravity: strictly lower when it compresses, strictly higher when it stretches"},
                     {EvidenceKind::exact,
                      fmt::format("two clamped links, k = L = 1: critical force {} without, {} with link "
                                  "weights of 1/10 towards the base",
                                  light.str(), heavy.str())}});
}

Judgement gravity_orthogonal(const Printed& printed, int) {
  // in-plane part of a unit gravity: zero when it is normal to the plane of motion (x, y)
  const std::vector<Rational> g = printed.at(0) == "orthogonal" ? std::vector<Rational>{0, 0, -1}
                                  : printed.at(0) == "parallel"
                                      ? std::vector<Rational>{0, -1, 0}
                                      : throw Error("claim", printed.at(0), "orthogonal or parallel");
  // torque of unit weights at the middles of two straight links about joint 1 and 2: g_y times their levers
  const Rational torque_1 = g[1] * (Rational(1, 2) + Rational(3, 2));
  const Rational torque_2 = g[1] * Rational(1, 2);
  const bool none = torque_1 == 0 && torque_2 == 0;
  return {none ? Verdict::confirmed : Verdict::refuted,
          none ? "" : "gravity in the plane of motion loads the joints",
          {{EvidenceKind::exact, fmt::format("joint torques of unit weights on two unit links: {}, {}",
                                             torque_1.str(), torque_2.str())}},
          ""};
}

Judgement gravity_small(const Printed& printed, int) {
  // two links on a passive base, a lateral weight w at the middle joint: V = 2kq^2 - FLq^2 - wLq to second
  // order
  const proofs::Formulas f({"k", "F", "L", "w", "q"});
  const ex V = f.parse("2*k*q^2-F*L*q^2-w*L*q");
  const ex q = f.symbol("q");
  const auto& unknown = GiNaC::ex_to<GiNaC::symbol>(q);
  const ex bend = (-V.diff(unknown).subs(q == 0) / V.diff(unknown, 2)).normal();
  const bool unbounded =
      bend.denom().subs(f.symbol("F") == 2 * f.symbol("k") / f.symbol("L")).normal().is_zero();
  const std::string truth =
      "it depends on the weights: the lateral deflection " + proofs::text(bend) +
      " of a two-link chain grows without bound towards F_c = 2k/L, and no bifurcation is left for any w "
      "other than zero; small means w L << 2k - F L";
  if (printed.at(0) != "small" && printed.at(0) != "none")
    throw Error("claim", printed.at(0), "small or none");
  const Verdict verdict = bend.is_zero()                          ? Verdict::confirmed
                          : printed.at(0) == "small" && unbounded ? Verdict::imprecise
                                                                  : Verdict::refuted;
  return {verdict,
          verdict == Verdict::confirmed ? "" : truth,
          {{EvidenceKind::symbolic, "q = " + proofs::text(bend) + " from V' = 0 to first order"}},
          ""};
}

}  // namespace

std::vector<Claim> claims::discussion() {
  return {
      {"spatial-minimum",
       "5, paragraph 1",
       "a spatial chain of planar sub-chains buckles at the minimum of their forces",
       {"minimum"},
       spatial},
      {"prismatic-joints",
       "5, paragraph 2",
       "prismatic joints do not affect the critical force",
       {"unchanged"},
       prismatic},
      {"prismatic-deflection",
       "5, paragraph 2",
       "with prismatic joints the total deflections are higher",
       {"higher"},
       prismatic_deflection},
      {"gravity-orthogonal",
       "5, paragraph 5",
       "gravity can be ignored when the plane of motion is orthogonal to it",
       {"orthogonal"},
       gravity_orthogonal},
      {"gravity-axial-stiffness",
       "5, paragraph 5",
       "gravity along the axis does not affect the stiffness behaviour",
       {"unchanged"},
       gravity_stiffness},
      {"gravity-axial-critical",
       "5, paragraph 5",
       "gravity along the axis changes the critical force",
       {"changed"},
       gravity_critical},
      {"gravity-small",
       "5, paragraph 5",
       "gravity acts on these structures like a small disturbance",
       {"small"},
       gravity_small},
  };
}

}  // namespace plumbline::verify
