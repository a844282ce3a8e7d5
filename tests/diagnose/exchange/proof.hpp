#pragma once
/// \file
/// Whether a corrected model does in MuJoCo what the diagnosis says.

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string_view>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/exchange/corrected.hpp"
#include "diagnose/exchange/mjcf.hpp"
#include "diagnose/exchange/ways.hpp"
#include "tests/diagnose/exchange/found.hpp"
#include "tests/diagnose/exchange/mujoco_bench.hpp"

namespace plumbline::exchange::test {

using diagnose::Experiment, diagnose::Prediction;

inline Pace pace_of(std::string_view effect) {
  if (effect == "viscoelasticity" || effect == "relaxation_spectrum" || effect == "sensor_drift" ||
      effect == "sensor_lag")
    return Pace::by_the_clock;
  const bool slides = effect == "joint_friction" || effect == "friction_spread" || effect == "hysteresis" ||
                      effect == "guide_friction";
  return slides ? Pace::interpolated : Pace::at_rest;
}

inline bool takes_time(const EffectAt& at) {
  return pace_of(at.effect->id) == Pace::by_the_clock;
}

/// As what a format carries the effect, or why not.
inline Way way_of(const Study& study, Format format, const EffectAt& at) {
  diagnose::NominalEffect effect{at.effect->id, at.joint, {}};
  for (const diagnose::ParameterRange& range : study.ranges(at))
    effect.parameters[std::string(range.name)] = range.scale;
  return exchange::way_of(format, effect);
}

/// Each row once, at the joint in the middle of three where it has one.
inline std::vector<EffectAt> rows(const Study& study) {
  std::vector<EffectAt> all;
  for (const EffectAt& at : possible_effects(study))
    if (at.joint == 0 || at.joint == 2) all.push_back(at);
  return all;
}

/// The rows that a format carries: each third from the one with this
/// number on, so that what is not tried in one way is in another; all with PLUMBLINE_EFFECTS=all.
inline std::vector<EffectAt> carried(const Study& study, Format format, std::size_t first) {
  const char* asked = std::getenv("PLUMBLINE_EFFECTS");
  const bool all = asked != nullptr && std::string_view(asked) == "all";
  std::vector<EffectAt> taken;
  std::size_t count = 0;
  for (const EffectAt& at : rows(study)) {
    if (!way_of(study, format, at).carried) continue;
    if (const std::size_t number = count++; all || number % 3 == first) taken.push_back(at);
  }
  return taken;
}

/// What MuJoCo makes of a model in every run.
inline Prediction in_mujoco(Model model, Pace pace) {
  Prediction all;
  for (const diagnose::Run& run : model.experiment.runs) {
    model.rest = run.rest;
    all.runs.push_back(MujocoBench(to_mjcf(model).text, pace).run(run));
  }
  return all;
}

/// How much slower the bench is on which something relaxes: dynamics is over long before.
inline constexpr double slowness = 5;

inline Experiment bench_for(const EffectAt& at) {
  Experiment experiment = diagnose::test::full_bench();
  if (!takes_time(at)) return experiment;
  experiment.runs.pop_back();
  for (diagnose::Run& run : experiment.runs)
    for (diagnose::Reading& reading : run.readings) reading.t *= slowness;
  return experiment;
}

inline double rms(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

/// Root mean square of what two predictions differ by, in standard deviations of the noise.
inline double apart(const Study& study, const Prediction& a, const Prediction& b) {
  return rms(study.residual(a) - study.residual(b));
}

/// As much of the effect as nobody would miss.
inline std::vector<double> amount_of(const Study& study, const EffectAt& at) {
  std::vector<double> amount = sizeable(study, at);
  if (at.effect->id == "viscoelasticity" || at.effect->id == "relaxation_spectrum") {
    for (std::size_t tau = 1; tau < amount.size(); tau += 2) amount[tau] += std::log(slowness);
    return amount;
  }
  const auto moved = [&] { return apart(study, predict(study, {{at}}, amount), study.nominal()); };
  constexpr double plain = 6;
  while (moved() < plain)
    for (double& value : amount) value *= 2;
  return amount;
}

/// Residuals of readings that have the effect, in standard deviations of their noise.
struct Residuals {
  double nominal, found, mujoco;
};

/// Readings of the diagnosis' own model, and MuJoCo's with the written file.
inline Residuals residuals(const EffectAt& at) {
  const Study bare(bench_for(at));
  const std::vector<double> amount = amount_of(bare, at);
  const Study study(diagnose::test::measured(bare.experiment(), {{at}}, amount, 1));
  const Model model = corrected_models(study, found(study, at, amount)).front().model;
  return {rms(study.nominal_residual()), rms(study.residual(predict(study, {{at}}, amount))),
          rms(study.residual(in_mujoco(model, pace_of(at.effect->id))))};
}

/// The readings of a prediction with noise of the declared size.
inline Experiment read_with_noise(Experiment experiment, const Prediction& true_runs, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i)
      for (const diagnose::Channel& channel : experiment.runs[r].measured())
        channel.in(experiment.runs[r].readings[i]) =
            true_runs.runs[r](static_cast<Eigen::Index>(i), channel.column) +
            channel.sigma(experiment.noise) * normal(engine);
  return experiment;
}

}  // namespace plumbline::exchange::test
