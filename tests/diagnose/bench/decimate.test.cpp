#include "diagnose/bench/decimate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Readings of the nominal rig, pressed and released in a number of steps, with noise of the declared size.
Experiment logged(int steps) {
  Experiment experiment = three_links();
  experiment.noise = {0, 0, 0.1, 0.1, 0.01};
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, steps, true, 0.01);
  const Prediction nominal = predict(Study(experiment), {}, {});
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  Run& run = experiment.runs[0];
  for (std::size_t i = 0; i < run.readings.size(); ++i)
    for (const Channel& channel : run.measured())
      channel.in(run.readings[i]) = nominal.runs[0](static_cast<Eigen::Index>(i), channel.column) +
                                    channel.sigma(experiment.noise) * normal(random);
  return experiment;
}

/// Every reading written so many times, as a logger does that is faster than its sensor.
Experiment written_again(Experiment experiment, std::size_t times) {
  for (Run& run : experiment.runs) {
    std::vector<Reading> readings;
    for (const Reading& reading : run.readings)
      for (std::size_t copy = 0; copy < times; ++copy) readings.push_back(reading);
    run.readings = std::move(readings);
  }
  return experiment;
}

std::vector<double> values_of(const Run& run, std::size_t column) {
  std::vector<double> values;
  for (const Reading& reading : run.readings) values.push_back(reading[column]);
  return values;
}

}  // namespace

TEST_CASE("readings that a logger wrote again are one, and keep their numbers") {
  const Experiment once = logged(20);
  for (const std::size_t times : {2, 3, 4}) {
    const Run run = decimated(written_again(once, times)).runs[0];
    CHECK(values_of(run, column_Fx) == values_of(once.runs[0], column_Fx));
    CHECK(run.is_thinned());
    CHECK(run.first_taken(3) == 3 * times);
    CHECK(run.last_taken(3) == 4 * times - 1);
  }
}

TEST_CASE("equal readings of a coarse display are readings of their own") {
  // At one command, steps of two standard deviations: neighbours are equal as often as not.
  Experiment experiment = logged(20);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  Run& run = experiment.runs[0];
  for (Reading& reading : run.readings) {
    reading = run.readings.front();
    for (const Channel& channel : run.measured()) {
      const double step = 2 * channel.sigma(experiment.noise);
      channel.in(reading) = step * std::round(0.5 * normal(random));
    }
  }
  CHECK(decimated(experiment).runs[0].readings.size() == run.readings.size());
}

TEST_CASE("a sensor that holds its value while the command moves is left as it is") {
  Experiment experiment = logged(20);
  Run& run = experiment.runs[0];
  for (std::size_t i = 1; i < run.readings.size(); i += 2)
    for (const Channel& channel : run.measured()) channel.in(run.readings[i]) = channel.of(run.readings[i - 1]);
  CHECK(decimated(experiment).runs[0].readings.size() == run.readings.size());
}

TEST_CASE("a short experiment is not decimated") {
  const Experiment same = decimated(logged(400));
  CHECK(same.runs[0].readings.size() == 801);
  CHECK(same.runs[0].first_taken(7) == 7);
  CHECK(same.runs[0].last_taken(7) == 7);
}

TEST_CASE("a long run keeps its ends and turning points, and its readings their numbers") {
  const Experiment all = logged(5000), few = decimated(all);
  const Run &before = all.runs[0], &after = few.runs[0];
  CHECK(after.readings.size() < 1100);
  CHECK(after.readings.front()[column_x] == before.readings.front()[column_x]);
  CHECK(after.readings.back()[column_x] == before.readings.back()[column_x]);
  const auto depth = [](const Reading& a, const Reading& b) { return a[column_x] < b[column_x]; };
  const auto deepest = std::min_element(after.readings.begin(), after.readings.end(), depth);
  CHECK((*deepest)[column_x] ==
        (*std::min_element(before.readings.begin(), before.readings.end(), depth))[column_x]);
  CHECK(std::isnan((*deepest)[column_Fx]));
  std::size_t next = 0;
  for (std::size_t i = 0; i < after.readings.size(); ++i) {
    CHECK(after.first_taken(i) == next);
    next = after.last_taken(i) + 1;
  }
  CHECK(next == before.readings.size());
}

