#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/noise.hpp"
#include "diagnose/noise/noise_steps.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

constexpr std::size_t at_Fx = static_cast<std::size_t>(Channel::Name::Fx);
constexpr std::size_t at_Fy = static_cast<std::size_t>(Channel::Name::Fy);

/// E min(z^2, 2.5^2) of a normal z: 1 - 2 (2.5 phi(2.5) + (1 - 2.5^2) (1 - Phi(2.5))), by which a variance of
/// cut squares is corrected.
const double cut_mean = 1 - 2 * (2.5 * std::exp(-3.125) / std::sqrt(2 * std::numbers::pi) -
                                 5.25 * std::erfc(2.5 / std::sqrt(2.0)) / 2);

/// A wave of this amplitude in Fx, of so many degrees a reading; nothing in Fy. Nothing of it is cut: no
/// value of a wave is above 2.5 of its deviations.
std::vector<double> wave(std::size_t count, double amplitude, double degrees) {
  std::vector<double> residual(2 * count, 0.0);
  for (std::size_t i = 0; i < count; ++i)
    residual[i] = amplitude * std::sin(degrees * std::numbers::pi / 180 * static_cast<double>(i) + 0.3);
  return residual;
}

/// Variance of some numbers about zero where no square is cut.
double uncut(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return sum / static_cast<double>(values.size()) / cut_mean;
}

std::vector<double> steps_apart(const std::vector<double>& residual, std::size_t count, std::size_t lag) {
  std::vector<double> steps;
  for (std::size_t i = lag; i < count; ++i) steps.push_back(residual[i] - residual[i - lag]);
  return steps;
}

/// What estimate_noise() makes of a scale that `differences` differences show, by the priors: the logarithm
/// of a scale is known to 1 / differences, half as many values in it being independent.
/// \param enough  they
/// are, whatever they say
double believed(double scale, double differences, bool enough = true) {
  const double values = differences / 2;
  const double spread =
      enough ? std::max(beliefs::scale_spread, std::abs(std::log(scale))) : beliefs::scale_spread;
  return std::pow(scale, values / (values + 1 / (spread * spread)));
}

}  // namespace

TEST_CASE("readings that alternate scatter by half their step, and correlate as little as can be") {
  const Measurements measurements(blank_experiment({12}));
  std::vector<double> residual(24, 0.0);
  for (std::size_t i = 0; i < 12; ++i) residual[i] = i % 2 == 0 ? 0.7 : -0.7;
  const RawNoise found = raw_noise(measurements, residual);
  // every difference is 1.4, and none is cut; over two readings there is none: 1 + phi = 0
  CHECK(found.scale[at_Fx] == close_to(1.4 / std::sqrt(2 * cut_mean)));
  CHECK(found.correlation[at_force] == -1);
  CHECK(found.values[at_Fx] == 11);
  CHECK(found.values[at_Fy] == 11);
  CHECK(found.scale[at_Fy] == 1);
  CHECK(found.values[static_cast<std::size_t>(Channel::Name::q)] == 0);
}

TEST_CASE("one step in a hundred that is far too large counts by 2.5 deviations") {
  const Measurements measurements(blank_experiment({101}));
  std::vector<double> residual(202, 0.0);
  for (std::size_t i = 0; i < 101; ++i) residual[i] = (i % 2 == 0 ? 0.5 : -0.5) + (i > 50 ? 40 : 0);
  // 99 squares are one, the one of 39 or 41 is 6.25 v: 100 c v = 99 + 6.25 v. Iterated to a millionth.
  const double variance = 99 / (100 * cut_mean - 6.25);
  CHECK(raw_noise(measurements, residual).scale[at_Fx] == close_to(std::sqrt(variance / 2)).epsilon(2e-6));
}

