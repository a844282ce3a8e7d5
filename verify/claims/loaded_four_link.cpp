/// \file
/// Section 3.2: four links under load, (11), (12), Table 1, Figures 11 to 13.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>

#include "proofs/census.hpp"
#include "proofs/decimal.hpp"
#include "proofs/exactly.hpp"
#include "proofs/symbolic_statics.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/loaded_chains.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

/// The paper's chains of Table 1 with the end point at (3.8 - d, 0).
proofs::Census at_deflection(const Chain<Interval>& chain, const Rational& deflection) {
  return held_at(chain, table_1_reach() - Interval(deflection));
}

std::string located(const proofs::Located& number, int digits) {
  return number.str(std::min(digits, proofs::located_digits));
}

Judgement direct_kinematics(const Printed& printed, int) {
  std::vector<std::string> names;
  for (int i = 1; i <= 4; ++i) {
    names.push_back(fmt::format("L{}", i));
    names.push_back(fmt::format("q{}", i));
  }
  const proofs::Formulas formulas(names);
  proofs::SymbolicShape shape;
  for (int i = 1; i <= 4; ++i) {
    shape.length.push_back(formulas.symbol(fmt::format("L{}", i)));
    shape.stiffness.emplace_back(1);
    shape.q.push_back(formulas.symbol(fmt::format("q{}", i)));
  }
  return judge_formulas(formulas, printed, {end_point(shape)(0, 0)}, {"x"},
                        "direct kinematics of four links");
}

/// Joint angles that stay free when the end point is held: n less the rank of the Jacobian.
Judgement freedom(const Printed& printed, int) {
  const auto count = [](std::size_t n) {
    return n - static_cast<std::size_t>(Eigen::FullPivLU<Matrix<Rational>>(bent_jacobian(n)).rank());
  };
  return judge_count(printed.at(0), count, "n - 2 joint angles stay free, none for two links",
                     EvidenceKind::exact, "n less the rank of J in rationals, bent shape");
}

/// Where the end point of a chain of Table 1 may be: each printed angle stands for all that round to it.
Point<Interval> place_in_table(const Chain<Interval>& chain) {
  const Interval half(Rational(1, 20000));
  std::vector<Interval> q = chain.rest();
  for (Interval& angle : q) angle = hull(angle - half, angle + half);
  return end_point(chain, q);
}

Judgement table1_place(const Chain<Interval>& chain, const Printed& printed) {
  const Point<Interval> p = place_in_table(chain), middle = end_point(chain, chain.rest());
  const bool right = p.x.contains(proofs::parse_decimal(printed.at(0)).value()) &&
                     p.y.contains(proofs::parse_decimal(printed.at(1)).value());
  const std::string found =
      fmt::format("({}, {}) L", certified_decimal(middle.x, 6), certified_decimal(middle.y, 3));
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "the end point is " + found,
          {{EvidenceKind::interval, "direct kinematics: " + found + " at the printed angles, in " +
                                        p.x.text(5) + ", " + p.y.text(5) + " for all that round to them"}},
          ""};
}

/// (11): what the initial displacement of both rows of Table 1 is.
Judgement initial_displacement(const Printed& printed, int) {
  const Rational stated = proofs::parse_decimal(printed.at(0)).value();
  bool right = true;
  std::vector<std::string> found;
  for (const Chain<Interval>& chain : {u_shaped_chain(), z_shaped_chain()}) {
    right = right && (Interval(4) - place_in_table(chain).x).contains(stated);
    found.push_back(certified_decimal(Interval(4) - end_point(chain, chain.rest()).x, 4));
  }
  const std::string list = fmt::format("{} L", fmt::join(found, " L and "));
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : "Delta_x is " + list,
      {{EvidenceKind::interval, "4 L - x_0 at the angles of Table 1: " + list + ", within their rounding"}},
      ""};
}

