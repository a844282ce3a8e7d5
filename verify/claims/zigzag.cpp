/// \file
/// Section 3.1: the Z-chain of Figures 8 and 9, three links with a passive base.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "proofs/census/census.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/expression.hpp"
#include "verify/chains/loaded_chains.hpp"
#include "verify/chains/three_link_plane.hpp"
#include "verify/chains/zigzag_path.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/formula_value.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

using namespace fig_8;

template <class Deflection>
const proofs::Census& at_deflection(const Premises& given, const Deflection& deflection) {
  return zigzag(given).at(deflection);
}

Judgement number_of_shapes(const Printed& printed, const Premises& given, int) {
  const Rational early = around(given).at / 2, late = 5 * around(given).at;
  const proofs::Census before = at_deflection(given, early), after = at_deflection(given, late);
  const bool always = types(before) == types(after);
  const bool right = Counts(printed.at(0)) == Counts(types(after));
  return {right && always ? Verdict::confirmed
          : right         ? Verdict::imprecise
                          : Verdict::refuted,
          right && always
              ? ""
              : fmt::format("from {} L on; before it {}", buckling(given).point.load.str(6), types(before)),
          {{EvidenceKind::interval,
            fmt::format("certified censuses at {} ({}) and {} ({}), no joint wound up; {} and {} boxes",
                        in_lengths(early), types(before), in_lengths(late), types(after), before.boxes,
                        after.boxes)}},
          ""};
}

/// How the shape passes the bifurcation, with the evidence.
std::pair<std::string, std::vector<Evidence>> passage(const Premises& given) {
  const auto [at, next, wide] = around(given);
  const Rational far = std::min<Rational>(5 * at / 2, last(given));
  const proofs::Census before = at_deflection(given, Rational(at - next)),
                       after = at_deflection(given, Rational(at + next));
  bool continuous = types(before) == "1 stable, 1 unstable" && types(after) == "2 stable, 2 unstable";
  std::size_t segments = 0;
  double farthest = 0;
  const auto load = static_cast<double>(buckling(given).point.load);
  for (const proofs::PathCertificate& side :
       leaving(path(given), buckling(given), from_rational<double>(far))) {
    continuous = continuous && side.regular();
    segments += side.segments;
    farthest = std::max(farthest, side.runs.empty() ? 1 : side.runs[0].from - load);
  }
  continuous = continuous && farthest < from_rational<double>(next);
  return {
      continuous ? "continuous" : "jump",
      {{EvidenceKind::interval, fmt::format("certified censuses {} before ({}) and after the value ({})",
                                            in_lengths(next), types(before), types(after))},
       {EvidenceKind::interval,
        fmt::format("both sides of the branch that crosses there are smooth, stable and ahead, proved by {} "
                    "interval Newton segments from less than {:.0e} L behind the value up to {}",
                    segments, farthest, in_lengths(far))},
       {EvidenceKind::mp50, fmt::format("bifurcation located by Newton's method in {} digits",
                                        std::numeric_limits<proofs::Located>::digits10)}}};
}

Judgement jump(const Printed& printed, const Premises& given, int digits) {
  const auto [found, evidence] = passage(given);
  Judgement result = judge_word(
      printed.at(0), found == "jump" ? "suddenly jumps" : "passes continuously",
      "the chain loses its stability in a supercritical pitchfork bifurcation, which two stable shapes leave "
      "continuously: the sudden change is one of stiffness, not of shape",
      evidence);
  result.value = located(buckling(given).point.load, digits);
  return result;
}

