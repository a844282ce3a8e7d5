#include "diagnose/decision/shrink.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// The readings of one run of `runs`.
HeldOut whole_run(const Experiment& experiment, std::size_t which) {
  HeldOut held;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    held.reading.emplace_back(experiment.runs[r].readings.size(), r == which);
  held.names = {experiment.runs[which].id};
  return held;
}

/// A flat list that holds one value for each series, with alternating sign.
VectorXd by_series(const Measurements& measurements, const std::vector<double>& size) {
  VectorXd values(static_cast<Eigen::Index>(measurements.size()));
  for (std::size_t s = 0; s < size.size(); ++s) {
    const Series& series = measurements.series()[s];
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      values(static_cast<Eigen::Index>(series.first + i)) = i % 2 == 0 ? size[s] : -size[s];
  }
  return values;
}

}  // namespace

TEST_CASE("the shrink of four held-out readings, by hand") {
  Experiment experiment = blank_experiment({4, 4});
  experiment.noise[Channel::Name::Fx] = 0.5;
  experiment.noise[Channel::Name::Fy] = 2;
  const Measurements measurements(experiment);  // series: Fx of the first run and the second, then Fy
  NoiseEstimate noise = declared_noise(measurements);
  for (ChannelNoise& one : noise.channels) one.scale = 1.5;
  // What the first run leaves was seen and does not count.
  const VectorXd before = by_series(measurements, {50, 6, 70, 8}),
                 after = by_series(measurements, {30, 1, 40, 2});
  const Shrink shrink = measure_shrink(measurements, whole_run(experiment, 1), before, after, noise);
  CHECK(shrink.heldout == std::vector<std::string>{"run-2"});
  CHECK(shrink.rms_before.at(Channel(Channel::Name::Fx)) == close_to(3));   // 6 sigmas of 0.5 N
  CHECK(shrink.rms_before.at(Channel(Channel::Name::Fy)) == close_to(16));  // 8 sigmas of 2 N
  CHECK(shrink.rms_after.at(Channel(Channel::Name::Fx)) == close_to(0.5));
  CHECK(shrink.rms_after.at(Channel(Channel::Name::Fy)) == close_to(4));
  // squares in sigmas: before 4 (36 + 64) = 400, after 4 (1 + 4) = 20; noise of 1.5 sigmas gives 8 * 2.25
  CHECK(shrink.ratio == close_to(std::sqrt(20.0 / 400)));
  CHECK(shrink.noise_floor_ratio == close_to(std::sqrt(18.0 / 400)));
  CHECK(shrink.chi2_per_value_after == close_to(20.0 / 18));
  // In noise of 0.5 and 2.5 sigmas every value counts by its own: (4 2^2 + 4 0.8^2) / 8
  noise_of(noise, Channel(Channel::Name::Fx)).scale = 0.5;
  noise_of(noise, Channel(Channel::Name::Fy)).scale = 2.5;
  CHECK(measure_shrink(measurements, whole_run(experiment, 1), before, after, noise).chi2_per_value_after ==
        close_to(2.32));
  CHECK(shrink.channels.at(Channel(Channel::Name::Fx)).ratio == close_to(1.0 / 6));
  CHECK(shrink.channels.at(Channel(Channel::Name::Fy)).ratio == close_to(2.0 / 8));
  CHECK(shrink.channels.at(Channel(Channel::Name::Fx)).noise_floor_ratio == close_to(1.5 / 6));
  CHECK(shrink.channels.at(Channel(Channel::Name::Fy)).noise_floor_ratio == close_to(1.5 / 8));
  // the two blocks, Fx and Fy, leave 1/6 and 1/4: no draw of them leaves less or more
  CHECK(shrink.ratio_low == close_to(1.0 / 6));
  CHECK(shrink.ratio_high == close_to(1.0 / 4));
}

TEST_CASE("every value is weighed by the noise that it has") {
  const Experiment experiment = blank_experiment({4, 4});
  const Measurements measurements(experiment);
  const VectorXd before = by_series(measurements, {9, 6, 9, 8}),
                 after = by_series(measurements, {9, 3, 9, 2});
  NoiseEstimate noise = declared_noise(measurements);
  noise_of(noise, Channel(Channel::Name::Fy)).scale = 2;
  noise.shape.relative.segment(4, 2).setConstant(3);  // the first two of Fx
  const Shrink shrink = measure_shrink(measurements, whole_run(experiment, 1), before, after, noise);
  // Fx: twice 2^2 and twice 6^2, then twice 1 and twice 3^2; Fy: four times 4^2, then four times 1
  CHECK(shrink.ratio == close_to(std::sqrt(24.0 / 144)));
  CHECK(shrink.noise_floor_ratio == close_to(std::sqrt(8.0 / 144)));
}

