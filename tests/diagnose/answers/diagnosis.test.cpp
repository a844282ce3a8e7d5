#include "diagnose/answers/diagnosis.hpp"

#include <doctest/doctest.h>

#include <set>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>

#include "diagnose/inference/fit.hpp"
#include "diagnose/report/report.hpp"

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A bench of three links pressed from two shapes and back, without readings yet.
Experiment unread_bench() {
  Experiment experiment{{{0.25, 0.2, 0.25}, {2.0, 1.5, 2.0}, {0, 0, 0}, {0, 0}, {}, {}},
                        "bench",
                        {Bench::Plane::horizontal, {0, 0}, false},
                        {0, 0, 0.02, 0.02, 0.001},
                        {}};
  const auto press = [&](const std::string& id, const std::vector<double>& rest, double depth, double aside) {
    Run run{id, Control::end_point, rest, {}};
    double theta = 0, x = 0, y = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      theta += rest[j];
      x += experiment.link_length[j] * std::cos(theta);
      y += experiment.link_length[j] * std::sin(theta);
    }
    for (int i = 0; i < 41; ++i) {
      const double share = (i <= 20 ? i : 40 - i) / 20.0;
      run.readings.push_back({1.5 * i, x - depth * share, y + aside * share, 0, 0, {0, 0, 0}});
    }
    experiment.runs.push_back(run);
  };
  press("u", {-0.4, 0.4, 0.4}, 0.10, 0);
  press("z", {-0.3, 0.8, -0.7}, 0.07, 0);
  press("u-aside", {-0.4, 0.5, 0.3}, 0.06, 0.05);
  press("z-again", {-0.35, 0.8, -0.8}, 0.08, 0);
  return experiment;
}

/// Fills in what the rig would have measured, and noise.
Experiment with_readings(Experiment experiment, const Candidate& cause, const std::vector<double>& parameters,
                         std::uint64_t seed, double noise_scale = 1) {
  const Prediction truth = predict(Study(experiment), cause, parameters);
  REQUIRE(truth.reached);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise_scale);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i) {
      Reading& reading = experiment.runs[r].readings[i];
      const auto row = truth.runs[r].row(static_cast<Eigen::Index>(i));
      reading.Fx = row(column_Fx) + experiment.noise.Fx * normal(random);
      reading.Fy = row(column_Fy) + experiment.noise.Fy * normal(random);
      for (std::size_t j = 0; j < 3; ++j)
        reading.q[j] = row(column_q + static_cast<Eigen::Index>(j)) + experiment.noise.q * normal(random);
    }
  }
  return experiment;
}

/// The spring of joint 2 loses torque beyond a deflection, and regains it: a ripple of its own, N m.
Experiment rippled(Experiment experiment, double amplitude) {
  const Prediction nominal = predict(Study(experiment), {}, {});
  const Prediction bent = predict(Study(experiment), {{{"rest_angle", 2}}}, {0.0}, true);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i) {
      Reading& reading = experiment.runs[r].readings[i];
      const auto row = static_cast<Eigen::Index>(i);
      const double ripple = amplitude * std::sin(15 * nominal.runs[r](row, column_q + 1));
      reading.Fx += ripple * bent.sensitivity[0][r](row, column_Fx);
      reading.Fy += ripple * bent.sensitivity[0][r](row, column_Fy);
      for (std::size_t j = 0; j < 3; ++j)
        reading.q[j] += ripple * bent.sensitivity[0][r](row, column_q + static_cast<Eigen::Index>(j));
    }
  }
  return experiment;
}

std::vector<std::string> said(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const EffectAt& at : diagnosis.cause.ranking[diagnosis.cause.best].hypothesis.fit.candidate.effects)
    names.push_back(at.label());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("a nominal experiment with a mis-declared sigma has no gap") {
  const Diagnosis diagnosis =
      plumbline::diagnose::diagnose(Study(with_readings(unread_bench(), {}, {}, 1, 1.4)));
  CHECK_FALSE(diagnosis.gap.present);
  CHECK(diagnosis.cause.verdict == CauseVerdict::none);
}

