#include "diagnose/inference/search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <map>
#include <random>
#include <string>

#include "diagnose/bench/decimate.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/decision/heldout.hpp"
#include "diagnose/decision/rival.hpp"
#include "diagnose/noise/outliers.hpp"
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

/// Asks that nothing that a search found costs more than a part of it, where the rest can be nothing.
/// \return how often that was asked
std::size_t check_cost_beside_parts(const Study& study) {
  const Findings findings = search(study);
  std::size_t compared = 0;
  for (const Hypothesis& whole : findings.hypotheses)
    for (const Hypothesis& part : findings.hypotheses) {
      const Candidate &larger = whole.fit.candidate, &smaller = part.fit.candidate;
      if (!within(smaller, larger) || !tolerated_beside(study, smaller, larger)) continue;
      CAPTURE(smaller.label());
      CAPTURE(larger.label());
      ++compared;
      CHECK(whole.fit.cost < part.fit.cost + 1);  // beyond it a search starts again from the part
    }
  return compared;
}

}  // namespace

TEST_CASE("no explanation costs more than a part of it, where the rest can be nothing" *
          doctest::test_suite("long")) {
  const std::string experiments = PLUMBLINE_SOURCE_DIR "/tests/experiments/";
  for (const char* name : {"machining-base_compliance", "machining", "link_length-tip_stiffness"}) {
    CAPTURE(name);
    const Experiment experiment = decimated(read_experiment(experiments + name));
    const Study study(without(experiment, choose_heldout(experiment)));
    CHECK(check_cost_beside_parts(study) > 3);
  }
}

TEST_CASE("unequal friction of the joints is found where it leaves least, and not in a hollow beside") {
  // Five links of which no angle is read, pressed and let go; with this draw, as with eight of forty, a
  // search that exchanges nothing ends in a hollow, at a hundred times the cost.
  Experiment bench = test::three_links();
  bench.link_length = {0.12, 0.1, 0.11, 0.09, 0.1};
  bench.joint_stiffness = {2, 1.5, 1.8, 1.2, 1};
  bench.link_mass.assign(5, 0);
  test::press(bench, {0.3, -0.4, 0.3, -0.2, 0.3}, {-0.06, 0.01}, 20, true);
  test::press(bench, {-0.2, 0.3, 0.3, 0.2, -0.4}, {-0.036, 0.036}, 20, true);
  for (Run& run : bench.runs)
    for (Reading& reading : run.readings) reading.q.clear();
  const Candidate truth = test::only("friction_spread");
  constexpr unsigned draw = 8;
  std::mt19937 random(draw);
  std::uniform_real_distribution<double> size(std::log(0.02), std::log(0.4));
  std::vector<double> friction(5);
  for (double& one : friction) one = std::exp(size(random));
  const Study study(test::measured(bench, truth, friction, draw));
  const Findings findings = search(study);
  const auto found = std::find_if(findings.hypotheses.begin(), findings.hypotheses.end(),
                                  [&](const Hypothesis& one) { return one.fit.candidate == truth; });
  FitSettings settings;
  settings.noise = findings.noise;
  REQUIRE(found != findings.hypotheses.end());
  const double at_truth = fit_from(study, truth, settings, friction).cost,
               there = fit_from(study, truth, settings, found->fit.parameters).cost;
  CHECK(there < at_truth + 3);  // a likelihood twenty times less
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
  findings.tolerance->correlation.fill(0.3);
  weigh(study, findings);
  for (const double scale : findings.noise.scale) CHECK(scale == close_to(2 * std::sqrt(8.0)));
  CHECK(findings.noise.correlation == BySensor{0.3, 0.3, 0.3});
  Findings none;
  weigh(study, none);
  CHECK(none.hypotheses.empty());
}