TEST_CASE("correlation and scale of a wave are those of its differences") {
  constexpr std::size_t count = 40;
  const Measurements measurements(blank_experiment({count}));
  // over two readings a wave differs by 4 cos^2(54 degrees) = 1.38 times what it does over one, in squares
  const std::vector<double> residual = wave(count, 1.1, 108);
  const double near = uncut(steps_apart(residual, count, 1)), far = uncut(steps_apart(residual, count, 2));
  const RawNoise found = raw_noise(measurements, residual);
  const double phi = far / near - 1;
  CHECK(std::abs(phi - 0.38) < 0.05);
  CHECK(found.correlation[at_force] == close_to(phi));
  CHECK(found.scale[at_Fx] == close_to(std::sqrt(near / 2 / (1 - phi))));
  SUBCASE("the scale is believed as far as there are values, a correlation as far as it is not rare") {
    const NoiseModel noise = estimate_noise(measurements, residual);
    const double weight = 78 / (78 + 1 / (beliefs::correlation_spread * beliefs::correlation_spread));
    CHECK(noise.correlation[at_force] == close_to(weight * phi));
    CHECK(noise.of({Channel::Name::Fx, 0}) ==
          close_to(believed(std::sqrt(near / 2 / (1 - weight * phi)), 39)));
  }
}

TEST_CASE("two channels weigh together by their numbers of differences") {
  Experiment experiment = blank_experiment({40});
  for (std::size_t i = 20; i < 40; ++i) experiment.runs[0].readings[i].Fy = std::nan("");
  const Measurements measurements(experiment);
  std::vector<double> residual = wave(40, 1, 108);
  residual.resize(60);
  const std::vector<double> other = wave(20, 1, 112);
  std::copy(other.begin(), other.begin() + 20, residual.begin() + 40);
  const double first = uncut(steps_apart(residual, 40, 2)) / uncut(steps_apart(residual, 40, 1)),
               second = uncut(steps_apart(other, 20, 2)) / uncut(steps_apart(other, 20, 1));
  CHECK(raw_noise(measurements, residual).correlation[at_force] ==
        close_to((39 * first + 19 * second) / 58 - 1));
}

TEST_CASE("differences that grow as those of a slope show no correlation, and second differences the scale") {
  constexpr std::size_t count = 400;
  const Measurements measurements(blank_experiment({count}));
  const std::vector<double> residual = wave(count, 3, 20);
  std::vector<double> curved;
  for (std::size_t i = 1; i + 1 < count; ++i)
    curved.push_back(residual[i - 1] - 2 * residual[i] + residual[i + 1]);
  const RawNoise found = raw_noise(measurements, residual);
  CHECK(found.correlation[at_force] == 0);
  CHECK(found.scale[at_Fx] == close_to(std::sqrt(uncut(curved) / 6)));  // 1 - 4 + 6 - ...: 1 + 4 + 1
  SUBCASE("a channel beside it that has none of the slope gives the correlation, and both scales follow it") {
    std::vector<double> both = residual;
    const std::vector<double> beside = wave(count, 1, 108);
    std::copy(beside.begin(), beside.begin() + count, both.begin() + count);
    const double near = uncut(steps_apart(beside, count, 1));
    const double phi = uncut(steps_apart(beside, count, 2)) / near - 1;
    const RawNoise pair = raw_noise(measurements, both);
    CHECK(pair.correlation[at_force] == close_to(phi));
    CHECK(pair.scale[at_Fx] == close_to(std::sqrt(uncut(curved) / 2 / ((1 - phi) * (3 - phi)))));
    CHECK(pair.scale[at_Fy] == close_to(std::sqrt(near / 2 / (1 - phi))));
  }
}

TEST_CASE("a slope counts as one beyond what chance gives one time in twenty alone, and as 1 before") {
  // over two readings 4 cos^2(40 degrees) = 2.35 times as much: among 39 differences 2 + 0.58 are chance,
  // among 399 2 + 0.18
  for (const std::size_t count : {40U, 400U}) {
    const Measurements measurements(blank_experiment({count}));
    const RawNoise found = raw_noise(measurements, wave(count, 1, 80));
    CHECK(found.correlation[at_force] == (count == 40 ? 1 : 0));
  }
  // over two readings 4 cos^2(42.25 degrees) = 2.19 times as much, and second differences of
  // 4 sin^2(42.25 degrees) = 1.81 times those over one: 1.81 / 3 of its variance
  const Measurements measurements(blank_experiment({400}));
  const std::vector<double> residual = wave(400, 1, 84.5);
  std::vector<double> curved;
  for (std::size_t i = 1; i + 1 < 400; ++i)
    curved.push_back(residual[i - 1] - 2 * residual[i] + residual[i + 1]);
  const RawNoise found = raw_noise(measurements, residual);
  CHECK(found.correlation[at_force] == 0);
  CHECK(found.scale[at_Fx] == close_to(std::sqrt(uncut(curved) / 6)));
  CHECK(correlation_deviation(0.5, 36) == close_to(0.3));
}