TEST_CASE(
    "how large a gap is, channel by channel in its unit, is the rms of what is read beside the nominal "
    "model") {
  const Study study(with_readings(unread_bench(), {}, {}, 1));
  std::map<Channel, double> squares, count;
  for (std::size_t r = 0; r < study.experiment().runs.size(); ++r) {
    const Run& run = study.experiment().runs[r];
    for (const Channel& channel : run.measured())
      for (std::size_t i = 0; i < run.readings.size(); ++i) {
        const double nominal = study.nominal().runs[r](static_cast<Eigen::Index>(i), column_of(channel));
        squares[channel] += std::pow(channel.of(run.readings[i]) - nominal, 2);
        count[channel] += 1;
      }
  }
  const std::map<Channel, double> rms = plumbline::diagnose::diagnose(study).gap.rms;
  REQUIRE(rms.size() == 5);  // two forces and three angles
  for (const auto& [channel, value] : rms) {
    CAPTURE(channel.label());
    CHECK(value == close_to(std::sqrt(squares[channel] / count[channel])));
  }
}

TEST_CASE("readings that scatter many times what was declared are no gap, but may hide a ripple") {
  Experiment forces = test::three_links(), positions = forces;
  test::press(forces, {0.3, -0.5, 0.4}, {-0.05, 0}, 60, true);
  test::load(positions, {0.2, 0.3, -0.3}, {0, 0}, {-2.0, 1.0}, 120);
  for (Experiment* bench : {&forces, &positions}) {
    for (Reading& reading : bench->runs[0].readings) reading.q.clear();
    for (const double times : {1.0, 3.0, 6.0, 13.0}) {
      CAPTURE(times);
      Experiment experiment = *bench;
      const Noise declared = experiment.noise;
      for (double* sigma :
           {&experiment.noise.x, &experiment.noise.y, &experiment.noise.Fx, &experiment.noise.Fy})
        *sigma *= times;
      experiment = test::measured(experiment, {}, {}, 5);
      experiment.noise = declared;
      const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(experiment));
      CHECK(diagnosis.cause.verdict == CauseVerdict::none);
      CHECK((as_text(diagnosis).find("may hide in it") != std::string::npos) == (times > 5));
    }
  }
}

TEST_CASE(
    "one cause is identified, with its joint, its parameter within bounds, and the shrink at the noise") {
  const Study study(with_readings(unread_bench(), {{{"backlash", 2}}}, {0.04}, 2));
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(study);
  CHECK(diagnosis.cause.verdict == CauseVerdict::identified);
  CHECK(said(diagnosis) == std::vector<std::string>{"backlash(2)"});
  const Estimate& b = diagnosis.estimates.at(0).at(0);
  CHECK(b.low < 0.04);
  CHECK(b.high > 0.04);
  // bounds of 95 %: 1.96 deviations to either side where the parameter acts nearly linearly; of 90 %: 1.64
  FitSettings settings;
  settings.noise = diagnosis.noise;
  const double deviation = std::sqrt(fit(study, {{{"backlash", 2}}}, settings).covariance(0, 0));
  CHECK((b.high - b.low) / (2 * deviation) == close_to(1.96).epsilon(0.04));
  CHECK(diagnosis.where.joints.front().joint == 2);
  REQUIRE(diagnosis.shrink);
  CHECK(diagnosis.shrink->ratio_low <= diagnosis.shrink->noise_floor_ratio * 1.1);
  CHECK(diagnosis.shrink->ratio < 0.5);
}

TEST_CASE("two causes at once are both named" * doctest::test_suite("long")) {
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(
      with_readings(unread_bench(), {{{"joint_friction", 0}, {"joint_stiffness", 1}}}, {0.03, 0.3}, 3)));
  CHECK(diagnosis.cause.verdict == CauseVerdict::identified);
  CHECK(said(diagnosis) == std::vector<std::string>{"joint_friction", "joint_stiffness(1)"});
}

