/// \file
/// Section 3.1: the Z-chain of Figures 8 and 9, three links with a passive base.

#include <fmt/core.h>

#include <algorithm>

#include "proofs/census/census.hpp"
#include "proofs/exact/exactly.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/three_link_plane.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

HeldChain zigzag(const Premises& given) {
  return held(given, "fig-8-chain");
}

template <class Deflection>
const proofs::Census& at_deflection(const Premises& given, const Deflection& deflection) {
  return zigzag(given).at(deflection);
}

/// Up to 0.6 L, to the side on which the first angle grows.
const SlowPath& path(const Premises& given) {
  return zigzag(given).compressed(0.6);
}

/// Where the zigzag loses its stability.
const BranchEvent<proofs::Located>& buckling(const Premises& given) {
  const auto& events = path(given).events;
  if (events.size() != 1 || events[0].kind != EventKind::bifurcation)
    throw Error("Fig. 8", std::to_string(events.size()) + " events up to 0.6 L", "one bifurcation");
  return events[0];
}

/// Mean stiffness over the last 0.001 L before the bifurcation, and over 0.001 L after it.
std::pair<Interval, Interval> stiffnesses(const Premises& given) {
  const Rational at = proofs::exactly(buckling(given).point.load), next(1, 1000000), wide(1, 1000);
  return {mean_stiffnesses(path(given), {Rational(at - wide), Rational(at - next)})[0],
          mean_stiffnesses(path(given), {Rational(at + next), Rational(at + wide)})[0]};
}

std::string next_to_bifurcation(const Premises& given) {
  const auto [before, after] = stiffnesses(given);
  return fmt::format(
      "certified censuses 0.001 L and 1e-6 L before and after the bifurcation: somewhere in between the "
      "slope dF/dDelta is {} k/L^2 before and {} k/L^2 after",
      certified_decimal(before, 5), certified_decimal(after, 5));
}

Judgement number_of_shapes(const Printed& printed, const Premises& given, int) {
  const proofs::Census before = at_deflection(given, Rational(2, 100)),
                       after = at_deflection(given, Rational(2, 10));
  const bool always = types(before) == types(after);
  const bool right = Counts(printed.at(0)) == Counts(types(after));
  return {
      right && always ? Verdict::confirmed
      : right         ? Verdict::imprecise
                      : Verdict::refuted,
      right && always
          ? ""
          : fmt::format("from {} L on; before it {}", buckling(given).point.load.str(6), types(before)),
      {{EvidenceKind::interval,
        fmt::format("certified censuses at 0.02 L ({}) and 0.2 L ({}), no joint wound up; {} and {} boxes",
                    types(before), types(after), before.boxes, after.boxes)}},
      ""};
}

/// How the shape passes the bifurcation, with the evidence.
std::pair<std::string, std::vector<Evidence>> passage(const Premises& given) {
  const Interval at(buckling(given).point.load, buckling(given).point.load), off(Rational(1, 1000000));
  const proofs::Census before = at_deflection(given, at - off), after = at_deflection(given, at + off);
  bool continuous = types(before) == "1 stable, 1 unstable" && types(after) == "2 stable, 2 unstable";
  std::size_t segments = 0;
  double farthest = 0;
  const auto load = static_cast<double>(buckling(given).point.load);
  for (const proofs::PathCertificate& side : leaving(path(given), buckling(given), 0.1)) {
    continuous = continuous && side.regular();
    segments += side.segments;
    farthest = std::max(farthest, side.runs.empty() ? 1 : side.runs[0].from - load);
  }
  continuous = continuous && farthest < 1e-6;
  return {
      continuous ? "continuous" : "jump",
      {{EvidenceKind::interval,
        fmt::format("certified censuses 1e-6 L before ({}) and 1e-6 L after the value ({})", types(before),
                    types(after))},
       {EvidenceKind::interval,
        fmt::format("both sides of the branch that crosses there are smooth, stable and ahead, proved by {} "
                    "interval Newton segments from less than {:.0e} L behind the value up to 0.1 L",
                    segments, farthest)},
       {EvidenceKind::mp50, "bifurcation located by Newton's method in 64 digits"}}};
}

Judgement jump(const Printed& printed, const Premises& given, int digits) {
  const auto [found, evidence] = passage(given);
  Judgement result = judge_word(
      printed.at(0), found,
      "the zigzag loses its stability in a supercritical pitchfork bifurcation: two stable shapes, "
      "carried into each other by half a turn, leave it continuously, and the sudden change is one of "
      "stiffness, not of shape",
      evidence);
  result.value = located(buckling(given).point.load, digits);
  return result;
}

