/// \file
/// Section 3.2: four links under load, (11), (12), Table 1, Figures 11 to 13.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>

#include "proofs/census/census.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/symbolic_statics.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

HeldChain u_chain(const Premises& given) {
  return held(given, "u-chain");
}
HeldChain z_chain(const Premises& given) {
  return held(given, "z-chain");
}

/// Joint angles that stay free when the end point is held: n less the rank of the Jacobian.
Judgement freedom(const Printed& printed, int) {
  const auto count = [](std::size_t n) {
    return n - static_cast<std::size_t>(Eigen::FullPivLU<Matrix<Rational>>(bent_jacobian(n)).rank());
  };
  return judge_count(printed.at(0), count, "n - 2 joint angles stay free, none for two links",
                     EvidenceKind::exact, "n less the rank of J in rationals, bent shape");
}

/// A printed angle: all that round to it.
Interval rounded(const std::string& decimal) {
  const std::optional<Rational> angle = proofs::parse_decimal(decimal);
  const std::size_t point = decimal.find('.');
  if (!angle || point == std::string::npos) throw Error("claim", "'" + decimal + "'", "an angle");
  Rational half(1, 2);
  for (std::size_t i = point + 1; i < decimal.size(); ++i) half /= 10;
  return hull(Interval(Rational(*angle - half)), Interval(Rational(*angle + half)));
}

/// Where the end point of a unit chain with four printed angles may be.
Point<Interval> place_of(const Printed& printed) {
  std::vector<Interval> q;
  for (std::size_t i = 0; i < 4; ++i) q.push_back(rounded(printed.at(i)));
  return end_point(Chain<Interval>({1, 1, 1, 1}, {1, 1, 1, 1}, {0, 0, 0, 0}), q);
}

/// printed: four angles, x and y
Judgement table1_place(const Printed& printed, int) {
  if (printed.size() != 6) throw Error("claim", fmt::format("{} entries", printed.size()), "6");
  const Point<Interval> p = place_of(printed);
  const bool right = p.x.contains(proofs::parse_decimal(printed[4]).value()) &&
                     p.y.contains(proofs::parse_decimal(printed[5]).value());
  const std::string found = fmt::format("({}, {}) L", p.x.text(6), p.y.text(6));
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? "" : "the end point is in " + found,
      {{EvidenceKind::interval, "direct kinematics for all angles that round to the printed ones: " + found}},
      ""};
}

