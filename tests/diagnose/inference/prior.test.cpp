#include "diagnose/inference/prior.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/diagnose/bench.hpp"

using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

double prior_of(const Study& study, const std::vector<EffectAt>& effects) {
  return std::exp(log_prior(study, {effects}));
}

}  // namespace

TEST_CASE("all single causes of the catalogue together have the share of single causes") {
  for (const Experiment& experiment : {full_bench(), three_links()}) {
    const Study study(experiment);
    double sum = 0;
    for (const EffectAt& at : possible_effects(study))
      if (!at.effect->is_tolerance) sum += prior_of(study, {at});
    // 0.75 without tolerances beside them, which are a fifth; what is left are tolerances alone, and orders.
    CHECK(sum < 0.75 * 0.8 + 1e-9);
    CHECK(sum > 0.75 * 0.8 * 0.7);
  }
}

TEST_CASE("a number that is wrong beside a cause is more probable than a second cause of another kind") {
  const Study study(full_bench());
  const EffectAt cause("backlash", 2), number("joint_stiffness", 1), other("joint_stop", 1);
  CHECK(prior_of(study, {cause, number}) > 2 * prior_of(study, {cause, other}));
  CHECK(prior_of(study, {cause, number}) < prior_of(study, {cause}));
  // In any order.
  CHECK(log_prior(study, {{cause, number}}) == doctest::Approx(log_prior(study, {{number, cause}})));
}

TEST_CASE("effects of time are untimed where time stamps count readings, and possible where they do not") {
  Experiment experiment = full_bench();
  CHECK(untimed_effects(Study(experiment)).empty());
  for (Run& run : experiment.runs)
    for (std::size_t i = 0; i < run.readings.size(); ++i) run.readings[i].t = static_cast<double>(i);
  const Study counted(experiment);
  const std::vector<EffectAt> untimed = untimed_effects(counted), possible = possible_effects(counted);
  CHECK_FALSE(untimed.empty());
  for (const EffectAt& at : untimed) CHECK(std::find(possible.begin(), possible.end(), at) == possible.end());
}