/// Whether the stiffness falls by half or more at the bifurcation.
std::string change_of_stiffness(const Premises& given) {
  const auto [before, after] = stiffnesses(given);
  return certainly_less(after * Interval(2), before) ? "reduces"
         : certainly_less(before, after)             ? "grows"
                                                     : "stays";
}

/// printed: what the shape does at the critical force, and the stiffness
Judgement sudden_change(const Printed& printed, const Premises& given, int) {
  auto [shape, evidence] = passage(given);
  evidence.push_back({EvidenceKind::interval, next_to_bifurcation(given)});
  const std::string stiffness = change_of_stiffness(given);
  Judgement result = judge_list(printed, {shape, stiffness},
                                "the stiffness " + stiffness +
                                    " at once; the shape goes over continuously, from Z to U by way "
                                    "of a straightened joint",
                                evidence);
  if (result.verdict == Verdict::refuted && printed == Printed{"jump", stiffness})
    result.verdict = Verdict::imprecise;
  return result;
}

Judgement smooth(const Printed& printed, const Premises& given, int digits) {
  const auto [before, after] = stiffnesses(given);
  Judgement result = judge_word(
      printed.at(0), certainly_less(after * Interval(10), before) ? "not smooth" : "smooth",
      "the slope does not jump",
      {{EvidenceKind::interval, next_to_bifurcation(given)},
       {EvidenceKind::mp50,
        "the bifurcation, located to fifty digits, is a pitchfork: the energy of the branch that crosses "
        "is less by c (Delta - Delta_c)^2 + …, c > 0, and the slope of F = dE/dDelta falls at once by 2c"}});
  result.value = located(buckling(given).point.load, digits);
  return result;
}

Judgement softens(const Printed& printed, const Premises& given, int) {
  return judge_word(printed.at(0), change_of_stiffness(given),
                    "the stiffness is not less after the bifurcation",
                    {{EvidenceKind::interval, next_to_bifurcation(given)}});
}

/// Whether the chain buckles, and one that is not symmetric.
Judgement bent_buckling(const Printed& printed, const Premises& given, int) {
  const auto buckles = [&](const char* const chain) {
    return held(given, chain).compressed(0.6).of_kind(EventKind::bifurcation).size();
  };
  const std::size_t symmetric = buckles("fig-8-chain"), other = buckles("fig-8-other");
  const std::string found = symmetric > 0 && other > 0 ? "all" : symmetric > 0 || other > 0 ? "some" : "none";
  return judge_word(printed.at(0), found, "it is " + found,
                    {path(given).evidence(), held(given, "fig-8-other").compressed(0.6).evidence()});
}

/// Where joint 2 straightens, and where the first angle passes zero.
proofs::Located arch(const Premises& given) {
  return straightens_at(path(given), 1, Rational(42, 1000), Rational(3, 10));
}
proofs::Located level(const Premises& given) {
  return straightens_at(path(given), 0, Rational(42, 1000), Rational(3, 10));
}

/// From which shape to which the chain changes where it buckles.
Judgement change_of_shape(const Printed& printed, const Premises& given, int digits) {
  const Rational before(4, 100), after(42, 1000);
  const std::string from = letter(reached(at_deflection(given, before), path(given), before)),
                    to = letter(reached(at_deflection(given, after), path(given), after));
  const bool right = printed.at(0) == from && printed.at(1) == to;
  const std::string later =
      letter(reached(at_deflection(given, Rational(3, 10)), path(given), Rational(3, 10)));
  Judgement result{
      right ? Verdict::confirmed : Verdict::refuted,
      right ? ""
            : fmt::format("where it buckles the shape is {} before and {} after; a joint straightens, "
                          "and the shape is {}, not before {} L",
                          from, to, later, arch(given).str(6)),
      {{EvidenceKind::interval,
        fmt::format("certified censuses at 0.04, 0.042 and 0.3 L: the slowly compressed chain is {}, {} "
                    "and {}",
                    from, to, later)},
       {EvidenceKind::mp50, "the joint angle's zero located in 64 digits"}},
      ""};
  result.value = located(arch(given), digits);
  return result;
}

std::string first_signs(const proofs::CertifiedEquilibrium& one) {
  return signs(one).substr(0, 2);
}

Judgement begins(const Printed& printed, const Premises& given, int) {
  const Rational some(1, 50), last(1, 25);
  const PlaneProof& plane = prove_in_plane(zigzag(given), 0, last);
  const proofs::Census census = at_deflection(given, some);
  const std::string pattern = first_signs(reached(census, path(given), some));
  const bool always =
      plane.whole && types(census) == "1 stable, 1 unstable" &&
      path(given).everywhere(0, last, [&](const auto& one) { return first_signs(one) == pattern; });
  return judge_word(
      printed.at(0), always ? pattern : "changing", "the signs of the first two angles are " + pattern,
      {{EvidenceKind::interval, plane.text() + "; certified census at 0.02 L: " + types(census)},
       {EvidenceKind::interval,
        "proved branch from 0 to 0.04 L, in enclosures of all its states: the signs of phi and "
        "of the bend at joint 2 are " +
            pattern}});
}