/// (12) against (11) and (21): delta_x = x_0 - x.
Judgement loaded_deflection(const Printed& printed, int) {
  const proofs::Formulas formulas({"L1", "L2", "L3", "L4", "Dx", "dx"});
  GiNaC::ex length = 0;
  for (const char* name : {"L1", "L2", "L3", "L4"}) length += formulas.symbol(name);
  const GiNaC::ex initial = length - formulas.symbol("Dx");
  return judge_formulas(
      formulas, printed, {initial, initial - formulas.symbol("dx")}, {"x_0", "x"},
      "Delta_x as far as x_0 lies behind the straight chain's end point, delta_x = x_0 - x; with "
      "Delta_x = 0 it is the delta_x of (21)");
}

/// The printed rest angles of Table 1 against the shapes of a straight unit chain held at 3.8.
Judgement table1_origin(const Printed& printed, int) {
  const Chain<Interval> straight({1, 1, 1, 1}, {1, 1, 1, 1}, {0, 0, 0, 0});
  const proofs::Census census = held_at(straight, table_1_reach());
  Interval nearest(100);
  std::string kind;
  for (const auto& one : census.equilibria) {
    Interval distance(0);
    for (std::size_t i = 0; i < printed.size() - 1; ++i)
      distance += sqr(one.q.at(i) - Interval(proofs::parse_decimal(printed.at(i + 1)).value()));
    if (!certainly_less(distance, nearest)) continue;
    nearest = distance;
    kind = signs(one);
  }
  const bool right = kind == printed.at(0) && certainly_less(nearest, Interval(Rational(1, 1000000)));
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : "the nearest buckled shape of the straight chain has the signs " + kind,
      {{EvidenceKind::interval,
        fmt::format(
            "the angles are those of the straight unit chain buckled to 0.2 L, signs {}, to {} rad: nearest "
            "of the {} shapes of a certified census",
            kind, proofs::Located(sqrt(nearest).middle()).str(2), census.equilibria.size())}},
      ""};
}

Judgement surface(const Chain<Interval>& chain, const Printed& printed) {
  const proofs::Census census = at_deflection(chain, Rational(2, 5));
  const std::string found = extrema(census, 1);
  return judge_word(
      printed.at(0), found, {printed.at(0), found},
      fmt::format("on the sheet q_4 > 0 there are {}; {} equilibria in all", found, census.equilibria.size()),
      {{EvidenceKind::interval,
        fmt::format("certified census at the end point (3.4, 0), {} boxes", census.boxes)}});
}

Judgement stable_signs(const Chain<Interval>& chain, const SlowPath& path, const Printed& printed) {
  const Rational d(2, 5);
  const std::string found = signs(reached(at_deflection(chain, d), path, d));
  return judge_word(
      printed.at(0), found, {printed.at(0), found},
      "the shape that the chain has at 0.4 L has the signs " + found,
      {{EvidenceKind::interval,
        "certified census at the end point (3.4, 0): the state of the slowly compressed chain, signs " +
            found}});
}

/// A fold makes the forces jump though the energy surface moves continuously: continuity proves nothing.
Judgement continuity_proof(const Printed& printed, int) {
  const auto all = claims::loaded_three_link();
  const auto bent =
      std::find_if(all.begin(), all.end(), [](const Claim& c) { return c.id == "bent-continuous"; });
  const Judgement snap = bent->check({"can jump"}, 10);
  const bool counterexample = snap.verdict == Verdict::confirmed;
  return judge_word(
      printed.at(0), counterexample ? "does not prove" : "proves", {"proves", "does not prove"},
      "the minimum that is followed can vanish while the surface changes continuously; that the curves "
      "of Fig. 12 are continuous is shown by following them (fig-12-continuous)",
      {snap.evidence.front()});
}

Judgement u_continuous(const Printed& printed, int) {
  return judge_word(printed.at(0), u_path().continuity(), {"continuous", "a jump", "open"},
                    "stability is lost on the way", {u_path().evidence()});
}

Judgement u_resistance(const Printed& printed, int) {
  return judge_word(printed.at(0), u_path().stiff() ? "increasing" : "not increasing",
                    {"increasing", "not increasing"}, "the force falls somewhere", {u_path().evidence()});
}