TEST_CASE("hum beside a gap is taken out of the readings, and said") {
  Experiment humming = with_readings(unread_bench(), {{{"joint_friction"}}}, {0.03}, 3);
  for (Run& run : humming.runs)
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      const double wave = std::sin(2 * std::numbers::pi * static_cast<double>(i) / 3.7);
      run.readings[i].Fx += 3 * humming.noise.Fx * wave;
      run.readings[i].Fy += 3 * humming.noise.Fy * wave;
    }
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(humming));
  CHECK(said(diagnosis) == std::vector<std::string>{"joint_friction"});
  CHECK(diagnosis.cause.verdict == CauseVerdict::identified);
  CHECK(diagnosis.gap.hum.size() == 2 * humming.runs.size());
  for (const HummingChannel& one : diagnosis.gap.hum) {
    CHECK(one.channel.sensor() == Sensor::force);
    CHECK(one.period == doctest::Approx(3.7).epsilon(0.05));
    CHECK(one.rms == doctest::Approx(3 / std::numbers::sqrt2).epsilon(0.25));
  }
  // What is left is the noise that was put in.
  CHECK(diagnosis.cause.ranking[diagnosis.cause.best].chi2_per_dof < 1.3);
}

TEST_CASE("values of their own in each run do not stand for what machining leaves" *
          doctest::test_suite("long")) {
  Experiment two_runs = unread_bench();
  two_runs.runs.resize(2);
  const Candidate machined{{{"stiffness_spread"}, {"length_spread"}, {"rest_spread"}}};
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int chain = 0; chain < 8; ++chain) {
    std::vector<double> parameters;
    for (const double tolerance : {0.03, 0.003, 0.006})
      for (int joint = 0; joint < 3; ++joint) parameters.push_back(tolerance * normal(random));
    Experiment experiment = with_readings(two_runs, machined, parameters, 5);
    for (Run& run : experiment.runs)
      for (Reading& reading : run.readings) reading.q.clear();
    const Diagnosis answer = diagnose::diagnose(Study(experiment));
    CAPTURE(answer.cause.ranking[answer.cause.best].hypothesis.fit.candidate.label());
    std::vector<Fit> named{answer.cause.ranking[answer.cause.best].hypothesis.fit};
    for (const std::size_t place : answer.cause.equivalent)
      named.push_back(answer.cause.ranking[place].hypothesis.fit);
    CHECK(std::any_of(named.begin(), named.end(), [](const Fit& one) {
      const auto& effects = one.candidate.effects;
      return std::none_of(effects.begin(), effects.end(),
                          [](const EffectAt& at) { return at.effect->id.starts_with("run_"); });
    }));
  }
}

TEST_CASE("what no run can separate is one class") {
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(
      Study(with_readings(unread_bench(), {{{"train_compliance", 0}}}, {0.002}, 4)));
  CHECK(diagnosis.cause.verdict == CauseVerdict::ambiguous);
  CHECK(diagnosis.cause.equivalent.size() == 1);
  const auto& other = diagnosis.cause.ranking[diagnosis.cause.equivalent.front()].hypothesis.fit.candidate;
  const auto names = said(diagnosis);
  CHECK(((names.front() == "train_compliance" && other.effects.front().label() == "base_compliance") ||
         (names.front() == "base_compliance" && other.effects.front().label() == "train_compliance")));
}