/// Half a turn carries the chain of rest angles (a, b) into that of (-b, -a), read from its other end.
bool is_its_half_turn(const Premise& chain) {
  const auto &length = chain.parts.at("length"), &k = chain.parts.at("stiffness"),
             &rest = chain.parts.at("rest");
  const proofs::Formulas names({"pi"});
  const auto zero = [&](const std::string& formula) { return proofs::identical(names.parse(formula), 0); };
  const auto minus = [&](const std::string& a, const std::string& b) {
    return zero(with_fractions("(" + a + ")-(" + b + ")"));
  };
  return length.size() == 3 && minus(length[0], length[2]) && zero(with_fractions(k[0])) &&
         minus(k[1], k[2]) && zero(with_fractions("(" + rest[1] + ")+(" + rest[2] + ")"));
}

/// printed: what the shape does at the critical force, and the stiffness
Judgement sudden_change(const Printed& printed, const Premises& given, int) {
  auto [shape, evidence] = passage(given);
  evidence.push_back({EvidenceKind::interval, next_to_bifurcation(given)});
  const std::string stiffness = change_of_stiffness(given);
  const std::string how = shape == "jump" ? "suddenly" : "continuously",
                    what = stiffness == "reduces" ? "reduce" : "keep";
  Judgement result =
      judge_list(printed, {how, what},
                 fmt::format("the stiffness {} at once; the shape changes {}, from Z to U by way of "
                             "a straightened joint",
                             stiffness, how),
                 evidence);
  if (result.verdict == Verdict::refuted && printed == Printed{"suddenly", what})
    result.verdict = Verdict::imprecise;
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
    return held(given, chain)
        .compressed(from_rational<double>(last(given)))
        .of_kind(EventKind::bifurcation)
        .size();
  };
  const std::size_t symmetric = buckles("fig-8-chain"), other = buckles("fig-8-other");
  const std::string found = symmetric > 0 && other > 0 ? "all" : symmetric > 0 || other > 0 ? "some" : "none";
  return judge_word(printed.at(0), found, "it is " + found,
                    {path(given).evidence(),
                     held(given, "fig-8-other").compressed(from_rational<double>(last(given))).evidence()});
}

/// The shapes before the bifurcation and at the end of the path.
Judgement change_of_shape(const Printed& printed, const Premises& given, int digits) {
  const auto [at, next, wide] = around(given);
  const auto shape = [&](const Rational& d) {
    return letter(reached(at_deflection(given, d), path(given), d));
  };
  const Rational before = at - wide, after = at + wide;
  const std::string from = shape(before), just = shape(after), to = shape(last(given));
  Judgement result = judge_list(
      printed, {from, to}, fmt::format("it is {} before and {} in the end", from, to),
      {{EvidenceKind::interval,
        fmt::format("certified censuses at {}, {} and {}: the slowly compressed chain is {}, {} and {}",
                    in_lengths(before), in_lengths(after), in_lengths(last(given)), from, just, to)},
       {EvidenceKind::mp50, "the joint angle's zero, by bisection between certified states"}});
  result.value = located(arch(given), digits);
  return result;
}

std::string first_signs(const proofs::CertifiedEquilibrium& one) {
  return signs(one).substr(0, 2);
}

Judgement begins(const Printed& printed, const Premises& given, int) {
  const Rational end = around(given).at - around(given).wide, some = end / 2;
  const PlaneProof& plane = prove_in_plane(zigzag(given), 0, end);
  const proofs::Census census = at_deflection(given, some);
  const std::string pattern = first_signs(reached(census, path(given), some));
  const bool alone = plane.whole && Counts(types(census)).of("stable") == 1;
  const bool always =
      path(given).everywhere(0, end, [&](const auto& one) { return first_signs(one) == pattern; });
  if (!plane.whole) throw Error("Fig. 9a", "an open range of deflections", "a proof in the plane");
  return judge_word(
      printed.at(0), alone && always ? pattern : "changing",
      alone && always ? "the signs of the first two angles are " + pattern
                      : "they change, or another shape is stable",
      {{EvidenceKind::interval,
        fmt::format("{}; certified census at {}: {}", plane.text(), in_lengths(some), types(census))},
       {EvidenceKind::interval,
        fmt::format(
            "proved branch from 0 to {}, in enclosures of all its states: the signs of phi and of the bend "
            "at joint 2 are {}",
            in_lengths(end), pattern)}});
}

