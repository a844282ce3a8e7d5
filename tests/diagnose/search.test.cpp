#include "diagnose/inference/search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "diagnose/answers/heldout.hpp"
#include "diagnose/bench/condense.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/inference/rival.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

bool has(const Candidate& whole, const EffectAt& at) {
  return std::find(whole.effects.begin(), whole.effects.end(), at) != whole.effects.end();
}

bool within(const Candidate& part, const Candidate& whole) {
  return part.effects.size() < whole.effects.size() &&
         std::all_of(part.effects.begin(), part.effects.end(),
                     [&](const EffectAt& at) { return has(whole, at); });
}

/// Whether all that the whole has beside the part is held by tolerances, which can be nothing.
bool tolerated_beside(const Study& study, const Candidate& part, const Candidate& whole) {
  return std::all_of(whole.effects.begin(), whole.effects.end(), [&](const EffectAt& at) {
    return has(part, at) || study.ranges(at).front().tolerance > 0;
  });
}

}  // namespace

TEST_CASE("no explanation costs more than a part of it, where the rest can be nothing" *
          doctest::test_suite("long")) {
  const std::string experiments = PLUMBLINE_SOURCE_DIR "/tests/experiments/";
  for (const char* name : {"machining-base_compliance", "machining", "link_length-tip_stiffness"}) {
    CAPTURE(name);
    const Experiment experiment = condensed(read_experiment(experiments + name));
    const Study study(without(experiment, choose_heldout(experiment)));
    const Findings findings = search(study);
    std::size_t compared = 0;
    for (const Hypothesis& whole : findings.hypotheses)
      for (const Hypothesis& part : findings.hypotheses) {
        const Candidate &larger = whole.fit.candidate, &smaller = part.fit.candidate;
        if (!within(smaller, larger) || !tolerated_beside(study, smaller, larger)) continue;
        ++compared;
        CHECK(whole.fit.cost < part.fit.cost + 1);  // of a cost of some hundred: where iterations end
      }
    CHECK(compared > 3);
  }
}

TEST_CASE("explanations are weighed in the noise that the one leaves that costs least, best evidence first") {
  const Experiment bench = [] {
    Experiment experiment = test::three_links();
    test::press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 12, true);
    return test::measured(experiment, test::only("force_gain"), {0.05}, 5);
  }();
  const Study study(bench);
  const Fit gain = fit(study, test::only("force_gain"), {}), bias = fit(study, test::only("force_bias"), {});
  REQUIRE(gain.cost < bias.cost);
  Findings findings{{{bias, 7, 7, {}}, {gain, 7, 7, {}}}, {}};
  weigh(study, findings);
  const NoiseModel noise =
      estimate_noise(study.measurements(), without_outliers(study.measurements(), gain.residual));
  CHECK(findings.noise.scale == noise.scale);
  CHECK(findings.noise.correlation == noise.correlation);
  CHECK(findings.hypotheses[0].fit.candidate == gain.candidate);
  for (const Hypothesis& one : findings.hypotheses) {
    CHECK(one.log_likelihood == log_likelihood(study.measurements(), one.fit.residual, noise));
    CHECK(one.log_evidence == log_evidence(study, one.fit, noise));
  }
  // What is tolerated eight neighbours share: together they count as one.
  findings.tolerance = NoiseModel();
  findings.tolerance->scale.fill(2);
  findings.tolerance->correlation = 0.3;
  weigh(study, findings);
  for (const double scale : findings.noise.scale) CHECK(scale == close_to(2 * std::sqrt(8.0)));
  CHECK(findings.noise.correlation == 0.3);
  Findings none;
  weigh(study, none);
  CHECK(none.hypotheses.empty());
}

TEST_CASE("a search finds one cause and two, each combination once, and says how far it is") {
  Experiment bench = test::three_links();
  bench.noise.q = 0;
  test::press(bench, {0.3, -0.5, 0.4}, {-0.05, 0}, 12, true);
  for (Reading& reading : bench.runs[0].readings) reading.q.clear();
  const Candidate one{{{"joint_stiffness", 2}}}, two{{{"joint_stiffness", 2}, {"force_bias"}}};
  for (const Candidate& truth : {one, two}) {
    CAPTURE(truth.label());
    const std::vector<double> values = truth == one ? std::vector{0.2} : std::vector{0.2, 0.5, -0.4};
    const Study study(test::measured(bench, truth, values, 5));
    std::vector<double> shares;
    const Findings findings = search(study, [&](double share) { shares.push_back(share); });
    const std::vector<Hypothesis>& all = findings.hypotheses;
    // One cause that fits is looked at alone, and two with the pairs that are possible and what machining
    // leaves.
    CHECK(shares == (truth == one ? std::vector{0.1, 1.0} : std::vector{0.1, 0.4, 0.6, 1.0}));
    CHECK(std::any_of(all.begin(), all.end(),
                      [](const Hypothesis& each) { return each.fit.candidate.machined(); }));
    for (const Hypothesis& each : all)
      CHECK((each.fit.candidate.effects.size() <= 2 || each.fit.candidate.machined()));
    for (const EffectAt& at : possible_effects(study))
      CHECK(std::any_of(all.begin(), all.end(), [&](const Hypothesis& each) {
              return each.fit.candidate == Candidate{{at}};
            }) == fit(study, Candidate{{at}}, {}).converged);
    for (const Hypothesis& each : all) CHECK(many_valued(study, each.fit.candidate) <= 1);
    CHECK(std::is_sorted(all.begin(), all.end(), [](const Hypothesis& a, const Hypothesis& b) {
      return a.log_evidence > b.log_evidence;
    }));
    const auto same = [](const Candidate& a, const Candidate& b) {
      return std::is_permutation(a.effects.begin(), a.effects.end(), b.effects.begin(), b.effects.end());
    };
    bool found = false;
    for (const Hypothesis& hypothesis : all) {
      CHECK(hypothesis.fit.converged);
      CHECK(std::count_if(all.begin(), all.end(), [&](const Hypothesis& other) {
              return same(other.fit.candidate, hypothesis.fit.candidate);
            }) == 1);
      found = found || same(hypothesis.fit.candidate, truth);
    }
    CHECK(found);
    if (truth == two) continue;
    // What is known already is looked at from where it stands, and not twice.
    Findings known;
    known.hypotheses.push_back(all.front());
    const Findings again = search(study, {}, known);
    CHECK(again.hypotheses.front().fit.cost < all.front().fit.cost + 0.1);
  }
}