TEST_CASE(
    "a stop that one run alone shows is found and tested on blocks of it, and may be what only that run met" *
    doctest::test_suite("long")) {
  // Joint 3 reaches its stop in the last run alone: without it nothing is known of the stop, and the others
  // have no gap that could shrink.
  Experiment experiment = unread_bench();
  const auto farther = [](Run& run, double times) {
    const double start = run.readings.front().x;
    for (Reading& reading : run.readings) reading.x = start + times * (reading.x - start);
  };
  farther(experiment.runs.front(), 1.3);
  farther(experiment.runs.back(), 1.6);
  const Prediction nominal = predict(Study(experiment), {}, {});
  std::array<double, 4> reach{};
  for (std::size_t r = 0; r < 4; ++r)
    reach[r] = (nominal.runs[r].col(column_q + 2) - experiment.runs[r].rest[2]).abs().maxCoeff();
  REQUIRE(*std::max_element(reach.begin(), reach.end()) == reach[3]);
  const double stop = (reach[3] + *std::max_element(reach.begin(), reach.begin() + 3)) / 2;
  const Diagnosis diagnosis =
      plumbline::diagnose::diagnose(Study(with_readings(experiment, {{{"joint_stop", 3}}}, {stop, 20}, 8)));
  for (const std::string& name : diagnosis.shrink->heldout) CHECK(name.find('[') != std::string::npos);
  CHECK(said(diagnosis) == std::vector<std::string>{"joint_stop(3)"});
  CHECK(diagnosis.cause.verdict == CauseVerdict::ambiguous);
  CHECK(diagnosis.cause.reservation == Reservation::one_run);
  CHECK(diagnosis.shrink->tested());
  CHECK(diagnosis.shrink->ratio < 1.5 * diagnosis.shrink->noise_floor_ratio);
}

TEST_CASE("probabilities of all that is ranked and of the unknown sum to one") {
  const Diagnosis diagnosis =
      plumbline::diagnose::diagnose(Study(with_readings(unread_bench(), {{{"force_gain", 0}}}, {0.1}, 6)));
  double sum = diagnosis.cause.unknown;
  for (const Ranked& one : diagnosis.cause.ranking) sum += one.probability;
  CHECK(sum == close_to(1));
}

TEST_CASE("the next run is proposed on request where the cause is clear") {
  // So weak that the second best is not out of sight.
  const Experiment experiment = with_readings(unread_bench(), {{{"joint_coupling", 0}}}, {0.006}, 2);
  const Diagnosis plain = plumbline::diagnose::diagnose(Study(experiment));
  REQUIRE(plain.cause.verdict == CauseVerdict::identified);
  REQUIRE(plain.cause.ranking.size() > 1);
  CHECK(plain.proposals.empty());
  CHECK_FALSE(plumbline::diagnose::diagnose(Study(experiment), {}, true).proposals.empty());
}

TEST_CASE("a joint whose spring does what no effect does is unknown, and the joint is named" *
          doctest::test_suite("long")) {
  const Experiment experiment = rippled(with_readings(unread_bench(), {}, {}, 5), 0.05);
  const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(experiment));
  CHECK(diagnosis.cause.verdict == CauseVerdict::unknown);
  CHECK(diagnosis.where.joints.front().joint == 2);
  REQUIRE(diagnosis.missing);
  CHECK(diagnosis.missing->what == "torque at joint 2");
  // A function of the angle alone, but for the noise.
  CHECK(diagnosis.missing->by_position > 0.5);
  CHECK(diagnosis.missing->by_direction < diagnosis.missing->by_position + 0.2);
}

TEST_CASE(
    "what leaves more than the readings scatter but no more than is tolerated is named, beside the unknown" *
    doctest::test_suite("long")) {
  struct Lab {
    const char* what;
    Experiment experiment;
    double stiffness, ripple, noise_scale, tolerated;
  };
  Experiment fine = unread_bench();
  fine.noise = {0, 0, 0.0005, 0.0005, 0.00002};
  // A ripple of a third of a declared sigma where readings repeat to a tenth of it; and one of some twenty
  // sigmas beside a gap that is beyond fifty, of which 0.15, or 7.5 sigmas, and more are tolerated.
  const std::vector<Lab> labs{{"declared", unread_bench(), 0.2, 0.0005, 0.1, 1},
                              {"a clear gap", fine, 0.5, 0.002, 1, 7.5}};
  for (const Lab& lab : labs) {
    CAPTURE(lab.what);
    const Experiment experiment = rippled(
        with_readings(lab.experiment, {{{"joint_stiffness", 1}}}, {lab.stiffness}, 9, lab.noise_scale),
        lab.ripple);
    const Diagnosis diagnosis = plumbline::diagnose::diagnose(Study(experiment));
    CHECK(diagnosis.cause.verdict == CauseVerdict::ambiguous);
    CHECK(diagnosis.cause.reservation == Reservation::beyond_noise);
    CHECK(said(diagnosis) == std::vector<std::string>{"joint_stiffness(1)"});
    // What the readings scatter is still what they scatter, not what is tolerated of them.
    CHECK(diagnosis.noise.scale[static_cast<std::size_t>(Channel::Name::Fx)] < lab.tolerated / 2);
  }
}

