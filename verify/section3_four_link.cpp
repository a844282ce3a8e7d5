/// \file
/// Section 3.2: four links under load, (11), (12), Table 1, Figures 11 to 14.

#include <fmt/core.h>

#include <Eigen/LU>
#include <plumbline/equilibrium.hpp>

#include "proofs/census.hpp"
#include "proofs/decimal.hpp"
#include "proofs/symbolic_statics.hpp"
#include "verify/claims.hpp"
#include "verify/judging.hpp"
#include "verify/section3_chains.hpp"

namespace plumbline {
namespace {

/// The paper's chains of Table 1 with the end point at (3.8 - d, 0).
Census at_deflection(const Chain<Interval>& chain, const Rational& deflection) {
  return held_at(chain, table_1_reach() - Interval(deflection));
}

/// Slowly compressed up to 1.5 L; computed once.
const SlowPath& u_path() {
  static const SlowPath instance = compress_slowly(u_shaped_chain(), table_1_reach(), 1.5);
  return instance;
}
const SlowPath& z_path() {
  static const SlowPath instance = compress_slowly(z_shaped_chain(), table_1_reach(), 1.5);
  return instance;
}

std::string located(const Located& number, int digits) {
  return number.str(std::min(digits, located_digits));
}

Judgement direct_kinematics(const Printed& printed, int) {
  std::vector<std::string> names;
  for (int i = 1; i <= 4; ++i) {
    names.push_back(fmt::format("L{}", i));
    names.push_back(fmt::format("q{}", i));
  }
  const Formulas formulas(names);
  SymbolicShape shape;
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
    const auto size = static_cast<Eigen::Index>(n);
    Matrix<Rational> J(2, size);
    Rational x = 0, y = 0;
    for (Eigen::Index i = size; i-- > 0;) {  // a bent shape: the link's half-angle tangent is 1 / (i + 2)
      const Rational t(1, static_cast<int>(i) + 2);
      x += (1 - t * t) / (1 + t * t);
      y += 2 * t / (1 + t * t);
      J(0, i) = -y;
      J(1, i) = x;
    }
    return n - static_cast<std::size_t>(Eigen::FullPivLU<Matrix<Rational>>(J).rank());
  };
  return judge_count(printed.at(0), count, "n - 2 joint angles stay free, none for two links",
                     EvidenceKind::exact, "n less the rank of J in rationals, bent shape");
}

Judgement table1_place(const Chain<Interval>& chain, const Printed& printed) {
  const Point<Interval> p = end_point(chain, chain.rest());
  return judge_decimals(printed, {p.x, p.y}, {"x_0", "y_0"}, "direct kinematics at the printed angles");
}

/// The printed rest angles of Table 1 against the shapes of a straight unit chain held at 3.8.
Judgement table1_origin(const Printed& printed, int) {
  const Chain<Interval> straight({1, 1, 1, 1}, {1, 1, 1, 1}, {0, 0, 0, 0});
  const Census census = held_at(straight, table_1_reach());
  Interval nearest(100);
  std::string kind;
  for (const auto& one : census.equilibria) {
    Interval distance(0);
    for (std::size_t i = 0; i < printed.size() - 1; ++i)
      distance += sqr(one.q.at(i) - Interval(parse_decimal(printed.at(i + 1)).value()));
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
            kind, Located(sqrt(nearest).middle()).str(2), census.equilibria.size())}},
      ""};
}

