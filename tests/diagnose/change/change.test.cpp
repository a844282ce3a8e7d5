#include "diagnose/change/change.hpp"

#include <plumbline/base/error.hpp>

#include "diagnose/change/change_report.hpp"
#include "diagnose/priors.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// One run there and back, whose readings are so many a way.
Experiment swept(int steps, double interval = 2) {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, steps, true, interval);
  return experiment;
}

const Candidate lack{{{"hysteresis", 0}}};
const std::vector<double> of_lack{0.3, 0.02, 0.2, 0.05, 0.1, 0.1};
const Candidate friction = only("joint_friction");

/// The largest value that is left, in declared sigmas, and how many there are.
std::pair<double, Eigen::Index> left(const RelativeReadings& relative) {
  const Study study(relative.experiment);
  const VectorXd residual = study.nominal_residual();
  return {residual.cwiseAbs().maxCoeff(), residual.size()};
}

Experiment without_noise(Experiment experiment, const Candidate& truth,
                         const std::vector<double>& parameters) {
  const Noise declared = experiment.noise;
  experiment.noise = {};
  for (double& one : experiment.noise.sigma) one = 1e-12;
  experiment = measured(experiment, truth, parameters, 1);
  experiment.noise = declared;
  return experiment;
}

}  // namespace

TEST_CASE("a lack that both states share leaves nothing, though it is many sigmas") {
  const Study one(without_noise(swept(20), lack, of_lack));
  REQUIRE(one.nominal_residual().cwiseAbs().maxCoeff() > 10);
  const RelativeReadings same = relative_to(one, one.experiment());
  CHECK(left(same).second == one.nominal_residual().size());
  // rounding of forces of 10 N, over a sigma of 0.01 N
  CHECK(left(same).first < 1e-10);
}

TEST_CASE("the declared noise is that of a difference") {
  const Study one(swept(10));
  const RelativeReadings relative = relative_to(one, one.experiment());
  for (const Channel::Name name : {Channel::Name::Fx, Channel::Name::q})
    CHECK(relative.experiment.noise[name] == close_to(std::sqrt(2.0) * one.experiment().noise[name]));
}

TEST_CASE("commands between those of the other state are compared by interpolation, on the same way") {
  const Study coarse(without_noise(swept(40), lack, of_lack));
  const Experiment fine = without_noise(swept(50), lack, of_lack);
  const RelativeReadings relative = relative_to(coarse, fine);
  // Two thirds of the readings of the finer run find a reading that has not counted yet: 81 of 101, less
  // those that share one.
  CHECK(relative.runs.front().paired > 60);
  CHECK(relative.runs.front().paired <= 81);
  // The lack of the two ways differs by tens of sigmas: had they been mixed, that would be left.
  CHECK(left(relative).first < 0.05 * Study(fine).nominal_residual().cwiseAbs().maxCoeff());
}

TEST_CASE("an offset of the clock and another rate are no change") {
  const Study slow(without_noise(swept(20, 2), lack, of_lack));
  Experiment fast = without_noise(swept(20, 0.5), lack, of_lack);
  for (Reading& reading : fast.runs.front().readings) reading.t += 1000;
  const RelativeReadings relative = relative_to(slow, fast);
  CHECK(relative.runs.front().rate == close_to(4));
  CHECK(left(relative).first < 1e-10);
}

TEST_CASE("a part of the path that the other state never took is left out, and counted") {
  const Study whole(without_noise(swept(20), lack, of_lack));
  Experiment half = whole.experiment();
  half.runs.front().readings.resize(11);  // half of the way there
  const RelativeReadings relative = relative_to(Study(half), whole.experiment());
  CHECK(relative.runs.front().paired == 11);
  CHECK(relative.runs.front().of == 41);
  CHECK(left(relative).first < 1e-10);
}

