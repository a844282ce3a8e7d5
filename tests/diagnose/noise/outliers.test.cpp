#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "diagnose/noise/gathered.hpp"
#include "diagnose/noise/noise.hpp"
#include "diagnose/noise/outliers.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

using Places = std::map<std::size_t, double>;

/// Which of so many readings of Fx are marked, these values being added to nothing; those of Fy follow them.
/// Where nothing scatters, five times two thirds of a sigma are far out: 3.33.
std::vector<std::size_t> marked_of(std::size_t count, const Places& values) {
  std::vector<double> residual(2 * count, 0.0);
  for (const auto& [place, value] : values) residual[place] += value;
  const std::vector<bool> marked = outliers(Measurements(blank_experiment({count})), residual);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i]) places.push_back(i);
  return places;
}

using Marks = std::vector<std::size_t>;

}  // namespace

TEST_CASE(
    "an outlier gives way to the median of nine readings around it, of five in a short run, within the run") {
  const auto replaced = [](std::size_t count, std::size_t place) {
    std::vector<double> ramp(2 * count, 0.0);
    for (std::size_t i = 0; i < count; ++i) ramp[i] = 0.1 * static_cast<double>(i);
    ramp[place] += 20;
    const Measurements measurements(blank_experiment({count}));
    const std::vector<double> clean = without_outliers(measurements, ramp);
    for (std::size_t i = 0; i < 2 * count; ++i)
      if (i != place) CHECK(clean[i] == ramp[i]);
    return clean[place];
  };
  // Of a ramp with one value on top the median is that of the reading after the middle.
  CHECK(replaced(40, 20) == close_to(2.1));
  CHECK(replaced(40, 0) == close_to(0.5));  // of readings 0 to 8
  CHECK(replaced(40, 1) == close_to(0.5));
  CHECK(replaced(40, 4) == close_to(0.5));
  CHECK(replaced(40, 5) == close_to(0.6));   // of 1 to 9
  CHECK(replaced(40, 39) == close_to(3.5));  // of 31 to 39
  CHECK(replaced(18, 0) == close_to(0.5));
  CHECK(replaced(17, 0) == close_to(0.3));  // of 0 to 4
  CHECK(replaced(17, 1) == close_to(0.3));
  CHECK(replaced(17, 3) == close_to(0.4));
  CHECK(replaced(17, 16) == close_to(1.4));
}

TEST_CASE("two readings that are off alike are outliers, three are something that lasts") {
  CHECK(marked_of(40, {{10, 20}, {11, 20}}) == Marks{10, 11});
  CHECK(marked_of(40, {{10, 20}, {11, 20}, {12, 20}}).empty());
  CHECK(marked_of(40, {{10, -20}, {11, -20}, {12, -20}, {13, -20}}).empty());
  CHECK(marked_of(40, {{10, 20}, {11, -20}, {12, 20}}) == Marks{10, 11, 12});
  CHECK(marked_of(40, {{10, 20}, {11, 20}, {12, -20}, {13, -20}}) == Marks{10, 11, 12, 13});
  // what is off by less than an outlier, to the same side, is no third
  CHECK(marked_of(40, {{9, 1}, {10, 20}, {11, 20}, {12, 1}}) == Marks{10, 11});
  CHECK(marked_of(40, {{10, 20}, {12, 20}, {14, 20}}) == Marks{10, 12, 14});
  // the end of one channel and the beginning of the next are no neighbours
  CHECK(marked_of(40, {{38, 20}, {39, 20}, {40, 20}}) == Marks{38, 39, 40});
  CHECK(marked_of(40, {{37, 20}, {38, 20}, {39, 20}}).empty());
}

TEST_CASE("what is no farther off its neighbours than an outlier is leads on") {
  CHECK(marked_of(40, {{20, 6}}) == Marks{20});
  CHECK(marked_of(40, {{19, 3}, {20, 6}, {21, 3}}).empty());
  CHECK(marked_of(40, {{19, 3}, {20, 7}, {21, 3}}) == Marks{20});
  CHECK(marked_of(40, {{19, -3}, {20, -6}, {21, -3}}).empty());
  CHECK(marked_of(40, {{19, -3}, {20, -7}, {21, -3}}) == Marks{20});
  CHECK(marked_of(40, {{19, 3}, {20, 6}}).empty());
  CHECK(marked_of(40, {{20, 6}, {21, 3}}).empty());
  CHECK(marked_of(40, {{19, -3}, {20, 6}, {21, 3}}).empty());
  // of two in a row each is asked by itself
  CHECK(marked_of(40, {{19, 3}, {20, 6}, {21, 6}, {22, 3}}).empty());
  CHECK(marked_of(40, {{19, 3}, {20, 6}, {21, 7}, {22, 3}}) == Marks{21});
  // one after the other
  CHECK(marked_of(40, {{19, 3}, {20, 6}, {21, 3}, {22, 6}, {23, 3}}).empty());
}