namespace {

/// What a search reported after every single effect, which take it half of the way in equal steps.
std::vector<double> after_singles(const std::vector<double>& shares) {
  std::size_t singles = 0;
  while (singles < shares.size() && shares[singles] <= 0.5) ++singles;
  CHECK(singles > 10);
  for (std::size_t i = 0; i < singles; ++i)
    CHECK(shares[i] == close_to(0.5 * static_cast<double>(i + 1) / static_cast<double>(singles)));
  return {shares.begin() + static_cast<std::ptrdiff_t>(singles), shares.end()};
}

}  // namespace

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
    // One cause of one value that fits is looked at alone, and two with the pairs that are possible and what
    // machining leaves.
    CHECK(after_singles(shares) == (truth == one ? std::vector{1.0} : std::vector{0.7, 0.8, 1.0}));
    REQUIRE((truth == two || study.ranges(all.front().fit.candidate).size() == 1));
    CHECK((truth == two) == std::any_of(all.begin(), all.end(), [](const Hypothesis& each) {
            return each.fit.candidate.has_all_tolerances();
          }));
    CHECK((truth == two) == std::any_of(all.begin(), all.end(), [](const Hypothesis& each) {
            return each.fit.candidate.has_all_tolerances() && each.fit.candidate.count() == 2;
          }));
    for (const Hypothesis& each : all)
      CHECK((each.fit.candidate.effects.size() <= 2 || each.fit.candidate.has_all_tolerances()));
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

namespace {

/// One press of which forces alone are read.
Experiment forces_of_a_press(int steps, bool back) {
  Experiment bench = test::three_links();
  bench.noise.q = 0;
  test::press(bench, {0.3, -0.5, 0.4}, {-0.05, 0}, steps, back);
  for (Reading& reading : bench.runs[0].readings) reading.q.clear();
  return bench;
}

/// As a search fits: in what the readings scatter, which does not hang together.
FitSettings as_a_search(const Study& study) {
  FitSettings settings;
  settings.noise.scale =
      estimate_noise(study.measurements(), without_outliers(study.measurements(), study.nominal_residual()))
          .scale;
  return settings;
}

const Hypothesis* found_among(const Findings& findings, const Candidate& candidate) {
  const auto place =
      std::find_if(findings.hypotheses.begin(), findings.hypotheses.end(), [&](const Hypothesis& one) {
        return std::is_permutation(one.fit.candidate.effects.begin(), one.fit.candidate.effects.end(),
                                   candidate.effects.begin(), candidate.effects.end());
      });
  return place == findings.hypotheses.end() ? nullptr : &*place;
}

/// Values that a fit is free in; all that tolerances hold count as one.
std::size_t freedom(const Study& study, const Candidate& candidate) {
  std::size_t free = 0, held = 0;
  for (const ParameterRange& range : study.ranges(candidate)) (range.tolerance > 0 ? held : free) += 1;
  return free + (held > 0 ? 1 : 0);
}

}  // namespace

TEST_CASE(
    "an explanation has three values for each that it is free in, and is fitted in what the readings "
    "scatter") {
  // nine readings of two forces; and three, one force of which is missing
  for (const int steps : {4, 1}) {
    Experiment bench = test::measured(forces_of_a_press(steps, true), test::only("force_gain"), {0.2}, 5);
    if (steps == 1) bench.runs[0].readings[2].Fy = test::nan_value();
    const Study study(bench);
    const std::size_t values = study.measurements().size(), most = values / 3;
    REQUIRE(values == (steps == 4 ? 18 : 5));
    const FitSettings settings = as_a_search(study);
    const Findings findings = search(study);
    bool just_few_enough = false, too_many = false, held = false;
    for (const EffectAt& at : possible_effects(study)) {
      CAPTURE(at.label());
      const Candidate alone{{at}};
      const Fit own = fit(study, alone, settings);
      const Hypothesis* found = found_among(findings, alone);
      const std::size_t free = freedom(study, alone);
      CHECK((found != nullptr) == (own.converged && free <= most));
      if (found != nullptr) CHECK(found->fit.cost == own.cost);
      just_few_enough = just_few_enough || free == most;
      too_many = too_many || free > most;
      held = held || (free == 1 && study.ranges(at).size() > 1);
    }
    CHECK(just_few_enough);
    CHECK(too_many == (steps == 1));
    CHECK(held);
    for (const Hypothesis& one : findings.hypotheses) CHECK(freedom(study, one.fit.candidate) <= most);
  }
}