/// (11): what the initial displacement of both rows of Table 1 is.
Judgement initial_displacement(const Printed& printed, int) {
  const Rational stated = proofs::parse_decimal(printed.at(0)).value();
  bool right = true;
  std::vector<std::string> found;
  for (const char* row : {"table-1-u", "table-1-z"}) {
    const Interval displacement = Interval(4) - place_of(printed_in_paper(row)).x;
    right = right && displacement.contains(stated);
    found.push_back(displacement.text(5));
  }
  const std::string list = fmt::format("{} L", fmt::join(found, " L and "));
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "Delta_x is in " + list,
          {{EvidenceKind::interval, "4 L - x_0 for all angles that round to those of Table 1: " + list}},
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

/// Signs and angles of Table 1 against the shapes of a straight unit chain held at 3.8, to a unit of the last
/// place.
Judgement table1_origin(const Printed& printed, const Premises& given, int) {
  if (printed.size() != 5) throw Error("claim", fmt::format("{} entries", printed.size()), "5");
  const HeldChain straight = held(given, "unit-chain");
  const Rational displacement = proofs::parse_decimal(printed_in_paper("initial-displacement").at(0)).value();
  const proofs::Census& census = straight.at(displacement);
  const auto one = std::find_if(census.equilibria.begin(), census.equilibria.end(),
                                [&](const auto& shape) { return signs(shape) == printed[0]; });
  std::vector<std::string> angles, other;
  bool right = one != census.equilibria.end();
  for (std::size_t i = 0; right && i < 4; ++i) {
    const Interval place = rounded(printed[i + 1]),
                   twice = place + place - Interval(place.middle(), place.middle());
    const Interval& angle = one->q[i];  // `twice` is a unit to either side
    right = certainly_less(Interval(twice.lower(), twice.lower()), angle) &&
            certainly_less(angle, Interval(twice.upper(), twice.upper()));
    angles.push_back(certified_decimal(angle, 6));
    if (!certainly_less(place, angle) && !certainly_less(angle, place)) continue;
    other.push_back(printed[i + 1]);
  }
  return {
      right ? Verdict::confirmed : Verdict::refuted,
      right ? ""
            : "no shape of the straight chain has these signs and, to a unit of the last place, these angles",
      {{EvidenceKind::interval,
        fmt::format(
            "the straight unit chain held {} L from its end, certified census of {} shapes: {}; rounded to "
            "four places other than printed: {}",
            proofs::to_exact(displacement), census.equilibria.size(), fmt::join(angles, ", "),
            other.empty() ? "none" : fmt::format("{}", fmt::join(other, ", ")))}},
      ""};
}

Judgement stable_signs(const HeldChain& chain, const Rational& d, const Printed& printed) {
  const std::string found = signs(reached(chain.at(d), chain.compressed(far), d));
  return judge_word(
      printed.at(0), found,
      fmt::format("the shape that the chain has at {} L has the signs {}", proofs::to_exact(d), found),
      {{EvidenceKind::interval,
        fmt::format("certified census at {} L: the state of the slowly compressed chain, signs {}",
                    proofs::to_exact(d), found)}});
}

/// The stable shapes on the sheet q_4 > 0 of the figure: imprecise where one of several is printed.
Judgement z_signs(const Printed& printed, const Premises& given, int) {
  const Rational d = given.exact("fig-13-deflection");
  Judgement result = stable_signs(z_chain(given), d, printed);
  std::vector<std::string> stable, others;
  for (const auto& one : z_chain(given).at(d).equilibria) {
    if (sign_character(sin(one.q.at(3))) != '+') continue;
    (one.negative_directions == 0 ? stable : others)
        .push_back(fmt::format("{} (E = {} k)", signs(one), certified_decimal(one.energy, 4)));
  }
  if (result.verdict != Verdict::confirmed || stable.size() < 2) return result;
  result.verdict = Verdict::imprecise;
  result.truth = fmt::format(
      "of the {} stable shapes with q_4 > 0, {}, the slowly compressed chain has {}; the saddle "
      "there is {}",
      stable.size(), fmt::join(stable, " and "), printed.at(0), fmt::join(others, " and "));
  return result;
}

/// A fold makes the forces jump though the energy surface moves continuously: continuity alone proves
/// nothing.
Judgement continuity_proof(const Printed& printed, int) {
  const auto all = claims::loaded_three_link();
  const auto bent =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.first == "bent-continuous"; });
  const Judgement snap = bent->second({"can jump"}, {}, 10);
  const std::string found = snap.verdict == Verdict::confirmed ? "does not prove" : "proves";
  return {
      printed.at(0) == found ? Verdict::confirmed : Verdict::imprecise,
      printed.at(0) == found
          ? ""
          : "so as long as the minimum that is followed does not vanish, as it can while the surface changes "
            "continuously; that the curves of Fig. 12 are continuous is shown by following them",
      {snap.evidence.front()},
      ""};
}

/// The end of the branch on which two equilibria of the Z-chain are born as the compression grows.
BranchEvent<proofs::Located> birth(const HeldChain& chain, const Rational& d) {
  const proofs::Census& census = chain.at(d);
  const auto saddle = std::find_if(census.equilibria.begin(), census.equilibria.end(),
                                   [](const auto& one) { return one.negative_directions == 1; });
  if (saddle == census.equilibria.end()) throw Error("Fig. 13", "no saddle at " + d.str() + " L", "one");
  const Branch<double> branch = branch_through(chain, *saddle, from_rational<double>(d), -1, {0, 0.5});
  const SlowPath& path = chain.compressed(far);
  for (auto& event : proofs::locate_events(path.chain, path.loading, branch)) {
    if (event.kind == EventKind::fold) return event;
  }
  throw Error("Fig. 13", "no fold on the saddle's branch", "one");
}