TEST_CASE("the first and the last reading of a channel lead nowhere") {
  CHECK(marked_of(40, {{0, 10}}) == Marks{0});
  CHECK(marked_of(40, {{0, 10}, {1, 10}}) == Marks{0, 1});
  CHECK(marked_of(40, {{0, 3}, {1, 6}, {2, 3}}).empty());
  CHECK(marked_of(40, {{37, 3}, {38, 6}, {39, 3}}).empty());
  CHECK(marked_of(40, {{38, 10}, {39, 10}}) == Marks{38, 39});
  // though the next channel begins as high as this one ends
  CHECK(marked_of(40, {{38, 10}, {39, 10}, {40, 10}, {41, 10}, {42, 10}}) == Marks{38, 39});
  CHECK(marked_of(40, {{40, 3}, {41, 6}, {42, 3}}).empty());
  CHECK(marked_of(40, {{77, 3}, {78, 6}, {79, 3}}).empty());
}

TEST_CASE("a channel of fewer than thirty differences scatters with the other one of its sensor") {
  // Fx alternates by four, a median of 4 / 0.6745 / sqrt(2) = 4.2 sigma of noise; with as many differences of
  // Fy, that are nothing, by two: 2.1. Five of either are 21 and 10.5.
  for (const std::size_t count : {20U, 30U, 31U}) {
    CAPTURE(count);
    Places values;
    for (std::size_t i = 0; i < count; ++i) values[i] = i % 2 == 0 ? 2 : -2;
    values[8] += 15;
    CHECK(marked_of(count, values) == (count < 31 ? Marks{8} : Marks{}));
  }
}

TEST_CASE("where more than 1.5 % are far out and three at least, three deviations are far") {
  const auto with_gross = [](std::size_t count, std::vector<std::size_t> gross) {
    Places values{{5, 2.5}};
    for (const std::size_t i : gross) values[i] = 30;
    return marked_of(count, values);
  };
  // 200 values: three are no more than 1.5 %
  CHECK(with_gross(100, {20, 40, 60}) == Marks{20, 40, 60});
  CHECK(with_gross(100, {20, 40, 60, 80}) == Marks{5, 20, 40, 60, 80});
  CHECK(with_gross(60, {20, 30, 50}) == Marks{5, 20, 30, 50});
  CHECK(with_gross(20, {10, 15}) == Marks{10, 15});
  // two deviations of two thirds are 2: less is none
  CHECK(marked_of(60, {{5, 1.9}, {20, 30}, {30, 30}, {50, 30}}) == Marks{20, 30, 50});
}

TEST_CASE("where many are far out, three of them stand together by chance") {
  // Of 200 values six are 3 %, 1.5 % to one side: three in a row are expected 2 * 200 * 0.015^3 = 1.4e-3
  // times, four 2e-5 times, and 1e-3 is no chance. Of five three are expected 8e-4 times.
  const Places rare{{40, -30}, {50, 30}, {60, -30}, {70, 30}, {80, -30}, {90, 30}};
  Places three = rare, four = rare;
  for (const std::size_t i : {20U, 21U, 22U}) three[i] = four[i] = 30;
  four[23] = 30;
  CHECK(marked_of(100, three) == Marks{20, 21, 22, 40, 50, 60, 70, 80, 90});
  CHECK(marked_of(100, four) == Marks{40, 50, 60, 70, 80, 90});
  three.erase(40);
  CHECK(marked_of(100, three) == Marks{50, 60, 70, 80, 90});
}

TEST_CASE("where many are far out the noise is what is left without them") {
  // every twelfth of 60 values: 10 of 59 differences are large, the others 1.6 or nothing
  Places values;
  for (std::size_t i = 0; i < 60; ++i) values[i] = i % 2 == 0 ? 0.8 : -0.8;
  for (const std::size_t i : {6U, 18U, 30U, 42U, 54U}) values[i] += 30;
  // 1.6 / 0.6745 / sqrt(2) = 1.68: three of these are 5.03. The others of a reading stand 1.6 off at most.
  values[12] += 5.3;
  CHECK(marked_of(60, values) == Marks{6, 12, 18, 30, 42, 54});
  values[12] -= 2;
  CHECK(marked_of(60, values) == Marks{6, 18, 30, 42, 54});
}