proofs::Located force_at(const Premises& given, const Rational& deflection) {
  return paper_force(path(given).at(deflection)).x;
}

Judgement critical_angle(const Printed& printed, const Premises& given, int digits) {
  const proofs::Located angle = buckling(given).point.theta(0);
  const Rational at = proofs::exactly(buckling(given).point.load), off(1, 1000000);
  bool negative = true;
  for (const auto& one : states(path(given), {Rational(at - off), Rational(at + off)}))
    negative = negative && certainly_less(one.q[0], Interval(Rational(-1, 10)));
  Judgement result = judge_word(
      printed.at(0), negative ? "negative" : "0",
      fmt::format(
          "at the critical force, {} k/L, the first angle is still {}; it passes zero at {} k/L, {} L, where "
          "nothing happens to the stiffness",
          paper_force(buckling(given).point).x.str(6), angle.str(8),
          force_at(given, proofs::exactly(level(given))).str(6), level(given).str(6)),
      {{EvidenceKind::interval,
        "certified censuses 1e-6 L before and after the bifurcation: the first angle is below -0.1"},
       {EvidenceKind::mp50, "theta_1 at the located bifurcation"}});
  result.value = located(angle, digits);
  return result;
}

/// The stiffness just before and just after the first angle is zero.
Judgement at_zero_angle(const Printed& printed, const Premises& given, int digits) {
  const Rational at = proofs::exactly(level(given)), off(1, 100);
  const std::vector<Interval> means =
      mean_stiffnesses(path(given), {Rational(at - off), at, Rational(at + off)});
  const std::string found =
      certainly_less(means[1] * Interval(Rational(11, 10)), means[0]) ? "reduces" : "does not";
  Judgement result = judge_word(
      printed.at(0), found,
      "the stiffness falls at the bifurcation, before; where phi = 0 it changes smoothly",
      {{EvidenceKind::interval,
        fmt::format(
            "certified censuses 0.01 L before, at and 0.01 L after phi = 0: mean stiffness {} and {} k/L^2",
            certified_decimal(means[0], 5), certified_decimal(means[1], 5))},
       path(given).evidence()});
  result.value = located(force_at(given, at), digits) + " k/L where phi = 0";
  return result;
}

/// On the branch that ends in U⁺, as the paper has it.
Judgement later_angle(const Printed& printed, const Premises& given, int digits) {
  const proofs::CertifiedEquilibrium here =
      reached(at_deflection(given, Rational(3, 10)), path(given), Rational(3, 10));
  if (letter(here) != "U⁺") throw Error("Fig. 8", letter(here) + " at 0.3 L", "U⁺");
  Judgement result = judge_word(
      printed.at(0), certainly_positive(here.q[0]) ? "positive" : "negative", "it stays negative",
      {{EvidenceKind::interval,
        "certified census at 0.3 L: on the branch that is U⁺ there; on its image by half a turn the angle is "
        "negative"},
       {EvidenceKind::mp50, fmt::format("it is zero at {} L, located in 64 digits", level(given).str(8))}});
  result.value = located(level(given), digits);
  return result;
}

/// Proved: the word for all states from 0.07 L until just before joint 2 straightens, and that for all from
/// just after it on; "++, then +-", or the one where they are the same.
std::string one_after_another(const Premises& given,
                              std::string (*word)(const proofs::CertifiedEquilibrium&)) {
  const Rational at = proofs::exactly(arch(given)), next(1, 200), last(3, 5);
  const auto of_all = [&](const Rational& from, const Rational& to) {
    const std::string found = word(states(path(given), {to}).front());
    const bool always = path(given).everywhere(from, to, [&](const auto& one) { return word(one) == found; });
    if (!always) throw Error("Fig. 9", "an open stretch of its path", "one word for all its states");
    return found;
  };
  const std::string before = of_all(Rational(7, 100), Rational(at - next)),
                    after = of_all(Rational(at + next), last);
  return before == after ? before : before + ", then " + after;
}

/// Imprecise where what is printed is one of several.
Judgement of_later_shapes(const Premises& given, const std::string& printed, const std::string& found,
                          const std::string& truth) {
  Judgement result = judge_word(
      printed, found, truth,
      {{EvidenceKind::interval,
        fmt::format(
            "proved branch from 0.07 L to 0.005 L before joint 2 straightens at {} L, and from 0.005 L after "
            "that to 0.6 L, in enclosures of all its states: {}",
            arch(given).str(6), found)}});
  if (result.verdict == Verdict::refuted && (found + ",").starts_with(printed + ","))
    result.verdict = Verdict::imprecise;
  return result;
}

