#include "verify/chains/zigzag_path.hpp"

#include <fmt/core.h>

#include <cmath>
#include <plumbline/base/error.hpp>

#include "proofs/exact/exactly.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify::fig_8 {

HeldChain zigzag(const Premises& given) {
  return held(given, "fig-8-chain");
}

Rational last(const Premises& given) {
  return {static_cast<int>(std::ceil(2 * static_cast<double>(zigzag(given).reach.middle()))), 10};
}

const SlowPath& path(const Premises& given) {
  return zigzag(given).compressed(from_rational<double>(last(given)));
}

const BranchEvent<proofs::Located>& buckling(const Premises& given) {
  const auto& events = path(given).events;
  if (events.size() != 1 || events[0].kind != EventKind::bifurcation)
    throw Error("Fig. 8", fmt::format("{} events up to {}", events.size(), in_lengths(last(given))),
                "one bifurcation");
  return events[0];
}

Neighbourhood around(const Premises& given) {
  const Rational at = proofs::exactly(buckling(given).point.load);
  return {at, at / 40000, at / 40};
}

std::pair<Interval, Interval> stiffnesses(const Premises& given) {
  const auto [at, next, wide] = around(given);
  return {mean_stiffnesses(path(given), {Rational(at - wide), Rational(at - next)})[0],
          mean_stiffnesses(path(given), {Rational(at + next), Rational(at + wide)})[0]};
}

std::string next_to_bifurcation(const Premises& given) {
  const auto [before, after] = stiffnesses(given);
  const auto [at, next, wide] = around(given);
  return fmt::format(
      "certified censuses {} and {} before and after the bifurcation: somewhere in between the "
      "slope dF/dDelta is {} k/L^2 before and {} k/L^2 after",
      in_lengths(wide), in_lengths(next), certified_decimal(before, 5), certified_decimal(after, 5));
}

std::string change_of_stiffness(const Premises& given) {
  const auto [before, after] = stiffnesses(given);
  return certainly_less(after * Interval(2), before) ? "reduces"
         : certainly_less(before, after)             ? "grows"
                                                     : "stays";
}

proofs::Located arch(const Premises& given) {
  return straightens_at(path(given), 1, Rational(around(given).at + around(given).wide), last(given));
}

proofs::Located level(const Premises& given) {
  return straightens_at(path(given), 0, Rational(around(given).at + around(given).wide), last(given));
}

}  // namespace plumbline::verify::fig_8
