#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>

#include "diagnose/bench/decimate.hpp"
#include "diagnose/decision/verdict.hpp"
#include "diagnose/rig/user_effects/read_effects.hpp"
#include "diagnose/rig/user_effects/stated_effect.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Two links under a force there and back, and once more with twice as much.
Experiment sprung_links() {
  Experiment experiment;
  experiment.name = "two sprung links";
  experiment.link_length = {0.3, 0.2};
  experiment.joint_stiffness = {4.0, 3.0};
  experiment.link_mass = {0, 0};
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::horizontal, {0, 0}, false};
  experiment.noise = {1e-4, 1e-4, 0.01, 0.01, 1e-3};
  test::load(experiment, {0.4, -0.6}, {0, 0}, {0, 3}, 12);
  test::load(experiment, {0.4, -0.6}, {0, 0}, {-2, -4}, 14);
  test::load(experiment, {-0.2, 0.8}, {0, 0}, {1, 3.5}, 12);
  return experiment;
}

struct Answer {
  Verdict verdict;
  Posterior posterior;
  [[nodiscard]] std::set<std::vector<std::string>> named() const {
    std::set<std::vector<std::string>> all;
    for (std::size_t i = 0; i < verdict.named; ++i) all.insert(posterior.causes[i].labels);
    return all;
  }
};

Answer answer_of(const Study& study) {
  const Findings findings = search(study);
  const Posterior found = posterior(study, findings);
  return {decide(found), found};
}

/// Both are the same answer: what decides is the same up to what a maximisation leaves.
void check_same(const Answer& a, const Answer& b) {
  CHECK(a.verdict.verdict == b.verdict.verdict);
  CHECK(a.named() == b.named());
  CHECK(std::abs(a.posterior.no_gap - b.posterior.no_gap) < 0.05);
  CHECK(std::abs(a.posterior.outside - b.posterior.outside) < 0.05);
}

const std::vector<Candidate>& some_causes() {
  static const std::vector<Candidate> all{test::only("joint_stiffness", 2), test::only("force_bias"),
                                          test::only("rest_angle", 1)};
  return all;
}

/// Parameters of a sizeable effect; times are in the middle of their ranges.
std::vector<double> sizeable(const Study& study, const Candidate& candidate) {
  std::vector<double> parameters;
  for (const ParameterRange& range : study.ranges(candidate))
    parameters.push_back(range.may_be_nothing() ? 0.5 * range.scale : (range.low + range.high) / 2);
  return parameters;
}

Experiment sprung_links_with(const Candidate& cause, unsigned seed) {
  const Experiment bare = sprung_links();
  return test::measured(bare, cause, sizeable(Study(bare), cause), seed);
}

}  // namespace

TEST_CASE("the order of the runs changes no answer") {
  for (const Candidate& cause : some_causes()) {
    CAPTURE(cause.label());
    Experiment experiment = sprung_links_with(cause, 11);
    const Answer before = answer_of(Study(experiment));
    std::rotate(experiment.runs.begin(), experiment.runs.begin() + 1, experiment.runs.end());
    check_same(before, answer_of(Study(experiment)));
  }
}

TEST_CASE("units change no answer: lengths, torques and all that follows from them") {
  constexpr double length = 8, torque = 32;  // powers of two: nothing is rounded
  for (const Candidate& cause : some_causes()) {
    CAPTURE(cause.label());
    Experiment experiment = sprung_links_with(cause, 12);
    const Answer before = answer_of(Study(experiment));
    for (double& one : experiment.link_length) one *= length;
    for (double& one : experiment.joint_stiffness) one *= torque;
    experiment.noise[Channel::Name::x] *= length, experiment.noise[Channel::Name::y] *= length;
    experiment.noise[Channel::Name::Fx] *= torque / length,
        experiment.noise[Channel::Name::Fy] *= torque / length;
    for (Run& run : experiment.runs)
      for (Reading& reading : run.readings) {
        reading[column_x] *= length, reading[column_y] *= length;
        reading[column_Fx] *= torque / length, reading[column_Fy] *= torque / length;
      }
    check_same(before, answer_of(Study(experiment)));
  }
}

TEST_CASE("the other side of the plane changes no answer") {
  for (const Candidate& cause : some_causes()) {
    CAPTURE(cause.label());
    Experiment experiment = sprung_links_with(cause, 13);
    const Answer before = answer_of(Study(experiment));
    for (Run& run : experiment.runs) {
      for (double& one : run.rest) one = -one;
      for (Reading& reading : run.readings) {
        reading[column_y] = -reading[column_y], reading[column_Fy] = -reading[column_Fy];
        for (std::size_t c = column_q; c < reading.value.size(); ++c) reading.value[c] *= -1;
      }
    }
    check_same(before, answer_of(Study(experiment)));
  }
}

TEST_CASE(
    "declared noise twice as large, and all departures with it, moves every evidence by the same amount") {
  const Experiment experiment = sprung_links_with(test::only("joint_stiffness", 2), 14);
  Experiment doubled = experiment;
  Noise& noise = doubled.noise;
  noise = {2 * noise[Channel::Name::x], 2 * noise[Channel::Name::y], 2 * noise[Channel::Name::Fx],
           2 * noise[Channel::Name::Fy], 2 * noise[Channel::Name::q]};
  const Study one(experiment), two(doubled);
  const CommandStates states(experiment);
  const auto log_likelihood = [&](const Study& study, const VectorXd& residual) {
    return Likelihood(study.measurements(), states, full_model(), NoiseShape(study.measurements()),
                      one.nominal_residual())
        .look(residual)
        .log_likelihood;
  };
  const auto values = static_cast<double>(one.measurements().size());
  for (const double share : {1.0, 0.3, 0.0}) {
    const VectorXd residual = share * one.nominal_residual();
    // A density per declared sigma: each value is as likely over twice the range.
    CHECK(log_likelihood(one, residual) - log_likelihood(two, residual) ==
          doctest::Approx(values * std::log(2.0)).epsilon(1e-9));
  }
}

