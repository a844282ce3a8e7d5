#include "diagnose/answers/where.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Presses of a nearly straight chain in so many readings each, without angles: a force that first grows
/// steeply, and next to nothing once the chain gives way.
Experiment presses(const std::vector<int>& readings) {
  Experiment experiment = three_links();
  experiment.noise[Channel::Name::q] = 0;
  for (const int count : readings)
    press(experiment, {0.05, -0.1, 0.05}, {-1e-3 * count, 0}, count - 1, false);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.value.resize(column_q);
  return experiment;
}

/// The same bench, read so many declared sigmas off what the nominal model predicts.
Study read_off(Experiment experiment, const VectorXd& residual) {
  const Study bare(experiment);
  for (const Series& series : bare.measurements().series())
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(series.first + i);
      series.channel.in(experiment.runs[series.run].readings[series.readings[i]]) =
          bare.nominal().runs[series.run](static_cast<Eigen::Index>(series.readings[i]),
                                          series.channel.column) +
          bare.measurements().sigma()(row) * residual(row);
    }
  return Study(experiment);
}

VectorXd nothing_off(const Measurements& measurements) {
  return VectorXd::Zero(static_cast<Eigen::Index>(measurements.size()));
}

/// Gives a series values of this size and alternating sign.
void fill(const Measurements& measurements, std::size_t series, double size, VectorXd& residual) {
  const Series& one = measurements.series()[series];
  for (std::size_t i = 0; i < one.readings.size(); ++i)
    residual(static_cast<Eigen::Index>(one.first + i)) = i % 2 == 0 ? size : -size;
}

/// Residuals come back from readings but for rounding.
constexpr double read_back = 1e-9;

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
  const Experiment experiment = presses({10, 10});
  const Measurements measurements(experiment);  // Fx of the first run and the second, then Fy
  VectorXd residual = nothing_off(measurements);
  fill(measurements, 0, 2, residual);  // noise of scale 2: 0 beyond it
  fill(measurements, 2, 1, residual);  // less than noise: 10 (1/4 - 1) = -7.5
  fill(measurements, 1, 6, residual);  // 10 (9 - 1) = 80
  fill(measurements, 3, 4, residual);  // 10 (4 - 1) = 30
  const Study study = read_off(experiment, residual);
  NoiseEstimate noise = declared_noise(study);
  for (ChannelNoise& one : noise.channels) one.scale = 2;
  const Where where = locate(study, noise);
  // by channel: Fx 0 + 80, Fy 30 - 7.5
  CHECK(where.channels.front().channel.label() == "Fx");
  CHECK(share_of(where.channels, "Fx") == close_to(80 / 102.5));
  CHECK(share_of(where.channels, "Fy") == close_to(22.5 / 102.5));
  // by run: the first is below noise, its share is nothing and no debt
  CHECK(where.runs.front().run == "press-2");
  CHECK(share_of(where.runs, "press-2") == close_to(1));
  CHECK(share_of(where.runs, "press-1") == 0.0);
  double sum = 0;
  for (const PathShare& one : where.load_path) {
    CHECK(one.share >= 0);
    if (one.run == "press-1") CHECK(one.share == 0.0);
    sum += one.share;
  }
  CHECK(sum == close_to(1));
}

TEST_CASE("a reading that is noisier than others has less of the gap") {
  const Experiment experiment = presses({10, 10});
  const Measurements measurements(experiment);
  VectorXd residual = nothing_off(measurements);
  for (std::size_t s = 0; s < 4; ++s) fill(measurements, s, 3, residual);
  const Study study = read_off(experiment, residual);
  NoiseEstimate noise = declared_noise(study);
  for (const std::size_t s : {1U, 3U})
    noise.shape.relative.segment(static_cast<Eigen::Index>(measurements.series()[s].first), 10)
        .setConstant(2);
  // 9 - 1 a value in the first run, 9 / 4 - 1 in the second
  CHECK(share_of(locate(study, noise).runs, "press-1") == close_to(8 / 9.25));
}