/// The first angle and the stiffness where the chain buckles.
Judgement critical_state(const Printed& printed, const Premises& given, int digits) {
  const auto [at, next, wide] = around(given);
  const proofs::Located angle = buckling(given).point.theta(0);
  std::string signs_there;
  for (const auto& one : states(path(given), {Rational(at - next), Rational(at + next)}))
    signs_there += sign_character(one.q[0]);
  const std::string word = signs_there == "--"   ? "is still negative"
                           : signs_there == "++" ? "is already positive"
                                                 : "becomes equal to zero",
                    stiffness =
                        change_of_stiffness(given) == "reduces" ? "essentially reduces" : "does not reduce";
  const proofs::Located zero = level(given);
  Judgement result = judge_list(
      printed, {word, stiffness},
      fmt::format(
          "at the critical force, {} k/L, the stiffness {} and the first angle is {}; it is zero after "
          "it, at {} k/L",
          paper_force(buckling(given).point).x.str(6), stiffness, angle.str(8),
          paper_force(path(given).at(proofs::exactly(zero))).x.str(6)),
      {{EvidenceKind::interval,
        fmt::format(
            "certified censuses {} before and after the bifurcation: the first angle has the signs {}",
            in_lengths(next), signs_there)},
       {EvidenceKind::interval, next_to_bifurcation(given)},
       {EvidenceKind::mp50, "theta_1 at the located bifurcation, and where it is zero"}});
  // "after" the force has reached it: later is meant
  if (result.verdict == Verdict::refuted && printed == Printed{"becomes equal to zero", stiffness})
    result.verdict = Verdict::convention;
  result.value = located(angle, digits);
  return result;
}

/// The first angle on the branch that is followed, after it has passed zero.
Judgement later_angle(const Printed& printed, const Premises& given, int digits) {
  const proofs::CertifiedEquilibrium here =
      reached(at_deflection(given, last(given)), path(given), last(given));
  Judgement result = judge_word(
      printed.at(0), certainly_positive(here.q[0]) ? "positive" : "negative", "it stays negative",
      {{EvidenceKind::interval,
        fmt::format(
            "certified census at {}, on the branch that is {} there; on its image by half a turn the angle "
            "has the other sign",
            in_lengths(last(given)), letter(here))},
       {EvidenceKind::mp50, fmt::format("it is zero at {} L", level(given).str(8))}});
  result.value = located(level(given), digits);
  return result;
}

/// The word for all states from where the first angle has passed zero until joint 2 straightens, proved next
/// to these; the states from there on have another.
Judgement of_positive_angle(const Premises& given, const std::string& printed,
                            std::string (*word)(const proofs::CertifiedEquilibrium&)) {
  const Rational from = proofs::exactly(level(given)), to = proofs::exactly(arch(given)),
                 next = (to - from) / 40;
  const std::string found = word(states(path(given), {Rational(to - next)}).front()),
                    later = word(states(path(given), {last(given)}).front());
  const bool always = path(given).everywhere(Rational(from + next), Rational(to - next),
                                             [&](const auto& one) { return word(one) == found; });
  if (!always) throw Error("Fig. 9", "an open stretch of its path", "one word for all its states");
  return judge_word(
      printed, found, fmt::format("it is {}, and {} after joint 2 has straightened", found, later),
      {{EvidenceKind::interval,
        fmt::format("proved branch from {} to {}, between the zeros of the first angle and of joint "
                    "2, in enclosures of all its states: {}; at {}: {}",
                    in_lengths(Rational(from + next)), in_lengths(Rational(to - next)), found,
                    in_lengths(last(given)), later)}});
}

Judgement later_name(const Printed& printed, const Premises& given, int) {
  return of_positive_angle(given, printed.at(0), letter);
}

