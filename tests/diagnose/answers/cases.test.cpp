#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/bench/decimate.hpp"
#include "diagnose/bench/read_experiment.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

Diagnosis diagnosed(const std::string& name) {
  return diagnose::diagnose(
      Study(decimated(read_experiment(PLUMBLINE_SOURCE_DIR "/tests/cases/" + name, nullptr))));
}

/// Whether a cause of exactly these effects is among those named.
bool names(const Diagnosis& diagnosis, std::vector<std::string> effects) {
  std::sort(effects.begin(), effects.end());
  for (std::size_t i = 0; i < diagnosis.cause.named; ++i) {
    std::vector<std::string> own;
    for (const EffectAt& at : diagnosis.cause.ranking[i].cause.effects) own.push_back(at.label());
    std::sort(own.begin(), own.end());
    if (own == effects) return true;
  }
  return false;
}

bool hedges(const Diagnosis& diagnosis) {
  return diagnosis.cause.verdict == CauseVerdict::unknown || diagnosis.cause.or_unknown;
}

}  // namespace

TEST_CASE("a stop that two readings show is a gap, and a stop among its causes") {
  for (const char* bench : {"two-readings-at-the-end", "two-readings-at-the-turn"}) {
    CAPTURE(bench);
    const Diagnosis diagnosis = diagnosed(bench);
    CHECK(diagnosis.gap.present);
    CHECK(names(diagnosis, {"joint_stop(1)"}));
  }
}

TEST_CASE("a stop far stiffer than the spring is found") {
  const Diagnosis diagnosis = diagnosed("stiff-stop");
  CHECK(diagnosis.gap.present);
  CHECK((names(diagnosis, {"joint_stop(1)"}) || hedges(diagnosis)));
  REQUIRE_FALSE(diagnosis.cause.ranking.empty());
  CHECK(diagnosis.cause.ranking.front().hypothesis.candidate.label() == "joint_stop(1)");
}

TEST_CASE("a payload is found in a sag test without forces") {
  CHECK(names(diagnosed("sag-with-payload"), {"tip_payload"}));
}

TEST_CASE("the weight of an arm is found in five poses of a servo") {
  CHECK(names(diagnosed("servo-sag"), {"gravity"}));
}

TEST_CASE("dry friction that gives before it slips is dry friction") {
  const Diagnosis diagnosis = diagnosed("presliding-friction");
  CHECK(diagnosis.cause.verdict == CauseVerdict::identified);
  CHECK(names(diagnosis, {"joint_friction"}));
}

TEST_CASE("the order of the loads hides no soft spring") {
  for (const char* bench : {"alternating", "zero-return"}) {
    CAPTURE(bench);
    CHECK(names(diagnosed(bench), {"joint_stiffness(1)"}));
  }
}

TEST_CASE("few readings of a strange device are never surely without a gap") {
  CHECK(diagnosed("tenth-of-the-readings").gap.probability > 0.5);
}

TEST_CASE("few readings of a strange device name no cause alone") {
  CHECK(diagnosed("tenth-of-the-readings").cause.verdict != CauseVerdict::identified);
}

TEST_CASE("a run that is written as two names what the whole names") {
  CHECK(names(diagnosed("run-in-two-files"), {"rail_misalignment"}));
}

TEST_CASE("declared noise of a thirty-third hides no soft spring") {
  const Diagnosis diagnosis = diagnosed("sigma-33-times-too-small");
  CHECK(diagnosis.gap.present);
  CHECK((names(diagnosis, {"joint_stiffness(2)"}) || hedges(diagnosis)));
}

TEST_CASE("a run that alone is in another unit is explained by no cause of the whole") {
  CHECK(hedges(diagnosed("one-run-in-another-unit")));
}

TEST_CASE("a servo that stops at 26 degrees, whatever it is told, has a limit of travel there") {
  const Diagnosis diagnosis = diagnosed("travel-limit");
  CHECK(diagnosis.cause.verdict == CauseVerdict::identified);
  REQUIRE(names(diagnosis, {"upper_limit(1)"}));
  // Thirteen readings there, each to 0.3 degrees.
  CHECK(std::abs(diagnosis.estimates[0][0].value - 26 * std::numbers::pi / 180) < 4 * 0.0052 / std::sqrt(13));
}

TEST_CASE("a slider of 10 kN behind a spring with 3 mm of play each way is friction in series with play") {
  const Diagnosis diagnosis = diagnosed("slider-behind-play");
  CHECK(diagnosis.cause.verdict == CauseVerdict::identified);
  CHECK(names(diagnosis, {"backlash(1)", "series_friction(1)"}));
}
