/// \file
/// `bench-simulate DIR [COUNT [SEED]]`: writes experiments of random layout and cause, simulated by the
/// diagnosis' own forward model, each a folder with its label. `plumbline trial --experiments DIR` scores a
/// diagnosis on them. They are what the thresholds and probabilities of the diagnosis were calibrated on;
/// agreement on them says nothing about the forward model itself.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <random>

#include "benchmarks/write_labelled.hpp"
#include "diagnose/inference/study.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::bench {
using namespace diagnose;
namespace {

using Random = std::mt19937_64;
using Json = nlohmann::json;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double log_between(Random& random, double low, double high) {
  return std::exp(between(random, std::log(low), std::log(high)));
}
bool chance(Random& random, double probability) {
  return between(random, 0, 1) < probability;
}
std::size_t choice(Random& random, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

struct Scenario {
  Experiment experiment;
  Json label;
};

/// U: bent one way; Z and W: zigzag, W more so; or nearly straight.
std::vector<double> rest_shape(Random& random, std::size_t n) {
  std::vector<double> rest(n);
  const double side = chance(random, 0.5) ? 1 : -1;
  const std::size_t kind = choice(random, 4);
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = i % 2 == 0 ? -1 : 1;
    const double plan[] = {i == 0 ? -0.5 : 1.0 / static_cast<double>(n - 1), (i == 0 ? 0.45 : 1) * turn,
                           (i == 0 ? 0.6 : 1.3) * turn, 0.1 * between(random, -1, 1)};
    rest[i] = side * 0.75 * plan[kind] * between(random, 0.9, 1.1);
  }
  return rest;
}

/// Load; load and unload; or a cycle and a half.
double load_share(std::size_t profile, double s) {
  if (profile == 0) return s;
  if (profile == 1) return 1 - std::abs(1 - 2 * s);
  return s < 1.0 / 3 ? 3 * s : (s < 2.0 / 3 ? 2 - 3 * s : 3 * s - 2);
}

/// A run that the nominal chain can follow without a snap.
std::optional<Run> draw_run(Random& random, const Experiment& experiment, std::size_t number) {
  double total = 0, stiffness = 0;
  for (const double length : experiment.link_length) total += length;
  for (const double k : experiment.joint_stiffness) stiffness = std::max(stiffness, k);
  Run run{fmt::format("run-{}", number), Control::end_point, {}, {}};
  run.rest = rest_shape(random, experiment.link_length.size());
  const bool force = experiment.joint_stiffness[0] > 0 && chance(random, 0.2);
  run.control = force ? Control::force : Control::end_point;
  const double angle = chance(random, 0.6) ? std::numbers::pi : between(random, 0, 2 * std::numbers::pi);
  const double size =
      force ? stiffness / total * between(random, 0.2, 0.9) : total * between(random, 0.04, 0.16);
  const Vector2 by = size * Vector2(std::cos(angle), std::sin(angle));
  const Vector2 start = force ? Vector2(0, 0) : unloaded_end(experiment, run.rest);
  const std::size_t profile = choice(random, 3), count = 25 + choice(random, 70);
  const double pause = log_between(random, 0.3, 5);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = load_share(profile, static_cast<double>(i) / static_cast<double>(count - 1));
    const Vector2 to = start + s * by;
    Reading reading{static_cast<double>(i) * pause, {0, 0, 0, 0}};
    (force ? reading[column_Fx] : reading[column_x]) = to.x();
    (force ? reading[column_Fy] : reading[column_y]) = to.y();
    run.readings.push_back(reading);
  }
  Experiment alone = experiment;
  alone.runs = {run};
  const Prediction nominal = predict(Study(alone), {}, {});
  if (!nominal.reached || nominal.snapped || !nominal.runs[0].allFinite()) return std::nullopt;
  return run;
}

