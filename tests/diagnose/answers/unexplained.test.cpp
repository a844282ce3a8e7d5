#include "diagnose/answers/unexplained.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

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
    reading[column_Fx] = row(column_Fx), reading[column_Fy] = row(column_Fy), reading.value.resize(column_q);
  }
  return experiment;
}

Where in_Fx() {
  Where where;
  where.channels = {{Channel(Channel::Name::Fx), 1}};
  return where;
}

/// What is said of a part that is added to Fx.
template <class Part>
Missing described(Part part) {
  Experiment experiment = exact_press();
  std::vector<Reading>& readings = experiment.runs[0].readings;
  for (std::size_t i = 0; i < readings.size(); ++i) readings[i][column_Fx] += part(i, readings[i]);
  const Study study(experiment);
  return describe_missing(study, declared_noise(study), in_Fx());
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
    CHECK(missing.points[i].at == experiment.runs[0].readings[i][column_x]);
    CHECK(missing.points[i].t == 2.0 * static_cast<double>(i));
    CHECK(missing.points[i].value == doctest::Approx(0.001 * static_cast<double>(i)).scale(1).epsilon(1e-9));
    CHECK(missing.points[i].falling == (i <= 40));  // x goes down to the turn
  }
}

TEST_CASE("shares of what is missing that go with the place, the direction and the time, by hand") {
  // Where both ways come by with the same value every reading has a neighbour that says the same.
  const Missing of_place =
      described([](std::size_t, const Reading& r) { return 0.05 * std::sin(900 * r[column_x]); });
  CHECK(of_place.by_position == doctest::Approx(1));
  CHECK(of_place.by_direction == doctest::Approx(1));

  // One that is 1 on the way out and -1 on the way back has a neighbour of the other sign everywhere.
  const Missing of_way = described([](std::size_t i, const Reading&) { return i <= 40 ? 0.05 : -0.05; });
  CHECK(of_way.by_position == 0);
  CHECK(of_way.by_direction == doctest::Approx(1));
  CHECK(of_way.by_time == doctest::Approx(1));

  // One that grows with time goes with neither alone, but is a line over each way.
  const Missing of_time =
      described([](std::size_t i, const Reading&) { return 0.001 * (static_cast<double>(i) - 40); });
  CHECK(of_time.by_position == 0);
  CHECK(of_time.by_direction == doctest::Approx(1));

  // What is everywhere the same has no variance that anything could explain, but for rounding.
  const Missing constant = described([](std::size_t, const Reading&) { return 0.05; });
  CHECK(constant.by_position < 0.5);
}

TEST_CASE("white noise goes with nothing, however few readings there are") {
  // Off its neighbours a value has the variance that it has: of N readings, 2 N / 3 independent at least, the
  // share spreads by sqrt(3 / N) about nothing, and the trend takes 1 / N more.
  std::mt19937_64 random(5);
  std::normal_distribution<double> unit;
  double sum = 0;
  for (int draw = 0; draw < 20; ++draw) {
    const Missing noise = described([&](std::size_t, const Reading&) { return 0.05 * unit(random); });
    CHECK(noise.by_position < 5 * std::sqrt(3.0 / 81));
    sum += noise.by_time / 20;
  }
  CHECK(sum < std::sqrt(3.0 / 81));
}

TEST_CASE("direction is the sign of motion: a run that begins pushed in and lets go moves back too") {
  Experiment experiment = exact_press();
  Run pushed = experiment.runs[0];
  pushed.id = "let-go";
  std::reverse(pushed.readings.begin(), pushed.readings.begin() + 41);
  pushed.readings.resize(41);  // from the turn to the start
  for (std::size_t i = 0; i < 41; ++i) pushed.readings[i].t = experiment.runs[0].readings[i].t;
  experiment.runs.push_back(pushed);
  for (std::size_t r : {0U, 1U})
    for (std::size_t i = 0; i < experiment.runs[r].readings.size(); ++i)
      experiment.runs[r].readings[i][column_Fx] += r == 0 && i <= 40 ? 0.05 : -0.05;
  const Study study(experiment);
  const Missing missing = describe_missing(study, declared_noise(study), in_Fx());
  for (std::size_t i = 0; i < 41; ++i) CHECK_FALSE(missing.points[81 + i].falling);
  CHECK(missing.by_direction == doctest::Approx(1));
}

TEST_CASE("an outlier is not missing, and runs of another control are not drawn with it") {
  Experiment experiment = exact_press();
  experiment.runs[0].readings[20][column_Fx] += 50;
  load(experiment, {0.3, -0.5, 0.4}, {0, 0}, {-0.1, 0}, 10);
  for (Reading& reading : experiment.runs[1].readings)
    reading[column_x] = 0.5, reading[column_y] = 0.1, reading.value.resize(column_q);
  const Study study(experiment);
  NoiseEstimate noise = declared_noise(study);
  noise.shape.outlier[20] = true;  // Fx is the first series
  CHECK(describe_missing(study, noise, in_Fx()).points.size() == 80);
  Where in_x;
  in_x.channels = {{Channel(Channel::Name::x), 1}};
  const Missing of_x = describe_missing(study, declared_noise(study), in_x);
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
  Experiment read = measured(experiment, only("joint_stiffness", 2), {std::log1p(0.3)}, 3);
  const Study study(read);
  Where where = in_Fx();
  CHECK(describe_missing(study, declared_noise(study), where).against == "y");
  where.joints = {{2, 0.6}, {1, 0.4}, {3, 0}};
  where.joint_evidence = JointEvidence::measured;
  const Missing torque = describe_missing(study, declared_noise(study), where);
  CHECK(torque.what == "torque at joint 2");
  CHECK(torque.unit == "N m");
  CHECK(torque.against == "q2");
  CHECK(torque.against_unit == "rad");
  REQUIRE(torque.points.size() == 11);
  // The true rig carries 0.3 k_2 d_2 more than the nominal one. Forces of 1e-4 N a lever of 0.4 m away, and
  // angles of 1e-5 rad at 2 N m/rad, leave 6e-5. 0.004.
  for (std::size_t i = 0; i < 11; ++i) {
    CHECK(torque.points[i].at == read.runs[0].readings[i][column_q + 1]);
    CHECK(torque.points[i].value ==
          doctest::Approx(-0.3 * 1.5 * (torque.points[i].at + 0.5)).scale(1).epsilon(5 * 6e-5));
  }
  where.joints[0].share = 0.5;
  CHECK(describe_missing(study, declared_noise(study), where).what == "Fx");
  where.joints[0].share = 0.6;
  where.joint_evidence = JointEvidence::implied_by_fits;
  CHECK(describe_missing(study, declared_noise(study), where).what == "Fx");
}
