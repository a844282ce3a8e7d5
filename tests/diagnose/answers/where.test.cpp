#include "diagnose/answers/where.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A nominal model that grows as stiff along x in all readings of a blank experiment, but for those from
/// `soft` on of every run, where the force grows no more.
Prediction straight(const Experiment& experiment, std::size_t soft) {
  Prediction nominal;
  for (const Run& run : experiment.runs) {
    Trace trace = Trace::Zero(static_cast<Eigen::Index>(run.readings.size()), 6);
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      trace(static_cast<Eigen::Index>(i), column_x) = 0.3 - 0.01 * static_cast<double>(i);
      trace(static_cast<Eigen::Index>(i), column_Fx) = -static_cast<double>(std::min(i, soft - 1));
    }
    nominal.runs.push_back(trace);
  }
  return nominal;
}

void fill(const Measurements& measurements, std::size_t series, double size, std::vector<double>& residual) {
  const Series& one = measurements.series()[series];
  for (std::size_t i = 0; i < one.readings.size(); ++i) residual[one.first + i] = i % 2 == 0 ? size : -size;
}

double share_of(const std::vector<ChannelShare>& shares, const std::string& channel) {
  for (const ChannelShare& one : shares)
    if (one.channel.label() == channel) return one.share;
  return -1;
}
double share_of(const std::vector<RunShare>& shares, const std::string& run) {
  for (const RunShare& one : shares)
    if (one.run == run) return one.share;
  return -1;
}

}  // namespace

TEST_CASE("shares are of the squared residual beyond noise, by hand") {
  const Experiment experiment = blank_experiment({10, 10});
  const Measurements measurements(experiment);  // Fx, Fy of the first run, Fx, Fy of the second
  NoiseModel noise;
  noise.scale = {9, 9, 2, 2, 9};
  std::vector<double> residual(measurements.size());
  fill(measurements, 0, 2, residual);  // noise of scale 2: 0 beyond it
  fill(measurements, 1, 1, residual);  // less than noise: 10 (1/4 - 1) = -7.5
  fill(measurements, 2, 6, residual);  // 10 (9 - 1) = 80
  fill(measurements, 3, 4, residual);  // 10 (4 - 1) = 30
  const Where where = locate(Study(experiment), straight(experiment, 5), residual, noise);
  // by channel: Fx 0 + 80, Fy 30 - 7.5
  CHECK(where.channels.front().channel.label() == "Fx");
  CHECK(share_of(where.channels, "Fx") == close_to(80 / 102.5));
  CHECK(share_of(where.channels, "Fy") == close_to(22.5 / 102.5));
  // by run: the first is below noise, its share is nothing and no debt
  CHECK(where.runs.front().run == "run-2");
  CHECK(share_of(where.runs, "run-2") == close_to(1));
  CHECK(share_of(where.runs, "run-1") == 0.0);
  double sum = 0;
  for (const PathShare& one : where.load_path) {
    CHECK(one.share >= 0);
    if (one.run == "run-1") CHECK(one.share == 0.0);
    sum += one.share;
  }
  CHECK(sum == close_to(1));
}

TEST_CASE("along the path a share belongs to the readings that hold it, also where others are missing") {
  Experiment experiment = blank_experiment({12});
  for (std::size_t i = 0; i < 4; ++i) experiment.runs[0].readings[i].Fx = std::nan("");
  const Measurements measurements(experiment);
  // Fx of readings 4-11, Fy of readings 0-11; the force grows no more from reading 8 on
  std::vector<double> residual(measurements.size());
  fill(measurements, 0, 1, residual);
  fill(measurements, 1, 1, residual);
  for (std::size_t i = 4; i < 8; ++i) residual[i] *= 3;  // readings 8-11: 4 (9 - 1) beyond noise
  const Where where = locate(Study(experiment), straight(experiment, 8), residual, {});
  REQUIRE(where.load_path.size() == 2);
  const PathShare &stiff = where.load_path[0], &soft = where.load_path[1];
  CHECK((stiff.from == 0 && stiff.to == 7 && stiff.regime == Regime::pre_critical));
  CHECK((soft.from == 8 && soft.to == 11 && soft.regime == Regime::post_critical));
  CHECK(stiff.share == 0.0);
  CHECK(soft.share == close_to(1));
}

TEST_CASE("one outlier of 25 sigma moves no share") {
  const Experiment experiment = blank_experiment({20, 20});
  const Measurements measurements(experiment);
  std::vector<double> residual(measurements.size());
  fill(measurements, 0, 1, residual);
  fill(measurements, 1, 1, residual);
  fill(measurements, 2, 1, residual);
  fill(measurements, 3, 2, residual);
  residual[measurements.series()[0].first + 10] += 25;
  const Where where = locate(Study(experiment), straight(experiment, 9), residual, {});
  CHECK(share_of(where.runs, "run-2") == close_to(1));
  CHECK(share_of(where.channels, "Fy") == close_to(1));
}

TEST_CASE("shares of joints: in proportion, largest first, alike where nothing is known") {
  const std::vector<JointShare> some = joint_shares({1, 0, 3});
  REQUIRE(some.size() == 3);
  CHECK((some[0].joint == 3 && some[0].share == close_to(0.75)));
  CHECK((some[1].joint == 1 && some[1].share == close_to(0.25)));
  CHECK((some[2].joint == 2 && some[2].share == 0.0));
  for (const JointShare& one : joint_shares({0, 0, 0, 0})) CHECK(one.share == close_to(0.25));
}

