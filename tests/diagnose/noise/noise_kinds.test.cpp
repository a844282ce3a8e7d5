// Each kind of departure from even noise, planted and found (noise/terms).

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "diagnose/noise/estimate_noise.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline::diagnose;

namespace {

Experiment long_bench() {
  Experiment experiment = test::three_links();
  for (int run = 0; run < 4; ++run)
    test::press(experiment, {0.3, -0.5, 0.4}, {-0.01 * (run + 3), 0}, 40, true);
  return test::measured(experiment, {}, {}, 21);
}

/// White noise on readings of the nominal chain, to be spoilt.
struct Spoilt {
  Study study;
  VectorXd residual = study.nominal_residual();

  explicit Spoilt(Experiment experiment = long_bench()) : study(std::move(experiment)) {}

  /// Calls `change(value, number)` for every reading of the force in a run.
  template <class Change>
  void forces_of(std::size_t run, Change change) {
    for (const Series& series : study.measurements().series())
      if (series.run == run && series.channel.sensor() == Sensor::force)
        for (std::size_t i = 0; i < series.readings.size(); ++i)
          change(residual(static_cast<Eigen::Index>(series.first + i)), i);
  }
  [[nodiscard]] NoiseShape shape() const {
    const CommandStates states(study.experiment());
    return estimate_noise(study.experiment(), study.measurements(), states, residual, residual,
                          NoiseShape(study.measurements()), Departures::sought);
  }
};

}  // namespace

TEST_CASE("noise that grows with the reading is found, with its ratio") {
  Spoilt bench;
  const Measurements& measurements = bench.study.measurements();
  double largest = 0;
  for (const Series& series : measurements.series())
    if (series.channel.name == Channel::Name::Fx)
      for (std::size_t i = 0; i < series.readings.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(series.first + i);
        largest = std::max(largest, std::abs(measurements.value()(row) / measurements.sigma()(row)));
      }
  const double ratio = 6 / largest;
  for (const Series& series : measurements.series())
    if (series.channel.name == Channel::Name::Fx)
      for (std::size_t i = 0; i < series.readings.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(series.first + i);
        bench.residual(row) *= std::hypot(1, ratio * measurements.value()(row) / measurements.sigma()(row));
      }
  const NoiseShape shape = bench.shape();
  REQUIRE(shape.proportional.contains(Channel::Name::Fx));
  // 324 values of which a third have most of their noise from it: its logarithm is known to 1 / sqrt(2 *
  // 100), and the grid has steps of a third.
  CHECK(std::abs(std::log(shape.proportional.at(Channel::Name::Fx) / ratio)) < 0.4);
  CHECK(shape.noisier.empty());
}

TEST_CASE("a segment of six times the noise is found, with its readings and its factor") {
  Spoilt bench;
  bench.forces_of(1, [](double& value, std::size_t i) { value *= i >= 20 && i < 50 ? 6 : 1; });
  const NoiseShape shape = bench.shape();
  REQUIRE(shape.noisier.size() == 1);
  const NoisierSegment& found = shape.noisier.front();
  CHECK(found.run == 1);
  CHECK_FALSE(found.whole_run);
  // A reading at its edge tells the segment from the rest where it is larger than two: nine in ten of six.
  CHECK(std::abs(static_cast<double>(found.from) - 20) <= 3);
  CHECK(std::abs(static_cast<double>(found.to) - 49) <= 3);
  CHECK(std::abs(std::log(found.factor / 6)) < 0.3);
}

TEST_CASE("readings of a coarse display that repeat share one rounding error, others are as they were") {
  Experiment experiment = long_bench();
  const double step = 4 * experiment.noise[Channel::Name::Fx];
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading[column_Fx] = step * std::round(reading[column_Fx] / step);
  const Spoilt bench(experiment);
  const NoiseShape shape = bench.shape();
  CHECK(shape.quantised);
  const Measurements& measurements = bench.study.measurements();
  for (const Series& series : measurements.series()) {
    if (series.channel.name != Channel::Name::Fx) continue;
    for (std::size_t i = 1; i + 1 < series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(series.first + i);
      const auto value = [&](Eigen::Index k) { return measurements.value()(k); };
      const bool repeats = value(row) == value(row - 1) || value(row) == value(row + 1);
      CHECK((shape.relative(row) > 1) == repeats);
    }
  }
}

TEST_CASE("a large slow sinusoid is seen as one of a moderate size is") {
  for (const double size : {2.0, 10.0}) {
    CAPTURE(size);
    constexpr double period = 9.3;
    Spoilt bench;
    bench.forces_of(1, [&](double& value, std::size_t i) {
      value += size * std::sin(2 * std::numbers::pi * static_cast<double>(i) / period + 0.4);
    });
    const NoiseShape shape = bench.shape();
    const auto found = std::find_if(shape.interference.begin(), shape.interference.end(),
                                    [](const Interference& one) { return one.run == 1; });
    REQUIRE(found != shape.interference.end());
    CHECK(found->sensor == Sensor::force);
    CHECK(std::abs(1 / found->period - 1 / period) < 0.005);
  }
}

TEST_CASE("each outlier is as probable as the others make it") {
  const Study study(long_bench());
  NoiseShape shape(study.measurements());
  shape.outlier[3] = true;
  const double one = shape.outliers().share;
  shape.outlier[70] = shape.outlier[71] = true;
  CHECK(shape.outliers().share > one);
  // A density: both parts together integrate to one.
  const OutlierModel model = shape.outliers();
  double sum = 0;
  constexpr double step = 0.05, far = 2e4;  // beyond it a Cauchy density of width 10 has 2 * 10 / (pi far)
  for (double z = -far; z < far; z += step) sum += step * std::exp(model.log_density(z));
  CHECK(std::abs(sum - 1) < 2 * 10 / (std::numbers::pi * far) + 1e-6);
}
