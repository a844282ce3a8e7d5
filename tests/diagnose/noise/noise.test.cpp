#include "diagnose/noise/noise.hpp"
#include "diagnose/noise/outliers.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

TEST_CASE("scale and correlation of noise are found again, with outliers among the readings") {
  const Experiment experiment = blank_experiment({60, 90, 80});
  const Measurements measurements(experiment);
  std::mt19937_64 random(1);
  for (const double scale : {0.75, 1.0, 1.4}) {
    for (const double correlation : {0.0, 0.4}) {
      double mean_scale = 0, mean_correlation = 0;
      constexpr int draws = 50;
      for (int draw = 0; draw < draws; ++draw) {
        std::vector<double> noise = correlated_noise(measurements, scale, correlation, random);
        add_outliers(noise, 0.015, 12, random);
        const NoiseModel found = estimate_noise(measurements, without_outliers(measurements, noise));
        mean_scale += found.of({Channel::Name::Fx, 0}) / draws;
        mean_correlation += found.correlation[at_force] / draws;
      }
      // 460 values: each estimate spreads by about 5 %; the priors pull by a few percent more.
      CHECK(mean_scale == close_to(scale).epsilon(0.06));
      CHECK(std::abs(mean_correlation - correlation) < 0.06);
    }
  }
}

TEST_CASE("a slow gap ten sigmas high does not pass for noise") {
  const Experiment experiment = blank_experiment({80, 100});
  const Measurements measurements(experiment);
  std::mt19937_64 random(2);
  std::vector<double> residual = correlated_noise(measurements, 1.0, 0.0, random);
  for (const Series& series : measurements.series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      residual[series.first + i] +=
          10 * std::sin(3.0 * static_cast<double>(i) / static_cast<double>(series.readings.size()));
  CHECK(estimate_noise(measurements, residual).of({Channel::Name::Fx, 0}) < 1.15);
}

TEST_CASE("an outlier is marked, the readings beside it and a step are not") {
  const Experiment experiment = blank_experiment({20});
  const Measurements measurements(experiment);
  std::vector<double> residual(measurements.size());
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] = (i % 2 == 0 ? 0.5 : -0.5) + (i % 20 > 12 ? 30 : 0);
  residual[6] += 12;
  const std::vector<bool> marked = outliers(measurements, residual);
  for (std::size_t i = 0; i < marked.size(); ++i) CHECK(marked[i] == (i == 6));
}

TEST_CASE(
    "the turn of a curve is no outlier, a reading that stands off both its neighbours is one there too") {
  const Experiment experiment = blank_experiment({40});
  const Measurements measurements(experiment);
  std::mt19937_64 random(8);
  std::vector<double> residual = correlated_noise(measurements, 0.3, 0, random);
  // a cusp that rises by four sigmas a reading: its tip stands ten off the median of nine
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] += std::max(0.0, 24 - 4 * std::abs(static_cast<double>(i % 40) - 20));
  for (const bool marked : outliers(measurements, residual)) CHECK_FALSE(marked);
  residual[17] += 15;
  const std::vector<bool> marked = outliers(measurements, residual);
  CHECK(marked[17]);
  CHECK(std::count(marked.begin(), marked.end(), true) == 1);
}

TEST_CASE("what a model leaves of smooth readings is no noise, however rough it is") {
  Experiment experiment = blank_experiment({60, 80});
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  const double sigma = experiment.noise.Fx;
  for (Run& run : experiment.runs) {
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      const double way = static_cast<double>(i) / static_cast<double>(run.readings.size());
      run.readings[i].Fx = sigma * (200 * std::sin(3 * way) + normal(random));
      run.readings[i].Fy = sigma * (90 * way * way + normal(random));
    }
  }
  const Measurements measurements(experiment);
  for (const double size : {1.0, 20.0}) {
    const std::vector<double> left = correlated_noise(measurements, size, 0, random);
    // Of noise itself the bound, three times what third differences show, is no bound. The median of some 60
    // third differences, of which a third are independent, is known to 0.28 of itself.
    const double scale = estimate_noise(measurements, left).of({Channel::Name::Fx, 0});
    CHECK(scale > 0.9);
    CHECK(scale < (size > 1 ? 3 * (1 + 3 * 0.28) : 1.1));
  }
}

TEST_CASE("innovations of correlated noise are white") {
  const Experiment experiment = blank_experiment({4000});
  const Measurements measurements(experiment);
  std::mt19937_64 random(3);
  NoiseModel noise;
  noise.scale.fill(1.3);
  noise.correlation.fill(0.5);
  const std::vector<double> white =
      whiten(measurements, correlated_noise(measurements, 1.3, 0.5, random), noise);
  double variance = 0, neighbour = 0;
  for (std::size_t i = 1; i < white.size(); ++i) {
    variance += white[i] * white[i] / static_cast<double>(white.size());
    neighbour += white[i] * white[i - 1] / static_cast<double>(white.size());
  }
  CHECK(variance == close_to(1).epsilon(0.05));  // three deviations of sqrt(2 / 8000)
  CHECK(std::abs(neighbour) < 0.035);
}

TEST_CASE("the scale of a hundred thousand normal numbers is found to a third of a percent") {
  const Experiment experiment = blank_experiment({100000});
  const Measurements measurements(experiment);
  std::mt19937_64 random(5);
  // A variance from m differences of neighbours spreads by sqrt(3/m), a scale by half of that: 0.2 % of 2e5.
  const RawNoise found = raw_noise(measurements, correlated_noise(measurements, 1.2, 0.0, random));
  CHECK(found.scale[2] == close_to(1.2).epsilon(0.006));
}

TEST_CASE("innovations of a short series give its exact Gaussian density: r' C^-1 r, C_ij = s^2 phi^|i-j|") {
  const Experiment experiment = blank_experiment({6});
  const Measurements measurements(experiment);
  NoiseModel noise;
  noise.scale = {9, 9, 1.3, 1.3, 9};
  noise.correlation.fill(0.6);
  Eigen::MatrixXd covariance(6, 6);
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j < 6; ++j)
      covariance(i, j) = 1.3 * 1.3 * std::pow(0.6, static_cast<double>(std::abs(i - j)));
  // large at the beginning, where a first value taken for an innovation would show
  const Eigen::VectorXd r{{3.0, -1.0, 0.5, 2.0, 0.0, -0.7}};
  std::vector<double> residual(12, 0.0);
  for (std::size_t i = 0; i < 6; ++i) residual[i] = r(static_cast<Eigen::Index>(i));
  double sum = 0;
  for (const double z : whiten(measurements, residual, noise)) sum += z * z;
  CHECK(sum == close_to(r.dot(covariance.ldlt().solve(r))));
}

TEST_CASE("nothing within five of the least sigma that a lab may mean is an outlier") {
  const Experiment experiment = blank_experiment({20});
  const Measurements measurements(experiment);
  std::vector<double> residual(measurements.size());
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = i % 2 == 0 ? 1e-3 : -1e-3;
  residual[7] = 3;  // the bound is 5 / 1.5
  for (const bool marked : outliers(measurements, residual)) CHECK_FALSE(marked);
  residual[7] = 4;
  CHECK(outliers(measurements, residual)[7]);
}

TEST_CASE("four readings have no outlier: a neighbourhood is five") {
  const Measurements four(blank_experiment({4})), five(blank_experiment({5}));
  std::vector<double> residual(8, 0.0);
  residual[1] = 30;
  CHECK_FALSE(outliers(four, residual)[1]);
  residual.resize(10);
  CHECK(outliers(five, residual)[1]);
}