TEST_CASE("a shrink tests where the gap is more than the noise, and fails where it is surely none") {
  Shrink shrink;
  shrink.noise_floor_ratio = 0.7, shrink.ratio_low = 0.99;
  CHECK(shrink.tested());
  CHECK_FALSE(shrink.fails());
  shrink.noise_floor_ratio = 0.71, shrink.ratio_low = 1.01;
  CHECK_FALSE(shrink.tested());
  CHECK(shrink.fails());
}

TEST_CASE("bounds are of blocks of neighbours; nothing held out leaves the shrink as it is") {
  const Experiment experiment = blank_experiment({16, 16});
  const Measurements measurements(experiment);
  const NoiseEstimate noise = declared_noise(measurements);
  const VectorXd before = by_series(measurements, {5, 10, 5, 10}),
                 after = by_series(measurements, {1, 1, 1, 1});
  const Shrink shrink = measure_shrink(measurements, whole_run(experiment, 1), before, after, noise);
  // of blocks that all leave a tenth no draw leaves more or less
  CHECK(shrink.ratio == close_to(0.1));
  CHECK(shrink.ratio_low == close_to(0.1));
  CHECK(shrink.ratio_high == close_to(0.1));
  // two blocks of each channel that leave 1 and 3 of ten
  VectorXd uneven = after;
  for (const std::size_t s : {1U, 3U})
    uneven.segment(static_cast<Eigen::Index>(measurements.series()[s].first) + 8, 8) *= 3;
  const Shrink ragged = measure_shrink(measurements, whole_run(experiment, 1), before, uneven, noise);
  const ChannelShrink& force = ragged.channels.at(Channel(Channel::Name::Fx));
  CHECK(force.ratio == close_to(std::sqrt(0.05)));
  CHECK(force.ratio_low == close_to(0.1));
  CHECK(force.ratio_high == close_to(0.3));
  const Shrink none = measure_shrink(measurements, nothing_held(experiment), before, after, noise);
  CHECK(none.ratio == 1);
  CHECK(none.channels.empty());
  CHECK(none.rms_before.empty());
}

TEST_CASE("an outlier among the held-out readings counts neither before nor after") {
  const Experiment experiment = blank_experiment({9, 9});
  const Measurements measurements(experiment);
  VectorXd before = by_series(measurements, {5, 10, 5, 10}), after = by_series(measurements, {1, 1, 1, 1});
  const std::size_t bad = measurements.series()[1].first + 4;
  before(static_cast<Eigen::Index>(bad)) += 40;
  after(static_cast<Eigen::Index>(bad)) += 40;
  NoiseEstimate noise = declared_noise(measurements);
  noise.shape.outlier[bad] = true;
  const Shrink shrink = measure_shrink(measurements, whole_run(experiment, 1), before, after, noise);
  CHECK(shrink.ratio == close_to(0.1));
  CHECK(shrink.outliers == 1);
  // 18 values, of which one is 50 before and 41 after
  CHECK(shrink.ratio_with_outliers == close_to(std::sqrt((17 + 41 * 41) / (1700.0 + 50 * 50))));
  CHECK(measure_shrink(measurements, whole_run(experiment, 0), before, after, noise).outliers == 0);
}

TEST_CASE("bounds of the shrink: 1.96 deviations of the ratio of white noise to a constant gap") {
  const Experiment experiment = blank_experiment({800, 8});
  const Measurements measurements(experiment);
  std::mt19937_64 random(4);
  const auto width_of = [&](double correlation) {
    // the mean of draws, so that the chance of one residual does not show
    double below = 0, above = 0;
    constexpr int draws = 20;
    for (int draw = 0; draw < draws; ++draw) {
      const VectorXd after = correlated_noise(measurements, 1, correlation, random);
      const VectorXd before = VectorXd::Constant(after.size(), 10);
      const Shrink shrink =
          measure_shrink(measurements, whole_run(experiment, 0), before, after, declared_noise(measurements));
      below += (shrink.ratio - shrink.ratio_low) / shrink.ratio / draws;
      above += (shrink.ratio_high - shrink.ratio) / shrink.ratio / draws;
    }
    return std::pair(below, above);
  };
  // The mean of N squares of unit normal numbers spreads by sqrt(2/N), its root by half of that: N = 1600.
  const double expected = 1.96 / std::sqrt(2 * 1600.0);
  const auto white = width_of(0);
  // 200 blocks estimate a deviation to 5 %, 20 such estimates and the 1000 draws each to 2 %
  CHECK(white.first / expected == close_to(1).epsilon(0.05));
  CHECK(white.second / expected == close_to(1).epsilon(0.05));
  // Squares of noise that correlates by phi correlate by phi^2 = 0.49. In blocks of eight the variance of
  // their sum is 1 + 2 sum_k (1 - k/8) 0.49^k = 2.45 times that of independent ones.
  const auto slow = width_of(0.7);
  // Their skewness is 8 (1 + 6 sum_d d 0.49^d) N / (2 2.45 N)^1.5 = 0.23: bounds at 1.96 stand (1.96^2 - 1) /
  // 6 of that farther up, by 5.5 % of 1.96, and the root brings either 2.7 % down. Of independent ones both
  // are 1.7 %.
  constexpr double skewed = 0.028;
  CHECK(slow.first / (std::sqrt(2.45) * expected) == close_to(1 - skewed).epsilon(0.05));
  CHECK(slow.second / (std::sqrt(2.45) * expected) == close_to(1 + skewed).epsilon(0.05));
}

