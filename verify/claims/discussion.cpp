/// \file
/// Section 5: what the discussion says about prismatic joints, disturbances, gravity and parameters.

#include <fmt/core.h>

#include <Eigen/LU>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/expression.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/sampled/sampled.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

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
  const bool changed = compliant_vanishes && !rigid_vanishes;
  // the rigid chain's force for ever stiffer links: the condition on it, as a fraction of kappa^2
  const ex compliance = GiNaC::realsymbol("c");
  const bool small =
      proofs::limit_at_zero(prismatic_determinant(2, 1 / compliance) * pow(compliance, 2), compliance)
          .is_zero();
  const std::string word = changed ? "changed" : "unchanged";
  return {
      printed.at(0) == word                   ? Verdict::confirmed
      : printed.at(0) == "unchanged" && small ? Verdict::imprecise
                                              : Verdict::refuted,
      printed.at(0) == word
          ? ""
          : "to leading order in the deflections only: F solves F = F_c(L_j - F/kappa_j), a relative change "
            "of first order in F/(kappa L); two equal links on a passive base buckle where F (L - F/kappa) = "
            "2k",
      {Evidence::by_theorem("Prismatic joints",
                            "at the straight shape axial and angular variations do not couple, and the links "
                            "are shorter by F/kappa_j"),
       {EvidenceKind::symbolic,
        fmt::format("two links, k = L = 1, kappa = 9: the second variation of the full potential is singular "
                    "at F = 3: {}, at the rigid chain's F = 2: {}; there its determinant over kappa^2 "
                    "vanishes for kappa -> infinity: {}",
                    compliant_vanishes, rigid_vanishes, small)}},
      ""};
}

/// Which way the lowest critical force goes where a link yields, by trying: each link of random chains,
/// shortened by a hundredth. A chain with a shortened link is that of a yielding one at its critical force F,
/// of the axial stiffness F over the shortening.
Judgement prismatic_direction(const Printed& printed, int) {
  constexpr std::uint64_t seed = 1, chains = 40;
  constexpr int digits = 12;
  std::size_t cases = 0, higher = 0, lower = 0;
  std::string example;
  for (std::uint64_t index = 0; index < chains; ++index) {
    const auto rigid = convert<Rational>(random_chain(seed, index), [](double x) { return Rational(x); });
    const proofs::ForceEnclosure before = proofs::enclose_critical_forces(rigid, 1, digits).front();
    for (std::size_t link = 0; link < rigid.size(); ++link) {
      std::vector<Rational> length = rigid.length();
      length[link] *= Rational(99, 100);
      const Chain<Rational> shortened(length, rigid.stiffness());
      ++cases;
      higher += count_below(shortened, before.high) == 0 ? 1 : 0;
      if (count_below(shortened, before.low) == 0) continue;
      if (lower++ == 0) example = fmt::format("link {} of chain {}", link + 1, index);
    }
  }
  const std::string found = higher > 0 && lower > 0 ? "higher or lower" : higher > 0 ? "higher" : "lower";
  Judgement result = judge_word(
      printed.at(0), found, "it is " + found,
      {{EvidenceKind::exact,
        fmt::format("random chains 0 to {} of seed {}, each link in turn shorter by a hundredth, as one that "
                    "yields is "
                    "at its critical force: the lowest force is higher in {} cases, lower in {}, first {}",
                    chains - 1, seed, higher, lower, example)}});
  result.statement = fmt::format(
      "the critical force can be {}: where one link of a random chain yields by a hundredth, {} chains and "
      "each link in turn, it is higher in {} of {} cases and lower in {}",
      found, chains, higher, cases, lower);
  return result;
}

/// The shortening of two straight links under F, from the potential kappa (u_1^2 + u_2^2) / 2 - F (u_1 +
/// u_2).
Judgement prismatic_deflection(const Printed& printed, int) {
  const GiNaC::symbol u1("u1"), u2("u2");
  const GiNaC::possymbol F("F"), kappa("kappa");
  const ex x = (1 - u1) + (1 - u2), potential = kappa * (pow(u1, 2) + pow(u2, 2)) / 2 + F * x;
  const ex found =
      GiNaC::lsolve(GiNaC::lst{potential.diff(u1) == 0, potential.diff(u2) == 0}, GiNaC::lst{u1, u2});
  const ex shortening = (2 - x).subs(found).normal();
  const std::string word = shortening.info(GiNaC::info_flags::positive)   ? "higher"
                           : shortening.is_zero()                         ? "equal"
                           : shortening.info(GiNaC::info_flags::negative) ? "lower"
                                                                          : "open";
  return judge_word(printed.at(0), word, "the straight chain shortens by " + proofs::text(shortening),
                    {{EvidenceKind::symbolic,
                      "two straight links: the potential is stationary where they have shortened by " +
                          proofs::text(shortening) + "; the rigid chain's deflection is 0"}});
}