TEST_CASE("rounding, which does not correlate, hides neither correlation nor scale of noise that does") {
  // A correlation of 0.85 rounded to half a sigma: without its rounding it would be taken for 0.74.
  constexpr std::size_t count = 40000;
  Experiment experiment = blank_experiment({count});
  std::mt19937_64 random(33);
  std::vector<double> residual = correlated_noise(Measurements(experiment), 1, 0.85, random);
  for (double& value : residual) value = 0.5 * std::round(value / 0.5);
  for (std::size_t i = 0; i < count; ++i) {
    experiment.runs[0].readings[i].Fx = residual[i];
    experiment.runs[0].readings[i].Fy = residual[count + i];
  }
  const RawNoise found = raw_noise(Measurements(experiment), residual);
  // three of the deviations of 80,000 values
  CHECK(std::abs(found.correlation[at_force] - 0.85) < 3 * correlation_deviation(0.85, 2.0 * count));
  // s^2 = d / (1 - phi): that of phi, and the 0.5 % of the variance of d that so many differences leave open
  const double off = std::hypot(correlation_deviation(0.85, 2.0 * count) / 0.15, 0.005);
  CHECK(std::abs(std::log(std::pow(found.scale[at_Fx], 2))) < 3 * off);
}

TEST_CASE("noise beyond what was declared remembers no longer than a tenth of a run of middle length") {
  const auto largest = [](const std::vector<std::size_t>& runs) {
    const Measurements measurements(blank_experiment(runs));
    std::vector<double> rough(measurements.size());
    for (std::size_t i = 0; i < rough.size(); ++i) rough[i] = i % 2 == 0 ? 2 : -2;
    return raw_noise(measurements, rough).largest_correlation[at_force];
  };
  CHECK(largest({20}) == close_to(std::exp(-0.5)));
  CHECK(largest({10, 50, 20}) == close_to(std::exp(-0.5)));
  CHECK(largest({4000}) == 0.9);
}

TEST_CASE(
    "noise no larger than declared remembers as long as makes it that large, beyond that a tenth of a run") {
  // A run of twelve readings that rise and fall by pairs: 1 + phi = 2 - 1/6.
  const Measurements measurements(blank_experiment({12}));
  const auto found = [&](double size) {
    std::vector<double> residual(24, 0.0);
    for (std::size_t i = 0; i < 12; ++i) residual[i] = i % 4 == 0 || i % 4 == 3 ? size : -size;
    return raw_noise(measurements, residual);
  };
  const double near = 6.0 / 11 / cut_mean / 2;  // of six steps of one
  CHECK(found(0.5).correlation[at_force] == close_to(5.0 / 6));
  CHECK(found(0.5).largest_correlation[at_force] == close_to(1 - near));
  CHECK(found(0.5).scale[at_Fx] == close_to(1));
  CHECK(found(5).correlation[at_force] == close_to(5.0 / 6));
  CHECK(found(5).largest_correlation[at_force] == close_to(std::exp(-10.0 / 12)));
  CHECK(found(5).scale[at_Fx] == close_to(std::sqrt(100 * near / (1 - std::exp(-10.0 / 12)))));
}

TEST_CASE("what is large and slow at once is no noise beyond one and a half") {
  SUBCASE("because its neighbours correlate by more than a half") {
    const Measurements measurements(blank_experiment({300}));
    const std::vector<double> residual = wave(300, 4, 95);  // 4 cos^2(47.5 degrees) = 1.826
    const NoiseModel noise = estimate_noise(measurements, residual);
    CHECK(noise.correlation[at_force] > 0.5);
    CHECK(noise.of({Channel::Name::Fx, 0}) == 1.5);
  }
  SUBCASE("or would, by more than 0.9, in a run too short to tell") {
    const Measurements measurements(blank_experiment({12}));
    const std::vector<double> residual = wave(12, 12, 80);
    const NoiseModel noise = estimate_noise(measurements, residual);
    CHECK(raw_noise(measurements, residual).correlation[at_force] > 0.9);
    CHECK(noise.correlation[at_force] < 0.5);
    CHECK(noise.of({Channel::Name::Fx, 0}) == 1.5);
  }
  SUBCASE("what is as large and does not last is noise") {
    const Measurements measurements(blank_experiment({300}));
    CHECK(estimate_noise(measurements, wave(300, 4, 112)).of({Channel::Name::Fx, 0}) > 2.5);
  }
}