TEST_CASE("along the path of several runs each stretch has its readings, counted as they were taken") {
  Experiment experiment = blank_experiment({6, 5});
  // the second run was read ten times: two of its readings were drawn into one each
  experiment.runs[1].groups = {2, {0, 2, 4, 6, 8, 10}};
  const Measurements measurements(experiment);
  std::vector<double> residual(measurements.size());
  fill(measurements, 0, 3, residual);  // 8 beyond noise a reading
  fill(measurements, 3, 2, residual);  // 3
  for (std::size_t s : {1U, 2U}) fill(measurements, s, 1, residual);
  const Where where = locate(Study(experiment), straight(experiment, 4), residual, {});
  REQUIRE(where.load_path.size() == 4);
  struct Stretch {
    std::string run;
    std::size_t from, to;
    double beyond;
    Regime regime;
  };
  // the force grows as stiff up to reading 3: four readings, and what is left of six and of five
  const std::vector<Stretch> expected{{"run-1", 0, 3, 32, Regime::pre_critical},
                                      {"run-1", 4, 5, 16, Regime::post_critical},
                                      {"run-2", 0, 7, 12, Regime::pre_critical},
                                      {"run-2", 8, 9, 3, Regime::post_critical}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    CHECK(where.load_path[i].run == expected[i].run);
    CHECK(where.load_path[i].from == expected[i].from);
    CHECK(where.load_path[i].to == expected[i].to);
    CHECK(where.load_path[i].regime == expected[i].regime);
    CHECK(where.load_path[i].share == close_to(expected[i].beyond / 63));
  }
}

TEST_CASE("every reading of a series counts, the first and the last, and none of another") {
  const Experiment experiment = blank_experiment({10, 12});
  const Measurements measurements(experiment);
  // lines, which have no outliers: each series has squares of its own from end to end
  std::vector<double> residual(measurements.size());
  std::vector<double> sum(4);
  for (std::size_t s = 0; s < 4; ++s) {
    const Series& series = measurements.series()[s];
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const double value = static_cast<double>(2 + s + i * (s + 1));
      residual[series.first + i] = value;
      sum[s] += value * value - 1;
    }
  }
  const double all = sum[0] + sum[1] + sum[2] + sum[3];
  const Where where = locate(Study(experiment), straight(experiment, 20), residual, {});
  CHECK(share_of(where.channels, "Fx") == close_to((sum[0] + sum[2]) / all).epsilon(1e-9));
  CHECK(share_of(where.runs, "run-1") == close_to((sum[0] + sum[1]) / all).epsilon(1e-9));
  REQUIRE(where.load_path.size() == 2);
  CHECK(where.load_path[1].share == close_to((sum[2] + sum[3]) / all).epsilon(1e-9));
}

TEST_CASE("runs and channels stand largest first, those that are alike as they were") {
  const Experiment experiment = blank_experiment({8, 8, 8, 8});
  const Measurements measurements(experiment);
  std::vector<double> residual(measurements.size());
  for (std::size_t s = 0; s < 8; ++s) fill(measurements, s, s == 5 ? 3 : s % 2 == 1 ? 2 : 1, residual);
  const Where where = locate(Study(experiment), straight(experiment, 4), residual, {});
  std::vector<std::string> runs, channels;
  for (const RunShare& one : where.runs) runs.push_back(one.run);
  for (const ChannelShare& one : where.channels) channels.push_back(one.channel.label());
  CHECK(runs == std::vector<std::string>{"run-3", "run-1", "run-2", "run-4"});
  CHECK(channels == std::vector<std::string>{"Fy", "Fx"});
  // 3 a reading in three runs, 8 in one
  CHECK(share_of(where.runs, "run-3") == close_to(8 / 17.0));
  CHECK(share_of(where.runs, "run-4") == close_to(3 / 17.0));

  // Where nothing is beyond noise all shares are alike.
  for (double& one : residual) one = 0;
  const Where nowhere = locate(Study(experiment), straight(experiment, 4), residual, {});
  for (const RunShare& one : nowhere.runs) CHECK(one.share == 0.25);
  for (const ChannelShare& one : nowhere.channels) CHECK(one.share == 0.5);
}

TEST_CASE("the joint whose torque is missing is told by measured angles alone, and said to be") {
  Experiment experiment = test::three_links();
  test::press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, true);
  experiment = test::measured(experiment, test::only("joint_stiffness", 2), {0.5}, 3);
  const Study study(experiment);
  const Where where = locate(study, study.nominal(), study.nominal_residual(), {});
  CHECK(where.joint_evidence == JointEvidence::measured);
  REQUIRE(where.joints.size() == 3);
  CHECK(where.joints.front().joint == 2);
  // the others miss what noise of their angles and of the force gives, which is no share of it
  CHECK(where.joints.front().share == close_to(1));
  // A hundredfold noise might have given as much.
  NoiseModel loud;
  loud.scale.fill(100);
  CHECK(locate(study, study.nominal(), study.nominal_residual(), loud).joints.empty());

  for (Reading& reading : experiment.runs[0].readings) reading.q.clear();
  const Study forces(experiment);
  CHECK(locate(forces, forces.nominal(), forces.nominal_residual(), {}).joints.empty());

  CHECK(joint_evidence_words(JointEvidence::measured) == "of the measured torque residual");
  CHECK(joint_evidence_words(JointEvidence::implied_by_fits) ==
        "of the torque that the explanation adds");
  CHECK(joint_evidence_words(JointEvidence::implied_by_law) ==
        "probability of being the only joint at fault");
}