TEST_CASE("along the path a share belongs to the readings that hold it, also where others are missing") {
  Experiment experiment = presses({12});
  for (std::size_t i = 0; i < 2; ++i) experiment.runs[0].readings[i][column_Fx] = nan_value();
  const Measurements measurements(experiment);
  const std::vector<Regime> regime = regimes(experiment.runs[0], Study(experiment).nominal().runs[0]);
  std::size_t soft_from = 0;
  while (soft_from < 12 && regime[soft_from] != Regime::post_critical) ++soft_from;
  REQUIRE(soft_from > 0);
  REQUIRE(soft_from < 12);
  VectorXd residual = nothing_off(measurements);
  fill(measurements, 0, 1, residual);
  fill(measurements, 1, 1, residual);
  for (std::size_t i = 0; i < 10; ++i)  // Fx of readings 2 to 11
    if (i + 2 >= soft_from) residual(static_cast<Eigen::Index>(i)) *= 3;
  const Study study = read_off(experiment, residual);
  const Where where = locate(study, declared_noise(study));
  REQUIRE(where.load_path.size() > 1);
  const PathShare& soft = where.load_path.back();
  CHECK((soft.from == soft_from && soft.to == 11 && soft.regime == Regime::post_critical));
  CHECK(soft.share == close_to(1).epsilon(read_back));
  for (std::size_t i = 0; i + 1 < where.load_path.size(); ++i) CHECK(where.load_path[i].share < read_back);
}

TEST_CASE("an outlier moves no share") {
  const Experiment experiment = presses({20, 20});
  const Measurements measurements(experiment);
  VectorXd residual = nothing_off(measurements);
  for (std::size_t s = 0; s < 4; ++s) fill(measurements, s, s == 3 ? 2 : 1, residual);
  residual(10) += 25;
  const Study study = read_off(experiment, residual);
  NoiseEstimate noise = declared_noise(study);
  CHECK(share_of(locate(study, noise).runs, "press-1") > 0.5);
  noise.shape.outlier[10] = true;
  const Where where = locate(study, noise);
  CHECK(share_of(where.runs, "press-2") == close_to(1).epsilon(read_back));
  CHECK(share_of(where.channels, "Fy") == close_to(1).epsilon(read_back));
}

TEST_CASE("shares of joints: in proportion, largest first, alike where nothing is known") {
  const std::vector<JointShare> some = joint_shares({1, 0, 3});
  REQUIRE(some.size() == 3);
  CHECK((some[0].joint == 3 && some[0].share == close_to(0.75)));
  CHECK((some[1].joint == 1 && some[1].share == close_to(0.25)));
  CHECK((some[2].joint == 2 && some[2].share == 0.0));
  for (const JointShare& one : joint_shares({0, 0, 0, 0})) CHECK(one.share == close_to(0.25));
}