Experiment draw_layout(Random& random) {
  Experiment experiment;
  const std::size_t n = 2 + choice(random, 5);
  const double length = log_between(random, 0.04, 0.4), stiffness = log_between(random, 0.2, 30);
  const bool equal_links = chance(random, 0.3), equal_springs = chance(random, 0.5);
  for (std::size_t i = 0; i < n; ++i) {
    experiment.link_length.push_back(length * (equal_links ? 1 : between(random, 0.7, 1.4)));
    experiment.joint_stiffness.push_back(stiffness * (equal_springs ? 1 : between(random, 0.6, 1.6)));
  }
  if (n > 2 && chance(random, 0.25)) experiment.joint_stiffness[0] = 0;
  experiment.link_mass.assign(n, 0);
  experiment.gravity = {0, 0};
  const std::size_t plane = choice(random, 3);
  experiment.bench = {
      plane == 0 ? Bench::Plane::vertical : (plane == 1 ? Bench::Plane::horizontal : Bench::Plane::unknown),
      {0, -1},
      plane == 0};
  const std::size_t runs = 1 + choice(random, 5);
  while (experiment.runs.size() < runs)
    if (auto run = draw_run(random, experiment, experiment.runs.size() + 1)) experiment.runs.push_back(*run);
  return experiment;
}

/// Declared noise: a share of what the nominal chain shows.
void declare_noise(Random& random, Experiment& experiment) {
  const Prediction nominal = predict(Study(experiment), {}, {});
  double force = 0, travel = 0;
  for (const Trace& trace : nominal.runs) {
    force = std::max({force, trace.col(column_Fx).abs().maxCoeff(), trace.col(column_Fy).abs().maxCoeff()});
    travel = std::max({travel, trace.col(column_x).maxCoeff() - trace.col(column_x).minCoeff(),
                       trace.col(column_y).maxCoeff() - trace.col(column_y).minCoeff()});
  }
  const double sharpness = log_between(random, 60, 500);
  experiment.noise = {travel / sharpness, travel / sharpness, force / sharpness, force / sharpness, 0};
  if (chance(random, 0.4)) {
    experiment.noise[Channel::Name::q] = log_between(random, 4e-4, 3e-3);
    for (Run& run : experiment.runs)
      for (Reading& reading : run.readings) reading[column_q + std::ssize(experiment.link_length) - 1] = 0;
  }
}

void write_readings(Experiment& experiment, const Prediction& predicted) {
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    Run& run = experiment.runs[r];
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      const auto row = predicted.runs[r].row(static_cast<Eigen::Index>(i));
      Reading& reading = run.readings[i];
      (run.control == Control::end_point ? reading[column_Fx] : reading[column_x]) =
          row(run.control == Control::end_point ? column_Fx : column_x);
      (run.control == Control::end_point ? reading[column_Fy] : reading[column_y]) =
          row(run.control == Control::end_point ? column_Fy : column_y);
      for (Eigen::Index c = column_q; c < std::ssize(reading.value); ++c) reading[c] = row(c);
    }
  }
}