/// The unstable equilibria of a chain whose shapes at an end point form closed curves.
Judgement disturbance(const Printed& printed, const Premises& given, int) {
  const Rational d(1, 10);
  const HeldChain chain = held(given, "fig-7-chain");
  const proofs::Census& census = chain.at(d);
  std::size_t unstable = 0, maxima = 0;
  for (const auto& one : census.equilibria) {
    if (one.negative_directions.value() == 0) continue;
    ++unstable;
    maxima += one.negative_directions.value() == chain.chain.size() - 2 ? 1 : 0;
  }
  const bool leaves = unstable > 0 && maxima == unstable && unstable < census.equilibria.size();
  return judge_word(
      printed.at(0), leaves ? "stable" : "unstable", "a disturbance can lead back",
      {Evidence::by_theorem("Stability", "an equilibrium with a negative direction is unstable"),
       {EvidenceKind::interval,
        fmt::format(
            "chain of Fig. 7 at {}, certified census: each of the {} unstable equilibria is a strict "
            "maximum of E in its only free direction, so that losing energy the chain ends in one of the "
            "{} minima, whichever the disturbance. With more links an unstable equilibrium can be a "
            "saddle, which the disturbances of a set of measure zero lead back to",
            in_lengths(d), unstable, census.equilibria.size() - unstable)}});
}

/// What another scale of the force, or of all stiffnesses, does to the curve of two links.
Judgement other_force(const Printed& printed, int) {
  const proofs::Formulas f({"k", "L", "q", "alpha", "s"});
  const ex force = f.parse("2*k*q/(L*sin(alpha+q))"),
           scaled = force.subs(f.symbol("k") == f.symbol("s") * f.symbol("k"));
  const bool shift = proofs::identical((scaled - force).diff(GiNaC::ex_to<GiNaC::symbol>(f.symbol("q"))), 0);
  const bool stretch = proofs::identical(scaled, f.symbol("s") * force);
  const std::string word = shift ? "shift" : stretch ? "stretch" : "another";
  return {printed.at(0) == word                 ? Verdict::confirmed
          : stretch && printed.at(0) == "shift" ? Verdict::convention
                                                : Verdict::refuted,
          printed.at(0) == word
              ? ""
              : "the forces at every deflection change in proportion: the curve is stretched",
          {Evidence::by_theorem("Scaling", "all stiffnesses times s: all forces times s"),
           {EvidenceKind::symbolic, "(1) with s k for k: F times s; the difference depends on q"}},
          ""};
}