Judgement surface(const Chain<Interval>& chain, const Printed& printed) {
  const Census census = at_deflection(chain, Rational(2, 5));
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
  const auto claims = loaded_three_link_claims();
  const auto bent =
      std::find_if(claims.begin(), claims.end(), [](const Claim& c) { return c.id == "bent-continuous"; });
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

/// "increasing" where the tangent stiffness is proved positive all along a path.
std::string resistance(const SlowPath& path) {
  return path.stiff() ? "increasing" : "not increasing";
}

Judgement u_resistance(const Printed& printed, int) {
  return judge_word(printed.at(0), resistance(u_path()), {"increasing", "not increasing"},
                    "the force falls somewhere", {u_path().evidence()});
}

Judgement u_stiffness(const Printed& printed, int) {
  const auto& points = u_path().stretches[0].points;
  bool falls = u_path().regular() && u_path().events.empty();
  for (std::size_t i = 1; i < points.size(); ++i)
    falls = falls && points[i].stiffness < points[i - 1].stiffness;
  return judge_word(
      printed.at(0), falls ? "decreasing" : "another", {"decreasing", "another"},
      "the tangent stiffness has a minimum on the way",
      {{EvidenceKind::real64,
        fmt::format("stable path to 1.5 L, no stationary stiffness; from {:.6g} to {:.6g} k/L^2",
                    points.front().stiffness, points.back().stiffness)}});
}

/// The end of the branch on which two equilibria of the Z-chain are born as the compression grows.
BranchEvent<Located> birth() {
  const Chain<Interval> chain = z_shaped_chain();
  const auto rounded = [](const Interval& x) { return static_cast<double>(x.middle()); };
  const Rational d(2, 5);
  const Census census = at_deflection(chain, d);
  const NominalModel<double> model(convert<double>(chain, rounded));
  Brancher<NominalModel<double>> brancher(model, {Control::end_point, {3.8, 0}, {-1, 0}},
                                          absolute_angles(model.chain().rest()));
  const CertifiedEquilibrium* saddle = nullptr;
  for (const auto& one : census.equilibria) {
    if (one.negative_directions == 1) saddle = &one;
  }
  if (saddle == nullptr) throw Error("Fig. 13", "no saddle at 0.4 L", "one");
  std::vector<double> q;
  for (const Interval& angle : saddle->q) q.push_back(rounded(angle));
  auto start = brancher.start(0.4, absolute_angles(q), {rounded(saddle->fx), rounded(saddle->fy)});
  Brancher<NominalModel<double>>::scale(start.tangent, start.tangent.load > 0 ? -1 : 1);
  const Branch<double> branch = Tracer<NominalModel<double>>(brancher, {0, 0.5}).run(start);
  for (auto& event : locate_events(z_path().chain, z_path().loading, branch)) {
    if (event.kind == EventKind::fold) return event;
  }
  throw Error("Fig. 13", "no fold on the saddle's branch", "one");
}

Judgement singular_surface(const Printed& printed, int digits) {
  const BranchEvent<Located> fold = birth();
  const Interval at(fold.point.load, fold.point.load), off(Rational(1, 100000));
  const Census before = held_at(z_shaped_chain(), table_1_reach() - at + off),
               after = held_at(z_shaped_chain(), table_1_reach() - at - off);
  const Census u1 = at_deflection(u_shaped_chain(), Rational(1, 20)),
               u2 = at_deflection(u_shaped_chain(), Rational(7, 10));
  const bool z = extrema(before) != extrema(after), u = extrema(u1) != extrema(u2);
  const std::string found =
      std::string(z ? "Z singular" : "Z regular") + (u ? ", U singular" : ", U regular");
  Judgement result = judge_word(
      printed.at(0), found, {printed.at(0), found}, found,
      {{EvidenceKind::interval, fmt::format("certified censuses of the Z-chain 1e-5 L before ({}) and after "
                                            "({}) the value; of the U-chain at "
                                            "0.05 L ({}) and 0.7 L ({})",
                                            extrema(before), extrema(after), extrema(u1), extrema(u2))},
       {EvidenceKind::mp50,
        "birth of a minimum and a saddle, a fold, located by Newton's method in 64 digits"}});
  result.value = located(fold.point.load, digits);
  return result;
}

Judgement z_smooth(const Printed& printed, int) {
  const bool smooth = z_path().regular();
  const std::string found = smooth ? "smooth" : "not smooth";
  Judgement result{Verdict::confirmed,
                   "",
                   {{EvidenceKind::theorem,
                     "implicit function theorem: where the Hessian on the tangent space is "
                     "definite, shape and force are analytic in the deflection"},
                    z_path().evidence()},
                   ""};
  if (printed.at(0) == found) return result;
  result.verdict = printed.at(0) == "not very smooth" && smooth ? Verdict::imprecise : Verdict::refuted;
  result.truth = "the curve is " + found + ": it bends sharply, but has no kink and no jump";
  return result;
}

Judgement z_soft(const Printed& printed, int) {
  const auto points = z_path().of_kind(EventKind::quasi_buckling);
  const double first = z_path().stretches[0].points.front().stiffness;
  const double least = points.empty() ? first : static_cast<double>(points[0].point.stiffness);
  return judge_word(
      printed.at(0), least < first / 20 ? "very low" : "not low", {"very low", "not low"},
      "the stiffness does not become low",
      {{EvidenceKind::mp50, fmt::format("least stiffness {:.6g} k/L^2, {:.3g} % of the initial {:.6g}", least,
                                        100 * least / first, first)}});
}

/// Whether the path has two parts, one steep and one flat, and the chain keeps its signs on both.
Judgement z_two_parts(const Printed& printed, int) {
  const auto& points = z_path().stretches[0].points;
  std::size_t steepest = 1;  // where the stiffness falls fastest
  const auto fall = [&](std::size_t i) {
    return (points[i - 1].stiffness - points[i].stiffness) / (points[i].load - points[i - 1].load);
  };
  for (std::size_t i = 2; i < points.size(); ++i) {
    if (points[i].load > 0.05 && fall(i) > fall(steepest)) steepest = i;
    if (points[steepest].load < 0.05) steepest = i;
  }
  const BranchPoint<double>&edge = points[steepest], &first = points.front(), &last = points.back();
  const double fast = -(edge.force.x - first.force.x) / edge.load,
               slow = -(last.force.x - edge.force.x) / (last.load - edge.load);
  const bool two = resistance(z_path()) == "increasing" && fast > 10 * slow;
  return judge_word(
      printed.at(0), two ? "fast, then very slow" : "even", {"fast, then very slow", "even"},
      "the force grows evenly",
      {{EvidenceKind::real64,
        fmt::format("force increasing all the way; past the start the stiffness falls fastest at about "
                    "{:.3f} L; mean stiffness {:.3g} k/L^2 before, {:.3g} after",
                    edge.load, fast, slow)}});
}

Judgement z_keeps(const Printed& printed, int) {
  std::string found;
  for (const Rational& d :
       {Rational(1, 20), Rational(1, 10), Rational(3, 20), Rational(2, 5), Rational(7, 10)}) {
    const std::string here = signs(reached(at_deflection(z_shaped_chain(), d), z_path(), d));
    found = found.empty() || found == here ? here : "changing";
  }
  return judge_word(printed.at(0), found, {printed.at(0), found},
                    "the signs of the joint angles are " + found,
                    {{EvidenceKind::interval,
                      "certified censuses at 0.05, 0.1, 0.15, 0.4 and 0.7 L: the state of the "
                      "slowly compressed chain has the signs " +
                          found}});
}

Judgement z_quasi(const Printed& printed, int digits) {
  const auto points = z_path().of_kind(EventKind::quasi_buckling);
  const std::string count = std::to_string(points.size());
  Judgement result = judge_word(printed.at(0), count, {printed.at(0), count},
                                count + " points of least stiffness up to 1.5 L", {});
  if (points.empty()) return with_evidence(result, EvidenceKind::real64, "none found");
  const Interval at(points[0].point.load, points[0].point.load), off(Rational(1, 100));
  const std::string before = extrema(held_at(z_shaped_chain(), table_1_reach() - at + off)),
                    after = extrema(held_at(z_shaped_chain(), table_1_reach() - at - off));
  result.evidence = {
      {EvidenceKind::interval,
       fmt::format(
           "certified censuses 0.01 L before ({}) and after ({}) the value: no equilibrium comes or goes",
           before, after)},
      {EvidenceKind::mp50, fmt::format("zero of the stiffness's derivative in 64 digits: stiffness {} k/L^2",
                                       points[0].point.stiffness.str(8))}};
  result.value = located(points[0].point.load, digits);
  return result;
}

/// Whether the stable shapes of a held end point are also stable under the force that holds it.
Judgement under_force(const Printed& printed, int) {
  std::vector<std::string> notes;
  bool alike = true;
  for (const auto& [name, chain, path] :
       {std::tuple{"U", u_shaped_chain(), &u_path()}, {"Z", z_shaped_chain(), &z_path()}}) {
    const NominalModel<Located> model(path->chain);
    EquilibriumSolver<NominalModel<Located>> solver(model);
    for (const Rational& d : {Rational(1, 10), Rational(2, 5), Rational(12, 10)}) {
      const BranchPoint<Located> held = path->at(d);
      const auto loaded = solver.under_force(held.force, held.theta);
      const bool same = (loaded.theta - held.theta).cwiseAbs().maxCoeff() < Located("1e-40");
      alike = alike && same && loaded.negative_directions == 0;
      notes.push_back(fmt::format("{} at {:.1f} L: {}", name, static_cast<double>(d),
                                  !same                             ? "another shape"
                                  : loaded.negative_directions == 0 ? "stable"
                                                                    : "unstable"));
    }
  }
  std::string list;
  for (const std::string& note : notes) list += (list.empty() ? "" : ", ") + note;
  Judgement result{
      Verdict::confirmed,
      "",
      {{EvidenceKind::theorem,
        "with and without the constraint the equations of equilibrium are the same; "
        "what is stable under the force is stable with its end point held"},
       {EvidenceKind::mp50, "the held shapes under the force that holds them, as a dead load: " + list}},
      ""};
  if (printed.at(0) == (alike ? "similar" : "the same equilibria, stable less often")) return result;
  result.verdict = printed.at(0) == "similar" ? Verdict::imprecise : Verdict::refuted;
  result.truth = "the same equilibria, but fewer of them are stable under the dead force: " + list;
  return result;
}

Judgement several(const Printed& printed, int digits) {
  const Chain<Interval> chain({1, 1, 1}, {0, 1, 2},
                              {0, Interval(Rational(11, 10)), Interval(Rational(-3, 2))});
  const SlowPath path = compress_slowly(chain, unloaded_reach(chain), 1.4);
  const auto points = path.of_kind(EventKind::quasi_buckling);
  Judgement result = judge_word(
      printed.at(0), path.regular() && points.size() >= 2 ? "possible" : "open",
      {"possible", "open", "impossible"}, "they exist",
      {path.evidence(),
       {EvidenceKind::mp50,
        fmt::format("three links, passive base, k = (0, 1, 2), rest angles 1.1 and -1.5: the stable path to "
                    "1.4 L has {} points of least stiffness{}",
                    points.size(), points.empty() ? "" : ", located in 64 digits")}});
  for (const auto& event : points)
    result.value += (result.value.empty() ? "" : "; ") + located(event.point.load, digits);
  return result;
}

}  // namespace

std::vector<Claim> loaded_four_link_claims() {
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
      {"fig-14-smooth",
       "3.2, Fig. 14",
       "the curve of the Z-chain is not very smooth",
       {"not very smooth"},
       z_smooth},
      {"fig-14-soft",
       "3.2, Fig. 14",
       "there is an area where the stiffness becomes very low",
       {"very low"},
       z_soft},
      {"fig-14-parts",
       "3.2, Fig. 14",
       "the resistance grows fast and monotonically, beyond a critical deflection very slowly",
       {"fast, then very slow"},
       z_two_parts},
      {"fig-14-shape", "3.2, Fig. 14", "the chain maintains its Z-shape", {"-+-+"}, z_keeps},
      {"fig-14-points", "3.2, Fig. 14", "a single quasi-buckling point was discovered", {"1"}, z_quasi},
      {"given-force",
       "3.2, after Fig. 14",
       "solving for a given force instead of a given deflection gives similar results",
       {"similar"},
       under_force},
      {"several-points",
       "3.2, last paragraph",
       "several quasi-buckling points may exist for some chains (an open question)",
       {"possible"},
       several},
  };
}

}  // namespace plumbline