TEST_CASE("decimated readings have the declared noise, and no gap") {
  const Study study(decimated(logged(5000)));
  const Eigen::VectorXd residual = study.nominal_residual();
  // 5 channels x 1000 values: the mean square scatters by sqrt(2/5000) = 0.02; groups of 11 are a little
  // better than the formula for large ones, by 1/11 at most.
  CHECK(residual.squaredNorm() / static_cast<double>(residual.size()) == close_to(0.96).epsilon(0.12));
}

TEST_CASE("a few outliers do not move decimated readings") {
  Experiment all = logged(5000);
  const Experiment clean = decimated(all);
  for (std::size_t i = 0; i < all.runs[0].readings.size(); i += 50) all.runs[0].readings[i][column_Fx] += 100;
  const Experiment few = decimated(all);
  // an outlier on one side of a group of eleven shifts its median by about a quarter of a sigma
  for (std::size_t i = 0; i < few.runs[0].readings.size(); ++i)
    if (const double Fx = few.runs[0].readings[i][column_Fx]; !std::isnan(Fx))
      CHECK(std::abs(Fx - clean.runs[0].readings[i][column_Fx]) < 5 * 0.1);
}

namespace {

/// A press whose x falls by one a reading and whose Fx is the number of the reading; one way, or back from a
/// reading on.
Experiment numbered(std::size_t count, std::size_t turn) {
  Experiment experiment = three_links();
  Run run{"press", Control::end_point, {0.3, -0.5, 0.4}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const double way = static_cast<double>(i <= turn ? i : 2 * turn - i), number = static_cast<double>(i);
    run.readings.push_back({2 * number, {-way, 3 * way, number, number}});
  }
  experiment.runs.push_back(run);
  return experiment;
}

}  // namespace

TEST_CASE("which readings are decimated, by hand") {
  // 1199 readings in 500 groups: three each, but for the first and the last one, and the two twos that 1197
  // between them would not fill: 399 threes.
  const Run run = decimated(numbered(1199, 1199)).runs[0];
  CHECK(run.groups.size == 3);
  REQUIRE(run.readings.size() == 401);
  CHECK(run.groups.first.size() == 402);
  for (std::size_t g = 1; g < 400; ++g) CHECK(run.groups.first[g] == 3 * g - 2);
  CHECK(run.groups.first[400] == 1198);
  CHECK(run.groups.first[401] == 1199);
  // Readings 4, 5 and 6: the mean time, the mean command, the median of the measured values.
  const Reading& third = run.readings[2];
  CHECK(third.t == 10);
  CHECK(third[column_x] == -5);
  CHECK(third[column_y] == 15);
  CHECK(third[column_Fx] == 5);
  CHECK(third[column_Fy] == 5);
  for (const std::size_t end : {0U, 400U}) CHECK(std::isnan(run.readings[end][column_Fx]));
  CHECK(run.readings[0][column_x] == 0);
  CHECK(run.readings[400][column_x] == -1198);

  // A turn stands alone. Between it and the ends, 599 readings each: 200 groups, one of them of two.
  const Run back = decimated(numbered(1201, 600)).runs[0];
  const auto turn = std::find(back.groups.first.begin(), back.groups.first.end(), 600U);
  REQUIRE(turn != back.groups.first.end());
  CHECK(*(turn - 1) == 597);
  CHECK(*(turn + 1) == 601);
  CHECK(*(turn + 200) == 1197);
  CHECK(*(turn + 201) == 1200);
}

