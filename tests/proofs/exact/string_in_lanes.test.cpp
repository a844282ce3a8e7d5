#include "proofs/exact/string_in_lanes.hpp"

#include <plumbline/straight/bead_string.hpp>

#include "proofs/exact/exactly.hpp"
#include "proofs/exact/forces_in_lanes.hpp"
#include "tests/proofs/random_chain.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// The end of a string in fractions: its deflection or, where it is free, its slope; and the changes of sign.
struct ExactRun {
  Rational end;
  std::size_t below = 0;
};

ExactRun exact_run(const detail::StringPiece<Wide>& string, const Rational& F) {
  Rational h = 1, g = exactly(string.slope);
  ExactRun result;
  auto note = [&, last = true](const Rational& x) mutable {
    result.below += (x > 0) != last ? 1 : 0;
    last = x > 0;
  };
  for (std::size_t i = 0; i < string.mass.size(); ++i) {
    g -= F * exactly(string.mass[i]) * h;
    result.end = g;
    if (i == string.spacing.size()) break;
    h += exactly(string.spacing[i]) * g;
    result.end = h;
    note(h);
  }
  if (string.free_end()) note(g);
  return result;
}

}  // namespace

TEST_CASE("a run in lanes is that in fractions, with the first two coefficients in the change of the force") {
  check_property("eight links, any of them passive, in any units", [] {
    const auto units = [](int least, int most) {
      return Rational(mp::pow(Integer(2), static_cast<unsigned>(*rc::gen::inRange(least, most))));
    };
    std::vector<Rational> length, stiffness;
    const Rational long_unit = 1 / units(0, 60), stiff_unit = units(0, 60);
    for (int i = 0; i < 8; ++i) {
      length.push_back(long_unit * *rc::gen::inRange(1, 9));
      stiffness.push_back(stiff_unit * *rc::gen::inRange(1, 9));
    }
    const auto passive = *rc::gen::inRange<std::size_t>(0, 16);
    if (passive < 8) stiffness[passive] = 0;
    const Chain<Rational> chain(length, stiffness);
    const auto wide = from_rational<Wide>(chain);
    const detail::BeadString<Wide> string(wide);
    const std::vector<ForceInLanes> known = forces_in_lanes(chain, 1);
    RC_PRE(!known.empty());  // within the range of double
    const Wide lowest = known.front().value;
    std::vector<Wide> forces;
    for (int i = 0; i < 11; ++i) forces.push_back(lowest * Wide(*rc::gen::inRange(1, 1000)) / 100);
    forces[4] = 0;  // out of range: the others are as they were
    for (const auto& piece : string.pieces()) {
      const auto runs = run_in_lanes(StringInWords(piece), forces);
      RC_ASSERT(runs.size() == forces.size());
      for (std::size_t i = 0; i < forces.size(); ++i) {
        RC_ASSERT(runs[i].sound == (i != 4));
        if (i == 4) continue;
        const Rational F = exactly(forces[i]), step(1, mp::pow(Integer(10), 15));
        const ExactRun here = exact_run(piece, F);
        const Rational more = exact_run(piece, F * (1 + step)).end,
                       less = exact_run(piece, F * (1 - step)).end, slope = (more - less) / (2 * step),
                       curvature = (more - 2 * here.end + less) / (2 * step * step);
        RC_ASSERT(runs[i].below == here.below);
        // up to a positive factor; eight beads lose a few of the digits of a double
        const double sum = static_cast<double>(abs(here.end) + abs(slope) + abs(curvature)),
                     found =
                         std::abs(runs[i].end.high) + std::abs(runs[i].slope) + std::abs(runs[i].curvature);
        RC_ASSERT(std::abs(runs[i].end.high / found - static_cast<double>(here.end) / sum) < 1e-11);
        RC_ASSERT(std::abs(runs[i].slope / found - static_cast<double>(slope) / sum) < 1e-11);
        RC_ASSERT(std::abs(runs[i].curvature / found - static_cast<double>(curvature) / sum) < 1e-11);
      }
    }
  });
}

TEST_CASE("from beside a critical force a run leads to it, with the third power of the distance") {
  const Chain<Rational> chain({1, 2, 1, 3, 1, 2}, {2, 1, 3, 1, 2, 1});
  const auto wide = from_rational<Wide>(chain);
  const detail::BeadString<Wide> string(wide);
  const StringInWords words(string.pieces()[0]);
  for (const ForceInLanes& force : forces_in_lanes(chain, 5)) {
    for (const double off : {-5e-7, 5e-7}) {
      const Wide near = force.value * Wide(1 + off);
      const Wide found = refined(near, run_in_lanes(words, {near})[0]);
      // off^3 is 1e-19, of which there are a few tens; Newton's method alone leaves off^2, which is 1e-13
      CHECK(abs(Wide(found / force.value - 1)) < 1e-16);
    }
    // too far away nothing is changed
    const Wide far = force.value * Wide(1.01);
    CHECK(refined(far, run_in_lanes(words, {far})[0]) == far);
  }
}
