#include "diagnose/decision/posterior.hpp"

#include <doctest/doctest.h>

#include "tests/diagnose/bench.hpp"

using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Of readings of the nominal chain that scatter so many times as much as is declared.
Posterior with_noise(double times) {
  Experiment experiment = measured(full_bench(), {}, {}, 11);
  Noise& declared = experiment.noise;
  for (double* one : {&declared.x, &declared.y, &declared.Fx, &declared.Fy, &declared.q}) *one /= times;
  const Study study(experiment);
  return posterior(study, search(study));
}

}  // namespace

// Both densities of the scale, that of a nugget and that of noise (docs/how-it-decides.md), are equal at
// about four times.
TEST_CASE("a scatter of many times the declared noise is no noise") {
  for (const double times : {1.0, 2.0}) CHECK(with_noise(times).no_gap > 0.5);
  for (const double times : {8.0, 25.0}) {
    const Posterior found = with_noise(times);
    CHECK(found.no_gap < 0.5);
    CHECK(found.outside > 0.5);
  }
}
