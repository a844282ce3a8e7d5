#include "exchange/mjcf.hpp"

#include <doctest/doctest.h>

#include "exchange/corrected.hpp"
#include "exchange/ways.hpp"
#include "tests/exchange/found.hpp"
#include "tests/exchange/mujoco_bench.hpp"

namespace plumbline::exchange {
namespace {

constexpr double slowness = 5;

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

test::Pace pace_of(std::string_view effect) {
  if (effect == "viscoelasticity" || effect == "relaxation_spectrum") return test::Pace::by_the_clock;
  const bool slides = effect == "joint_friction" || effect == "friction_spread" || effect == "hysteresis";
  return slides ? test::Pace::on_the_way : test::Pace::at_rest;
}

/// What MuJoCo makes of a model in every run.
Prediction in_mujoco(Model model) {
  Prediction all;
  test::Pace pace = test::Pace::at_rest;
  for (const diagnose::NominalEffect& effect : model.experiment.effects)
    pace = std::max(pace, pace_of(effect.id));
  for (const diagnose::Run& run : model.experiment.runs) {
    model.rest = run.rest;
    all.runs.push_back(test::MujocoBench(to_mjcf(model).text, pace).run(run));
  }
  return all;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

bool takes_time(const EffectAt& at) {
  return pace_of(at.effect->id) == test::Pace::by_the_clock;
}

/// The bench; one that is so slow that dynamics is over long before anything relaxes.
Experiment bench_for(const EffectAt& at) {
  Experiment experiment = diagnose::test::full_bench();
  if (!takes_time(at)) return experiment;
  experiment.runs.resize(1);
  for (diagnose::Reading& reading : experiment.runs.front().readings) reading.t *= slowness;
  return experiment;
}

std::vector<double> amount_of(const Study& study, const EffectAt& at) {
  std::vector<double> amount = test::sizeable(study, at);
  if (!takes_time(at)) return amount;
  for (std::size_t tau = 1; tau < amount.size(); tau += 2) amount[tau] += std::log(slowness);
  return amount;
}

/// An amount of which much shows and no run snaps.
Experiment with_readings(const Study& study, const EffectAt& at, const std::vector<double>& amount) {
  return diagnose::test::measured(study.experiment(), {{at}}, amount, 1);
}

}  // namespace

TEST_CASE("what MJCF carries does in MuJoCo what the diagnosis found") {
  const Study bare(diagnose::test::full_bench());
  for (const EffectAt& at : possible_effects(bare)) {
    if (!way_of(Format::mjcf, at.effect->id).carried || at.joint == 1 || at.joint == 3) continue;
    CAPTURE(at.label());
    const Study own(bench_for(at));
    const std::vector<double> amount = amount_of(own, at);
    const Study study(with_readings(own, at, amount));
    const auto models = corrected_models(study, test::found(study, at, amount));
    const double nominal = rms(study.nominal_residual()),
                 found = rms(study.residual(predict(study, {{at}}, amount))),
                 mujoco = rms(study.residual(in_mujoco(models.front().model)));
    CAPTURE(nominal);
    // The noise has size one. What joints at rest add to it is to be less than half of it. Damping, which the
    // file has for the dynamics, drags beside dry friction: by a twentieth at the pace of the test.
    CHECK(nominal > 5);
    CHECK(
        mujoco * mujoco - found * found <
        std::max(0.25, pace_of(at.effect->id) == test::Pace::on_the_way ? std::pow(0.06 * nominal, 2) : 0.0));
  }
}

}  // namespace plumbline::exchange
