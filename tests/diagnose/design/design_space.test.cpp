#include "diagnose/design/design_space.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/unmeasured.hpp"
#include "diagnose/design/candidate_runs.hpp"
#include "diagnose/inference/start.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Three links of which one press is planned, and nothing measured.
Experiment planned_press() {
  Experiment bench = three_links();
  press(bench, {0.3, -0.5, 0.4}, {-0.03, 0}, 6, true);
  return unmeasured(bench);
}

/// What a lab calls sizeable, by the words of the header: a scale, or a tolerance by turns to either side; of
/// one side one and a half and a half of it.
double sizeable_by_hand(const ParameterRange& range, std::size_t place) {
  const bool even = place % 2 == 0;
  if (!(range.tolerance > 0)) return range.scale;
  if (range.low == 0) return (even ? 1.5 : 0.5) * range.tolerance;
  return (even ? 1 : -1) * range.tolerance;
}

}  // namespace

TEST_CASE("a design space: planned runs first, as the nominal chain follows them, numbered through") {
  const DesignSpace all = design_space(planned_press());
  REQUIRE(all.planned == 1);
  CHECK(all.descriptions.front() == "press-1 as planned");
  CHECK(all.descriptions.size() == all.bench.runs.size());
  CHECK(all.bench.runs.size() > 3);
  CHECK(all.bench.run_count == 1);
  const Prediction nominal = Study(all.bench).nominal();
  CHECK(nominal.reached);
  CHECK_FALSE(nominal.snapped);
  const OperatingEnvelope so_far = operating_envelope(Study(planned_press()));
  for (std::size_t r = 0; r < all.bench.runs.size(); ++r) {
    const Run& run = all.bench.runs[r];
    CHECK(run.number == 0);
    CHECK(run.turns_back());
    for (std::size_t i = 0; i < run.readings.size(); ++i)
      for (const Channel& channel : run.measured())
        CHECK(channel.of(run.readings[i]) == nominal.runs[r](static_cast<Eigen::Index>(i), channel.column));
    if (r == 0) continue;
    CHECK(so_far.allows(nominal.runs[r], run));
  }
}

TEST_CASE("effects of a design space have a sizeable amount, halved until all runs can be followed") {
  const DesignSpace all = design_space(planned_press());
  const Study study(all.bench);
  CHECK(all.effects.size() == possible_effects(study).size());
  std::size_t whole = 0;
  for (const Instance& one : all.effects) {
    CAPTURE(one.candidate.label());
    REQUIRE(one.candidate.effects.size() == 1);
    const EffectAt& at = one.candidate.effects.front();
    const std::vector<ParameterRange> ranges = study.ranges(at);
    const InitialGuesses known = initial_guesses(study, at);
    const std::vector<double>& middle = known.points[known.points.size() / 2];
    for (std::size_t p = 0; p < ranges.size(); ++p) {
      CAPTURE(p);
      const ParameterRange& range = ranges[p];
      if (range.coordinate == Coordinate::plain && range.low <= 0) {
        const double share = one.parameters[p] / sizeable_by_hand(range, p);
        const double halved = -std::log2(share);
        CHECK(std::abs(halved - std::round(halved)) < 1e-9);
        CHECK(halved > -0.5);
        CHECK(halved < 6.5);
        whole += halved < 0.5 ? 1 : 0;
      } else if (range.coordinate == Coordinate::reciprocal) {
        CHECK(one.parameters[p] == close_to(std::max(middle[p], range.scale)));
      } else {
        CHECK(one.parameters[p] == close_to(middle[p]));
      }
    }
    // and then every run of the design space can be followed without a snap
    const Prediction followed = predict(study, one.candidate, one.parameters);
    CHECK(followed.reached);
    CHECK_FALSE(followed.snapped);
  }
  CHECK(whole > 10);
}

TEST_CASE("no effect is both possible and impossible at a joint") {
  const DesignSpace all = design_space(planned_press());
  for (const EffectAt& one : all.impossible)
    CHECK(std::none_of(all.effects.begin(), all.effects.end(),
                       [&](const Instance& other) { return other.candidate.effects.front() == one; }));
  // every row stands somewhere, but for those that need a second run
  for (const Effect& row : catalogue())
    for (std::size_t joint = row.at_joint ? 1 : 0; joint <= (row.at_joint ? 3U : 0U); ++joint) {
      const EffectAt at(row, joint);
      CAPTURE(at.label());
      CharacteristicScales twice = Study(all.bench).scales();
      twice.runs = 2;
      const bool can = row.possible({twice, joint > 0 ? joint - 1 : 0});
      CHECK((std::find(all.impossible.begin(), all.impossible.end(), at) == all.impossible.end()) == can);
    }
}

TEST_CASE("a bench whose chain follows no run is refused") {
  Experiment far = planned_press();
  for (Reading& one : far.runs[0].readings) one[column_x] = 3;
  CHECK_THROWS_WITH_AS(design_space(far),
                       "experiment \"three links\": found runs that the nominal chain cannot follow, "
                       "expected end points within "
                       "reach and a stable posture at every reading",
                       Error);
}

TEST_CASE("simulated readings: measured channels hold the prediction, others are empty") {
  Experiment bench = planned_press();
  load(bench, {0.2, 0.3, -0.3}, {0, 0}, {-0.5, 0.2}, 4);
  bench.noise[Channel::Name::Fy] = 0;
  bench = unmeasured(bench);
  const Prediction nominal = simulate(bench, Study(bench).nominal_rig(), {});
  const Experiment known = measured_as(bench, nominal);
  for (Eigen::Index i = 0; i < nominal.runs[0].rows(); ++i) {
    const Reading& reading = known.runs[0].readings[static_cast<std::size_t>(i)];
    CHECK(reading[column_Fx] == nominal.runs[0](i, column_Fx));
    CHECK(std::isnan(reading[column_Fy]));
    CHECK(reading[column_q + 2] == nominal.runs[0](i, column_q + 2));
    CHECK(reading[column_x] == bench.runs[0].readings[static_cast<std::size_t>(i)][column_x]);
  }
  CHECK(known.runs[1].readings[3][column_x] == nominal.runs[1](3, column_x));
  CHECK(known.runs[1].readings[3][column_Fx] == bench.runs[1].readings[3][column_Fx]);
}

TEST_CASE("planned runs that some effect cannot follow at any amount are left out") {
  Experiment bench = planned_press();
  // To a ten-millionth of the whole length, 0.6 m, which is 6e-8 m: an end that stands off along x by the
  // least that is tried, a 64th of what is sizeable, 3 mm, is out of reach.
  press(bench, {0.3, -0.5, 0.4}, {0, 0}, 2, true);
  bench = unmeasured(bench);
  Reading& farthest = bench.runs[1].readings[2];
  farthest[column_x] = 0.6 * (1 - 1e-7), farthest[column_y] = 0;
  const DesignSpace all = design_space(bench);
  CHECK(all.planned == 1);
  CHECK(all.descriptions[0] == "press-1 as planned");
  for (std::size_t r = 1; r < all.descriptions.size(); ++r)
    CHECK(all.descriptions[r].find("as planned") == std::string::npos);
}
