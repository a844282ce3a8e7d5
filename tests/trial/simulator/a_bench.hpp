#pragma once
/// \file
/// A bench made by hand on which every effect can act: four unequal links, bent at rest, pressed and let go
/// in two runs.

#include <cmath>

#include "trial/simulator/simulation.hpp"

namespace plumbline::simulator {

inline Plan a_bench() {
  Plan plan;
  plan.nominal.length = {0.2, 0.22, 0.18, 0.2};
  plan.nominal.stiffness = {2, 1.6, 1.8, 1.2};
  plan.plane = Plane::vertical;
  plan.down = {0, -1};
  plan.angles_measured = true;
  const auto run = [&](const std::string& id, std::vector<double> rest, Pair way) {
    PlannedRun made{id, false, std::move(rest), {}};
    double theta = 0, x = 0, y = 0;
    for (std::size_t j = 0; j < plan.size(); ++j) {
      theta += made.rest[j];
      x += plan.nominal.length[j] * std::cos(theta), y += plan.nominal.length[j] * std::sin(theta);
    }
    constexpr int legs = 14;
    for (int i = 0; i <= 2 * legs; ++i) {
      const double share = 1 - std::abs(i - legs) / static_cast<double>(legs);
      made.commands.push_back({2.0 * i, {x + share * way[0], y + share * way[1]}});
    }
    plan.runs.push_back(std::move(made));
  };
  run("u-unloading-x-1", {0.6, -0.4, -0.35, -0.4}, {-0.12, 0});
  run("z-unloading-xy-2", {-0.3, 0.6, -0.5, 0.4}, {-0.08, 0.05});
  return plan;
}

}  // namespace plumbline::simulator