/// Whether other stiffnesses change the ratio of the forces at two deflections.
Judgement other_stiffness(const Printed& printed, const Premises& given, int) {
  const Rational early(1, 10), late(6, 10);
  const auto ratio = [&](int third) {
    const Chain<Interval> nominal = given.chain("fig-7-chain");
    std::vector<Interval> stiffness = nominal.stiffness();
    stiffness.back() *= Interval(third);
    const HeldChain chain = held(Chain<Interval>(nominal.length(), stiffness, nominal.rest()));
    const auto force = [&](const Rational& d) { return chain.at(d).equilibria.front().fx; };
    return force(early) / force(late);
  };
  const Interval nominal = ratio(1), other = ratio(2);
  const bool changes = certainly_less(nominal, other) || certainly_less(other, nominal);
  return judge_word(
      printed.at(0), changes ? "changes" : "keeps", "the forces keep their ratio",
      {{EvidenceKind::interval, fmt::format("chain of Fig. 7, certified censuses, least energy: force at {} "
                                            "over that at {}: {}, with the last "
                                            "stiffness doubled: {}",
                                            in_lengths(early), in_lengths(late),
                                            certified_decimal(nominal, 5), certified_decimal(other, 5))}});
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
  const std::string word = light == heavy ? "unchanged" : "changed";
  // along the axis the straight chain does not yield at all: dx/dq = 0 there
  const proofs::Formulas f({"a", "b"});
  const ex x = f.parse("cos(a)+cos(a+b)");
  bool rigid = true;
  for (const char* angle : {"a", "b"})
    rigid = rigid && x.diff(GiNaC::ex_to<GiNaC::symbol>(f.symbol(angle)))
                         .subs(GiNaC::lst{f.symbol("a") == 0, f.symbol("b") == 0})
                         .is_zero();
  return {
      printed.at(0) == word                   ? Verdict::confirmed
      : printed.at(0) == "unchanged" && rigid ? Verdict::imprecise
                                              : Verdict::refuted,
      printed.at(0) == word ? ""
                            : "so for the stiffness along the axis, which is infinite in the straight shape; "
                              "the stiffness against lateral motion changes, as the critical force does",
      {Evidence::by_theorem("Axial gravity", "the lateral stiffness of the end point becomes strictly less"),
       {EvidenceKind::exact,
        fmt::format("two clamped links, k = L = 1: lateral stiffness dF_y/dy of the straight chain {} "
                    "without, {} with link weights of 1/10",
                    light.str(), heavy.str())}},
      ""};
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
  return judge_word(
      printed.at(0), light == heavy ? "unchanged" : "changed",
      "weights along the axis change the critical force",
      {Evidence::by_theorem(
           "Axial gravity",
           "the critical forces are strictly lower when it compresses, strictly higher when it stretches"),
       {EvidenceKind::exact,
        fmt::format("two clamped links, k = L = 1: critical force {} without, {} with link "
                    "weights of 1/10 towards the base",
                    light.str(), heavy.str())}});
}

/// Torques of unit weights at the middles of two links by the joint angles, gravity of any direction.
Judgement gravity_orthogonal(const Printed& printed, int) {
  const proofs::Formulas f({"q1", "q2", "gx", "gy", "gz", "z"});
  // the middles; the plane of motion is z = const
  const ex potential =
      f.parse("-gx*(cos(q1)/2+cos(q1)+cos(q1+q2)/2)-gy*(sin(q1)/2+sin(q1)+sin(q1+q2)/2)-gz*2*z");
  const bool normal = printed.at(0) == "orthogonal";
  const GiNaC::lst direction =
      normal ? GiNaC::lst{f.symbol("gx") == 0, f.symbol("gy") == 0} : GiNaC::lst{f.symbol("gz") == 0};
  bool none = true;
  for (const char* angle : {"q1", "q2"})
    none = none &&
           proofs::identical(potential.diff(GiNaC::ex_to<GiNaC::symbol>(f.symbol(angle))).subs(direction), 0);
  return {
      none ? Verdict::confirmed : Verdict::refuted,
      none ? "" : "gravity in the plane of motion loads the joints",
      {{EvidenceKind::symbolic,
        "two links, weights at their middles: the torques of gravity contain its components in the plane of "
        "motion alone, in every shape"}},
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
  // the middle joint moves aside by L sin q
  const ex deflection = proofs::series_coefficient(f.symbol("L") * sin(q), q, 1) * bend;
  const std::string truth = "it depends on the weights: the lateral deflection " +
                            proofs::text(deflection.normal()) +
                            " of the middle joint of a two-link chain grows without bound towards F_c = "
                            "2k/L, and no bifurcation is "
                            "left for any w other than zero; small means w L << 2k - F L";
  if (printed.at(0) != "small" && printed.at(0) != "none")
    throw Error("claim", printed.at(0), "small or none");
  const Verdict verdict = bend.is_zero()                          ? Verdict::confirmed
                          : printed.at(0) == "small" && unbounded ? Verdict::imprecise
                                                                  : Verdict::refuted;
  return {verdict,
          verdict == Verdict::confirmed ? "" : truth,
          {{EvidenceKind::symbolic,
            "the angle q = " + proofs::text(bend) + " from V' = 0 to first order, the deflection L q"}},
          ""};
}

}  // namespace

Checks claims::discussion() {
  return {
      {"prismatic-joints", prismatic},
      {"prismatic-deflection", prismatic_deflection},
      {"prismatic-direction", prismatic_direction},
      {"disturbance", disturbance},
      {"force-shift", other_force},
      {"stiffness-shape", other_stiffness},
      {"gravity-orthogonal", gravity_orthogonal},
      {"gravity-axial-stiffness", gravity_stiffness},
      {"gravity-axial-critical", gravity_critical},
      {"gravity-small", gravity_small},
  };
}

}  // namespace plumbline::verify