TEST_CASE("without commands in common, or with another nominal model, nothing is compared") {
  const Study one(swept(20));
  Experiment elsewhere = three_links();
  press(elsewhere, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 15, false);
  CHECK_THROWS_WITH_AS(
      relative_to(one, elsewhere),
      "--against: found 0 readings at commands that the other state has too, expected at least 5: "
      "repeat the runs of one state in the other",
      Error);
  Experiment other = swept(20);
  other.joint_stiffness[1] = 3;
  CHECK_THROWS_AS(what_changed(one, Study(other)), Error);
}

TEST_CASE("two data sets of one device show no change, though its model lacks an effect") {
  const Study before(measured(swept(20), lack, of_lack, 71)), after(measured(swept(20), lack, of_lack, 72));
  REQUIRE(before.nominal_residual().cwiseAbs().maxCoeff() > 10);
  const Change change = what_changed(before, after);
  CHECK(change.diagnosis.cause.verdict == CauseVerdict::none);
  CHECK(check(change) == Check::same);
}

TEST_CASE("a check says 0, 1 and 2 on either side of its limits") {
  CHECK(static_cast<int>(check_of(priors::check_is_sure / 2)) == 0);
  CHECK(static_cast<int>(check_of(1 - priors::check_is_sure / 2)) == 1);
  CHECK(static_cast<int>(check_of(0.5)) == 2);
}

TEST_SUITE_BEGIN("long");

TEST_CASE("an effect that came is there now, and one that went was there before: the other way round") {
  Candidate both = lack;
  both.effects.push_back(friction.effects.front());
  std::vector<double> values = of_lack;
  values.push_back(0.03);
  const Study less(measured(swept(20), lack, of_lack, 73)), more(measured(swept(20), both, values, 74));
  const Change came = what_changed(less, more), went = what_changed(more, less);
  for (const Change* change : {&came, &went}) {
    INFO(as_text(*change));
    REQUIRE(change->diagnosis.cause.is_explained());
    CHECK(change->diagnosis.cause.ranking.front().cause == friction);
    const Estimate& torque = change->diagnosis.estimates.front().front();
    CHECK(torque.low <= 0.03);
    CHECK(torque.high >= 0.03);
    CHECK(check(*change) == Check::changed);
  }
  CHECK(came.sense == Sense::added);
  CHECK(went.sense == Sense::removed);
  // The same two sets of readings: both senses change places, and nothing else does.
  CHECK(came.sense_probability == close_to(went.sense_probability));
  CHECK(as_text(came).find("dry friction in the joints, there now and not before") != std::string::npos);
  CHECK(as_json(went)["against"]["sense"] == "removed");
}

TEST_CASE("a stiffer end that came is no softer one that went: the state before needs the simpler model") {
  const Candidate stop = only("joint_stop", 2);
  const Study without(measured(swept(20), {}, {}, 75)), with(measured(swept(20), stop, {0.05, 1}, 76));
  const Change came = what_changed(without, with), went = what_changed(with, without);
  for (const Change* change : {&came, &went}) {
    INFO(as_text(*change));
    REQUIRE(change->diagnosis.cause.is_explained());
    CHECK(change->diagnosis.cause.ranking.front().cause == stop);
  }
  CHECK(came.sense == Sense::added);
  CHECK(went.sense == Sense::removed);
}

TEST_CASE("a payload at rest is found within a twentieth, beside a lack that both states share") {
  constexpr double weight = 0.5;
  Candidate both = lack;
  both.effects.push_back(only("tip_payload").effects.front());
  std::vector<double> values = of_lack;
  values.push_back(weight);
  const Change change = what_changed(Study(measured(full_bench(), lack, of_lack, 77)),
                                     Study(measured(full_bench(), both, values, 78)));
  INFO(as_text(change));
  REQUIRE(change.diagnosis.cause.is_explained());
  CHECK(change.diagnosis.cause.ranking.front().cause == only("tip_payload"));
  CHECK(change.diagnosis.estimates.front().front().value == close_to(weight).epsilon(0.05));
  CHECK(change.sense == Sense::added);
}

TEST_SUITE_END();