namespace {

/// A bench without effect that is pressed so often by so much of three centimetres, at so many readings each
/// way, with noise of the declared size.
Experiment cycled(int cycles, int each_way, double jitter = 0) {
  Experiment experiment = three_links();
  experiment.noise = {0, 0, 0.02, 0.02, 0};
  press(experiment, {0.3, -0.5, 0.4}, {-0.03, 0}, each_way, true, 0.01);
  Run& run = experiment.runs[0];
  const std::vector<Reading> once = run.readings;
  for (int cycle = 1; cycle < cycles; ++cycle)
    run.readings.insert(run.readings.end(), once.begin() + 1, once.end());
  for (std::size_t i = 0; i < run.readings.size(); ++i) run.readings[i].t = 0.01 * static_cast<double>(i);
  for (Reading& reading : run.readings) reading.value.resize(column_q);
  const Prediction nominal = predict(Study(experiment), {}, {});
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    for (const Channel& channel : run.measured())
      channel.in(run.readings[i]) = nominal.runs[0](static_cast<Eigen::Index>(i), channel.column) +
                                    channel.sigma(experiment.noise) * normal(random);
    run.readings[i][column_x] += jitter * normal(random);
  }
  return experiment;
}

}  // namespace

TEST_CASE("a run with small reversals has four groups between reversals, on average") {
  // There by so many readings, then 199 times back and there again by fifty of them: 200 segments, so 800
  // groups. Of 500 they would be of 25 readings and more, by the way of a tenth of the extent longer still.
  for (const auto& [there, size] :
       std::vector<std::pair<std::size_t, std::size_t>>{{2089, 15}, {2829, 15}, {2850, 16}}) {
    CAPTURE(there);
    const std::size_t count = there + 199 * 50 + 1;
    Experiment experiment = numbered(count, count);
    std::vector<Reading>& readings = experiment.runs[0].readings;
    for (std::size_t i = there; i < count; ++i) {
      const std::size_t leg = (i - there) / 50, on = (i - there) % 50, back = leg % 2 == 0 ? on : 50 - on;
      readings[i][column_x] = -static_cast<double>(there - back);
      readings[i][column_y] = -3 * readings[i][column_x];
    }
    const Run few = decimated(experiment).runs[0];
    // The readings between the first one and the first reversal.
    const auto turn = std::find(few.groups.first.begin(), few.groups.first.end(), there);
    REQUIRE(turn != few.groups.first.end());
    CHECK(static_cast<std::size_t>(turn - few.groups.first.begin()) == 1 + (there - 1 + size - 1) / size);
    CHECK(std::count_if(few.readings.begin(), few.readings.end(),
                        [](const Reading& r) { return std::isnan(r[column_Fx]); }) == 201);
  }
}

TEST_CASE("decimated readings have the declared noise and show no gap, however often and far a run goes") {
  // Forces of a press change by forty sigmas on the way, along a curve.
  for (const auto& [cycles, each_way] :
       std::vector<std::pair<int, int>>{{1, 5000}, {10, 500}, {50, 100}, {100, 20}, {1000, 2}}) {
    CAPTURE(cycles);
    CAPTURE(each_way);
    const Study study(decimated(cycled(cycles, each_way)));
    const Eigen::VectorXd residual = study.nominal_residual();
    REQUIRE(residual.size() >= 100);
    const double sum = residual.squaredNorm(), count = static_cast<double>(residual.size()),
                 chance = 4 * std::sqrt(2 / count);
    // Medians of a few scatter by up to a sixth less than the formula for many says.
    CHECK(sum / count < 1.05 + chance);
    CHECK(sum / count > 0.80 - chance);
  }
}

TEST_CASE("position jitter is not a reversal and does not prevent decimation") {
  const Experiment few = decimated(cycled(1, 5000, 3e-5));
  CHECK(few.runs[0].readings.size() < 600);
  std::size_t unseen = 0;
  for (const Reading& reading : few.runs[0].readings) unseen += std::isnan(reading[column_Fx]) ? 1 : 0;
  CHECK(unseen <= 3);
}

TEST_CASE("an unsteady position of a held run is not a reversal") {
  Experiment experiment = cycled(1, 500);
  Run held = experiment.runs[0];
  const Reading far = held.readings[500];
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < held.readings.size(); ++i) {
    held.readings[i] = far;
    held.readings[i].t = 0.01 * static_cast<double>(i);
    held.readings[i][column_x] += 5e-6 * normal(random);
  }
  experiment.runs.push_back(held);
  const Experiment few = decimated(experiment);
  CHECK(few.runs[1].readings.size() < 300);
  const std::vector<Reading>& left = few.runs[1].readings;
  CHECK(std::count_if(left.begin(), left.end(), [](const Reading& r) { return std::isnan(r[column_Fx]); }) <=
        3);
}