/// Root mean square without the largest twentieth: a gap that a single reading holds is no gap to a lab.
double size_of(VectorXd values) {
  std::sort(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const Eigen::Index count = values.size() - values.size() / 20;
  return count == 0 ? 0 : values.head(count).norm() / std::sqrt(static_cast<double>(count));
}

/// One way in which the rig is not the nominal one: a rig for every run.
struct Cause {
  Json effects = Json::array();
  std::vector<Rig> rigs;
};

Prediction simulate_runs(const Experiment& experiment, const std::vector<Rig>& rigs) {
  Prediction all;
  for (std::size_t r = 0; r < rigs.size(); ++r) {
    Experiment alone = experiment;
    alone.runs = {experiment.runs[r]};
    Prediction one = simulate(alone, rigs[r], {});
    all.reached = all.reached && one.reached && one.runs[0].allFinite();
    all.snapped = all.snapped || one.snapped;
    all.runs.push_back(std::move(one.runs[0]));
  }
  return all;
}

/// Parameters of one effect at a size, in fitted coordinates, in a random direction of the parameters.
std::vector<double> parameters_at(Random random, const Experiment& experiment, const EffectAt& at,
                                  double size) {
  std::vector<double> values;
  for (const ParameterRange& range : Study(experiment).ranges(at)) {
    double value = size * range.scale * between(random, 0.5, 1);
    if (range.low < 0 && chance(random, 0.5)) value = -value;
    if (range.coordinate == Coordinate::logarithm) value = between(random, range.low + 1.5, range.high - 2.5);
    values.push_back(value);
  }
  if (at.effect->id == "joint_stop") {
    // The stop moves in as the effect grows.
    values[0] = between(random, 0.2, 0.6) / (1 + size);
    values[1] = Study(experiment).ranges(at)[1].scale * log_between(random, 0.5, 20);
  }
  return values;
}

/// Whether every parameter is well inside what is physical.
bool physical(const Experiment& experiment, const EffectAt& at, const std::vector<double>& values) {
  const std::vector<ParameterRange> ranges = Study(experiment).ranges(at);
  for (std::size_t p = 0; p < values.size(); ++p) {
    const double share = ranges[p].coordinate == Coordinate::logarithm ? 1 : 0.6;
    if (values[p] < share * ranges[p].low || values[p] > share * ranges[p].high) return false;
  }
  return true;
}

Json labelled(const Experiment& experiment, const EffectAt& at, const std::vector<double>& values) {
  Json parameters = Json::object();
  const auto ranges = Study(experiment).ranges(at);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    parameters[std::string(ranges[p].name)] = catalogue_value(ranges[p].coordinate, values[p]);
  return {{"id", at.effect->id},
          {"joint", at.joint > 0 ? Json(at.joint) : Json(nullptr)},
          {"parameters", parameters}};
}

Cause catalogue_cause(const Random& random, const Experiment& experiment,
                      const std::vector<EffectAt>& effects, double size) {
  Candidate candidate{effects};
  std::vector<double> all;
  Cause cause;
  for (const EffectAt& at : effects) {
    const std::vector<double> own = parameters_at(random, experiment, at, size);
    all.insert(all.end(), own.begin(), own.end());
    cause.effects.push_back(labelled(experiment, at, own));
  }
  cause.rigs.assign(experiment.runs.size(), rig_with(Study(experiment), candidate, all));
  return cause;
}

/// Outside the catalogue: what is constant there changes here from run to run, or differs from joint to
/// joint.
Cause foreign_cause(Random random, const Experiment& experiment, double size) {
  Cause cause;
  const std::size_t kind = choice(random, 4);
  const std::size_t joint = choice(random, experiment.link_length.size());
  double stiffness = 0, total = 0;
  for (const double k : experiment.joint_stiffness) stiffness = std::max(stiffness, k);
  for (const double length : experiment.link_length) total += length;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    Rig rig = nominal_rig(experiment);
    const double sign = r % 2 == 0 ? 1 : -1;
    if (kind == 0) rig.rest_error[joint] = sign * 0.02 * size;
    if (kind == 1) rig.force_gain = sign * 0.03 * size;
    if (kind == 2) rig.weight[joint] = sign * size * 0.05 * stiffness / total * Vector2(0.6, -0.8);
    if (kind == 3) rig.stiffness[joint] *= r % 2 == 0 ? 1 + 0.1 * size : 1 / (1 + 0.1 * size);
    cause.rigs.push_back(rig);
  }
  cause.effects.push_back({{"id", "unknown"},
                           {"joint", kind == 1 ? Json(nullptr) : Json(joint + 1)},
                           {"parameters", Json::object()},
                           {"kind", kind}});
  return cause;
}

