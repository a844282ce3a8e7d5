/// \file
/// Arms that sensors beside a tracker measure: distances, a camera, an inclinometer, contacts with a plane.

#include "diagnose/bench/sensor_registration.hpp"
#include "diagnose/calibration/calibration.hpp"
#include "diagnose/inference/calibration.hpp"
#include "tests/diagnose/arms.hpp"

namespace plumbline::diagnose::test {
namespace {

using Name = Channel::Name;

const ArmSensorKind& kind(std::string_view key) {
  return *std::ranges::find(arm_sensor_kinds(), key, &ArmSensorKind::key);
}

Pose<double> pose(const Vector3<double>& place, const Vector3<double>& turn = Vector3<double>::Zero()) {
  Pose<double> at = Pose<double>::Identity();
  at.translation() = place;
  at.linear() = rotation_by(turn);
  return at;
}

/// A camera at x = 2 m that looks back at the arm: its axes are y, -z and -x of the world.
Pose<double> in_front() {
  Pose<double> at = pose({2, 0.1, 0.4});
  at.linear() << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  return at;
}

/// Where each kind of sensor stands; the plane lies below the arm, a little tilted.
std::vector<ArmSensor> one_of_each() {
  return {{"bar", &kind("distance"), 0, pose({0.9, -0.5, 0.1})},
          {"camera", &kind("camera"), 0, in_front(), 1400},
          {"level", &kind("inclinometer"), 1, pose({0, 0, 0}, {0.004, -0.003, 0})},
          {"floor", &kind("plane"), 0, pose({0, 0, -0.2}, {0.1, -0.05, 0})}};
}

/// An arm that only these sensors measure, its plate turned on link 3.
Experiment seen_by(const std::vector<ArmSensor>& sensors) {
  Experiment experiment = arm_bench(industrial_arm(0), 80);
  experiment.arm_bench.points.push_back({"plate", {2, pose({0.02, 0.03, 0}, {0.7, -0.4, 0.2})}});
  experiment.arm_bench.sensors = sensors;
  experiment.noise = {};
  experiment.noise[Name::distance] = experiment.noise[Name::height] = 2e-5;
  experiment.noise[Name::pixel] = 0.05, experiment.noise[Name::inclination] = 5e-5;
  for (Run& run : experiment.runs) {
    run.points = 2;
    run.of_sensors = experiment.arm_bench.sensor_channels(6);
    for (Reading& reading : run.readings) {
      reading.value.resize(4);
      for (const Channel& channel : run.of_sensors) channel.in(reading) = 0;
    }
  }
  experiment.arm_bench.frames = ArmBench::Frames::unknown;
  return experiment;
}

/// The same readings; sensors, point and plate are said to be elsewhere, by a few centimetres and tenths of a
/// radian.
Experiment said_elsewhere(Experiment experiment) {
  const Pose<double> off = pose({0.03, -0.05, 0.04}, {0.2, 0.1, -0.15});
  for (ArmSensor& sensor : experiment.arm_bench.sensors) {
    if (!sensor.kind->sees_turns) sensor.at = sensor.at * off;
  }
  experiment.arm_bench.points[0].at.frame = experiment.arm_bench.points[0].at.frame * off;
  experiment.arm_bench.points[1].at.frame = experiment.arm_bench.points[1].at.frame * off;
  return experiment;
}

/// A camera's focal length is not known.
Experiment without_focal_length(Experiment experiment) {
  for (ArmSensor& sensor : experiment.arm_bench.sensors)
    if (sensor.kind->has_focal_length) sensor.focal_length = 1, sensor.knows_focal_length = false;
  return experiment;
}

/// Zeros of two milliradians at all joints, and an encoder of joint 2 that is off its axis by as much.
Experiment off_everywhere(const std::vector<ArmSensor>& sensors, unsigned seed) {
  std::mt19937 dice(seed);
  std::normal_distribution<double> normal;
  Candidate truth;
  std::vector<double> parameters;
  for (std::size_t j = 1; j <= 6; ++j) {
    truth.effects.emplace_back("rest_angle", j);
    parameters.push_back(2e-3 * normal(dice));
  }
  truth.effects.emplace_back("encoder_ripple", 2);
  parameters.insert(parameters.end(), {4e-3, -3e-3});
  return as_given(seen_by(sensors), truth, parameters, seed);
}

std::vector<ArmSensor> of_kind(std::string_view key) {
  std::vector<ArmSensor> all = one_of_each();
  std::erase_if(all, [&](const ArmSensor& one) { return one.kind->key != key; });
  return all;
}

double largest_residual(const Experiment& experiment) {
  return Study(experiment).nominal_residual().cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("a sensor reads what its law says of a point in its frame") {
  const Pose<double> point = pose({0.3, -0.4, 1.2}, {0.25, 0, 0});
  CHECK(kind("distance").read(point).x() == doctest::Approx(1.3));
  CHECK(kind("camera").read(point) == Eigen::Vector2d(0.3 / 1.2, -0.4 / 1.2));
  CHECK(kind("plane").read(point).x() == 1.2);
  // Turned about x, the axis x stays level, and y rises by the angle.
  CHECK(kind("inclinometer").read(point).x() == 0);
  CHECK(kind("inclinometer").read(point).y() == doctest::Approx(0.25));
}

TEST_CASE("each sensor alone is found where it stands, its point where it sits") {
  for (const ArmSensorKind& one : arm_sensor_kinds()) {
    CAPTURE(one.key);
    Experiment exact = as_given(seen_by(of_kind(one.key)), {}, {}, 1);
    const Prediction nominal = Study(exact).nominal();
    for (std::size_t r = 0; r < exact.runs.size(); ++r)
      for (std::size_t i = 0; i < exact.runs[r].readings.size(); ++i)
        for (const Channel& channel : exact.runs[r].of_sensors)
          channel.in(exact.runs[r].readings[i]) =
              nominal.runs[r](static_cast<Eigen::Index>(i), channel.column);
    Experiment found = without_focal_length(said_elsewhere(exact));
    CHECK(largest_residual(found) > 100);
    register_sensors(found);
    // The search ends where a step gains 1e-12 of the squares: 1e-6 of readings of metres, radians or a
    // thousand pixels, over sigmas of some 1e-5 of these.
    CHECK(largest_residual(found) < 0.1);
    const ArmSensor &sensor = found.arm_bench.sensors[0], &truth = exact.arm_bench.sensors[0];
    CHECK((sensor.at.linear().col(2) - truth.at.linear().col(2)).norm() < (one.sees_own.at(3) ? 1e-4 : 0.5));
    if (one.has_focal_length) CHECK(sensor.focal_length == doctest::Approx(truth.focal_length).epsilon(1e-4));
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (one.sees_own.at(0) && one.sees_own.at(1))
        CHECK(std::abs(sensor.at.translation()(axis) - truth.at.translation()(axis)) < 1e-4);
  }
}

TEST_CASE("an arm is calibrated by distances, a camera, or all sensors together, wherever they stand") {
  const std::vector<ArmSensor> all = one_of_each();
  for (const std::vector<ArmSensor>& sensors :
       {std::vector<ArmSensor>{all[0], {"wire", &kind("distance"), 0, pose({-0.2, 0.8, 1.1})}},
        std::vector<ArmSensor>{all[1]}, all}) {
    CAPTURE(sensors.size());
    CAPTURE(sensors[0].name);
    const Experiment here = off_everywhere(sensors, 702410);
    const Study one = calibrated(Study(here)), other = calibrated(Study(said_elsewhere(here)));
    const Calibration& found = *one.experiment().arm_bench.calibration;
    REQUIRE(!found.beside.empty());
    CHECK(found.beside.front().label() == "encoder_ripple(2)");
    // Three steps of Gauss and Newton's method leave what difference quotients lose, 1e-6 of what the effects
    // do, some thousand sigmas.
    CHECK((one.nominal_residual() - other.nominal_residual()).norm() < 1e-1);
    for (const ArmSensor& sensor : sensors) {
      const double left = found.corrected.of(sensor.kind->reads),
                   noise =
                       here.noise[sensor.kind->reads] * std::sqrt(static_cast<double>(sensor.kind->numbers));
      CAPTURE(sensor.name);
      CHECK(left > 0.7 * noise);
      // A fold fits some forty numbers to as many as 64 values.
      CHECK(left < 2 * noise);
      CHECK(left < found.nominal.of(sensor.kind->reads) / 3);
    }
    CHECK(other.experiment().arm_bench.calibration->frames.size() == 3 + sensors.size());
  }
}

TEST_CASE("the place of a sensor lies within five standard deviations of the truth") {
  const std::vector<ArmSensor> all = one_of_each();
  const Study study = calibrated(Study(without_focal_length(said_elsewhere(off_everywhere(all, 702411)))));
  const std::vector<SolvedFrame>& frames = study.experiment().arm_bench.calibration->frames;
  REQUIRE(frames.size() == 3 + all.size());
  for (std::size_t s = 0; s < all.size(); ++s) {
    const SolvedFrame& found = frames[3 + s];
    CAPTURE(found.name);
    CHECK(found.of == SolvedFrame::Of::sensor);
    const Pose<double> off = all[s].at.inverse() * found.at;
    if (!found.turn.isZero(0))  // of what sees a turn, the direction of z shows two
      CHECK(off.linear().col(2).head<2>().norm() < 5 * found.turn.norm());
    if (all[s].kind->key != "plane") CHECK(off.translation().norm() < 5 * found.shift.norm() + 1e-12);
    if (all[s].kind->has_focal_length)
      CHECK(std::abs(found.focal_length - all[s].focal_length) < 5 * found.focal_length_sd);
  }
}

TEST_CASE("contacts alone are refused: an arm of no size touches the plane everywhere") {
  Experiment experiment = seen_by(of_kind("plane"));
  CHECK_THROWS_WITH_AS(calibrated(Study(experiment)), doctest::Contains("heights that differ"), Error);
  CHECK_NOTHROW(calibrated(Study(as_given(experiment, {}, {}, 702414))));
}

TEST_CASE("errors of a tool show in distances and pictures, its turn in an inclinometer") {
  const auto possible = [](std::string_view key, const char* id) {
    Experiment experiment = as_given(seen_by(of_kind(key)), {}, {}, 1);
    experiment.arm_bench.frames = ArmBench::Frames::known;
    const std::vector<EffectAt> all = possible_effects(Study(experiment));
    return std::ranges::find(all, EffectAt(id)) != all.end();
  };
  for (const char* key : {"distance", "camera", "plane"}) {
    CAPTURE(key);
    CHECK(possible(key, "tool_offset"));
    CHECK_FALSE(possible(key, "tool_turn"));
  }
  CHECK(possible("inclinometer", "tool_turn"));
  CHECK_FALSE(possible("inclinometer", "tool_offset"));
}

}  // namespace plumbline::diagnose::test