TEST_CASE("forces that were taken for weights are said to be, by their runs") {
  Experiment experiment = test::full_bench();
  for (Run& run : experiment.runs) run.by_weights = !run.holds_end_point();
  const auto said = [&](bool inferred) {
    Experiment declared = experiment;
    declared.runs[2].weights_inferred = inferred;
    return plumbline::diagnose::diagnose(Study(test::measured(declared, {}, {}, 4)));
  };
  const std::string words = "all forces of load-3 point straight down without noise: assumed to be weights";
  CHECK(as_text(said(true)).find(words) != std::string::npos);
  CHECK(as_json(said(true))["gap"]["assumed_weights"] == nlohmann::json{"load-3"});
  CHECK(as_text(said(false)).find("assumed to be weights") == std::string::npos);
  CHECK(as_json(said(false))["gap"]["assumed_weights"].empty());
}

TEST_CASE("the report as JSON holds what its format asks for") {
  const nlohmann::ordered_json json = as_json(
      plumbline::diagnose::diagnose(Study(with_readings(unread_bench(), {{{"force_gain", 0}}}, {0.1}, 6))));
  CHECK(json["format"] == "gap-diagnosis/2");
  CHECK(json["gap"]["present"] == true);
  CHECK(json["cause"]["verdict"] == "ambiguous");  // nothing else sets a scale of force
  std::set<std::string> named{json["cause"]["effects"][0]["id"]};
  for (const auto& one : json["cause"]["equivalent"]) named.insert(one[0]);
  CHECK(named.contains("force_gain"));
  CHECK(named.contains("stiffness_scale"));
  CHECK(json["cause"]["effects"][0]["joint"].is_null());
  for (const char* list : {"channels", "runs", "load_path", "joints"}) {
    double sum = 0;
    for (const auto& entry : json["where"][list]) sum += entry["share"].get<double>();
    CHECK(sum == close_to(1));
  }
  CHECK(json["shrink"]["ratio"].get<double>() < 0.5);
  CHECK_FALSE(
      as_text(plumbline::diagnose::diagnose(Study(with_readings(unread_bench(), {}, {}, 7)))).empty());
}

TEST_CASE(
    "elements that may change places are told in the order in which they yield, by the names of their "
    "places") {
  std::vector<Estimate> told{{"r_1", "ratio", 0.7, 0.6, 0.8, false}, {"d_1", "rad", 0.3, 0.2, 0.4, true},
                             {"r_2", "ratio", 0.9, 0.8, 1.0, true},  {"d_2", "rad", 0.1, 0.05, 0.15, false},
                             {"r_3", "ratio", 0.1, 0.0, 0.2, false}, {"d_3", "rad", 0.2, 0.15, 0.25, false}};
  put_in_order(told, 2);
  std::vector<std::string> names;
  std::vector<double> values, lows, highs;
  std::vector<bool> at_bound;
  for (const Estimate& one : told) {
    names.push_back(one.name);
    values.push_back(one.value);
    lows.push_back(one.low);
    highs.push_back(one.high);
    at_bound.push_back(one.at_bound);
  }
  CHECK(names == std::vector<std::string>{"r_1", "d_1", "r_2", "d_2", "r_3", "d_3"});
  CHECK(values == std::vector<double>{0.9, 0.1, 0.1, 0.2, 0.7, 0.3});
  CHECK(lows == std::vector<double>{0.8, 0.05, 0.0, 0.15, 0.6, 0.2});
  CHECK(highs == std::vector<double>{1.0, 0.15, 0.2, 0.25, 0.8, 0.4});
  CHECK(at_bound == std::vector<bool>{true, false, false, false, false, true});
  for (const char* const id : {"hysteresis", "relaxation_spectrum"})
    CHECK(EffectAt(id).effect->element_size == 2);
}
