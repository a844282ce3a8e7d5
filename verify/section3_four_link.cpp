/// \file
/// Section 3.2: four links under load, Table 1, Figures 11 to 14.

#include <fmt/core.h>

#include <algorithm>

#include "proofs/census.hpp"
#include "verify/claims.hpp"
#include "verify/judging.hpp"
#include "verify/section3_chains.hpp"

namespace plumbline {
namespace {

Judgement table1_place(const Chain<Interval>& chain, const Printed& printed) {
  const Point<Interval> p = end_point(chain, chain.rest());
  return judge_decimals(printed, {p.x, p.y}, {"x_0", "y_0"}, "direct kinematics at the printed angles");
}

/// Equilibria at 0.4 L on the sheet q_4 > 0: "1 minimum, 1 saddle, 1 maximum".
std::string sheet(const Census& census) {
  std::size_t count[3] = {0, 0, 0};
  for (const auto& one : census.equilibria) {
    const Interval q4 = sin(one.q[3]);
    if (!certainly_positive(q4) && !certainly_negative(q4))
      throw Error("census", "an open sign of q4", "a certain one");
    if (certainly_positive(q4)) ++count[one.negative_directions.value()];
  }
  return fmt::format("{} minima, {} saddles, {} maxima", count[0], count[1], count[2]);
}

Census at_04(const Chain<Interval>& chain) {
  Census census = census_at_end_point(chain, {Interval(Rational(34, 10)), Interval(0)});
  if (!census.complete()) throw Error("census", "undecided boxes", "a regular deflection");
  return census;
}

Judgement surface(const Chain<Interval>& chain, const Printed& printed) {
  const Census census = at_04(chain);
  const std::string found = sheet(census);
  return judge_word(
      printed.at(0), found, {printed.at(0), found},
      fmt::format("on the sheet q_4 > 0 there are {}; {} equilibria in all", found, census.equilibria.size()),
      {{EvidenceKind::interval,
        fmt::format("certified census at the end point (3.4, 0), {} boxes", census.boxes)}});
}

Judgement z_signs(const Printed& printed, int) {
  const Census census = at_04(z_shaped_chain());
  std::string signs;
  for (const Interval& q : census.equilibria.front().q)
    signs += certainly_positive(q) ? '+' : certainly_negative(q) ? '-' : '0';
  return judge_word(printed.at(0), signs, {printed.at(0), signs},
                    "the shape of least energy at 0.4 L has the signs " + signs,
                    {{EvidenceKind::interval, "certified census at the end point (3.4, 0)"}});
}

Judgement u_stiffness(const Printed& printed, int) {
  const QuasiBuckling path = quasi_buckling(u_shaped_chain());
  const bool falls = path.stable && path.points.empty() && path.last_stiffness < path.first_stiffness;
  return judge_word(
      printed.at(0), falls ? "decreasing" : "another", {"decreasing", "another"},
      "the tangent stiffness has a minimum on the way",
      {{EvidenceKind::mp50, fmt::format("stable path to 1.5 L, no stationary stiffness; from {} to {}",
                                        path.first_stiffness.str(6), path.last_stiffness.str(6))}});
}

Judgement z_quasi(const Printed& printed, int digits) {
  const QuasiBuckling path = quasi_buckling(z_shaped_chain());
  const std::string count = std::to_string(path.points.size());
  Judgement result = judge_word(
      printed.at(0), count, {printed.at(0), count}, count + " points of least stiffness up to 1.5 L",
      {{EvidenceKind::mp50,
        path.points.empty()
            ? std::string("none found")
            : fmt::format("least stiffness {} at {} L, at the start {}; the path is {}",
                          path.points[0].stiffness.str(8), path.points[0].load.str(8),
                          path.first_stiffness.str(6), path.stable ? "stable" : "not stable throughout")}});
  if (!path.points.empty()) result.value = path.points[0].load.str(std::min(digits, located_digits));
  return result;
}

}  // namespace

std::vector<Claim> loaded_four_link_claims() {
  return {
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
      {"fig-11-count",
       "3.2, Fig. 11",
       "the U-chain at 0.4 L, q4 > 0: one maximum, one minimum, one saddle",
       {"1 minima, 1 saddles, 1 maxima"},
       [](const Printed& printed, int) { return surface(u_shaped_chain(), printed); }},
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
       z_signs},
      {"fig-14-points", "3.2, Fig. 14", "a single quasi-buckling point was discovered", {"1"}, z_quasi},
  };
}

}  // namespace plumbline
