/// \file
/// A joint alone: its torque at an imposed angle, its angle under an imposed torque.

#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <algorithm>
#include <cmath>

#include "diagnose/inference/study.hpp"
#include "diagnose/rig/history.hpp"
#include "diagnose/rig/joint_law.hpp"
#include "diagnose/rig/nominal.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

// Newton stops with steps below 1e-7 rad, which leaves errors of their square.
constexpr double nearly = 1e-9;

/// Angles or torques there, back, and to the other side.
Experiment joint_alone(Control control, double stiffness, double most) {
  Experiment experiment;
  experiment.name = "a joint";
  experiment.device = Device::turning_joint;
  experiment.link_length = {1};
  experiment.joint_stiffness = {stiffness};
  experiment.link_mass = {0};
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::horizontal, {0, 0}, false};
  experiment.noise[Channel::Name::angle] = 1e-4;
  experiment.noise[Channel::Name::torque] = 1e-3;
  Run run{"loop", control, {0.05}, {}};
  run.device = Device::turning_joint;
  for (int i = 0; i <= 40; ++i) {
    const double at = most * std::sin(2 * M_PI * i / 40);
    const double there = control == Control::end_point ? 0.05 + at : at;
    run.readings.push_back({0.5 * i,
                            {control == Control::end_point ? there : nan_value(), 0,
                             control == Control::end_point ? nan_value() : there, 0}});
  }
  experiment.runs = {run};
  return experiment;
}

double shown(const Prediction& predicted, Eigen::Index reading, Channel::Name name) {
  return predicted.runs[0](reading, Channel(name).column);
}

using ChannelName = Channel::Name;

}  // namespace

TEST_CASE("the torque of a spring is its stiffness times the deflection, of any sign and size") {
  for (const double most : {3e-4, 0.5, 2.5}) {
    const Experiment experiment = joint_alone(Control::end_point, 7, most);
    const Prediction predicted = simulate(experiment, nominal_rig(experiment), {});
    REQUIRE(predicted.reached);
    CHECK_FALSE(predicted.snapped);
    for (Eigen::Index i = 0; i <= 40; ++i)
      CHECK(std::abs(shown(predicted, i, ChannelName::torque) -
                     7 * (shown(predicted, i, ChannelName::angle) - 0.05)) < 7 * nearly);
  }
}

TEST_CASE("an imposed torque gives the angle at which it is measured") {
  rc::check("with hardening, play and friction", [] {
    const double k = *rc::gen::inRange(1, 200), share = *rc::gen::inRange(1, 9) / 10.0;
    const Experiment held = joint_alone(Control::end_point, k, 0.3);
    Rig rig = nominal_rig(held);
    rig.hardening = {share};
    rig.friction = {0.02 * share * k};
    const Prediction torque = simulate(held, rig, {});
    RC_ASSERT(torque.reached);
    Experiment loaded = joint_alone(Control::force, k, 0);
    for (std::size_t i = 0; i < 41; ++i)
      loaded.runs[0].readings[i][column_Fx] =
          shown(torque, static_cast<Eigen::Index>(i), ChannelName::torque);
    const Prediction angle = simulate(loaded, rig, {});
    RC_ASSERT(angle.reached);
    // Friction that sticks gives by 1e-5 of its deflection at the slip torque, 0.02 share; where the angle
    // turns back, the torque falls by twice the friction, and the angle stays within that.
    for (Eigen::Index i = 0; i <= 40; ++i)
      RC_ASSERT(std::abs(shown(angle, i, ChannelName::angle) - shown(torque, i, ChannelName::angle)) < 1e-5);
  });
}

TEST_CASE("dry friction makes a loop of twice its torque") {
  const Experiment experiment = joint_alone(Control::end_point, 10, 0.4);
  Rig rig = nominal_rig(experiment);
  rig.friction = {0.3};
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  for (const Eigen::Index i : {5, 15, 25, 35}) {
    const double spring = 10 * (shown(predicted, i, ChannelName::angle) - 0.05),
                 way = i < 10 || i > 30 ? 1 : -1;
    CHECK(shown(predicted, i, ChannelName::torque) == doctest::Approx(spring + way * 0.3).epsilon(1e-6));
  }
}

TEST_CASE("a loop that begins on the way has slipped before its first reading") {
  Experiment experiment = joint_alone(Control::end_point, 10, 0.4);
  experiment.runs[0].begins_moving = true;
  Rig rig = nominal_rig(experiment);
  rig.friction = {0.3};
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  CHECK(shown(predicted, 0, ChannelName::torque) == doctest::Approx(0.3).epsilon(1e-6));
}

TEST_CASE("an imposed angle is followed past the largest torque") {
  const Experiment experiment = joint_alone(Control::end_point, 10, 0.5);
  Rig rig = nominal_rig(experiment);
  rig.hardening = {-3};  // k d (1 - 3 d^2) is largest at d = 1/3
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  CHECK(shown(predicted, 10, ChannelName::torque) == doctest::Approx(10 * 0.5 * (1 - 0.75)).epsilon(1e-9));
}