TEST_CASE("the steps of coarse readings scatter by a step over the root of twelve") {
  Experiment experiment = blank_experiment({40});
  for (std::size_t i = 0; i < 40; ++i) experiment.runs[0].readings[i].Fx = 4 * static_cast<double>(i / 8);
  const Measurements measurements(experiment);
  std::vector<double> residual(80, 0.0);
  for (const double off : {5.7, 5.8}) {  // 5 * 4 / sqrt(12) = 5.774
    residual[20] = off;
    CHECK(outliers(measurements, residual)[20] == (off > 5.774));
    residual[20] = 0;
  }
  residual[60] = 3.4;  // Fy, which is not coarse
  CHECK(outliers(measurements, residual)[60]);
}

TEST_CASE("positions say nothing of how forces scatter") {
  Experiment experiment = blank_experiment({20, 60});
  experiment.runs[1].control = Control::force;
  experiment.noise.x = experiment.noise.y = 1;
  std::vector<double> residual(160, 0.0);
  for (std::size_t i = 0; i < 40; ++i) residual[i] = i % 2 == 0 ? 2 : -2;
  residual[8] += 15;  // within five of 4 / 0.6745 / sqrt(2)
  for (const bool marked : outliers(Measurements(experiment), residual)) CHECK_FALSE(marked);
}

namespace {

/// A bench that measures a force in both directions and two angles, in two runs.
Experiment four_sensors() {
  Experiment experiment = blank_experiment({40, 30});
  experiment.noise.q = 1;
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.q = {0, 0};
  return experiment;
}

std::size_t marked_among(const std::vector<bool>& marked) {
  return static_cast<std::size_t>(std::count(marked.begin(), marked.end(), true));
}

}  // namespace

TEST_CASE("what is missed in all sensors, this way and that, for some readings, gathers") {
  // A cog that the model lacks: in each of five readings every sensor is off by 8 to 60 sigmas.
  const Measurements measurements(four_sensors());
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> size(8, 60), side(-1, 1);
  std::size_t marked = 0, missed = 0;
  for (int draw = 0; draw < 200; ++draw) {
    std::vector<double> residual = correlated_noise(measurements, 1, 0, random);
    const std::size_t begin = 5 + static_cast<std::size_t>(draw) % 25;
    for (const Series& series : measurements.series())
      for (std::size_t i = begin; series.run == 0 && i < begin + 5; ++i)
        residual[series.first + i] += std::copysign(size(random), side(random));
    const std::vector<bool> marks = outliers(measurements, residual);
    marked += marked_among(marks), missed += marked_among(gathered(measurements, marks));
  }
  CHECK(marked > 200 * 12);
  // What normal noise has beyond three sigmas is marked too where so many are far out: 0.27 % of 280.
  CHECK(static_cast<double>(marked - missed) < 0.01 * 200 * 20 + 0.0027 * 280 * 200);
}

TEST_CASE(
    "wild readings stay outliers, however they fall, and so does a reading that is wild in all sensors") {
  const Measurements measurements(four_sensors());
  std::mt19937_64 random(4);
  std::size_t wild = 0, found = 0;
  for (int draw = 0; draw < 300; ++draw) {
    std::vector<double> residual = correlated_noise(measurements, 1, 0, random);
    const std::vector<double> before = residual;
    add_outliers(residual, draw % 2 == 0 ? 0.02 : 0.08, 15, random);
    const std::vector<bool> marked = outliers(measurements, residual),
                            together = gathered(measurements, marked);
    for (std::size_t i = 0; i < residual.size(); ++i)
      if (residual[i] != before[i]) ++wild, found += marked[i] && !together[i];
  }
  // Of 300 x 70 places one in a thousand draws has one taken back by chance; three alike in a row are as
  // before.
  CHECK(static_cast<double>(found) > 0.99 * static_cast<double>(wild));
  std::vector<double> residual = correlated_noise(measurements, 1, 0, random);
  for (const Series& series : measurements.series())
    if (series.run == 0) residual[series.first + 20] += 20, residual[series.first + 21] -= 20;
  const std::vector<bool> marked = outliers(measurements, residual);
  CHECK(marked_among(marked) >= 8);
  CHECK(marked_among(gathered(measurements, marked)) == 0);
}
