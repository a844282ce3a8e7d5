#include "diagnose/inference/screen.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("the screen forecasts what a fit then finds, for an effect so small that it acts linearly") {
  const Experiment bench = full_bench();
  for (const EffectAt& at : {EffectAt{"joint_stiffness", 2}, EffectAt{"gravity"}, EffectAt{"force_bias"},
                             EffectAt{"axial_compliance"}}) {
    CAPTURE(at.effect->id);
    std::vector<double> truth;
    for (const ParameterRange& range : Study(bench).ranges(at)) truth.push_back(0.05 * range.scale);
    const Experiment experiment = measured(bench, {{at}}, truth, 23);
    const Measurements measurements(experiment);
    const Fit nominal = fit_from(Study(experiment), {}, {}, {});
    const std::vector<Prospect> prospects = screen(Study(experiment), nominal, {});
    CHECK(prospects.size() == possible_effects(Study(experiment)).size());
    const auto forecast = std::find_if(prospects.begin(), prospects.end(),
                                       [&](const Prospect& one) { return one.effect == at; });
    REQUIRE(forecast != prospects.end());
    const Fit found = fit(Study(experiment), {{at}}, {});
    for (std::size_t p = 0; p < truth.size(); ++p)
      CHECK(forecast->from.front()[p] == close_to(found.parameters[p]).epsilon(0.1));
  }
}

TEST_CASE("beside one of two causes the screen names the other first") {
  const Candidate both{{{"joint_friction"}, {"rest_angle", 3}}};
  const Experiment experiment = measured(full_bench(), both, {0.02, 0.05}, 29);
  const Measurements measurements(experiment);
  for (std::size_t known : {0U, 1U}) {
    const Fit base = fit(Study(experiment), {{both.effects[known]}}, {});
    const std::vector<Prospect> prospects = screen(Study(experiment), base, {});
    // Values of every joint within their tolerance contain what one joint does.
    const auto first = std::find_if(prospects.begin(), prospects.end(), [&](const Prospect& one) {
      return Study(experiment).ranges(one.effect).front().tolerance == 0;
    });
    CHECK(first->effect.effect->id == both.effects[1 - known].effect->id);
    CHECK(first->effect.joint == both.effects[1 - known].joint);
  }
}

TEST_CASE("a newcomer counts for what it takes off tolerances that are stretched, and its fit begins there") {
  const EffectAt gravity{"gravity"};
  const Candidate machined{{{"stiffness_spread"}, {"length_spread"}, {"rest_spread"}}};
  const Study bench(full_bench());
  const Study study(measured(bench.experiment(), {{gravity}}, {0.1 * bench.ranges(gravity)[0].scale}, 37));
  const Fit stretched = fit(study, machined, {});
  const std::vector<Prospect> prospects = screen(study, stretched, {});
  const auto relief = std::find_if(prospects.begin(), prospects.end(),
                                   [&](const Prospect& one) { return one.effect == gravity; });
  REQUIRE(relief != prospects.end());
  Candidate both = machined;
  both.effects.push_back(gravity);
  const Fit relieved = fit(study, both, {}, {relief->from, 1});
  CAPTURE(stretched.cost);
  CHECK(relieved.cost < stretched.cost - 10);
  CHECK(relief->cost == close_to(relieved.cost).epsilon(0.02));
}

TEST_CASE("an effect that the runs never exercised forecasts nothing") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {0, 0.03}, 20, false);  // x never moves: the guide never rubs
  const Experiment noisy = measured(experiment, {}, {}, 31);
  const Study study(noisy);
  const Fit nominal = fit_from(study, {}, {}, {});
  for (const Prospect& one : screen(study, nominal, {})) {
    if (one.effect.effect != &effect("guide_friction")) continue;
    CHECK(one.cost == close_to(nominal.cost));
    CHECK(one.from.front().front() == 0);
  }
}