Judgement u_stiffness(const Printed& printed, int) {
  const bool falls = u_path().regular() && u_path().proved[0].softens;
  return judge_word(printed.at(0), falls ? "decreasing" : "another", {"decreasing", "another"},
                    "the tangent stiffness does not fall all along", {u_path().evidence()});
}

/// The end of the branch on which two equilibria of the Z-chain are born as the compression grows.
BranchEvent<proofs::Located> birth() {
  const proofs::Census census = at_deflection(z_shaped_chain(), Rational(2, 5));
  const auto saddle = std::find_if(census.equilibria.begin(), census.equilibria.end(),
                                   [](const auto& one) { return one.negative_directions == 1; });
  if (saddle == census.equilibria.end()) throw Error("Fig. 13", "no saddle at 0.4 L", "one");
  const Branch<double> branch = branch_through(z_shaped_chain(), table_1_reach(), *saddle, 0.4, -1, {0, 0.5});
  for (auto& event : proofs::locate_events(z_path().chain, z_path().loading, branch)) {
    if (event.kind == EventKind::fold) return event;
  }
  throw Error("Fig. 13", "no fold on the saddle's branch", "one");
}

/// On the sheet q_4 > 0 that the figures show.
Judgement singular_surface(const Printed& printed, int digits) {
  const BranchEvent<proofs::Located> fold = birth();
  const Interval at(fold.point.load, fold.point.load), off(Rational(1, 100000));
  const std::string before = extrema(held_at(z_shaped_chain(), table_1_reach() - at + off), 1),
                    after = extrema(held_at(z_shaped_chain(), table_1_reach() - at - off), 1);
  const proofs::Census early = at_deflection(u_shaped_chain(), Rational(1, 20)),
                       middle = at_deflection(u_shaped_chain(), Rational(7, 10)),
                       late = at_deflection(u_shaped_chain(), Rational(7, 5));
  const std::string u = extrema(early, 1);
  const bool regular = extrema(middle, 1) == u && extrema(late, 1) == u;
  const std::string found =
      std::string(before != after ? "Z singular" : "Z regular") + (regular ? ", U regular" : ", U singular");
  Judgement result = judge_word(
      printed.at(0), found, {printed.at(0), found}, found,
      {{EvidenceKind::interval,
        fmt::format(
            "certified censuses, q_4 > 0: the Z-chain 1e-5 L before ({}) and after ({}) the value; the "
            "U-chain at 0.05, 0.7 and 1.4 L ({}; on both sheets together {} equilibria at 0.7 L, {} at 1.4 "
            "L)",
            before, after, u, middle.equilibria.size(), late.equilibria.size())},
       {EvidenceKind::mp50,
        "birth of a minimum and a saddle, a fold, located by Newton's method in 64 digits"}});
  result.value = located(fold.point.load, digits);
  return result;
}

/// Whether the place where the Z-chain's surface is singular is a state of the chain that is compressed.
Judgement apart(const Printed& printed, int digits) {
  const BranchEvent<proofs::Located> fold = birth();
  const BranchPoint<proofs::Located> followed = z_path().at(proofs::exactly(fold.point.load));
  const proofs::Located distance = (followed.theta - fold.point.theta).cwiseAbs().maxCoeff();
  const bool beside = z_path().regular() && distance > proofs::Located("0.01");
  Judgement result =
      judge_word(printed.at(0), beside ? "another shape" : "the shape", {"the shape", "another shape"},
                 "where the surface is singular two other equilibria are born; the shape that the chain has, "
                 "and its force, "
                 "pass that deflection regularly",
                 {z_path().evidence(),
                  {EvidenceKind::mp50,
                   fmt::format("at the fold, {} L, the followed shape differs from the one that is born by "
                               "up to {} rad in a link's orientation",
                               fold.point.load.str(8), distance.str(3))}});
  result.value = located(fold.point.load, digits);
  return result;
}

}  // namespace

