#include "diagnose/rig/characteristic_scales.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/chain_values.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Two links and a press of ten readings whose forces are 1 to 10 N along x, two of the readings empty in y.
Experiment ten_readings() {
  Experiment experiment = three_links();
  experiment.link_length = {0.3, 0.5};
  experiment.joint_stiffness = {0, 3};
  experiment.link_mass = {0, 0};
  Run run{"press", Control::end_point, {0.2, 0}, {}};
  for (int i = 0; i < 10; ++i) run.readings.push_back({0.5 * i * i + i, {0.7 - 0.01 * i, 0.1, -1.0 - i}});
  experiment.runs.push_back(run);
  return experiment;
}

}  // namespace

TEST_CASE("the characteristic scales of an experiment, by hand") {
  const Experiment experiment = ten_readings();
  const CharacteristicScales size = characteristic_scales(experiment);
  CHECK(size.stiffness == 3);  // passive joints have no part in the mean
  CHECK(size.length == 0.8);
  CHECK(size.link == 0.4);
  CHECK(size.force == 10);  // nine of ten are smaller
  CHECK(size.deflection == close_to(0.3 * 10 * 0.8 / 3));
  CHECK(size.duration == 49.5);
  CHECK(size.sampling_interval == 5.5);  // of pauses of 1.5 to 9.5 s the middle one
  CHECK(size.weighs);
  CHECK(size.measures_force);
  CHECK_FALSE(size.measures_both_forces);
  CHECK(size.load_cell);
  CHECK(size.pivot);
  CHECK(size.clock);
  CHECK_FALSE(size.turns_back);
  CHECK_FALSE(size.bent_at_rest);
  CHECK(size.largest_reading == 10);
  CHECK(size.at_largest == 1);  // the next, 9 N, is 100 sigma away
  CHECK(size.compliance() == close_to(0.64 / 3));
  CHECK(size.stiffness_at(0) == 3);
  CHECK(size.stiffness_at(1) == 3);
  using Name = Channel::Name;
  CHECK(size.measures(Name::Fx));
  for (const Name name : {Name::x, Name::y, Name::Fy, Name::q}) CHECK_FALSE(size.measures(name));
}

TEST_CASE("several runs: the longest duration, the shortest interval, all measured channels") {
  Experiment experiment = ten_readings();
  Run other = experiment.runs[0];
  for (Reading& r : other.readings)
    r.t *= 0.25, r[column_Fy] = 0.5, r.value.resize(column_q), r.value.insert(r.value.end(), {0.1, 0.2});
  other.rest = {0, 0.1};
  other.readings[9][column_x] = 0.9;
  experiment.runs.push_back(other);
  const CharacteristicScales size = characteristic_scales(experiment);
  CHECK(size.duration == 49.5);
  CHECK(size.sampling_interval == 1.375);
  CHECK(size.measures_both_forces);
  CHECK(size.turns_back);
  CHECK(size.bent_at_rest);
  CHECK(size.measures(Channel::Name::q));
  std::swap(experiment.runs[0], experiment.runs[1]);
  CHECK(characteristic_scales(experiment).sampling_interval == 1.375);
  CHECK(characteristic_scales(experiment).duration == 49.5);
}

TEST_CASE("duration from first to last reading, sampling interval as the most frequent one") {
  Experiment experiment = ten_readings();
  for (Reading& r : experiment.runs[0].readings) r.t += 3600;
  CHECK(characteristic_scales(experiment).duration == 49.5);
  CHECK(characteristic_scales(experiment).sampling_interval == 5.5);
  for (std::size_t i = 1; i < 10; ++i) experiment.runs[0].readings[i].t += 60;  // a rest after the first
  CHECK(characteristic_scales(experiment).sampling_interval == 6.5);            // of those from 2.5 to 61.5 s
  // stamps of a clock that is read more coarsely than the sensors
  for (std::size_t i = 0; i < 10; ++i)
    experiment.runs[0].readings[i].t = std::floor(static_cast<double>(i) / 3);
  CHECK(characteristic_scales(experiment).sampling_interval == 1);
}

TEST_CASE("only measured forces count: weights read none, an imposed force is no plateau") {
  Experiment experiment = ten_readings();
  experiment.runs[0].control = Control::force;
  CharacteristicScales size = characteristic_scales(experiment);
  CHECK_FALSE(size.measures_force);
  CHECK(size.load_cell);  // by which a servo sets it
  CHECK(size.pivot);
  CHECK(size.largest_reading == 0);
  CHECK(size.at_largest == 0);
  CHECK(size.measures(Channel::Name::x));
  CHECK_FALSE(size.measures(Channel::Name::Fx));
  experiment.runs[0].by_weights = true;
  size = characteristic_scales(experiment);
  CHECK_FALSE(size.load_cell);
  CHECK_FALSE(size.pivot);
}

TEST_CASE("readings within five sigmas of the largest force, of either sign, are a plateau") {
  Experiment experiment = ten_readings();
  experiment.noise[Channel::Name::Fx] = 0.1, experiment.noise[Channel::Name::Fy] = 0.2;
  std::vector<Reading>& readings = experiment.runs[0].readings;
  readings[0][column_Fx] = 9.51, readings[1][column_Fx] = -9.49;  // 4.9 and 5.1 sigmas away
  readings[2][column_Fy] = -9.01, readings[3][column_Fy] = 8.99;
  CHECK(characteristic_scales(experiment).at_largest == 3);
}