Judgement later_signs(const Printed& printed, const Premises& given, int) {
  return of_positive_angle(given, printed.at(0), first_signs);
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
  const auto [at, next, wide] = around(given);
  const Rational before = at - wide, after = at + wide;
  bool grows = certainly_less(-reached(at_deflection(given, before), path(given), before).fx,
                              -reached(at_deflection(given, after), path(given), after).fx);
  for (const proofs::PathCertificate& stretch : path(given).proved)
    grows = grows && stretch.certified() && stretch.stiff;
  return judge_word(
      printed.at(0), grows ? "monotonic" : "not monotonic", "the force falls somewhere",
      {path(given).evidence(),
       {EvidenceKind::interval,
        fmt::format("certified censuses at {} and {}: the force grows across the bifurcation too",
                    in_lengths(before), in_lengths(after))}});
}

/// Whether the two stable shapes beyond the bifurcation have equal energies: they do where half a turn
/// carries the chain into itself, and are told apart by certified energies where it does not.
Judgement local_minimum(const Printed& printed, const Premises& given, int) {
  const Rational at = around(given).at;
  const bool symmetric = is_its_half_turn(given.at("fig-8-chain"));
  std::vector<std::string> where;
  bool higher = false, stable = true;
  for (const Rational& d : {Rational(5 * at / 4), Rational(5 * at), last(given)}) {
    const proofs::Census census = at_deflection(given, d);
    const auto &a = census.equilibria.at(0), &b = census.equilibria.at(1);
    stable = stable && a.negative_directions == 0 && b.negative_directions == 0;
    higher = higher || certainly_less(a.energy, b.energy);
    where.push_back(fmt::format("{}: {} and {}", in_lengths(d), a.energy.text(8), b.energy.text(8)));
  }
  if (!stable || symmetric == higher)
    throw Error("Fig. 9e", "energies that are not told apart", "a certain order");
  return judge_word(
      printed.at(0),
      symmetric ? "one of two minima of equal energy"
                : "the local (instead of the global) minimum of the potential energy",
      symmetric
          ? "the two minima have the same energy at every deflection: half a turn carries the chain into "
            "itself, read from its other end, and one minimum into the other"
          : "the minima have different energies",
      {Evidence::by_theorem(
           "Reversal",
           fmt::format("turned by half a turn and read backwards three links on a passive base with "
                       "the rest angles (a, b) are those with (-b, -a): this chain is {}itself",
                       symmetric ? "" : "not ")),
       {EvidenceKind::interval,
        fmt::format("certified censuses, energies of the two stable shapes at {}", fmt::join(where, "; "))}});
}

Judgement keeps(const Printed& printed, const Premises& given, int) {
  const auto& end = path(given).stretches.back();
  const Rational straight = proofs::exactly(arch(given)), from = straight + (last(given) - straight) / 80;
  bool stays =
      path(given).stretches.size() == 2 && end.end == BranchEnd::load && path(given).proved.back().regular();
  stays = stays && path(given).everywhere(from, last(given),
                                          [](const auto& one) { return letter(one).front() == 'U'; });
  return judge_word(
      printed.at(0), stays ? "keeps" : "leaves", "it leaves the U-shape",
      {path(given).evidence(),
       {EvidenceKind::interval,
        fmt::format("in enclosures of all its states from {} to {} both bends have one sign, a U-shape: {}",
                    in_lengths(from), in_lengths(last(given)), stays)}});
}

}  // namespace

Checks claims::zigzag() {
  return {
      {"fig-8-stiffness", softens},
      {"fig-8-jump", jump},
      {"fig-8-shapes", change_of_shape},
      {"fig-8-count", number_of_shapes},
      {"bent-buckling", bent_buckling},
      {"fig-9-begin", begins},
      {"fig-9-continuous", first_part},
      {"fig-9-critical", critical_state},
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