std::vector<Claim> claims::loaded_four_link() {
  const std::string x = "L1*cos(q1)+L2*cos(q1+q2)+L3*cos(q1+q2+q3)+L4*cos(q1+q2+q3+q4)";
  return {
      {"eq-11", "3.2, (11)", "x_0 = sum L_j cos(q_1 + … + q_j)", {x}, direct_kinematics},
      {"redundancy",
       "3.2, after (11)",
       "with the end point held n - 2 joint angles are independent",
       {"n-2"},
       freedom},
      {"table-1-u",
       "3.2, Table 1",
       "end point of the U-shape",
       {"3.8", "0"},
       [](const Printed& printed, int) { return table1_place(u_shaped_chain(), printed); }},
      {"table-1-z",
       "3.2, Table 1",
       "end point of the Z-shape",
       {"3.8", "0"},
       [](const Printed& printed, int) { return table1_place(z_shaped_chain(), printed); }},
      {"table-1-u-shape",
       "3.2, Table 1",
       "the first row is a U-shape",
       {"-+++", "-0.3179", "0.0558", "0.3804", "0.3524"},
       table1_origin},
      {"table-1-z-shape",
       "3.2, Table 1",
       "the second row is a Z-shape",
       {"-+-+", "-0.2417", "0.6821", "-0.7958", "0.5170"},
       table1_origin},
      {"initial-displacement",
       "3.2, (11), Table 1",
       "both initial shapes have Delta_x = 0.2 L",
       {"0.2"},
       initial_displacement},
      {"eq-11-12",
       "3.2, (11), (12)",
       "x_0 = sum L_j - Delta_x and x = sum L_j - Delta_x - delta_x",
       {"L1+L2+L3+L4-Dx", "L1+L2+L3+L4-Dx-dx"},
       loaded_deflection},
      {"eq-12", "3.2, (12)", "x = sum L_j cos(q_1 + … + q_j) under load", {x}, direct_kinematics},
      {"fig-11-count",
       "3.2, Fig. 11",
       "the U-chain at 0.4 L, q4 > 0: one maximum, one minimum, one saddle",
       {"1 minima, 1 saddles, 1 maxima"},
       [](const Printed& printed, int) { return surface(u_shaped_chain(), printed); }},
      {"fig-11-shape",
       "3.2, Fig. 11",
       "the stable shape at 0.4 L is a U-shape as the initial one",
       {"-+++"},
       [](const Printed& printed, int) { return stable_signs(u_shaped_chain(), u_path(), printed); }},
      {"fig-11-continuity",
       "3.2, after Fig. 12",
       "a continuous evolution of E proves that the force-deflection curves are continuous",
       {"proves"},
       continuity_proof},
      {"fig-12-continuous",
       "3.2, Fig. 12",
       "the curves are continuous, the shape changes smoothly",
       {"continuous"},
       u_continuous},
      {"fig-12-resistance",
       "3.2, Fig. 12",
       "the resistance is gradually increasing",
       {"increasing"},
       u_resistance},
      {"fig-12-stiffness",
       "3.2, Fig. 12",
       "the stiffness of the U-chain is continuously decreasing",
       {"decreasing"},
       u_stiffness},
      {"fig-13-count",
       "3.2, Fig. 13",
       "the Z-chain at 0.4 L, q4 > 0: one maximum and one minimum",
       {"1 minima, 0 saddles, 1 maxima"},
       [](const Printed& printed, int) { return surface(z_shaped_chain(), printed); }},
      {"fig-13-shape",
       "3.2, Fig. 13",
       "the stable shape at 0.4 L is a Z-shape as the initial one",
       {"-+-+"},
       [](const Printed& printed, int) { return stable_signs(z_shaped_chain(), z_path(), printed); }},
      {"fig-13-singularities",
       "3.2, Fig. 13",
       "the surfaces of the Z-chain evolve with singularities, unlike those of the U-chain",
       {"Z singular, U regular"},
       singular_surface},
      {"fig-13-apart",
       "3.2, after Fig. 13",
       "the singular area of the force-deflection curve is where the surface is singular",
       {"the shape"},
       apart},
  };
}

}  // namespace plumbline::verify
