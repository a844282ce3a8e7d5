#include "diagnose/noise/estimate_noise.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "diagnose/noise/term.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A bench of which only the layout matters: residuals are made up.
Experiment long_bench() {
  Experiment experiment = test::three_links();
  for (int run = 0; run < 4; ++run)
    test::press(experiment, {0.3, -0.5, 0.4}, {-0.01 * (run + 3), 0}, 40, true);
  return experiment;
}

/// The same bench, its readings counted.
Experiment untimed(Experiment experiment) {
  for (Run& run : experiment.runs)
    for (std::size_t r = 0; r < run.readings.size(); ++r) run.readings[r].t = static_cast<double>(r);
  return experiment;
}

struct Made {
  Study study;
  CommandStates states{study.experiment()};
  VectorXd nominal = VectorXd::Zero(static_cast<Eigen::Index>(study.measurements().size()));

  explicit Made(unsigned seed, Experiment experiment = long_bench()) : study(std::move(experiment)) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    for (double& one : nominal) one = normal(engine);
  }
  [[nodiscard]] NoiseShape estimated() const {
    return estimate_noise(study.experiment(), study.measurements(), states, nominal, nominal,
                          NoiseShape(study.measurements()), Departures::sought);
  }
  [[nodiscard]] NoiseEstimate decomposed() const {
    return Likelihood(study.measurements(), states, full_model(), estimated(), nominal)
        .decompose(nominal)
        .noise;
  }
};

}  // namespace

TEST_CASE("white noise of the declared size is even, and its scale one") {
  const Made made(1);
  const NoiseShape shape = made.estimated();
  CHECK_FALSE(shape.has_outliers());
  CHECK(shape.noisier.empty());
  CHECK(shape.interference.empty());
  CHECK(shape.proportional.empty());
  for (const ChannelNoise& one : made.decomposed().channels) {
    // 324 values: the standard deviation of their scale is 1 / sqrt(2 * 324) = 0.04, and the prior pulls to
    // one.
    CHECK(std::abs(std::log(one.scale)) < 0.16);
    CHECK(one.correlation < 0.2);
  }
}

TEST_CASE("readings without a clock have no correlation, and that of the prior changes nothing") {
  const Made made(9, untimed(long_bench()));
  REQUIRE_FALSE(made.study.measurements().has_clock(0));
  for (const ChannelNoise& one : made.decomposed().channels) CHECK(one.correlation == 0);
  Hyperpriors uncorrelated = full_model();
  uncorrelated.correlation = {0}, uncorrelated.log_correlation = {0};
  const NoiseShape shape(made.study.measurements());
  const auto likelihood = [&](const Hyperpriors& priors) {
    return Likelihood(made.study.measurements(), made.states, priors, shape, made.nominal)
        .look(made.nominal)
        .log_likelihood;
  };
  CHECK(likelihood(full_model()) == close_to(likelihood(uncorrelated)));
}

TEST_CASE("noise times a factor is estimated to be so many times the declared noise") {
  Made made(2);
  made.nominal *= 5;
  for (const ChannelNoise& one : made.decomposed().channels) CHECK(std::abs(std::log(one.scale / 5)) < 0.2);
}

TEST_CASE("readings far off are outliers, those and no others") {
  Made made(3);
  const std::vector<Eigen::Index> off{17, 130, 222};
  for (const Eigen::Index i : off) made.nominal(i) += i % 2 ? 40 : -40;
  const NoiseShape shape = made.estimated();
  for (std::size_t i = 0; i < shape.outlier.size(); ++i)
    CHECK(shape.outlier[i] == (std::find(off.begin(), off.end(), static_cast<Eigen::Index>(i)) != off.end()));
}