Judgement later_name(const Printed& printed, const Premises& given, int) {
  const std::string found = one_after_another(given, letter);
  return of_later_shapes(given, printed.at(0), found,
                         found +
                             ": the bends keep their signs until one joint straightens, and have one "
                             "sign from there on; Figures 7 and 8 call that shape U⁺");
}

Judgement later_signs(const Printed& printed, const Premises& given, int) {
  const std::string found = one_after_another(given, first_signs);
  return of_later_shapes(given, printed.at(0), found,
                         "the signs of the first angle and of the bend at joint 2 are " + found);
}

/// The Z-chain up to its bifurcation.
Judgement first_part(const Printed& printed, const Premises& given, int) {
  const proofs::PathCertificate& proved = path(given).proved.front();
  bool stable = proved.certified() && proved.folds.empty() && !proved.runs.empty();
  for (const proofs::CertifiedRun& run : proved.runs)
    stable = stable &&
             (run.negative_directions == 0 || run.from >= static_cast<double>(buckling(given).point.load));
  return judge_word(printed.at(0), stable ? "continuous" : "open", "the shape does not change continuously",
                    {path(given).evidence()});
}

Judgement monotonic(const Printed& printed, const Premises& given, int) {
  const Rational before(4, 100), after(42, 1000);
  bool grows = certainly_less(-reached(at_deflection(given, before), path(given), before).fx,
                              -reached(at_deflection(given, after), path(given), after).fx);
  for (const proofs::PathCertificate& stretch : path(given).proved)
    grows = grows && stretch.certified() && stretch.stiff;
  return judge_word(printed.at(0), grows ? "monotonic" : "not monotonic", "the force falls somewhere",
                    {path(given).evidence(),
                     {EvidenceKind::interval,
                      "certified censuses at 0.04 and 0.042 L: the force grows across the bifurcation too"}});
}

Judgement local_minimum(const Printed& printed, const Premises& given, int) {
  bool equal = true;
  for (const Rational& d : {Rational(5, 100), Rational(2, 10), Rational(55, 100)}) {
    const proofs::Census census = at_deflection(given, d);
    const auto &a = census.equilibria.at(0), &b = census.equilibria.at(1);
    equal = equal && a.negative_directions == 0 && b.negative_directions == 0 &&
            !certainly_less(a.energy, b.energy);
  }
  return judge_word(
      printed.at(0), equal ? "equal" : "local",
      "both minima have the same energy at every deflection, for the chain turned by half a turn and "
      "read backwards is the same chain: neither is only local",
      {Evidence::by_theorem(
           "Reversal",
           "turned by half a turn and read backwards, three links with the rest angles (a, -a) "
           "and equal springs are the same chain"),
       {EvidenceKind::interval, "certified censuses at 0.05, 0.2 and 0.55 L: energies equal to 40 digits"}});
}

Judgement keeps(const Printed& printed, const Premises& given, int) {
  const auto& last = path(given).stretches.back();
  bool stays =
      path(given).stretches.size() == 2 && last.end == BranchEnd::load && path(given).proved.back().regular();
  stays = stays && path(given).everywhere(Rational(26, 100), Rational(3, 5),
                                          [](const auto& one) { return letter(one).front() == 'U'; });
  return judge_word(
      printed.at(0), stays ? "keeps" : "leaves", "it leaves the U-shape",
      {path(given).evidence(),
       {EvidenceKind::interval,
        "in enclosures of all its states from 0.26 to 0.6 L both bends have one sign: a U-shape"}});
}

}  // namespace

Checks claims::zigzag() {
  return {
      {"fig-8-smooth", smooth},
      {"fig-8-stiffness", softens},
      {"fig-8-jump", jump},
      {"fig-8-shapes", change_of_shape},
      {"fig-8-count", number_of_shapes},
      {"bent-buckling", bent_buckling},
      {"fig-9-begin", begins},
      {"fig-9-continuous", first_part},
      {"fig-9-angle", critical_angle},
      {"fig-9-softening", at_zero_angle},
      {"z-to-u-proved", sudden_change},
      {"fig-9-positive", later_angle},
      {"fig-9-name", later_name},
      {"fig-9-signs", later_signs},
      {"fig-9-monotonic", monotonic},
      {"fig-9-local", local_minimum},
      {"fig-9-keeps", keeps},
  };
}

}  // namespace plumbline::verify
