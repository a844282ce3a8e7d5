#include "simulator/make_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <plumbline/base/error.hpp>

#include "simulator/draw_plan.hpp"
#include "simulator/nominal_error.hpp"

namespace plumbline::simulator {
namespace {

using States = std::vector<std::vector<State>>;

/// A bench that works without any effect.
struct Bench {
  Plan plan;
  States states;
  std::vector<Readings> shown;
  Scatter scatter;
};

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

Scene scene_of(const Bench& bench) {
  Scene scene{bench.plan, std::vector<double>(bench.plan.size(), 0), 0, 0, 1e9};
  for (std::size_t r = 0; r < bench.states.size(); ++r) {
    const PlannedRun& run = bench.plan.runs[r];
    for (const State& state : bench.states[r]) {
      scene.force = std::max(scene.force, std::hypot(state.force[0], state.force[1]));
      for (std::size_t j = 0; j < state.q.size(); ++j)
        scene.deflection[j] = std::max(scene.deflection[j], std::abs(state.q[j] - run.rest[j]));
    }
    scene.duration = std::max(scene.duration, run.commands.back().t);
    scene.pause = std::min(scene.pause, run.commands[1].t);
  }
  return scene;
}

/// What the lab declares is the true sigma rounded, or wrong by up to a factor of 1.5.
Scatter draw_scatter(const Plan& plan, double force, Random& random) {
  Scatter scatter;
  const double kind = random.uniform(0, 1);
  double wrong = 1;
  if (kind < 0.18) {
    scatter.kind = "misdeclared";
    wrong = random.log_uniform(1 / 1.5, 1.5);
  } else if (kind < 0.30) {
    scatter.kind = "outliers";
    scatter.outliers = random.uniform(0.01, 0.02);
  } else if (kind < 0.40) {
    scatter.kind = "ar1";
    scatter.correlation = random.uniform(0.4, 0.8);
  }
  const Sigma is{force / random.log_uniform(60, 900), plan.reach() * random.log_uniform(1e-4, 6e-4),
                 random.log_uniform(7e-4, 2e-3)};
  scatter.declared = {significant(is.force, 3), significant(is.position, 3), significant(is.angle, 3)};
  scatter.sigma = {scatter.declared.force * wrong, scatter.declared.position * wrong,
                   scatter.declared.angle * wrong};
  scatter.missing = random.chance(0.1) ? random.uniform(0.02, 0.06) : 0;
  scatter.resolution = random.uniform(0.1, 0.5);
  return scatter;
}

std::optional<Bench> draw_bench(Random& random) {
  Bench bench;
  bench.plan = draw_plan(random);
  const Physics physics = physics_of(bench.plan);
  bench.states = simulate(bench.plan, physics);
  if (!calm(bench.states)) return std::nullopt;
  bench.shown = show_all(bench.plan, physics, bench.states);
  bench.scatter = draw_scatter(bench.plan, scene_of(bench).force, random);
  return bench;
}

double rms(const std::vector<Excess>& values) {
  double sum = 0;
  for (const Excess& one : values) sum += one.value * one.value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Where the gap shows most: the channel with the largest share of its square, and others nearly as large.
std::string channels_of(const std::vector<Excess>& values) {
  std::map<std::string, double> share;
  for (const Excess& one : values) share[one.channel] += one.value * one.value;
  double largest = 0;
  for (const auto& [channel, square] : share) largest = std::max(largest, square);
  constexpr double nearly = 0.7;
  std::string names;
  for (const auto& [channel, square] : share)
    if (square >= nearly * largest) names += (names.empty() ? "" : ", ") + channel;
  return names;
}

/// The experiment under some effects, without scatter.
struct Outcome {
  std::vector<Effect> effects;
  std::vector<Readings> shown;
  std::vector<Excess> gap;
};

Outcome outcome_of(const Bench& bench, std::vector<Effect> effects) {
  const Physics physics = physics_with(bench.plan, effects);
  const States states = simulate(bench.plan, physics);
  if (!calm(states)) throw Error("rig: the chain snaps");
  Outcome outcome{std::move(effects), show_all(bench.plan, physics, states), {}};
  outcome.gap = gap(bench.plan, outcome.shown, bench.shown, bench.scatter.sigma);
  return outcome;
}

/// The effect at about the wanted strength; nothing where that is beyond what labs meet.
std::optional<Outcome> tuned(const Bench& bench, const Effect& drawn, double wanted) {
  constexpr double smallest = 5e-3;
  double factor = 1;
  for (int attempt = 0; attempt < 5; ++attempt) {
    Outcome outcome = outcome_of(bench, {drawn.scaled(factor)});
    const double strength = rms(outcome.gap);
    if (strength > 0.8 * wanted && strength < 1.25 * wanted) return outcome;
    const double next =
        std::clamp(factor * (strength > 0 ? wanted / strength : 10), smallest, drawn.kind->reach);
    if (next == factor) break;
    factor = next;
  }
  return std::nullopt;
}

/// How much two gaps look alike, up to a factor.
double likeness(const std::vector<Excess>& one, const std::vector<Excess>& other) {
  double product = 0;
  for (std::size_t i = 0; i < one.size(); ++i) product += one[i].value * other[i].value;
  return std::abs(product) / (rms(one) * rms(other) * static_cast<double>(one.size()));
}

std::string key_of(const Effect& effect) {
  return trial::effect_key(std::string(effect.kind->id), effect.kind->at_joint ? effect.joint + 1 : 0);
}

trial::TrueEffect label_of(const Effect& effect, double strength) {
  const bool known = effect.kind->id != "unknown";
  trial::TrueEffect label{
      std::string(effect.kind->id), effect.kind->at_joint ? effect.joint + 1 : 0, {}, strength};
  for (std::size_t p = 0; p < effect.values.size() && known; ++p)
    label.parameters.emplace_back(effect.kind->names[p], effect.values[p]);
  return label;
}

/// Whether yielding of the base along y shows.
bool yields_aside(const Bench& bench, const Outcome& outcome) {
  std::vector<Effect> along = outcome.effects;
  for (Effect& effect : along)
    if (effect.kind->id == "base_compliance") effect.values[1] = 0;
  const std::vector<Excess> rest =
      gap(bench.plan, outcome.shown, outcome_of(bench, along).shown, bench.scatter.sigma);
  return rms(rest) * std::sqrt(static_cast<double>(rest.size())) > 2;
}

/// What the catalogue itself says cannot be told apart: a payload from a tare error, always; the base's
/// yielding along x from the train's, while the end point is imposed, if nothing yields noticeably along y.
std::vector<std::vector<std::string>> equivalents(const Bench& bench, const Outcome& outcome) {
  const bool imposed = std::none_of(bench.plan.runs.begin(), bench.plan.runs.end(),
                                    [](const PlannedRun& run) { return run.force_controlled; });
  std::vector<std::vector<std::string>> all;
  for (std::size_t e = 0; e < outcome.effects.size(); ++e) {
    const std::string_view id = outcome.effects[e].kind->id;
    std::string_view other;
    if (id == "tip_payload") other = "force_bias";
    if (id == "train_compliance" && imposed) other = "base_compliance";
    if (id == "base_compliance" && imposed && !yields_aside(bench, outcome)) other = "train_compliance";
    if (other.empty()) continue;
    all.emplace_back();
    for (std::size_t k = 0; k < outcome.effects.size(); ++k)
      all.back().push_back(k == e ? std::string(other) : key_of(outcome.effects[k]));
  }
  return all;
}

Experiment finished(const Bench& bench, const Outcome& outcome, const std::vector<double>& alone,
                    const std::string& name, Random& random) {
  Experiment made{name, bench.plan, bench.scatter, {}, {}, std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t r = 0; r < bench.plan.runs.size(); ++r)
    made.runs.push_back(scattered(bench.plan.runs[r], outcome.shown[r], bench.scatter, random));
  made.label.name = name;
  made.label.noise = bench.scatter.kind;
  made.label.noise_scale = bench.scatter.sigma.force / bench.scatter.declared.force;
  made.label.strength = outcome.effects.empty() ? 0 : significant(rms(outcome.gap), 4);
  for (std::size_t e = 0; e < outcome.effects.size(); ++e) {
    made.label.effects.push_back(label_of(outcome.effects[e], significant(alone[e], 4)));
    made.label.description += outcome.effects[e].kind->description;
  }
  if (!made.label.description.empty()) made.label.channel = channels_of(outcome.gap);
  made.label.equivalent = equivalents(bench, outcome);
  const Sigma& sigma = bench.scatter.sigma;
  if (bench.plan.nominal.mass.empty())
    made.nominal_error =
        nominal_error(bench.plan, bench.states,
                      {sigma.force, sigma.position, bench.plan.angles_measured ? sigma.angle : 0});
  return made;
}

std::optional<Experiment> attempt(const Wish& wish, const std::string& name, Random& random) {
  const std::optional<Bench> bench = draw_bench(random);
  if (!bench) return std::nullopt;
  const Scene scene = scene_of(*bench);
  std::vector<Outcome> parts;
  std::vector<double> alone;
  for (std::size_t e = 0; e < wish.kinds.size(); ++e) {
    const Effect effect = draw_effect(*wish.kinds[e], scene, random);
    if (!effect.kind) return std::nullopt;
    std::optional<Outcome> part = tuned(*bench, effect, wish.strengths[e]);
    if (!part) return std::nullopt;
    alone.push_back(rms(part->gap));
    parts.push_back(std::move(*part));
  }
  if (parts.empty()) return finished(*bench, {{}, bench->shown, {}}, {}, name, random);
  if (parts.size() == 1) return finished(*bench, parts.front(), alone, name, random);
  constexpr double too_alike = 0.9;
  if (likeness(parts[0].gap, parts[1].gap) > too_alike) return std::nullopt;
  const Outcome both = outcome_of(*bench, {parts[0].effects.front(), parts[1].effects.front()});
  return finished(*bench, both, alone, name, random);
}

}  // namespace

Wish draw_wish(Random& random) {
  const double kind = random.uniform(0, 1);
  const auto known = [&] { return &random.one_of(catalogue()); };
  if (kind < 0.15) return {};
  if (kind < 0.75) return {{known()}, {random.log_uniform(2.2, 50)}};
  if (kind < 0.87) return {{&random.one_of(outside())}, {random.log_uniform(6, 50)}};
  const Kind *one = known(), *other = known();
  // With play and dry friction in one joint its equilibrium is not unique; the others add up to one effect.
  const auto undetermined = [&] {
    const auto are = [&](std::string_view a, std::string_view b) {
      return (one->id == a && other->id == b) || (one->id == b && other->id == a);
    };
    return one == other || are("backlash", "joint_friction") || are("tip_payload", "force_bias") ||
           are("base_compliance", "train_compliance");
  };
  while (undetermined()) other = known();
  return {{one, other}, {random.log_uniform(5, 40), random.log_uniform(5, 40)}};
}

Experiment make_experiment(const Wish& wish, const std::string& name, Random& random) {
  constexpr int patience = 400;
  for (int i = 0; i < patience; ++i) {
    try {
      if (std::optional<Experiment> made = attempt(wish, name, random)) return std::move(*made);
    } catch (const Error&) {  // a chain that buckles where it must not, or does not come to rest: another one
    }
  }
  throw Error("rig: no bench for experiment " + name + " in " + std::to_string(patience) + " attempts");
}

/// The wish comes first, so that benches where it cannot be granted do not make it rarer.
Experiment make_experiment(std::uint64_t seed, std::size_t number, const std::string& name) {
  Random random(seed, number);
  const Wish wish = draw_wish(random);
  return make_experiment(wish, name, random);
}

}  // namespace plumbline::simulator
