/// \file
/// Section 3.1: three links with a passive base, bent at rest; the U-chain of Fig. 7.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <set>

#include "proofs/census/census.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/symbolic_statics.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/post_buckling.hpp"
#include "verify/chains/three_link_plane.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

HeldChain fig7_chain(const Premises& given) {
  return held(given, "fig-7-chain");
}
const SlowPath& fig7_path(const Premises& given) {
  return fig7_chain(given).compressed(far);
}
/// As far as all equilibria can be followed at once.
const PlaneProof& fig7_plane(const Premises& given) {
  return prove_in_plane(fig7_chain(given), 0, Rational(1135, 1000));
}

/// Imprecise where another word is printed, true but for exceptions, which `truth` names.
Judgement as_a_rule(const std::string& printed, const std::string& computed, const std::string& truth,
                    std::vector<Evidence> evidence) {
  Judgement result = judge_word(printed, computed, truth, std::move(evidence));
  if (result.verdict == Verdict::refuted) result.verdict = Verdict::imprecise;
  return result;
}

/// Rank of the Jacobian of three links with the directions (c, s): "singular" below 2.
std::string rank_word(const std::vector<std::pair<Rational, Rational>>& directions) {
  Matrix<Rational> J(2, 3);
  Rational x = 0, y = 0;
  for (Eigen::Index i = 3; i-- > 0;) {
    x += directions[static_cast<std::size_t>(i)].first;
    y += directions[static_cast<std::size_t>(i)].second;
    J(0, i) = -y;
    J(1, i) = x;
  }
  return Eigen::FullPivLU<Matrix<Rational>>(J).rank() < 2 ? "singular" : "non-singular";
}

Judgement singular(const Printed& printed, int) {
  const std::string straight = rank_word({{1, 0}, {1, 0}, {1, 0}});
  const std::string bent = rank_word({{1, 0}, {Rational(3, 5), Rational(4, 5)}, {1, 0}});
  const std::string folded = rank_word({{1, 0}, {1, 0}, {-1, 0}});
  return judge_list(
      printed, {straight, bent}, fmt::format("straight it is {}, bent {}", straight, bent),
      {{EvidenceKind::exact,
        fmt::format(
            "rank of J in rationals: straight {}, bent {}; also where all links are folded back on one "
            "line, (0, 0, pi), {}",
            straight, bent, folded)}});
}

/// Four links, symmetric at rest: the end point lies on the x axis. They snap.
HeldChain snapping_chain() {
  const Interval angle(Rational(3, 5));
  return held(Chain<Interval>({1, 1, 1, 1}, {5, 5, 5, 6}, {angle, Interval(-2) * angle, angle, 0}));
}

std::string numbers_of(const std::vector<Interval>& list) {
  std::vector<std::string> texts;
  for (const Interval& one : list) texts.push_back(certified_decimal(one, 3));
  return fmt::format("{}", fmt::join(texts, ", "));
}

Judgement always_continuous(const Printed& printed, int digits) {
  const HeldChain chain = snapping_chain();
  const SlowPath& path = chain.compressed(far);
  const auto folds = path.of_kind(EventKind::fold);
  if (folds.size() != 1) throw Error("snapping chain", std::to_string(folds.size()) + " folds", "one");
  const Rational before(1140, 1000), after(1145, 1000);
  const proofs::Census &here = chain.at(before), &there = chain.at(after);
  // the equilibrium that the chain follows before the fold has none near it after it
  const proofs::CertifiedEquilibrium last = reached(here, path, before);
  Interval nearest(10);
  for (const auto& one : there.equilibria) {
    Interval distance(0);
    for (std::size_t i = 0; i < one.q.size(); ++i) distance += sqr(one.q[i] - last.q[i]);
    if (certainly_less(distance, nearest)) nearest = distance;
  }
  const proofs::PathCertificate& proved = path.proved.front();
  const bool snaps = proved.certified() && proved.folds.size() == 1 && proved.runs.size() == 2 &&
                     proved.runs[0].negative_directions == 0 && proved.runs[1].negative_directions == 1;
  const bool jumps = path.stretches.size() == 2 && snaps &&
                     here.equilibria.size() == there.equilibria.size() + 2 &&
                     certainly_less(Interval(Rational(1, 100)), nearest);
  Judgement result = as_a_rule(
      printed.at(0), jumps ? "can jump" : "continuous",
      fmt::format("as long as no fold is met: the chain of four links with k = ({}) and the rest angles ({}) "
                  "snaps to "
                  "another shape at {} L of compression",
                  numbers_of(snapping_chain().chain.stiffness()), numbers_of(snapping_chain().chain.rest()),
                  folds[0].point.load.str(6)),
      {{EvidenceKind::interval,
        fmt::format(
            "that chain, certified censuses at {} ({}) and {} ({}): the shape that was followed and a saddle "
            "are gone, and no equilibrium is near it",
            in_lengths(before), types(here), in_lengths(after), types(there))},
       path.evidence(),
       {EvidenceKind::mp50, "fold located by Newton's method; the chain then flows to another shape"}});
  result.value = folds[0].point.load.str(std::min(digits, proofs::located_digits));
  return result;
}