TEST_CASE("along the path of several runs each segment has its readings, counted as they were taken") {
  Experiment experiment = presses({6, 5});
  // the second run was read ten times: two of its readings were drawn into one each
  experiment.runs[1].groups = {2, {0, 2, 4, 6, 8, 10}};
  const Measurements measurements(experiment);
  VectorXd residual = nothing_off(measurements);
  fill(measurements, 0, 3, residual);  // Fx of the first: 8 beyond noise a reading
  fill(measurements, 3, 2, residual);  // Fy of the second: 3
  for (const std::size_t s : {1U, 2U}) fill(measurements, s, 1, residual);
  const Study study = read_off(experiment, residual);
  const Where where = locate(study, declared_noise(study));
  struct Segment {
    std::string run;
    std::size_t from, to;
    double beyond;
    Regime regime;
  };
  std::vector<Segment> expected;
  for (std::size_t r = 0; r < 2; ++r) {
    const std::vector<Regime> regime = regimes(experiment.runs[r], study.nominal().runs[r]);
    const std::size_t taken = r + 1;  // readings in one
    for (std::size_t i = 0; i < regime.size(); ++i) {
      if (i == 0 || regime[i] != regime[i - 1])
        expected.push_back({experiment.runs[r].id, taken * i, 0, 0, regime[i]});
      expected.back().to = taken * i + r;
      expected.back().beyond += r == 0 ? 8 : 3;
    }
  }
  REQUIRE(expected.size() > 2);
  REQUIRE(where.load_path.size() == expected.size());
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
  const Experiment experiment = presses({10, 12});
  const Measurements measurements(experiment);
  VectorXd residual = nothing_off(measurements);
  std::vector<double> sum(4);
  for (std::size_t s = 0; s < 4; ++s) {
    const Series& series = measurements.series()[s];
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const double value = static_cast<double>(2 + s + i * (s + 1));
      residual(static_cast<Eigen::Index>(series.first + i)) = value;
      sum[s] += value * value - 1;
    }
  }
  const double all = sum[0] + sum[1] + sum[2] + sum[3];
  const Study study = read_off(experiment, residual);
  const Where where = locate(study, declared_noise(study));
  CHECK(share_of(where.channels, "Fx") == close_to((sum[0] + sum[1]) / all).epsilon(read_back));
  CHECK(share_of(where.runs, "press-1") == close_to((sum[0] + sum[2]) / all).epsilon(read_back));
  double second = 0;
  for (const PathShare& one : where.load_path) second += one.run == "press-2" ? one.share : 0;
  CHECK(second == close_to((sum[1] + sum[3]) / all).epsilon(read_back));
}

TEST_CASE("runs and channels stand largest first, those that are alike as they were") {
  const Experiment experiment = presses({8, 8, 8, 8});
  const Measurements measurements(experiment);
  VectorXd residual = nothing_off(measurements);
  const Where nowhere = [&] {
    const Study study = read_off(experiment, residual);
    return locate(study, declared_noise(study));
  }();
  // Where nothing is beyond noise all shares are alike.
  REQUIRE(nowhere.runs.size() == 4);
  for (std::size_t r = 0; r < 4; ++r) {
    CHECK(nowhere.runs[r].share == 0.25);
    CHECK(nowhere.runs[r].run == experiment.runs[r].id);
  }
  for (const ChannelShare& one : nowhere.channels) CHECK(one.share == 0.5);

  // Fy: 3 beyond noise a reading in three runs, 8 in one
  for (std::size_t s = 0; s < 8; ++s) fill(measurements, s, s == 6 ? 3 : s < 4 ? 1 : 2, residual);
  const Study study = read_off(experiment, residual);
  const Where where = locate(study, declared_noise(study));
  CHECK(where.runs.front().run == "press-3");
  CHECK(where.channels.front().channel.label() == "Fy");
  CHECK(share_of(where.runs, "press-3") == close_to(8 / 17.0));
  CHECK(share_of(where.runs, "press-4") == close_to(3 / 17.0));
}

TEST_CASE("the joint whose torque is missing is told by measured angles alone, and said to be") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, true);
  experiment = measured(experiment, only("joint_stiffness", 2), {0.5}, 3);
  const Study study(experiment);
  const Where where = locate(study, declared_noise(study));
  CHECK(where.joint_evidence == JointEvidence::measured);
  REQUIRE(where.joints.size() == 3);
  CHECK(where.joints.front().joint == 2);
  // the others miss what noise of their angles and of the force gives, which is no share of it
  CHECK(where.joints.front().share == close_to(1));
  // A hundredfold noise might have given as much.
  NoiseEstimate loud = declared_noise(study);
  for (ChannelNoise& one : loud.channels) one.scale = 100;
  CHECK(locate(study, loud).joints.empty());

  for (Reading& reading : experiment.runs[0].readings) reading.value.resize(column_q);
  const Study forces(experiment);
  CHECK(locate(forces, declared_noise(forces)).joints.empty());

  CHECK(joint_evidence_words(JointEvidence::measured) == "of the measured torque residual");
  CHECK(joint_evidence_words(JointEvidence::implied_by_fits) == "of the torque that the explanation adds");
  CHECK(joint_evidence_words(JointEvidence::implied_by_law) ==
        "probability of being the only joint at fault");
}