TEST_CASE("what is held out is hidden whole, what was commanded stays") {
  Experiment experiment = full_bench();  // press and back, press, load by force
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading = {reading.t, chain_values(1, 2, 3, 4, {5, 6, 7})};
  HeldOut held;
  for (const Run& run : experiment.runs) held.reading.emplace_back(run.readings.size(), false);
  for (auto& run : held.reading) run[2] = run[3] = true;
  const Experiment seen = without(experiment, held);
  REQUIRE(seen.runs.size() == experiment.runs.size());
  for (std::size_t r = 0; r < seen.runs.size(); ++r) {
    const bool displacement = seen.runs[r].control == Control::end_point;
    REQUIRE(seen.runs[r].readings.size() == experiment.runs[r].readings.size());
    for (std::size_t i = 0; i < seen.runs[r].readings.size(); ++i) {
      const Reading& reading = seen.runs[r].readings[i];
      const bool hidden = i == 2 || i == 3;
      CHECK(reading.t == experiment.runs[r].readings[i].t);
      CHECK(std::isnan(reading[column_x]) == (hidden && !displacement));
      CHECK(std::isnan(reading[column_y]) == (hidden && !displacement));
      CHECK(std::isnan(reading[column_Fx]) == (hidden && displacement));
      CHECK(std::isnan(reading[column_Fy]) == (hidden && displacement));
      for (const double q : reading.angles(3)) CHECK(std::isnan(q) == hidden);
    }
  }
  // no measured value of a hidden reading is left in any list of them
  const Measurements left(seen);
  for (const Series& series : left.series())
    for (const std::size_t i : series.readings) CHECK_FALSE(held.reading[series.run][i]);
}

TEST_CASE("a run that is held out whole is gone") {
  const Experiment experiment = full_bench();
  const Experiment seen = without(experiment, whole_run(experiment, 1));
  REQUIRE(seen.runs.size() == 2);
  CHECK(seen.runs[0].id == experiment.runs[0].id);
  CHECK(seen.runs[1].id == experiment.runs[2].id);
}

TEST_CASE("of runs of one kind the farthest but one is held out, in whatever order they stand") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, false);
  press(experiment, {0.2, -0.5, 0.4}, {-0.06, 0}, 20, false);
  press(experiment, {0.2, -0.5, 0.4}, {-0.04, 0}, 20, false);
  press(experiment, {0.2, -0.5, 0.4}, {-0.08, 0}, 20, true);
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(experiment.runs.begin(), experiment.runs.begin() + 1, experiment.runs.end());
    const HeldOut held = choose_heldout(experiment);
    CHECK(held.names == std::vector<std::string>{"press-1"});
    for (std::size_t r = 0; r < 4; ++r)
      for (const bool one : held.reading[r]) CHECK(one == (experiment.runs[r].id == "press-1"));
  }
}

TEST_CASE("of runs that repeat each other the same one is held out, in whatever order they stand") {
  Experiment experiment = three_links();
  for (int i = 0; i < 3; ++i) press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 20, false);
  const HeldOut first = choose_heldout(experiment);
  std::reverse(experiment.runs.begin(), experiment.runs.end());
  CHECK(choose_heldout(experiment).names == first.names);
}

TEST_CASE("where every run is the one of its kind, two stretches of each are held out") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 16, false);  // 17 readings: eighths of 2
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 12, true);   // 25: eighths of 3
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {-2.0, 1.0}, 5);  // 6: too short
  const HeldOut held = choose_heldout(experiment);
  CHECK(held.names ==
        std::vector<std::string>{"press-1[4:5]", "press-1[12:13]", "press-2[6:8]", "press-2[18:20]"});
  for (std::size_t i = 0; i < 17; ++i) CHECK(held.reading[0][i] == (i == 4 || i == 5 || i == 12 || i == 13));
  for (std::size_t i = 0; i < 25; ++i)
    CHECK(held.reading[1][i] == ((i >= 6 && i <= 8) || (i >= 18 && i <= 20)));
  for (const bool one : held.reading[2]) CHECK_FALSE(one);
}
