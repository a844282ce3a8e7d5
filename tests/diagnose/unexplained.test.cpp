#include "diagnose/answers/unexplained.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// A press of 2 cm there and back in 80 readings that the nominal model gives exactly, without angles.
Experiment exact_press() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 40, true);
  const Prediction nominal = predict(Study(experiment), {}, {});
  for (std::size_t i = 0; i < experiment.runs[0].readings.size(); ++i) {
    Reading& reading = experiment.runs[0].readings[i];
    const auto row = nominal.runs[0].row(static_cast<Eigen::Index>(i));
    reading.Fx = row(column_Fx), reading.Fy = row(column_Fy), reading.q = {};
  }
  return experiment;
}

Where in_Fx() {
  Where where;
  where.channels = {{{Channel::Name::Fx}, 1}};
  return where;
}

/// What is said of a part that is added to Fx.
template <class Part>
Missing described(Part part) {
  Experiment experiment = exact_press();
  std::vector<Reading>& readings = experiment.runs[0].readings;
  for (std::size_t i = 0; i < readings.size(); ++i) readings[i].Fx += part(i, readings[i]);
  const Study study(experiment);
  return describe_missing(study, study.nominal_residual(), in_Fx());
}

}  // namespace

TEST_CASE(
    "what is missing in a channel: the measured less the nominal value, over the command, with its time") {
  const auto part = [](std::size_t i, const Reading&) { return 0.001 * static_cast<double>(i); };
  const Missing missing = described(part);
  CHECK(missing.what == "Fx");
  CHECK(missing.unit == "N");
  CHECK(missing.against == "x");
  CHECK(missing.against_unit == "m");
  const Experiment experiment = exact_press();
  REQUIRE(missing.points.size() == 81);
  for (std::size_t i = 0; i < 81; ++i) {
    CHECK(missing.points[i].at == experiment.runs[0].readings[i].x);
    CHECK(missing.points[i].t == 2.0 * static_cast<double>(i));
    CHECK(missing.points[i].value == doctest::Approx(0.001 * static_cast<double>(i)).scale(1).epsilon(1e-9));
    CHECK(missing.points[i].returning == (i > 40));
  }
}

TEST_CASE("shares of what is missing that go with the place, the direction and the time, by hand") {
  // A part that has one value in each of the twenty bins of the way is all of the place.
  const double start = exact_press().runs[0].readings[0].x;
  const auto steps = [&](std::size_t, const Reading& r) {
    const double share = 1 - (start - r.x) / 0.02;  // from 0 at the far end to 1
    return 0.05 * std::sin(3 * std::min(19.0, std::floor(20 * share + 1e-9)));
  };
  const Missing of_place = described(steps);
  CHECK(of_place.by_position == doctest::Approx(1).epsilon(0.03));
  CHECK(of_place.by_position <= of_place.by_direction);

  // One that is 1 on the way out and -1 on the way back has a mean of nothing where both ways come by: in all
  // bins but the one at the far end, whose turn goes out alone.
  const Missing of_way = described([](std::size_t i, const Reading&) { return i <= 40 ? 0.05 : -0.05; });
  CHECK(of_way.by_position < 0.05);
  CHECK(of_way.by_direction == doctest::Approx(1));
  CHECK(of_way.by_time == doctest::Approx(1));

  // One that grows with time goes with neither alone. In each bin of a way, of two readings, it is within
  // 0.001 of its mean.
  const Missing of_time =
      described([](std::size_t i, const Reading&) { return 0.001 * (static_cast<double>(i) - 40); });
  CHECK(of_time.by_position < 0.05);
  CHECK(of_time.by_direction == doctest::Approx(1).epsilon(1e-3));
  CHECK(of_time.by_time >= of_time.by_direction);

  const Missing nothing = described([](std::size_t, const Reading&) { return 0; });
  CHECK(nothing.by_position <= 1);
}

TEST_CASE("a value that stands alone is not missing, and runs of another control are not drawn with it") {
  Experiment experiment = exact_press();
  experiment.runs[0].readings[20].Fx += 50;
  load(experiment, {0.3, -0.5, 0.4}, {0, 0}, {-0.1, 0}, 10);
  for (Reading& reading : experiment.runs[1].readings) reading.x = 0.5, reading.y = 0.1, reading.q = {};
  const Study study(experiment);
  CHECK(describe_missing(study, study.nominal_residual(), in_Fx()).points.size() == 80);
  Where in_x;
  in_x.channels = {{{Channel::Name::x}, 1}};
  const Missing of_x = describe_missing(study, study.nominal_residual(), in_x);
  CHECK(of_x.points.size() == 11);
  CHECK(of_x.what == "x");
  CHECK(of_x.against == "Fx");
  CHECK(of_x.against_unit == "N");
  CHECK(of_x.points.back().at == doctest::Approx(-0.1));
}

TEST_CASE("a press along y is told over y, and a joint that has most of the missing torque over its angle") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.01, 0.02}, 10, false);
  experiment.noise = {1e-4, 1e-4, 1e-4, 1e-4, 1e-5};
  Experiment read = measured(experiment, only("joint_stiffness", 2), {0.3}, 3);
  const Study study(read);
  Where where = in_Fx();
  CHECK(describe_missing(study, study.nominal_residual(), where).against == "y");
  where.joints = {{2, 0.6}, {1, 0.4}, {3, 0}};
  where.joint_evidence = JointEvidence::measured;
  const Missing torque = describe_missing(study, study.nominal_residual(), where);
  CHECK(torque.what == "torque at joint 2");
  CHECK(torque.unit == "N m");
  CHECK(torque.against == "q2");
  CHECK(torque.against_unit == "rad");
  REQUIRE(torque.points.size() == 11);
  // The true rig carries 0.3 k_2 d_2 more than the nominal one. Forces of 1e-4 N a lever of 0.4 m away, and
  // angles of 1e-5 rad at 2 N m/rad, leave 6e-5. 0.004.
  for (std::size_t i = 0; i < 11; ++i) {
    CHECK(torque.points[i].at == read.runs[0].readings[i].q[1]);
    CHECK(torque.points[i].value ==
          doctest::Approx(-0.3 * 1.5 * (torque.points[i].at + 0.5)).scale(1).epsilon(5 * 6e-5));
  }
  where.joints[0].share = 0.5;
  CHECK(describe_missing(study, study.nominal_residual(), where).what == "Fx");
  where.joints[0].share = 0.6;
  where.joint_evidence = JointEvidence::implied_by_fits;
  CHECK(describe_missing(study, study.nominal_residual(), where).what == "Fx");
}