TEST_CASE("a copy of an effect under another name is an alternative to it") {
  const std::vector<StatedEffect> stated = parse_effects(R"(format = "user-effects/1"
[[effect]]
id = "soft"
words = "a softer spring of joint {}"
where = "one joint"
torque = "a * 3 * d"
[effect.parameters.a]
unit = "1"
scale = 0.2
low = -0.9
high = 2
)",
                                                         "soft.toml");
  const Experiment experiment = sprung_links_with(test::only("joint_stiffness", 2), 15);
  const Answer answer = answer_of(study_with(experiment, stated));
  CHECK(answer.verdict.verdict == CauseVerdict::ambiguous);
  CHECK(answer.named().contains({"joint_stiffness(2)"}));
  CHECK(answer.named().contains({"user:soft(2)"}));
}

TEST_CASE("fewer readings make no answer surely other" * doctest::test_suite("long")) {
  std::mt19937 random(16);
  for (const Candidate& cause : some_causes()) {
    CAPTURE(cause.label());
    const std::vector<std::string> truth{cause.label()};
    for (const double kept : {0.5, 0.25, 0.12}) {
      CAPTURE(kept);
      Experiment experiment = sprung_links_with(cause, 17);
      std::bernoulli_distribution keep(kept);
      for (Run& run : experiment.runs)
        std::erase_if(run.readings, [&](const Reading& reading) {
          return &reading != &run.readings.back() && !keep(random);
        });
      const Answer answer = answer_of(Study(experiment));
      const bool hedged = answer.verdict.verdict == CauseVerdict::unknown || answer.verdict.or_outside ||
                          answer.verdict.verdict == CauseVerdict::none;
      CHECK((answer.named().contains(truth) || hedged));
    }
  }
}

namespace {

/// Another way to write the same readings, or less of what is known of them.
struct Rewriting {
  std::string name;
  std::function<void(Experiment&)> apply;
};

Rewriting noise_declared_times(double factor) {
  return {"noise declared " + std::to_string(factor) + " times as large", [factor](Experiment& experiment) {
            experiment.noise = {1e-4 * factor, 1e-4 * factor, 0.01 * factor, 0.01 * factor, 1e-3 * factor};
          }};
}

void without_clock(Experiment& experiment) {
  for (Run& run : experiment.runs)
    for (std::size_t i = 0; i < run.readings.size(); ++i) run.readings[i].t = static_cast<double>(i);
}

void every_run_in_two(Experiment& experiment) {
  std::vector<Run> parts;
  for (const Run& run : experiment.runs) {
    const auto half = run.readings.begin() + static_cast<std::ptrdiff_t>(run.readings.size() / 2);
    for (const bool later : {false, true}) {
      parts.push_back(run);
      parts.back().id += later ? "-later" : "-earlier";
      parts.back().readings = later ? std::vector<Reading>(half, run.readings.end())
                                    : std::vector<Reading>(run.readings.begin(), half);
    }
  }
  experiment.runs = std::move(parts);
}

void every_reading_twice(Experiment& experiment) {
  for (Run& run : experiment.runs) {
    std::vector<Reading> readings;
    for (const Reading& one : run.readings) readings.insert(readings.end(), 2, one);
    run.readings = std::move(readings);
  }
  experiment = decimated(std::move(experiment));
}

/// Whether the answer is sure, and is not this cause.
bool is_surely_other(const Answer& answer, const std::string& cause) {
  if (answer.verdict.verdict == CauseVerdict::none) return answer.posterior.no_gap > 0.95;
  return answer.verdict.verdict == CauseVerdict::identified && !answer.named().contains({cause});
}

}  // namespace

TEST_CASE("no way of writing the readings makes an answer surely other" * doctest::test_suite("long")) {
  const std::vector<Rewriting> all{{"without a clock", without_clock},
                                   {"every run in two", every_run_in_two},
                                   {"every reading twice", every_reading_twice},
                                   noise_declared_times(0.05),
                                   noise_declared_times(0.3),
                                   noise_declared_times(3),
                                   noise_declared_times(20)};
  std::vector<Candidate> causes = some_causes();
  causes.push_back(test::only("viscoelasticity"));
  for (const Candidate& cause : causes) {
    CAPTURE(cause.label());
    Experiment experiment = sprung_links();
    for (Run& run : experiment.runs)
      for (Reading& reading : run.readings) reading.t *= 2;
    experiment = test::measured(experiment, cause, sizeable(Study(experiment), cause), 21);
    CHECK_FALSE(is_surely_other(answer_of(Study(experiment)), cause.label()));
    for (const Rewriting& one : all) {
      CAPTURE(one.name);
      Experiment other = experiment;
      one.apply(other);
      CHECK_FALSE(is_surely_other(answer_of(Study(other)), cause.label()));
    }
  }
}

TEST_CASE("noise larger than declared is no gap, whatever the factor") {
  for (const double factor : {2.0, 10.0}) {
    CAPTURE(factor);
    Experiment noisy = sprung_links();
    noisy.noise = {1e-4 * factor, 1e-4 * factor, 0.01 * factor, 0.01 * factor, 1e-3 * factor};
    Experiment experiment = test::measured(noisy, {}, {}, 18);
    experiment.noise = sprung_links().noise;
    const Answer answer = answer_of(Study(experiment));
    CHECK((answer.verdict.verdict == CauseVerdict::none || answer.verdict.verdict == CauseVerdict::unknown));
  }
}