TEST_CASE("what is known already stays among what a search finds, better for its own start") {
  const Study study(test::measured(forces_of_a_press(12, true), test::only("joint_stiffness", 2), {0.2}, 5));
  // none that a search would look at by itself
  const Candidate three{{{"joint_stiffness", 1}, {"joint_stiffness", 2}, {"force_gain"}}};
  REQUIRE(found_among(search(study), three) == nullptr);
  Findings known;
  known.hypotheses.push_back({fit(study, three, {}), 0, 0, {}});
  const Findings findings = search(study, {}, known);
  const Hypothesis* found = found_among(findings, three);
  REQUIRE(found != nullptr);
  const Fit again = fit_from(study, three, as_a_search(study), known.hypotheses.front().fit.parameters);
  CHECK(found->fit.cost == again.cost);
  CHECK(found->fit.parameters == again.parameters);
}

TEST_CASE("where two effects leave structure three are looked for, and none costs more than a part of it") {
  const Candidate truth{{{"joint_stiffness", 2}, {"backlash", 1}, {"sensor_drift"}}};
  const std::vector<double> values{0.4, 0.03, 0.03, -0.02};
  Experiment bench = forces_of_a_press(16, true);
  bench.noise.Fx = bench.noise.Fy = 1e-3;
  const Study study(test::measured(bench, truth, values, 5));
  const FitSettings settings = as_a_search(study);
  std::vector<double> shares;
  const Findings findings = search(study, [&](double share) { shares.push_back(share); });
  CHECK(after_singles(shares) == std::vector{0.7, 0.8, 1.0});
  std::size_t compared = 0;
  std::vector<const Hypothesis*> triples;
  for (const Hypothesis& whole : findings.hypotheses) {
    const Candidate& larger = whole.fit.candidate;
    if (!larger.has_all_tolerances()) {
      CHECK(larger.effects.size() <= 3);
      if (larger.effects.size() == 3) triples.push_back(&whole);
    }
    for (const Hypothesis& part : findings.hypotheses) {
      if (!within(part.fit.candidate, larger) || !tolerated_beside(study, part.fit.candidate, larger))
        continue;
      ++compared;
      CHECK(whole.fit.cost < part.fit.cost + 1);  // a quarter of the noise of a value: where iterations end
    }
  }
  REQUIRE(triples.size() > 10);
  CHECK(compared > 10);
  const Hypothesis* found = found_among(findings, truth);
  REQUIRE(found != nullptr);
  CHECK(found->fit.cost < fit_from(study, truth, settings, values).cost + 1e-3);
  // The three best are looked at without each effect, from where they stand.
  std::sort(triples.begin(), triples.end(),
            [](const Hypothesis* a, const Hypothesis* b) { return a->fit.cost < b->fit.cost; });
  for (std::size_t t = 0; t < 3; ++t) {
    const Fit& whole = triples[t]->fit;
    for (std::size_t e = 0; e < 3; ++e) {
      const EffectAt each = whole.candidate.effects[e];
      const Instance rest =
          part(study, whole.candidate, whole.parameters, [&](const EffectAt& at) { return at != each; });
      CAPTURE(rest.candidate.label());
      const Hypothesis* two = found_among(findings, rest.candidate);
      REQUIRE(two != nullptr);
      CHECK(two->fit.cost <= fit_from(study, rest.candidate, settings, rest.parameters).cost);
    }
  }
}

TEST_CASE("the best pairs are looked at with what is a special case of one in its place") {
  const Candidate truth{{{"load_friction"}, {"sensor_drift"}}};
  Experiment bench = forces_of_a_press(16, true);
  bench.noise.Fx = bench.noise.Fy = 1e-3;
  const Study study(test::measured(bench, truth, {0.02, 3, 0.03, -0.02}, 5));
  const FitSettings settings = as_a_search(study);
  const Findings findings = search(study);
  std::vector<const Hypothesis*> pairs;
  for (const Hypothesis& one : findings.hypotheses)
    if (one.fit.candidate.effects.size() == 2) pairs.push_back(&one);
  REQUIRE(pairs.size() > 10);
  std::sort(pairs.begin(), pairs.end(),
            [](const Hypothesis* a, const Hypothesis* b) { return a->fit.cost < b->fit.cost; });
  int plain_ones = 0;
  for (std::size_t t = 0; t < 3; ++t) {
    const Candidate& whole = pairs[t]->fit.candidate;
    for (std::size_t e = 0; e < 2; ++e)
      for (const EffectAt& plain : possible_effects(study)) {
        if (!covers(whole.effects[e], plain) || has(whole, plain)) continue;
        Candidate plainer = whole;
        plainer.effects[e] = plain;
        CAPTURE(plainer.label());
        CHECK((found_among(findings, plainer) != nullptr) == fit(study, plainer, settings).converged);
        ++plain_ones;
      }
  }
  CHECK(plain_ones > 0);
}