/// On the sheet q_4 > 0 that the figures show.
Judgement singular_surface(const Printed& printed, const Premises& given, int digits) {
  const HeldChain chain = z_chain(given), u_shaped = u_chain(given);
  const BranchEvent<proofs::Located> fold = birth(chain, given.exact("fig-13-deflection"));
  const Rational next(1, 100000);
  const std::vector<Rational> looked_at{Rational(1, 20), Rational(7, 10), Rational(7, 5)};
  const Interval at(fold.point.load, fold.point.load), off(next);
  const std::string before = extrema(chain.at(at - off), 1), after = extrema(chain.at(at + off), 1);
  const proofs::Census &early = u_shaped.at(looked_at[0]), &middle = u_shaped.at(looked_at[1]),
                       &late = u_shaped.at(looked_at[2]);
  const std::string u = extrema(early, 1);
  const bool regular = extrema(middle, 1) == u && extrema(late, 1) == u;
  const std::string z_word = before != after ? "singular" : "regular",
                    u_word = regular ? "regular" : "singular";
  const BranchPoint<proofs::Located> followed = chain.compressed(far).at(proofs::exactly(fold.point.load));
  const proofs::Located distance = (followed.theta - fold.point.theta).cwiseAbs().maxCoeff();
  Judgement result = judge_rows(
      printed, {"Z", z_word, "U", u_word}, 2, fmt::format("Z {}, U {}", z_word, u_word),
      {{EvidenceKind::interval,
        fmt::format("certified censuses, q_4 > 0: the Z-chain {} before ({}) and after ({}) the value; the "
                    "U-chain at {} ({}; on "
                    "both sheets together {} equilibria at {}, {} at {})",
                    in_lengths(next), before, after, in_lengths(looked_at), u, middle.equilibria.size(),
                    in_lengths(looked_at[1]), late.equilibria.size(), in_lengths(looked_at[2]))},
       {EvidenceKind::mp50,
        fmt::format(
            "birth of a minimum and a saddle, a fold, located by Newton's method in 64 digits; the slowly "
            "compressed chain passes it regularly, in another shape: a link points {} rad otherwise",
            distance.str(3))}});
  result.value = located(fold.point.load, digits);
  return result;
}

/// The forces that hold the end point on its line.
Judgement forces_needed(const HeldChain& chain, const Rational& at, const Printed& printed, int digits) {
  const SlowPath& path = chain.compressed(far);
  const Rational from(1, 100), to(3, 2);
  const bool along = path.everywhere(from, to, [](const auto&one) { return !one.fx.contains_zero(); }),
             across = path.everywhere(from, to, [](const auto&one) { return !one.fy.contains_zero(); });
  std::vector<std::string> lateral;
  const std::vector<Rational> looked_at{Rational(1, 10), Rational(2, 5), Rational(4, 5)};
  for (const auto& one : states(path, looked_at)) lateral.push_back(certified_decimal(paper_force(one).y, 5));
  std::vector<std::string> found;
  if (along) found.emplace_back("Fx");
  if (across) found.emplace_back("Fy");
  Judgement result = judge_rows(
      printed, found, 1, fmt::format("{}", fmt::join(found, ", ")),
      {{EvidenceKind::interval,
        fmt::format("proved branch from {} to {}, in enclosures of all its states: not zero are {}",
                    in_lengths(from), in_lengths(to), fmt::join(found, ", "))},
       {EvidenceKind::interval,
        fmt::format("certified censuses at {}, the slowly compressed chain: F_y of (6) = {} k/L",
                    in_lengths(looked_at), fmt::join(lateral, ", "))}});
  result.value = fmt::format("{} k/L at {} L",
                             certified_decimal(paper_force(states(path, {at})[0]).y, std::min(digits, 30)),
                             proofs::to_exact(at));
  return result;
}

Judgement u_forces(const Printed& printed, const Premises& given, int digits) {
  return forces_needed(u_chain(given), given.exact("fig-11-deflection"), printed, digits);
}
Judgement z_forces(const Printed& printed, const Premises& given, int digits) {
  return forces_needed(z_chain(given), given.exact("fig-13-deflection"), printed, digits);
}

}  // namespace

Checks claims::loaded_four_link() {
  return {
      {"redundancy", freedom},
      {"table-1-u", table1_place},
      {"table-1-z", table1_place},
      {"table-1-u-shape", table1_origin},
      {"table-1-z-shape", table1_origin},
      {"initial-displacement", initial_displacement},
      {"eq-11-12", loaded_deflection},
      {"fig-11-continuity", continuity_proof},
      {"fig-12-lateral", u_forces},
      {"fig-14-lateral", z_forces},
      {"fig-13-shape", z_signs},
      {"fig-13-singularities", singular_surface},
  };
}

}  // namespace plumbline::verify
