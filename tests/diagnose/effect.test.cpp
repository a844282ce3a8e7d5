#include "diagnose/effect.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/error.hpp>

#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::test;

namespace {

bool has(const std::vector<EffectAt>& effects, EffectId effect, std::size_t joint = 0) {
  return std::find(effects.begin(), effects.end(), EffectAt{effect, joint}) != effects.end();
}

}  // namespace

TEST_CASE("weight has no part in a horizontal plane, and may have in an unknown one") {
  Experiment experiment = full_bench();
  for (const auto& [plane, heavy] :
       {std::pair(Bench::Plane::horizontal, false), std::pair(Bench::Plane::vertical, true),
        std::pair(Bench::Plane::unknown, true)}) {
    experiment.bench.plane = plane;
    const auto possible = possible_effects(experiment);
    CHECK(has(possible, EffectId::gravity) == heavy);
    CHECK(has(possible, EffectId::tip_payload) == heavy);
    CHECK(has(possible, EffectId::force_gain));
  }
}

TEST_CASE("a passive joint has no spring to be wrong, nor play in one") {
  Experiment experiment = full_bench();
  experiment.joint_stiffness[0] = 0;
  const auto possible = possible_effects(experiment);
  for (const EffectId effect : {EffectId::joint_stiffness, EffectId::rest_angle, EffectId::backlash}) {
    CHECK_FALSE(has(possible, effect, 1));
    CHECK(has(possible, effect, 2));
  }
  CHECK(has(possible, EffectId::link_length, 1));
}

TEST_CASE("names and ids of the catalogue are each other's inverse") {
  for (std::size_t e = 0; e < effect_count; ++e) {
    const auto effect = static_cast<EffectId>(e);
    CHECK(effect_id(effect_name(effect)) == effect);
  }
  CHECK_THROWS_AS((void)effect_id("elbow grease"), Error);
}

TEST_CASE("fitted coordinates and the catalogue's units are each other's inverse") {
  for (const Coordinate coordinate : {Coordinate::plain, Coordinate::logarithm, Coordinate::reciprocal})
    CHECK(catalogue_value(coordinate, fitted_value(coordinate, 0.37)) == doctest::Approx(0.37));
  CHECK(catalogue_value(Coordinate::reciprocal, 4) == 0.25);
  CHECK(fitted_value(Coordinate::logarithm, 1) == 0);
}
