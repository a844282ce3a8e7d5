#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <plumbline/base/error.hpp>

#include "trial/simulator/draw_plan.hpp"
#include "trial/simulator/nominal_error.hpp"

using namespace plumbline::simulator;

namespace {

/// Chains that buckle under an imposed force are left out: nominal statics has no unique answer there.
std::optional<std::vector<std::vector<State>>> states_of(const Plan& plan) {
  try {
    return simulate(plan, physics_of(plan));
  } catch (const plumbline::Error&) {
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("without an effect the simulator agrees with the nominal statics to a hundredth of the noise") {
  Random random(5, 1);
  double worst = 0;
  int benches = 0;
  while (benches < 20) {
    const Plan plan = draw_plan(random);
    if (!plan.nominal.mass.empty()) continue;
    const auto states = states_of(plan);
    if (!states) continue;
    double force = 0;
    for (const auto& run : *states)
      for (const State& state : run) force = std::max(force, std::hypot(state.force[0], state.force[1]));
    // the best instruments that experiments are drawn with
    const Sigma finest{force / 900, 1e-4 * plan.reach(), 7e-4};
    const double error = nominal_error(plan, *states, finest);
    CAPTURE(benches);
    CHECK(error < 0.01);
    worst = std::max(worst, error);
    ++benches;
  }
  MESSAGE("largest difference of 20 benches: " << worst << " sigma of the finest instruments");
}