TEST_CASE("a run of four times the noise of the others is found to be noisier") {
  Made made(4);
  for (const Series& series : made.study.measurements().series())
    if (series.run == 2 && series.channel.sensor() == Sensor::force)
      made.nominal.segment(static_cast<Eigen::Index>(series.first),
                           static_cast<Eigen::Index>(series.readings.size())) *= 4;
  const NoiseShape shape = made.estimated();
  REQUIRE(shape.noisier.size() == 1);
  CHECK(shape.noisier.front().run == 2);
  CHECK(shape.noisier.front().whole_run);
  CHECK(std::abs(std::log(shape.noisier.front().factor / 4)) < 0.3);
}

TEST_CASE("a sinusoid of three sigma is interference of its period, and no outliers") {
  Made made(5);
  constexpr double period = 7.3;
  for (const Series& series : made.study.measurements().series())
    if (series.run == 1 && series.channel.sensor() == Sensor::force)
      for (std::size_t i = 0; i < series.readings.size(); ++i)
        made.nominal(static_cast<Eigen::Index>(series.first + i)) +=
            3 * std::sin(2 * std::numbers::pi * static_cast<double>(i) / period + 0.4);
  const NoiseShape shape = made.estimated();
  // One frequency in all readings of the sensor, with an amplitude in each run.
  const auto size = [](const Interference& one) {
    double most = 0;
    for (const auto& [channel, rms] : one.rms) most = std::max(most, rms);
    return most;
  };
  const auto largest =
      std::max_element(shape.interference.begin(), shape.interference.end(),
                       [&](const Interference& a, const Interference& b) { return size(a) < size(b); });
  REQUIRE(largest != shape.interference.end());
  CHECK(largest->run == 1);
  CHECK(largest->sensor == Sensor::force);
  // The frequency of 81 readings at this ratio to the noise is known to about 0.1 / 81 a reading.
  CHECK(std::abs(1 / largest->period - 1 / period) < 0.005);
  for (const Series& series : made.study.measurements().series())
    if (series.run == 1 && series.channel.sensor() == Sensor::force)
      for (std::size_t i = 0; i < series.readings.size(); ++i) CHECK_FALSE(shape.outlier[series.first + i]);
}

TEST_CASE("innovations of an autoregression are white") {
  std::mt19937 engine(6);
  std::normal_distribution<double> normal;
  constexpr double rho = 0.7, scale = 3;
  VectorXd values(4000);
  double state = normal(engine);
  for (double& one : values) {
    one = scale * state;
    state = rho * state + std::sqrt(1 - rho * rho) * normal(engine);
  }
  const VectorXd white = innovations(values, scale, rho);
  const double variance = white.squaredNorm() / 4000;
  const double lagged = white.head(3999).dot(white.tail(3999)) / 3999;
  // Standard deviations sqrt(2 / 4000) and 1 / sqrt(4000); four of them.
  CHECK(std::abs(variance - 1) < 4 * std::sqrt(2.0 / 4000));
  CHECK(std::abs(lagged) < 4 / std::sqrt(4000.0));
}

TEST_CASE("columns are whitened as innovations are, across readings that are missing") {
  const Study study(long_bench());
  NoiseEstimate noise{{}, NoiseShape(study.measurements())};
  for (const Block& block : study.measurements().blocks())
    noise.channels.push_back({block.channel, 2, 0.5, 1});
  VectorXd ones = VectorXd::Ones(static_cast<Eigen::Index>(study.measurements().size()));
  const Series& first = study.measurements().series().front();
  const MatrixXd whole = noise.whitened(study.measurements(), ones);
  const VectorXd by_hand =
      innovations(VectorXd::Ones(static_cast<Eigen::Index>(first.readings.size())), 2, 0.5);
  CHECK((whole.col(0).head(by_hand.size()) - by_hand).norm() < 1e-12);
  // A gap of one reading: the correlation across it is 0.5 squared.
  noise.shape.outlier[3] = true;
  const MatrixXd gapped = noise.whitened(study.measurements(), ones);
  CHECK(gapped(3, 0) == 0);
  CHECK(gapped(4, 0) == close_to((1 - 0.25) / (2 * std::sqrt(1 - 0.0625))).epsilon(1e-12));
}