Judgement stiffness_amplitude(const Printed& printed, const Premises& given, int) {
  const Rational loaded(1, 2);
  const std::vector<Rational> at{Rational(1, 50), Rational(1, 10), Rational(3, 5)};
  const proofs::Located first = fig7_path(given).at(0).stiffness,
                        last = fig7_path(given).at(loaded).stiffness;
  const std::vector<Interval> means = mean_stiffnesses(fig7_path(given), at);
  const bool depends = certainly_less(means[1] * Interval(Rational(101, 100)), means[0]);
  return judge_word(
      printed.at(0), depends ? "depends" : "constant", "the stiffness does not change by a percent",
      {{EvidenceKind::interval,
        fmt::format("chain of Fig. 7, certified censuses at {}: mean stiffness {} and {} k/L^2",
                    in_lengths(at), certified_decimal(means[0], 5), certified_decimal(means[1], 5))},
       {EvidenceKind::mp50, fmt::format("dF/dDelta is {} k/L^2 without load, {} at {}", first.str(8),
                                        last.str(8), in_lengths(loaded))}});
}

/// Equations and unknowns at a given deflection.
Judgement four_equations(const Printed& printed, int) {
  const proofs::Formulas names({"L", "k", "phi", "q1", "q2", "alpha1", "alpha2", "Fx", "Fy"});
  const GiNaC::ex L = names.symbol("L"), k = names.symbol("k"), Fx = names.symbol("Fx"),
                  Fy = names.symbol("Fy");
  const proofs::SymbolicShape shape{{L, L, L},
                                    {0, k, k},
                                    {names.symbol("phi"), names.symbol("alpha1") + names.symbol("q1"),
                                     names.symbol("alpha2") + names.symbol("q2")}};
  const GiNaC::matrix balance = proofs::torque_balance(shape, Fx, Fy), p = end_point(shape);
  // with y = 0 the moment about the passive base settles F_y = 0
  const bool settled = proofs::identical(balance(0, 0), p(0, 0) * Fy - p(1, 0) * Fx);
  const std::size_t equations = balance.nops() + p.nops() - (settled ? 1 : 0), unknowns = shape.q.size() + 1;
  const std::string found = fmt::format("{} equations, {} unknowns", equations, unknowns);
  return judge_word(
      printed.at(0), found, found,
      {{EvidenceKind::symbolic,
        "(6) has three rows, (5) two; the first row is x F_y - y F_x = 0 and with y = 0 says F_y = 0. "
        "Unknown are phi, q_1, q_2, and F where Delta is given or Delta where F is"}});
}

/// What is unknown where Delta is the independent variable.
Judgement unknowns(const Printed& printed, int) {
  const std::vector<std::string> all{"L", "k", "alpha1", "alpha2", "x0", "Delta", "phi", "q1", "q2", "F"};
  const proofs::Formulas names(all);
  const auto s = [&](const char* name) { return names.symbol(name); };
  const proofs::SymbolicShape shape{{s("L"), s("L"), s("L")},
                                    {0, s("k"), s("k")},
                                    {s("phi"), s("alpha1") + s("q1"), s("alpha2") + s("q2")}};
  const GiNaC::matrix J = jacobian(shape), p = end_point(shape);
  const GiNaC::lst equations{J(0, 0) * s("F"), J(0, 1) * s("F") + s("k") * s("q1"),
                             J(0, 2) * s("F") + s("k") * s("q2"), p(0, 0) - s("x0") + s("Delta"), p(1, 0)};
  const auto unknown_where = [&](const std::string& given) {
    const std::set<std::string> known{"L", "k", "alpha1", "alpha2", "x0", given};
    std::set<std::string> found;
    for (const std::string& name : all) {
      if (!known.contains(name) && equations.has(names.symbol(name))) found.insert(name);
    }
    return found;
  };
  const std::set<std::string> stated(printed.begin(), printed.end());
  const bool complete = stated.size() == printed.size();
  const bool right = complete && stated == unknown_where("Delta");
  return {right                                      ? Verdict::confirmed
          : complete && stated == unknown_where("F") ? Verdict::convention
                                                     : Verdict::refuted,
          right ? ""
                : fmt::format("with F given they are {}; with Delta given, as the sentence before says, {}",
                              fmt::join(unknown_where("F"), ", "), fmt::join(unknown_where("Delta"), ", ")),
          {{EvidenceKind::symbolic,
            "symbols of (5) and (6) with (F_x, F_y) = (F, 0), less the chain's own, x_0 and what is given"}},
          ""};
}

