#include "diagnose/rig/effect.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <plumbline/base/error.hpp>

#include "diagnose/rig/nominal.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

bool has(const std::vector<EffectAt>& effects, const char* id, std::size_t joint = 0) {
  return std::find(effects.begin(), effects.end(), EffectAt(id, joint)) != effects.end();
}

}  // namespace

TEST_CASE("weights do not act in a horizontal plane, and may in an unknown one") {
  Experiment experiment = full_bench();
  for (const auto& [plane, heavy] :
       {std::pair(Bench::Plane::horizontal, false), std::pair(Bench::Plane::vertical, true),
        std::pair(Bench::Plane::unknown, true)}) {
    experiment.bench.plane = plane;
    const auto possible = possible_effects(Study(experiment));
    CHECK(has(possible, "gravity") == heavy);
    CHECK(has(possible, "tip_payload") == heavy);
    CHECK(has(possible, "force_gain"));
  }
}

TEST_CASE("a chain loaded by weights alone has no errors of an end pivot or a load cell") {
  Experiment experiment = three_links();
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {0, -1.0}, 10);
  const auto possible = [&](const char* id) { return has(possible_effects(Study(experiment)), id); };
  for (const bool by_weights : {false, true}) {
    experiment.runs[0].by_weights = by_weights;
    for (const char* id : {"tip_stiffness", "force_bias", "force_gain"}) CHECK(possible(id) == !by_weights);
    for (const char* id : {"tip_payload", "stiffness_scale"}) CHECK(possible(id));
  }
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {0, -1.0}, 10);  // one more, by a servo
  for (const char* id : {"tip_stiffness", "force_bias", "force_gain"}) CHECK(possible(id));
}

TEST_CASE("a passive joint has no errors of a spring") {
  Experiment experiment = full_bench();
  experiment.joint_stiffness[0] = 0;
  const auto possible = possible_effects(Study(experiment));
  for (const char* id : {"joint_stiffness", "rest_angle", "backlash"}) {
    CHECK_FALSE(has(possible, id, 1));
    CHECK(has(possible, id, 2));
  }
  CHECK(has(possible, "link_length", 1));
}

TEST_CASE("every effect is found by its id, and no other") {
  const Place at{characteristic_scales(full_bench()), 0};
  for (const Effect& row : catalogue()) {
    const Effect& found = effect(row.id, row.at_joint ? 1 : 0);
    CHECK(found.id == row.id);
    CHECK(found.at_joint == row.at_joint);
    // of two the one without a form
    if (&found != &row) CHECK_FALSE(row.form.empty());
  }
  CHECK(effect("hysteresis").at_joint == false);
  CHECK_THROWS_AS((void)effect("elbow grease"), Error);
  // a former id
  CHECK(&effect("joint_zero", 2) == &effect("rest_angle", 2));
  CHECK(effect("tool_mass").id == "tip_payload");
}

TEST_CASE("people are told of which form an effect is, files are not") {
  CHECK(EffectAt("joint_stops").name() == "joint_stops");
  CHECK(EffectAt(other_form("joint_stops")).name() == "joint_stops (each its own)");
  CHECK(EffectAt(other_form("asymmetric_spring")).name() == "asymmetric_spring (each its own)");
  CHECK(EffectAt("joint_friction").name() == "joint_friction");
  const EffectAt gives(other_form("joint_friction"));
  CHECK(gives.name() == "joint_friction (gives before it slips)");
  CHECK(gives.label() == "joint_friction");
  CHECK(EffectAt("backlash", 2).name() == "backlash(2)");
}

TEST_CASE("fitted coordinates and the catalogue's units are each other's inverse") {
  for (const Coordinate coordinate : {Coordinate::plain, Coordinate::logarithm, Coordinate::reciprocal})
    CHECK(catalogue_value(coordinate, fitted_value(coordinate, 0.37)) == close_to(0.37));
  CHECK(catalogue_value(Coordinate::reciprocal, 4) == 0.25);
  CHECK(fitted_value(Coordinate::logarithm, 1) == 0);
}

TEST_CASE(
    "a nominal effect with one value for all joints, or one at each, is the row with those parameters") {
  const auto asymmetry = [](const std::map<std::string, double>& parameters) {
    Experiment experiment = full_bench();
    experiment.effects = {{"asymmetric_spring", 0, parameters}};
    return nominal_rig(experiment).asymmetry;
  };
  CHECK(asymmetry({{"e", 0.2}}) == std::vector<double>{0.2, 0.2, 0.2});
  CHECK(asymmetry({{"e_1", 0.1}, {"e_2", -0.2}, {"e_3", 0.3}}) == std::vector<double>{0.1, -0.2, 0.3});
  CHECK_THROWS_WITH_AS(asymmetry({{"e_1", 0.1}}), doctest::Contains("parameters.e: found no such key"),
                       Error);
}