TEST_CASE("a run that reverses at every reading is not decimated") {
  Experiment experiment = cycled(1, 1000);
  for (std::size_t i = 0; i < experiment.runs[0].readings.size(); i += 2)
    experiment.runs[0].readings[i][column_x] += 1e-3;
  CHECK(decimated(experiment).runs[0].readings.size() == experiment.runs[0].readings.size());
}

TEST_CASE("more runs leave fewer readings of each: 33 for 30 runs, 20 for 60") {
  for (const auto& [runs, size] : std::vector<std::pair<std::size_t, std::size_t>>{{30, 10}, {60, 15}}) {
    Experiment many = numbered(300, 300);
    many.runs.resize(runs, many.runs[0]);
    CHECK(decimated(many).runs[0].groups.size == size);
  }
}

TEST_CASE("groups along a parabola lie on it, also where the command is faster") {
  Experiment experiment = numbered(10001, 10001);
  const auto along = [](double x) { return 3 - 2 * x + 0.01 * x * x; };
  for (const bool faster : {false, true}) {
    CAPTURE(faster);
    for (Reading& reading : experiment.runs[0].readings) {
      if (faster)
        reading[column_x] *= 1 - reading[column_x] / 1e5, reading[column_y] = -3 * reading[column_x];
      reading[column_Fx] = along(reading[column_x]);
    }
    for (std::size_t i = 3; i < 10001; i += 50)
      experiment.runs[0].readings[i][column_Fx] = std::numeric_limits<double>::quiet_NaN();
    const Run few = decimated(experiment).runs[0];
    CHECK(few.groups.size >= 19);
    // Of an even number the mean of the middle two is off by a quarter of the curvature, and of a step that
    // grows by a ten-thousandth of itself, twenty readings long, by less; a plain median by 25 of them.
    for (const Reading& reading : few.readings)
      if (!std::isnan(reading[column_Fx]))
        CHECK(std::abs(reading[column_Fx] - along(reading[column_x])) < 0.01);
  }
}

TEST_CASE("a few readings between two turning points lose their measured values") {
  // Groups of twenty, and five readings between two turns of a hundredth and more of the way.
  Experiment experiment = numbered(10001, 5000);
  std::vector<Reading>& readings = experiment.runs[0].readings;
  for (std::size_t i = 0; i < 6; ++i) {
    readings[2000 + i][column_x] += 100.0 * static_cast<double>(i + 1);
    readings[2000 + i][column_y] = -3 * readings[2000 + i][column_x];
  }
  const Run few = decimated(experiment).runs[0];
  REQUIRE(few.groups.size > 15);
  std::size_t unseen = 0;
  for (const Reading& reading : few.readings) unseen += std::isnan(reading[column_Fx]) ? 1 : 0;
  // The ends, the middle, the two new turns, and what is between these.
  CHECK(unseen == 6);
}

TEST_CASE("readings left: all up to 1000, otherwise 500 in all, at least 40 of a short run") {
  CHECK(decimated(numbered(1000, 1000)).runs[0].readings.size() == 1000);
  // 1001 in 500 groups would be three each as well
  CHECK(decimated(numbered(1001, 1001)).runs[0].groups.size == 3);
  Experiment two = numbered(3900, 3900);
  two.runs.push_back(numbered(100, 100).runs[0]);
  const Experiment few = decimated(two);
  CHECK(few.runs[0].groups.size == 9);  // 3900 in 487, a little more than eight each
  CHECK(few.runs[1].groups.size == 3);  // 100 in 40, not in 12
  two.runs[1] = numbered(80, 80).runs[0];
  CHECK(decimated(two).runs[1].groups.size == 1);  // twos would gain nothing
}