TEST_CASE(
    "a dozen differences of a channel, or sixteen of its sensor, show a scale that nobody would believe, "
    "fewer "
    "are steps of a gap") {
  const auto shows = [](std::size_t count, bool both) {
    Experiment experiment = blank_experiment({count});
    if (!both)
      for (Reading& reading : experiment.runs[0].readings) reading.Fy = std::nan("");
    std::vector<double> residual(both ? 2 * count : count, 0.0);
    for (std::size_t i = 0; i < count; ++i) residual[i] = i % 2 == 0 ? 2.5 : -2.5;
    const double raw = 5 / std::sqrt(2 * cut_mean), differences = static_cast<double>(count) - 1;
    const double found = estimate_noise(Measurements(experiment), residual).of({Channel::Name::Fx, 0});
    const bool enough = found > 2;
    CHECK(found == close_to(believed(raw, differences, enough)));
    return enough;
  };
  CHECK_FALSE(shows(12, false));
  CHECK(shows(13, false));
  CHECK_FALSE(shows(8, true));
  CHECK(shows(9, true));
}

TEST_CASE(
    "no scale exceeds the rounding of coarse readings, or three times their roughness, or one if that is "
    "more") {
  Experiment experiment = blank_experiment({40});
  for (std::size_t i = 0; i < 40; ++i) {
    experiment.runs[0].readings[i].Fx = static_cast<double>(i / 8);  // steps of one sigma
    experiment.runs[0].readings[i].Fy = std::pow(-1.0, static_cast<double>(i)) + 1e-6 * std::sqrt(double(i));
  }
  std::vector<double> residual(80);
  for (std::size_t i = 0; i < 80; ++i) residual[i] = i % 2 == 0 ? 9 : -9;
  for (const double sigma : {1.0, 0.2, 20.0}) {
    experiment.noise.Fx = experiment.noise.Fy = sigma;
    const Measurements measurements(experiment);
    const NoiseModel noise = estimate_noise(measurements, residual);
    // Third differences of Fx: mostly none, so that its roughness is not known and only its noise limits it.
    CHECK(noise.of({Channel::Name::Fx, 0}) > 9);
    CHECK(noise.of({Channel::Name::q, 0}) == 1);  // of which there is no reading
    // Fy alternates by two: its third differences are 8, of noise so large sqrt(20) sigma.
    const double rough = measurements.series()[1].roughness;
    CHECK(rough == close_to(8 / std::sqrt(20.0) / 0.6745 / sigma));
    CHECK(noise.of({Channel::Name::Fy, 0}) ==
          close_to(std::min(std::max(1.0, 3 * rough), believed(18 / std::sqrt(2 * cut_mean), 39))));
  }
}

TEST_CASE("a position has noise as a force has") {
  Experiment experiment = blank_experiment({12});
  experiment.runs[0].control = Control::force;
  experiment.noise.x = experiment.noise.y = 1;
  const Measurements measurements(experiment);
  std::vector<double> residual(24, 0.0);
  for (std::size_t i = 0; i < 12; ++i) residual[i] = i % 2 == 0 ? 0.4 : -0.4;
  const double scale = 0.8 / std::sqrt(2 * cut_mean);
  CHECK(raw_noise(measurements, residual).scale.front() == close_to(scale));
  CHECK(estimate_noise(measurements, residual).scale.front() == close_to(believed(scale, 11)));
}

TEST_CASE("two readings say nothing of noise") {
  const Measurements measurements(blank_experiment({2}));
  const RawNoise found = raw_noise(measurements, {1, 2, 0, 0});
  CHECK(found.correlation[at_force] == 0);
  CHECK(found.scale[at_Fx] == 1);
  CHECK(found.values[at_Fx] == 1);
}