/// The deflection that stands for all up to the end of the proof in the plane.
Rational looked_at_of_all() {
  return {1, 10};
}

/// The equilibria there, which stand for all deflections up to 1.135 L where the proof in the plane is
/// whole.
const proofs::Census& census_of_all(const Premises& given) {
  if (!fig7_plane(given).whole) throw Error("chain of Fig. 7", "an open range of deflections", "a proof");
  return fig7_chain(given).at(looked_at_of_all());
}

Evidence of_fig7_chain(const Premises& given, const std::string& census) {
  return {EvidenceKind::interval,
          fmt::format("chain of Fig. 7, {}; certified census at {}: {}", fig7_plane(given).text(),
                      in_lengths(looked_at_of_all()), census)};
}

/// How many equilibria there are, no joint wound up: of one kind up to 1.135 L, more beyond.
Judgement count(const Printed& printed, const Premises& given, int) {
  const std::string found = types(census_of_all(given));
  const Rational beyond(57, 50), far_beyond(6, 5);
  const proofs::Census &later = fig7_chain(given).at(beyond), &last = fig7_chain(given).at(far_beyond);
  const std::string truth =
      fmt::format("{} in the range that is proved; {} at {}, {} at {}", found, types(later),
                  in_lengths(beyond), types(last), in_lengths(far_beyond));
  const bool right = census_of_all(given).balanced && Counts(printed.at(0)) == Counts(found),
             always = found == types(later) && found == types(last);
  return {
      !right   ? Verdict::refuted
      : always ? Verdict::confirmed
               : Verdict::imprecise,
      right && always ? "" : truth,
      {of_fig7_chain(given, found),
       {EvidenceKind::interval,
        fmt::format(
            "certified censuses of every shape with joint angles within half a turn, each with as many "
            "stable as unstable ones, as the Euler characteristic of a circle demands: {} boxes at {}, {}; "
            "{} at {}, {}",
            later.boxes, in_lengths(beyond), types(later), last.boxes, in_lengths(far_beyond), types(last))}},
      ""};
}

std::string sorted_list(std::vector<std::string> words) {
  std::sort(words.begin(), words.end());
  return fmt::format("{}", fmt::join(words, ", "));
}

Judgement letters(const Printed& printed, const Premises& given, int) {
  std::vector<std::string> found;
  for (const auto& one : census_of_all(given).equilibria)
    found.push_back(letter(one) + (one.negative_directions == 0 ? " stable" : " unstable"));
  const std::string list = sorted_list(found);
  return judge_word(sorted_list(printed), list, "the equilibria are " + list, {of_fig7_chain(given, list)});
}

/// Which shapes are feasible, as section 2 has the word: stable.
Judgement feasible(const Printed& printed, const Premises& given, int) {
  std::vector<std::string> stable, unstable;
  for (const char* const name : {"U⁺", "U⁻", "Z⁺", "Z⁻"}) {
    for (const auto& one : census_of_all(given).equilibria) {
      if (letter(one) == name) (one.negative_directions == 0 ? stable : unstable).emplace_back(name);
    }
  }
  const auto named = [](const std::vector<std::string>& list) {
    return list.size() == 1 ? "shape " + list.front() : fmt::format("shapes ({})", fmt::join(list, ", "));
  };
  return judge_list(printed, {"feasible " + named(stable), "unfeasible " + named(unstable)},
                    fmt::format("section 2 calls the stable shapes feasible: these are {}, not {}",
                                fmt::join(stable, " and "), fmt::join(unstable, " and ")),
                    {of_fig7_chain(given, fmt::format("stable are {}", fmt::join(stable, " and ")))});
}

