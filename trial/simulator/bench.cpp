#include "trial/simulator/bench.hpp"

#include <cmath>
#include <plumbline/base/error.hpp>

#include "trial/simulator/draw_plan.hpp"
#include "trial/simulator/draw_scatter.hpp"

namespace plumbline::simulator {
namespace {

using States = std::vector<std::vector<State>>;

std::vector<Readings> show_all(const Plan& plan, const Physics& physics, const States& states) {
  std::vector<Readings> all;
  for (std::size_t r = 0; r < states.size(); ++r) all.push_back(show(plan, physics, plan.runs[r], states[r]));
  return all;
}

/// Whether the chain follows the load without a snap.
bool calm(const States& states) {
  constexpr double snap = 0.3;  // rad between two readings
  for (const auto& run : states) {
    for (std::size_t i = 1; i < run.size(); ++i)
      for (std::size_t j = 0; j < run[i].q.size(); ++j)
        if (std::abs(run[i].q[j] - run[i - 1].q[j]) > snap) return false;
  }
  return true;
}

}  // namespace

Scene scene_of(const Bench& bench) {
  Scene scene{bench.plan, bench.states, std::vector<double>(bench.plan.size(), 0), 0, 0, 1e9};
  for (std::size_t r = 0; r < bench.states.size(); ++r) {
    const PlannedRun& run = bench.plan.runs[r];
    for (const State& state : bench.states[r]) {
      scene.force = std::max(scene.force, std::hypot(state.force[0], state.force[1]));
      for (std::size_t j = 0; j < state.q.size(); ++j)
        scene.deflection[j] = std::max(scene.deflection[j], std::abs(state.q[j] - run.rest[j]));
    }
    scene.duration = std::max(scene.duration, run.commands.back().t);
    scene.sampling_interval = std::min(scene.sampling_interval, run.commands[1].t);
  }
  return scene;
}

std::optional<Bench> draw_bench(Random& random, bool rough) {
  constexpr double single_joint = 0.15;  // more often than laboratories publish it
  Bench bench;
  bench.plan = rough && random.chance(single_joint) ? draw_joint_plan(random) : draw_plan(random);
  const Physics physics = physics_of(bench.plan);
  bench.states = simulate(bench.plan, physics);
  if (!calm(bench.states)) return std::nullopt;
  bench.shown = show_all(bench.plan, physics, bench.states);
  const double force = scene_of(bench).force;
  bench.scatter =
      rough ? draw_rough_scatter(bench.plan, force, random) : draw_scatter(bench.plan, force, random);
  return bench;
}

double rms(const std::vector<Excess>& values) {
  double sum = 0;
  for (const Excess& one : values) sum += one.value * one.value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

Outcome outcome_of(const Bench& bench, std::vector<Effect> effects) {
  const Physics physics = physics_with(bench.plan, effects);
  const States states = simulate(bench.plan, physics);
  if (!calm(states)) throw Error("simulator: the chain snaps");
  Outcome outcome{std::move(effects), show_all(bench.plan, physics, states), {}};
  outcome.gap = gap(bench.plan, outcome.shown, bench.shown, bench.scatter.sigma);
  return outcome;
}

std::string key_of(const Effect& effect) {
  return trial::effect_key(std::string(effect.kind->id), effect.kind->at_joint ? effect.joint + 1 : 0);
}

}  // namespace plumbline::simulator
