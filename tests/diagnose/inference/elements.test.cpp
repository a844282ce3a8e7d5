#include "diagnose/inference/elements.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/inference/prior.hpp"
#include "diagnose/inference/search.hpp"
#include "diagnose/inference/start.hpp"
#include "diagnose/priors.hpp"
#include "diagnose/rig/nominal.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Hysteresis of so many elements, at all joints or at one.
EffectAt hysteresis(std::size_t elements, std::size_t joint = 0) {
  return {*effect("hysteresis", joint).orders().at(elements - 1), joint};
}

Hypothesis standing_at(const Candidate& candidate, std::vector<double> parameters) {
  Hypothesis hypothesis;
  hypothesis.candidate = candidate;
  hypothesis.parameters = std::move(parameters);
  return hypothesis;
}

/// Elements of equal strength that yield one after the other, each at two and a half times the turn of the
/// one before; what they carry is ten times the noise and more.
std::vector<double> elements_of(std::size_t count) {
  std::vector<double> values;
  for (std::size_t e = 0; e < count; ++e) {
    values.push_back(0.25);
    values.push_back(0.01 * std::pow(2.5, static_cast<double>(e)));
  }
  return values;
}

/// Pressed in far and let back, twice, in fine steps, with a fine load cell.
Experiment fine_bench() {
  Experiment experiment = test::three_links();
  experiment.noise[Channel::Name::Fx] = experiment.noise[Channel::Name::Fy] = 1e-3;
  experiment.noise[Channel::Name::q] = 0;
  test::press(experiment, {0.3, -0.5, 0.4}, {-0.08, 0}, 60, true);
  test::press(experiment, {-0.4, 0.3, 0.5}, {-0.06, 0.05}, 60, true);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.value.resize(column_q);
  return experiment;
}

}  // namespace

TEST_CASE("hysteresis may have one element to five; the catalogue's has three") {
  for (const std::size_t joint : {0, 2}) {
    const std::vector<const Effect*> rows = effect("hysteresis", joint).orders();
    REQUIRE(rows.size() == 5);
    CHECK(rows[2] == &effect("hysteresis", joint));
    const Study study(test::full_bench());
    for (std::size_t elements = 1; elements <= 5; ++elements) {
      const EffectAt at = hysteresis(elements, joint);
      CHECK(study.ranges(at).size() == 2 * elements);
      CHECK(at.label() == EffectAt("hysteresis", joint).label());
      CHECK(at.effect->orders() == rows);
      for (const auto& start : initial_guesses(study, at).points) CHECK(start.size() == 2 * elements);
    }
  }
}

TEST_CASE("elements that yield together are one of their strengths together") {
  const Study study(test::full_bench());
  const Trace one = predict(study, {{hysteresis(1)}}, {0.5, 0.03}).runs[0];
  for (std::size_t elements = 2; elements <= 5; ++elements) {
    std::vector<double> parameters;
    for (std::size_t e = 0; e < elements; ++e) {
      parameters.push_back(0.5 / static_cast<double>(elements));
      parameters.push_back(0.03);
    }
    const Trace several = predict(study, {{hysteresis(elements)}}, parameters).runs[0];
    CHECK((several - one).abs().maxCoeff() < 1e-8);  // equilibria are solved to ten digits
  }
}

TEST_CASE("a form that is two elements away, or none, gives no place to start") {
  const Study study(test::full_bench());
  const Hypothesis fitted = standing_at({{hysteresis(3)}}, {0.2, 0.4, 0.3, 0.1, 0.6, 0.2});
  for (const std::size_t elements : {1, 3, 5})
    CHECK(initial_guesses_of_order(study, fitted, 0, *hysteresis(elements).effect).points.empty());
}

