/// Each effect of an arm, planted, is found: it is named, and whatever is more probable predicts as much.
#include <iostream>

#include "diagnose/answers/diagnosis.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/arms.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

bool names_effect(const Diagnosis& diagnosis, const EffectAt& at) {
  for (std::size_t i = 0; i < diagnosis.cause.named; ++i)
    if (diagnosis.cause.ranking[i].cause.has(at)) return true;
  return false;
}

/// A size that shows, some scales of it.
std::vector<double> sizeable(const Study& study, const EffectAt& at) {
  std::vector<double> values;
  for (const ParameterRange& range : study.ranges(at)) {
    const double share = values.size() % 2 == 0 ? 1.0 : -0.6;
    values.push_back(std::clamp(share * range.scale, range.low, range.high));
  }
  return values;
}

}  // namespace

TEST_CASE("an arm without error has no gap") {
  const Experiment experiment = as_given(arm_bench(industrial_arm(), 40), {}, {}, 5);
  CHECK_FALSE(diagnose::diagnose(Study(experiment)).gap.present);
}

TEST_CASE("a wrong zero of the third joint of an arm is found, and how large it is") {
  const Experiment experiment = as_given(arm_bench(industrial_arm(), 40), only("rest_angle", 3), {0.003}, 7);
  const Study study(experiment);
  const Diagnosis diagnosis = diagnose::diagnose(study);
  REQUIRE(diagnosis.gap.present);
  REQUIRE(diagnosis.cause.named >= 1);
  CHECK(diagnosis.cause.ranking.front().cause.label() == "rest_angle(3)");
  const Estimate& found = diagnosis.estimates[0][0];
  CHECK(found.low < 0.003);
  CHECK(found.high > 0.003);
}

TEST_CASE(
    "each effect that is planted on an arm is named, and its own values are never better than those found" *
    doctest::test_suite("long")) {
  for (const NominalArm& arm : {industrial_arm(), collaborative_arm()}) {
    const Experiment bench = arm_bench(arm, 80, {.turns = true, .angles = true});
    const Study empty(bench);
    std::size_t planted = 0, named = 0;
    for (const EffectAt& at : possible_effects(empty)) {
      if (at.joint > 3 || at.effect->is_tolerance || at.effect->orders) continue;
      CAPTURE(at.label());
      const std::vector<double> truth = sizeable(empty, at);
      std::vector<double> values;
      const Study study(as_given(bench, {{at}}, truth, 11));
      const double strength =
          (study.nominal_residual() - Study(as_given(bench, {}, {}, 11)).nominal_residual()).norm();
      if (strength < 10) continue;  // no reading shows it
      const Diagnosis diagnosis = diagnose::diagnose(study);
      ++planted;
      named += names_effect(diagnosis, at);
      if (!names_effect(diagnosis, at)) {
        std::string said = verdict_word(diagnosis.cause.verdict);
        for (std::size_t i = 0; i < std::min<std::size_t>(3, diagnosis.cause.ranking.size()); ++i)
          said += ", " + diagnosis.cause.ranking[i].cause.label();
        MESSAGE(at.label() << " (" << strength << " sigma): " << said);
      }
      if (diagnosis.cause.ranking.empty()) continue;
      const double found = diagnosis.cause.ranking.front().hypothesis.residual.squaredNorm(),
                   true_squares = study.residual(predict(study, {{at}}, truth)).squaredNorm();
      CHECK(found < true_squares + 40);  // a simpler cause may be the more probable, with as many sigmas left
    }
    MESSAGE(named << " of " << planted << " named");
    CHECK(100 * named > 85 * planted);
  }
}
