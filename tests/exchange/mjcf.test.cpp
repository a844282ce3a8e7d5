#include "exchange/mjcf.hpp"

#include <doctest/doctest.h>

#include "exchange/corrected.hpp"
#include "exchange/ways.hpp"
#include "tests/exchange/found.hpp"
#include "tests/exchange/mujoco_bench.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

/// What MuJoCo makes of a model in every run.
Prediction in_mujoco(Model model) {
  Prediction all;
  bool timed = false;
  for (const diagnose::NominalEffect& effect : model.experiment.effects)
    timed = timed || effect.id == "viscoelasticity" || effect.id == "relaxation_spectrum";
  for (const diagnose::Run& run : model.experiment.runs) {
    model.rest = run.rest;
    all.runs.push_back(test::MujocoBench(to_mjcf(model).text, timed).run(run));
  }
  return all;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
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
    const std::vector<double> amount = test::sizeable(bare, at);
    const Study study(with_readings(bare, at, amount));
    const auto models = corrected_models(study, test::found(study, at, amount));
    const double nominal = rms(study.nominal_residual()),
                 found = rms(study.residual(predict(study, {{at}}, amount))),
                 mujoco = rms(study.residual(in_mujoco(models.front().model)));
    MESSAGE(at.label() << ": nominal " << nominal << ", found " << found << ", in MuJoCo " << mujoco);
    // Of noise of size one, what MuJoCo adds is to be a third at most.
    CHECK(mujoco < 1.05 * found);
  }
}

}  // namespace plumbline::exchange