TEST_CASE("a step to one element fewer joins two neighbours, and leaves what stands beside alone") {
  const Study study(test::full_bench());
  const Hypothesis fitted =
      standing_at({{"force_gain", hysteresis(3), "force_bias"}}, {0.1, 0.2, 0.4, 0.3, 0.1, 0.6, 0.2, 1, 2});
  const InitialGuesses fewer = initial_guesses_of_order(study, fitted, 1, *hysteresis(2).effect);
  // In the order of their turns 0.1, 0.2, 0.4; of two the turn in the middle, by strength.
  const std::vector<std::vector<double>> expected{{0.1, 0.9, (0.3 * 0.1 + 0.6 * 0.2) / 0.9, 0.2, 0.4, 1, 2},
                                                  {0.1, 0.3, 0.1, 0.8, (0.6 * 0.2 + 0.2 * 0.4) / 0.8, 1, 2}};
  REQUIRE(fewer.points.size() == expected.size());
  for (std::size_t s = 0; s < expected.size(); ++s) {
    REQUIRE(fewer.points[s].size() == expected[s].size());
    for (std::size_t p = 0; p < expected[s].size(); ++p)
      CHECK(fewer.points[s][p] == close_to(expected[s][p]).epsilon(1e-14));
  }
}

TEST_CASE(
    "a step to one element more adds a weak one, before, between and after those that there are, or splits "
    "one") {
  const Study study(test::full_bench());
  const Hypothesis fitted = standing_at({{hysteresis(2, 1), "force_gain"}}, {0.3, 0.1, 0.6, 0.02, 7});
  const InitialGuesses more = initial_guesses_of_order(study, fitted, 0, *hysteresis(3, 1).effect);
  REQUIRE(more.points.size() == 3 + 2);
  const double weak = 0.05;
  std::vector<double> added;
  for (std::size_t s = 0; s < 3; ++s) {
    const std::vector<double>& start = more.points[s];
    REQUIRE(start.size() == 7);
    CHECK(start.back() == 7);
    CHECK(start[2 * s] == close_to(weak));
    added.push_back(start[2 * s + 1]);
    std::vector<double> rest = start;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(2 * s),
               rest.begin() + static_cast<std::ptrdiff_t>(2 * s + 2));
    CHECK(rest == std::vector<double>{0.6, 0.02, 0.3, 0.1, 7});
  }
  CHECK(added[0] < 0.02);
  CHECK(added[1] == close_to(0.06));
  CHECK(added[2] > 0.1);
  // Two halves on either side, whose middle is the element that was split; in order of their turns.
  const std::vector<std::vector<double>> split{{0.3, 0.012, 0.3, 0.028, 0.3, 0.1, 7},
                                               {0.6, 0.02, 0.15, 0.06, 0.15, 0.14, 7}};
  for (std::size_t s = 0; s < split.size(); ++s)
    for (std::size_t p = 0; p < split[s].size(); ++p)
      CHECK(more.points[3 + s].at(p) == close_to(split[s][p]).epsilon(1e-14));
}

TEST_CASE("each element more is half as common") {
  const Study study(test::full_bench());
  for (std::size_t elements = 1; elements < 5; ++elements)
    CHECK(log_prior(study, {{hysteresis(elements + 1, 2)}}) - log_prior(study, {{hysteresis(elements, 2)}}) ==
          close_to(std::log(priors::one_more_element)));
}

TEST_CASE("a nominal model has as many elements as are named") {
  for (std::size_t elements = 1; elements <= 5; ++elements) {
    Experiment experiment = test::full_bench();
    std::map<std::string, double> parameters;
    for (std::size_t e = 1; e <= elements; ++e) {
      parameters["r_" + std::to_string(e)] = 0.1;
      parameters["d_" + std::to_string(e)] = 0.01 * static_cast<double>(e);
    }
    experiment.effects = {{"hysteresis", 2, parameters}};
    const Rig rig = nominal_rig(experiment);
    CHECK(rig.sliders[0].empty());
    CHECK(rig.sliders[1].size() == elements);
  }
}

TEST_CASE("a search finds how many elements there are" * doctest::test_suite("long")) {
  for (std::size_t elements = 1; elements <= 5; ++elements) {
    CAPTURE(elements);
    const Study study(test::measured(fine_bench(), {{hysteresis(elements)}}, elements_of(elements), 5));
    const Candidate found = search(study).hypotheses.front().candidate;
    CAPTURE(found.label());
    CAPTURE(study.ranges(found).size());
    CHECK(found == Candidate{{hysteresis(elements)}});
  }
}
