/// \file
/// The loop closed: a robot's MJCF, an effect added in MuJoCo, the lab's files in millimetres, the diagnosis,
/// the corrected MJCF, and in MuJoCo the gap is gone.
#include <doctest/doctest.h>

#include "diagnose/exchange/ways.hpp"
#include "tests/diagnose/exchange/lab.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::CauseVerdict, diagnose::EffectAt, diagnose::Study, test::apart, test::in_mujoco, test::Lab,
    test::RoundTrip;

std::string replaced(std::string text, const std::string& one, const std::string& other) {
  const std::size_t at = text.find(one);
  REQUIRE(at != std::string::npos);
  return text.replace(at, one.size(), other);
}

std::string named(const RoundTrip& trip) {
  return trip.diagnosis.cause.ranking.front().cause.label();
}

/// Noise has size one. What joints at rest add to it is less than half of it. On the way damping drags beside
/// dry friction: the robot's own, of which the diagnosis makes friction too, and that of what is added.
void check_gone(const RoundTrip& trip, const Lab& lab, test::Pace pace) {
  CAPTURE(trip.before);
  CAPTURE(trip.after);
  CHECK(trip.diagnosis.gap.present);
  const Study bare(lab.experiment);
  const double drag =
      pace == test::Pace::interpolated
          ? 0.06 * trip.before +
                apart(bare, in_mujoco(test::robot_alone(), lab.experiment, pace), bare.nominal())
          : 0;
  CAPTURE(drag);
  CHECK(trip.after * trip.after < 1.25 + drag * drag);
}

}  // namespace

TEST_CASE("attributes of a robot's MJCF changed by hand are named, and the corrected file has them" *
          doctest::test_suite("long")) {
  struct Change {
    std::string one, other, cause;
  };
  for (const Change& change :
       {Change{"stiffness=\"1.5\"", "stiffness=\"1.95\"", "joint_stiffness(2)"},
        Change{"pos=\"0.25 0 0\" quat", "pos=\"0.26 0 0\" quat", "link_length(2)"},
        Change{"springref=\"28.64788975654116\"", "springref=\"31\"", "rest_angle(2)"},
        Change{"<body name=\"thigh\"", "<body name=\"thigh\" pos=\"0.004 -0.003 0\"", "position_offset"}}) {
    CAPTURE(change.cause);
    const Lab lab(12);
    const test::Pace pace = test::Pace::at_rest;
    const RoundTrip trip =
        round_trip(lab, lab.experiment, replaced(test::robot_alone(), change.one, change.other), pace, 7);
    REQUIRE(trip.diagnosis.cause.verdict != CauseVerdict::none);
    CHECK(named(trip) == change.cause);
    check_gone(trip, lab, pace);
  }
}

TEST_CASE("round trips: every effect that MJCF carries" * doctest::test_suite("long")) {
  // What lags is taken to go straight from reading to reading: these are close for it.
  const Lab lab(12), fine(40);
  for (const EffectAt& at : test::carried(Study(lab.experiment), Format::mjcf, 2)) {
    // Alone it cannot weigh while the robot's own links do not.
    if (at.effect->id == "tip_payload") continue;
    // Its fit ends in a local optimum on this bench (docs/how-it-decides.md lists what fails).
    if (at.effect->id == "hysteresis") continue;
    CAPTURE(at.label());
    const Lab& own = at.effect->id == "sensor_lag" ? fine : lab;
    const Study bare(test::bench_in(own, at));
    const Model truth =
        corrected_models(bare, test::found(bare, at, test::amount_of(bare, at)), own.folder / "robot.xml")
            .front()
            .model;
    const test::Pace pace = test::pace_of(at.effect->id);
    const RoundTrip trip = round_trip(own, bare.experiment(), written(truth, Format::mjcf).text, pace, 11);
    CHECK(trip.diagnosis.cause.verdict != CauseVerdict::unknown);
    check_gone(trip, own, pace);
  }
}

}  // namespace plumbline::exchange