TEST_CASE("sensitivities are those of two rigs, and the load sensor's are exact") {
  const Experiment experiment = joint_alone(Control::end_point, 10, 0.4);
  const Study study(experiment);
  const Candidate all{{{"load_zero"}, {"load_gain"}, {"joint_stiffness", 1}}};
  const Prediction predicted = predict(study, all, {0.1, 0.2, std::log1p(0.3)}, true);
  REQUIRE(predicted.reached);
  for (Eigen::Index i = 0; i <= 40; ++i) {
    const double spring = 10 * (shown(predicted, i, ChannelName::angle) - 0.05);
    CHECK(shown(predicted, i, ChannelName::torque) == doctest::Approx(1.2 * 1.3 * spring + 0.1).scale(1));
    CHECK(predicted.sensitivity[0][0](i, column_Fx) == doctest::Approx(1));
    CHECK(predicted.sensitivity[1][0](i, column_Fx) == doctest::Approx(1.3 * spring).scale(1));
    // by the logarithm of the stiffness
    CHECK(predicted.sensitivity[2][0](i, column_Fx) == doctest::Approx(1.2 * 1.3 * spring).scale(1));
  }
}

TEST_CASE("only effects of a joint and of its load sensor are possible") {
  const Study study(joint_alone(Control::end_point, 10, 0.4));
  bool bearing = false, sensor = false;
  for (const EffectAt& at : possible_effects(study)) {
    CAPTURE(at.label());
    for (const ParameterRange& range : study.ranges(at)) {
      CHECK(range.unit != "m");
      CHECK(range.unit != "N");
      CHECK(range.unit != "1/N");
      CHECK(range.unit != "m/N");
    }
    bearing = bearing || at.label() == "joint_friction";
    sensor = sensor || at.label() == "sensor_drift";
  }
  CHECK(bearing);
  CHECK(sensor);
}

TEST_CASE("at a joint that slides every unit of turning is one of sliding") {
  Experiment experiment = joint_alone(Control::end_point, 10, 0.004);
  experiment.device = experiment.runs[0].device = Device::sliding_joint;
  const Study study(experiment);
  for (const EffectAt& at : possible_effects(study))
    for (const ParameterRange& range : study.ranges(at)) {
      CAPTURE(at.label());
      CAPTURE(std::string(range.unit));
      CHECK(range.unit.find("rad") == std::string_view::npos);
      CHECK(range.unit.find("N m") == std::string_view::npos);
    }
}

TEST_CASE("noise of the imposed channel reaches the measured one through the spring") {
  Experiment held = joint_alone(Control::end_point, 10, 0.4);
  for (Reading& one : held.runs[0].readings) one[column_Fx] = 10 * (one[column_x] - 0.05);
  CHECK(Study(held).measurements().sigma()(0) == doctest::Approx(std::hypot(1e-3, 10 * 1e-4)));
  Experiment loaded = joint_alone(Control::force, 10, 0.4);
  for (Reading& one : loaded.runs[0].readings) one[column_x] = 0.05 + one[column_Fx] / 10;
  CHECK(Study(loaded).measurements().sigma()(0) == doctest::Approx(std::hypot(1e-4, 1e-3 / 10)));
}

TEST_CASE("ranges of angles follow joints that hardly turn") {
  // The torque of 0.3 mrad turns by 0.09 mrad: nine thousandths of 0.01 rad. Nine readings of ten, in steps
  // of 9 degrees of a sine, stay below its value at 81 degrees.
  const double turn = 0.009 * std::sin(0.45 * M_PI);
  Experiment read = joint_alone(Control::end_point, 2.2, 3e-4);
  for (Reading& one : read.runs[0].readings) one[column_Fx] = 2.2 * (one[column_x] - 0.05);
  const std::vector<ParameterRange> ranges = Study(read).ranges({"rest_angle", 1});
  CHECK(ranges[0].high == doctest::Approx(0.6 * turn));
  CHECK(ranges[0].scale == doctest::Approx(0.05 * turn));
}

TEST_CASE("a slider behind play carries its torque at most, and turns back through the play first") {
  constexpr double k = 7, play = 0.02, most = 0.6;
  const Experiment experiment = joint_alone(Control::end_point, k, 0.3);
  Rig rig = nominal_rig(experiment);
  rig.backlash = {play};
  rig.slip = {most};
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  double slid = 0;  // the slider follows the joint beyond what play and spring allow
  for (Eigen::Index i = 0; i <= 40; ++i) {
    const double d = shown(predicted, i, ChannelName::angle) - 0.05, reach = play + most / k;
    slid = std::clamp(slid, d - reach, d + reach);
    const double stretched = std::copysign(std::max(std::abs(d - slid) - play, 0.0), d - slid);
    // A slipping spring keeps one part in `slipping` of its stiffness, over 0.6 rad of way.
    CHECK(std::abs(shown(predicted, i, ChannelName::torque) - k * stretched) < k * 0.6 / JointLaw::slipping);
  }
}