TEST_CASE("scales stay positive without forces, time or stiffness") {
  Experiment experiment = ten_readings();
  for (Reading& r : experiment.runs[0].readings) r[column_Fx] = 0, r.t = 0;
  CharacteristicScales size = characteristic_scales(experiment);
  CHECK(size.force == close_to(0.1 * 3 / 0.8));
  CHECK(size.deflection == close_to(0.03));
  CHECK(size.duration == 1e-3);
  CHECK(size.sampling_interval == 1e-3);
  CHECK(size.at_largest == 0);
  experiment.runs[0].readings[0][column_Fx] = 1e3;
  experiment.runs[0].readings[1][column_Fx] = 1e3;
  size = characteristic_scales(experiment);
  CHECK(size.deflection == 1);
  experiment.bench.plane = Bench::Plane::horizontal;
  CHECK_FALSE(characteristic_scales(experiment).weighs);
}

TEST_CASE("the excitation of the nominal joints: the largest of each, by hand") {
  Experiment experiment = three_links();
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {0, -1}, 4);
  load(experiment, {0, 0, 0}, {0, 0}, {0, 0.5}, 4);
  const Study study(experiment);
  const Excitation& use = study.excitation();
  double largest = 0, torque = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double most = 0;
    for (std::size_t r = 0; r < 2; ++r)
      for (Eigen::Index row = 0; row < 5; ++row)
        most = std::max(most, std::abs(angle(study.nominal().runs[r], row, i) - experiment.runs[r].rest[i]));
    CHECK(use.deflection[i] == most);
    CHECK(most > 0);
    largest = std::max(largest, most), torque = std::max(torque, experiment.joint_stiffness[i] * most);
  }
  CHECK(use.largest == largest);
  CHECK(use.torque == torque);
}

TEST_CASE("a run: reversals of its command, and a clock that only counts") {
  Run run{"press", Control::end_point, {0}, {}};
  const auto at = [&](double t, double x, double y) {
    run.readings.push_back({t, chain_values(x, y, 0, 0, {0})});
  };
  at(0, 0, 0), at(1, 1, 0), at(2, 2, 0.1), at(3, 2, 0.1), at(4, 1.5, 0.1), at(5, nan_value(), 0), at(6, 1, 0),
      at(7, 1, 1), at(8, 1.2, 0.5);
  CHECK(run.turning_points() ==
        std::vector<bool>{false, false, false, true, false, false, true, true, false});
  CHECK(run.turns_back());
  CHECK(run.counts_readings());
  run.readings[4].t = 4.5;
  CHECK_FALSE(run.counts_readings());
  run.control = Control::force;
  CHECK_FALSE(run.turns_back());
  CHECK(run.command(run.readings[7]) == Eigen::Vector2d(0, 0));
  CHECK(run.imposed()[0] == Channel(Channel::Name::Fx));
  CHECK(run.imposed()[1] == Channel(Channel::Name::Fy));
  const std::vector<Channel> measured = run.measured();
  REQUIRE(measured.size() == 3);
  CHECK(measured[0] == Channel(Channel::Name::x));
  CHECK(measured[1] == Channel(Channel::Name::y));
  CHECK(measured[2] == Channel(Channel::Name::q, 0));
  // The median of m normal values has the variance pi / 2 m.
  CHECK(run.noise_of_group() == 1);
  run.groups.size = 8;
  CHECK(run.noise_of_group() == close_to(std::sqrt(std::acos(-1.0) / 16)));
  run.groups.first = {0, 3, 5};
  CHECK(run.first_taken(1) == 3);
  CHECK(run.last_taken(0) == 2);
  CHECK(run.last_taken(1) == 4);
}

TEST_CASE("a channel: its label, unit, sensor, noise and place in a reading") {
  Reading reading{1, chain_values(2, 3, 4, 5, {6, 7})};
  const Noise noise{0.1, 0.2, 0.3, 0.4, 0.5};
  struct Row {
    Channel channel;
    const char *label, *unit;
    Sensor sensor;
    double value, sigma;
  };
  using Name = Channel::Name;
  for (const Row& row : {Row{Channel(Name::x), "x", "m", Sensor::position, 2, 0.1},
                         Row{Channel(Name::y), "y", "m", Sensor::position, 3, 0.2},
                         Row{Channel(Name::Fx), "Fx", "N", Sensor::force, 4, 0.3},
                         Row{Channel(Name::Fy), "Fy", "N", Sensor::force, 5, 0.4},
                         Row{Channel(Name::q, 0), "q1", "rad", Sensor::angle, 6, 0.5},
                         Row{Channel(Name::q, 1), "q2", "rad", Sensor::angle, 7, 0.5}}) {
    CHECK(row.channel.label() == row.label);
    CHECK(row.channel.unit() == row.unit);
    CHECK(row.channel.sensor() == row.sensor);
    CHECK(row.channel.of(reading) == row.value);
    CHECK(row.channel.sigma(noise) == row.sigma);
    row.channel.in(reading) = 9;
    CHECK(row.channel.of(reading) == 9);
  }
  CHECK(kind_of(Name::q).label == "q");
  CHECK(Channel(Name::Fx) < Channel(Name::Fy));
  CHECK(Channel(Name::q, 1) < Channel(Name::x));
}
