#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "diagnose/answers/diagnosis.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

Experiment presses_four_ways() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, true);
  press(experiment, {-0.2, -0.5, 0.4}, {-0.06, 0.02}, 20, true);
  press(experiment, {0.2, 0.5, -0.4}, {-0.04, 0}, 20, true);
  press(experiment, {0.2, -0.3, -0.4}, {0, -0.05}, 20, true);
  return experiment;
}

std::set<std::string> named_causes(const Cause& cause) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < cause.named; ++i) {
    std::set<std::string> labels;
    for (const EffectAt& at : cause.ranking[i].cause.effects) labels.insert(at.label());
    std::string name;
    for (const std::string& label : labels) name += label + " ";
    names.insert(name);
  }
  return names;
}

}  // namespace

TEST_CASE("the order of the runs does not change the answer" * doctest::test_suite("long")) {
  const std::vector<std::pair<Candidate, std::vector<double>>> truths{
      {only("backlash", 2), {0.03}},
      {only("force_gain"), {0.1}},
      {{{{"joint_friction", 0}, {"joint_stiffness", 1}}}, {0.03, 0.3}},
      {{}, {}}};
  // Fits end where an iteration gains less than some hundredths of a unit of log likelihood, and sums are rounded
  // in another order.
  constexpr double close = 0.02;
  unsigned seed = 20;
  for (const auto& [truth, parameters] : truths) {
    CAPTURE(truth.label());
    Experiment experiment = measured(presses_four_ways(), truth, parameters, ++seed);
    const Diagnosis first = plumbline::diagnose::diagnose(Study(experiment));
    for (int turn = 0; turn < 2; ++turn) {
      std::rotate(experiment.runs.begin(), experiment.runs.begin() + 1, experiment.runs.end());
      if (turn == 1) std::swap(experiment.runs[0], experiment.runs[1]);
      const Diagnosis again = plumbline::diagnose::diagnose(Study(experiment));
      CHECK(again.cause.verdict == first.cause.verdict);
      CHECK(named_causes(again.cause) == named_causes(first.cause));
      CHECK(std::abs(again.gap.probability - first.gap.probability) < close);
      CHECK(std::abs(again.cause.unknown - first.cause.unknown) < close);
      CHECK(std::abs(again.cause.ranking.front().probability - first.cause.ranking.front().probability) < close);
      std::map<std::string, double> share;
      for (const RunShare& one : first.where.runs) share[one.run] = one.share;
      for (const RunShare& one : again.where.runs) CHECK(std::abs(one.share - share.at(one.run)) < close);
      REQUIRE(again.shrink.has_value() == first.shrink.has_value());
      if (first.shrink) CHECK(again.shrink->ratio == close_to(first.shrink->ratio).epsilon(close));
    }
  }
}