/// How many equilibria of the chain of Fig. 7 have the least energy.
Judgement global_minimum(const Printed& printed, const Premises& given, int) {
  // of both negative joint angles, U⁺, there is one: census_of_all
  const bool alone =
      census_of_all(given).equilibria.size() == 4 && fig7_plane(given).least("--", &PlanePiece::energy);
  const std::string found = alone ? "1" : "several";
  const Rational d(1140, 1000);
  const proofs::Census& census = snapping_chain().at(d);
  const proofs::CertifiedEquilibrium here = reached(census, snapping_chain().compressed(far), d);
  return judge_word(
      printed.at(0), found, found + " equilibria have the least energy",
      {of_fig7_chain(given, "one U⁺; its energy is below that of every other box at the same deflection"),
       {EvidenceKind::interval,
        fmt::format("a chain is not always there: the chain that snaps (bent-continuous), "
                    "slowly compressed to {}, has E = {} k, the lowest minimum {} k",
                    in_lengths(d), certified_decimal(here.energy, 5),
                    certified_decimal(census.equilibria.front().energy, 5))}});
}

/// The shape of the chain of Fig. 7 at rest.
Judgement rest_shape(const Printed& printed, const Premises& given, int) {
  proofs::CertifiedEquilibrium rest;
  rest.q = given.chain("fig-7-chain").rest();
  const std::string found = letter(rest), stated = printed.at(0);
  const bool hyphen = stated == found.substr(0, 1) + "⁻";  // the stroke of "U-configuration"
  return {stated == found ? Verdict::confirmed
          : hyphen        ? Verdict::convention
                          : Verdict::refuted,
          stated == found ? "" : "the chain of Fig. 7 is " + found + ", as the text before it says",
          {{EvidenceKind::interval, "signs of the rest angles: " + signs(rest, 1)}},
          ""};
}

/// How the straight chain leaves its shape where it buckles.
Judgement straight_jump(const Printed& printed, int) {
  const Rational curvature = post_buckling_curvature<Rational>(Chain<Rational>({1, 1, 1}, {0, 1, 1}),
                                                               {Rational(1), {1, -1, -1}, Rational(0)});
  return as_a_rule(
      printed.at(0), curvature > 0 ? "continuous" : "jump",
      "like Euler's column, the straight three-link chain bends continuously from F_c on: F = "
      "F_c + F_2 a^2 with "
      "F_2 > 0. What jumps is the stiffness",
      {Evidence::by_theorem("Bent above the lowest force",
                            "no bent shape has a compression up to F_1; by Supercritical they begin "
                            "at it"),
       {EvidenceKind::exact, fmt::format("F_2 of the U-shape = {} k/L", curvature.str())}});
}

Judgement least_force(const Printed& printed, const Premises& given, int) {
  const bool least = fig7_plane(given).least("--", &PlanePiece::energy) &&
                     fig7_plane(given).least("--", &PlanePiece::compression);
  return judge_word(
      printed.at(0), least ? "minimum" : "another",
      "the shape of least energy has the least compression among those that are compressed",
      {of_fig7_chain(given,
                     "one U⁺; its energy and its compression are below those of every other box at "
                     "the same deflection")});
}

Judgement observed(const Printed& printed, const Premises& given, int) {
  const Rational d(1, 10);
  const std::string shape = letter(reached(census_of_all(given), fig7_path(given), d));
  const bool lowest = shape == "U⁺" && fig7_plane(given).least("--", &PlanePiece::energy);
  const std::string found = lowest ? "global" : "local";
  const bool right = printed.at(0) == shape && printed.at(1) == found && fig7_path(given).regular();
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : fmt::format("the shape that is reached is {}, a {} minimum", shape, found),
      {fig7_path(given).evidence(),
       of_fig7_chain(given, "the slowly compressed chain is " + shape +
                                ", whose energy is below that of every other box at the same deflection")},
      ""};
}

}  // namespace

Checks claims::loaded_three_link() {
  return {
      {"singular-straight", singular},
      {"bent-continuous", always_continuous},
      {"stiffness-amplitude", stiffness_amplitude},
      {"four-equations", four_equations},
      {"four-unknowns", unknowns},
      {"observed-global", global_minimum},
      {"fig-7-feasible", feasible},
      {"fig-7-count", count},
      {"fig-7-shapes", letters},
      {"fig-7-force", least_force},
      {"fig-7-observed", observed},
      {"fig-7-rest", rest_shape},
      {"straight-jump", straight_jump},
  };
}

}  // namespace plumbline::verify
