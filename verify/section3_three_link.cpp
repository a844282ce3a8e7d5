/// \file
/// Section 3.1: three links with a passive base under load, Figures 7 to 9.

#include <fmt/core.h>

#include <algorithm>

#include "proofs/census.hpp"
#include "verify/claims.hpp"
#include "verify/judging.hpp"
#include "verify/section3_chains.hpp"

namespace plumbline {
namespace {

const Rational u_alpha[] = {Rational(-1, 4), Rational(-1, 3)},
               z_alpha[] = {Rational(1, 10), Rational(-1, 10)};

Chain<Interval> u_chain() {
  return three_link_chain_at(u_alpha[0], u_alpha[1]);
}
Chain<Interval> z_chain() {
  return three_link_chain_at(z_alpha[0], z_alpha[1]);
}

/// All equilibria at a deflection, proved complete.
Census at_deflection(const Chain<Interval>& chain, const Rational& deflection) {
  Census census = census_at_end_point(chain, {unloaded_reach(chain) - Interval(deflection), Interval(0)});
  if (!census.complete()) throw Error("census", "undecided boxes", "a regular deflection");
  return census;
}

/// "2 stable, 2 unstable".
std::string types(const Census& census) {
  std::size_t stable = 0;
  for (const auto& one : census.equilibria) stable += one.negative_directions.value() == 0 ? 1 : 0;
  return fmt::format("{} stable, {} unstable", stable, census.equilibria.size() - stable);
}

std::string range_note(const Census& census) {
  return fmt::format("every shape, each with joint deflections of at most half a turn; {} boxes",
                     census.boxes);
}

Judgement u_count(const Printed& printed, int) {
  std::string found;
  std::size_t boxes = 0;
  for (const Rational& d : {Rational(1, 50), Rational(1, 20), Rational(1, 10)}) {
    const Census census = at_deflection(u_chain(), d);
    if (!found.empty() && found != types(census))
      found = "another";
    else
      found = types(census);
    boxes += census.boxes;
  }
  return judge_word(
      printed.at(0), found, {"2 stable, 2 unstable", "1 stable, 3 unstable", found},
      "at 0.02, 0.05 and 0.1 L there are " + found,
      {{EvidenceKind::interval, fmt::format("certified census at three deflections, {} boxes", boxes)}});
}

Judgement u_force(const Printed& printed, int) {
  bool least = true;
  for (const Rational& d : {Rational(1, 10), Rational(3, 10), Rational(6, 10)}) {
    const Census census = at_deflection(u_chain(), d);
    const auto& lowest = census.equilibria.front();  // by energy
    for (const auto& other : census.equilibria) {
      const Interval a = -lowest.fx, b = -other.fx;
      if (&other != &lowest && certainly_positive(b)) least = least && certainly_less(a, b);
    }
    least = least && lowest.negative_directions == 0;
  }
  return judge_word(printed.at(0), least ? "minimum" : "another", {"minimum", "another"},
                    "the shape of least energy has the least compression among those that are compressed",
                    {{EvidenceKind::interval, "certified censuses at 0.1, 0.3 and 0.6 L"}});
}

Judgement z_count(const Printed& printed, int) {
  const Census before = at_deflection(z_chain(), Rational(2, 100)),
               after = at_deflection(z_chain(), Rational(2, 10));
  const std::string found = types(before) == types(after) ? types(after) : "changes";
  return judge_word(printed.at(0), found, {"2 stable, 2 unstable", "changes", found},
                    fmt::format("at 0.02 L {}, at 0.2 L {}", types(before), types(after)),
                    {{EvidenceKind::interval, "certified censuses; " + range_note(after)}});
}

Judgement z_jump(const Printed& printed, int digits) {
  const ZigzagBuckling buckling = zigzag_buckling();
  const Census before = at_deflection(z_chain(), Rational(4, 100)),
               after = at_deflection(z_chain(), Rational(42, 1000));
  const bool pitchfork = types(before) == "1 stable, 1 unstable" && types(after) == "2 stable, 2 unstable";
  Judgement result = judge_word(
      printed.at(0), buckling.continuous && pitchfork ? "continuous" : "jump", {"jump", "continuous"},
      "the zigzag loses its stability in a supercritical pitchfork bifurcation: two mirrored stable shapes "
      "leave it "
      "continuously, and the sudden change is one of stiffness, not of shape",
      {{EvidenceKind::interval,
        "certified censuses at 0.04 L (" + types(before) + ") and 0.042 L (" + types(after) + ")"},
       {EvidenceKind::mp50,
        "bifurcation located by Newton's method; both sides of the crossing branch stable and ahead"}});
  result.value = buckling.point.load.str(std::min(digits, located_digits));
  return result;
}

Judgement z_angle(const Printed& printed, int digits) {
  const ZigzagBuckling buckling = zigzag_buckling();
  const Mpfr50 angle = buckling.point.theta(0);
  Judgement result =
      judge_word(printed.at(0), abs(angle) < Mpfr50("1e-40") ? "0" : "negative", {"0", "negative"},
                 "at the critical force the first angle is still " + angle.str(8) +
                     "; it passes zero later, and nothing happens to the stiffness there",
                 {{EvidenceKind::mp50, "theta_1 at the located bifurcation"}});
  result.value = angle.str(std::min(digits, located_digits));
  return result;
}

Judgement z_energy(const Printed& printed, int) {
  bool equal = true;
  for (const Rational& d : {Rational(5, 100), Rational(2, 10), Rational(55, 100)}) {
    const Census census = at_deflection(z_chain(), d);
    const auto &a = census.equilibria.at(0), &b = census.equilibria.at(1);
    equal = equal && a.negative_directions == 0 && b.negative_directions == 0 &&
            !certainly_less(a.energy, b.energy);
  }
  return judge_word(
      printed.at(0), equal ? "equal" : "local", {"local", "equal"},
      "both minima have the same energy at every deflection, for the chain turned by half a turn and "
      "read backwards is the same chain: neither is only local",
      {{EvidenceKind::interval, "certified censuses at 0.05, 0.2 and 0.55 L: energies equal to 40 digits"}});
}

}  // namespace

std::vector<Claim> loaded_three_link_claims() {
  return {
      {"fig-7-count",
       "3.1, Fig. 7",
       "the U-chain has two stable and two unstable equilibria",
       {"2 stable, 2 unstable"},
       u_count},
      {"fig-7-force",
       "3.1, Fig. 7",
       "the shape that is observed has the minimum compressive force",
       {"minimum"},
       u_force},
      {"fig-8-count",
       "3.1, Fig. 8",
       "the Z-chain too has four equilibria, two of them stable",
       {"2 stable, 2 unstable"},
       z_count},
      {"fig-8-jump", "3.1, Fig. 8", "the shape suddenly jumps from Z to U", {"jump"}, z_jump},
      {"fig-9-angle", "3.1, Fig. 9b", "at the critical force the first angle becomes zero", {"0"}, z_angle},
      {"fig-9-local",
       "3.1, Fig. 9e",
       "the observed shape can be a local instead of the global minimum",
       {"local"},
       z_energy},
  };
}

}  // namespace plumbline