TEST_CASE("where an effect of two values fits it is held against two of few values, and against machining") {
  const Study study(test::measured(forces_of_a_press(16, true), test::only("force_bias"), {0.6, -0.5}, 5));
  std::vector<double> shares;
  const Findings findings = search(study, [&](double share) { shares.push_back(share); });
  CHECK(after_singles(shares) == std::vector{1.0});
  REQUIRE(findings.hypotheses.front().fit.candidate == test::only("force_bias"));
  std::size_t pairs = 0, machined = 0;
  for (const Hypothesis& one : findings.hypotheses) {
    const Candidate& candidate = one.fit.candidate;
    if (candidate.has_all_tolerances()) {
      ++machined;
      continue;
    }
    CHECK(candidate.effects.size() <= 2);
    if (candidate.effects.size() < 2) continue;
    ++pairs;
    CHECK(many_valued(study, candidate) == 0);
  }
  CHECK(pairs > 0);
  CHECK(machined > 1);  // alone, and with one effect more
}

TEST_CASE("of one press, too, no explanation costs more than a part of it, of one cause and of three") {
  const std::vector<std::pair<Candidate, std::vector<double>>> truths{
      {{{{"joint_stop", 3}}}, {0.02, 3}},
      {{{{"joint_stiffness", 2}, {"force_gain"}, {"backlash", 1}}}, {0.25, 0.2, 0.03}},
      {{{{"force_gain"}, {"backlash", 2}, {"sensor_drift"}}}, {0.2, 0.03, 0.03, -0.02}}};
  for (const auto& [truth, values] : truths) {
    CAPTURE(truth.label());
    Experiment bench = forces_of_a_press(16, true);
    bench.noise.Fx = bench.noise.Fy = 1e-3;
    const Study study(test::measured(bench, truth, values, 5));
    CHECK(check_cost_beside_parts(study) > 10);
  }
}

TEST_CASE("an effect of one value that fits is held against the others of the catalogue alone") {
  const Study study(test::measured(forces_of_a_press(16, true), test::only("rest_angle", 2), {0.1}, 5));
  const Findings findings = search(study);
  REQUIRE(findings.hypotheses.front().fit.candidate == test::only("rest_angle", 2));
  for (const Hypothesis& one : findings.hypotheses) CHECK(one.fit.candidate.effects.size() == 1);
}

TEST_CASE("of a single joint what machining leaves is looked at as a whole, and no part of it by itself") {
  // one spring has no spread of stiffness that is not its own
  Experiment bench = test::three_links();
  bench.link_length = {0.3};
  bench.joint_stiffness = {2};
  bench.link_mass = {0};
  bench.noise.q = 0;
  test::load(bench, {0.3}, {0, 0}, {-2, 1}, 16);
  for (Reading& reading : bench.runs[0].readings) reading.q.clear();
  const Candidate truth{{{"position_offset"}}};
  const Study study(test::measured(bench, truth, {0.01, -0.02}, 5));
  const Findings findings = search(study);
  bool whole = false;
  for (const Hypothesis& one : findings.hypotheses) {
    CAPTURE(one.fit.candidate.label());
    CHECK(one.fit.candidate.effects.size() > 0);
    const bool machined = one.fit.candidate.has_all_tolerances();
    whole = whole || machined;
    CHECK((machined || std::none_of(one.fit.candidate.effects.begin(), one.fit.candidate.effects.end(),
                                    [](const EffectAt& at) { return at.effect->is_tolerance; })));
  }
  CHECK(whole);
}