/// Draws causes until one is followed by the rig at the wanted size; grows it until the gap is as large as
/// wanted, in root mean square of declared sigmas.
std::optional<Scenario> draw(std::uint64_t seed) {
  Random random(seed);
  Experiment experiment = draw_layout(random);
  declare_noise(random, experiment);
  const Prediction nominal = predict(Study(experiment), {}, {});
  write_readings(experiment, nominal);
  const Measurements measurements(experiment);
  const double wanted = log_between(random, 2.5, 25), kind = between(random, 0, 1);
  const std::vector<EffectAt> possible = possible_effects(Study(experiment));
  std::vector<EffectAt> effects;
  if (kind > 0.1) {
    // First the kind of effect, then its place.
    while (effects.size() < (kind > 0.97 ? 3U : kind > 0.85 ? 2U : 1U)) {
      const Effect* drawn = &catalogue()[choice(random, catalogue().size())];
      std::vector<EffectAt> places;
      for (const EffectAt& at : possible)
        if (at.effect == drawn && std::none_of(effects.begin(), effects.end(),
                                               [&](const EffectAt& other) { return other.effect == drawn; }))
          places.push_back(at);
      if (!places.empty()) effects.push_back(places[choice(random, places.size())]);
    }
  }
  const auto pressed = std::count_if(experiment.runs.begin(), experiment.runs.end(),
                                     [](const Run& run) { return run.control == Control::end_point; });
  const bool foreign = kind > 0.1 && kind < 0.18;
  if (foreign && pressed < 2) return std::nullopt;
  const Random frozen = random;
  Cause cause;
  double strength = 0;
  Prediction truth = nominal;
  if (!effects.empty()) {
    double low = 0, high = 0, size = 0.2;
    for (int i = 0; i < 40; ++i) {
      cause = foreign ? foreign_cause(frozen, experiment, size)
                      : catalogue_cause(frozen, experiment, effects, size);
      truth = simulate_runs(experiment, cause.rigs);
      strength = truth.reached && !truth.snapped ? size_of(measurements.residual(truth))
                                                 : std::numeric_limits<double>::infinity();
      if (std::abs(strength - wanted) < 0.02 * wanted) break;
      (strength < wanted ? low : high) = size;
      size = high == 0 ? 2 * size : (low + high) / 2;
      if (size > 1e3) break;
    }
    if (!(std::abs(strength - wanted) < 0.1 * wanted)) return std::nullopt;
    for (const EffectAt& at : effects) {
      if (foreign) break;
      if (!physical(experiment, at, parameters_at(frozen, experiment, at, size))) return std::nullopt;
      if (effects.size() == 1) break;
      // Of several, each is to be seen.
      const std::vector<Rig> alone = catalogue_cause(frozen, experiment, {at}, size).rigs;
      const double part = size_of(measurements.residual(simulate_runs(experiment, alone)));
      if (!(part > 0.4 * wanted)) return std::nullopt;
    }
  }
  write_readings(experiment, truth);
  return Scenario{experiment,
                  {{"effects", cause.effects}, {"equivalent", Json::array()}, {"strength_sigma", strength}}};
}

/// Makes readings of predictions: noise as labs have it.
void add_noise(Random& random, Scenario& scenario) {
  static const std::array<const char*, 4> kinds{"declared", "misdeclared", "outliers", "ar1"};
  const std::size_t kind = chance(random, 0.5) ? 0 : choice(random, 4);
  scenario.label["noise"] = kinds[kind];
  const double scale = kind == 1 ? log_between(random, 1 / 1.5, 1.5) : 1;
  const double phi = kind == 3 ? between(random, 0.3, 0.65) : 0;
  const bool quantised = chance(random, 0.3);
  Experiment& experiment = scenario.experiment;
  std::normal_distribution<double> normal;
  const Measurements measurements(experiment);
  for (const Series& series : measurements.series()) {
    double state = normal(random);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      if (i > 0) state = phi * state + std::sqrt(1 - phi * phi) * normal(random);
      double error = scale * state;
      if (kind == 2 && chance(random, 0.015)) error += 15 * between(random, -1, 1);
      Reading& reading = experiment.runs[series.run].readings[series.readings[i]];
      double& measured = series.channel.in(reading);
      const double sigma = measurements.sigma()(static_cast<Eigen::Index>(series.first + i));
      measured += sigma * error;
      if (quantised) measured = sigma / 3 * std::round(3 * measured / sigma);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: bench-simulate DIR [COUNT [SEED]]\n", stderr);
    return 2;
  }
  const std::size_t count = argc > 2 ? std::stoul(argv[2]) : 100;
  std::uint64_t seed = 1'000'000 * (argc > 3 ? std::stoul(argv[3]) : 1);
  for (std::size_t made = 0; made < count; ++seed) {
    std::optional<Scenario> scenario = draw(seed);
    if (!scenario) continue;
    scenario->experiment.name = fmt::format("simulated-{:04}", ++made);
    Random random(seed + 500'000);
    add_noise(random, *scenario);
    write_labelled(std::filesystem::path(argv[1]) / scenario->experiment.name, scenario->experiment,
                   scenario->label);
  }
  return 0;
}

}  // namespace plumbline::bench

int main(int argc, char** argv) {
  return plumbline::bench::main(argc, argv);
}
