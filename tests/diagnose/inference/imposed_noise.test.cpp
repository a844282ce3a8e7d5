#include "diagnose/inference/imposed_noise.hpp"

#include <cmath>
#include <numbers>

#include "diagnose/inference/measurements.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

constexpr double length = 0.4, stiffness = 3, upright = std::numbers::pi / 2;

/// One link that stands upright, pushed along x at its end: k (q - q_0) = -F L sin q.
Experiment pushed_link() {
  Experiment experiment{{{length}, {stiffness}, {}, {0, 0}, {}, {}},
                        "one link",
                        {Bench::Plane::horizontal, {0, 0}, false},
                        {2e-4, 2e-4, 0, 0, 1e-3},
                        {}};
  Run run{"push", Control::force, {upright}, {}};
  for (int i = 0; i < 6; ++i) run.readings.push_back({1.0 * i, 0, length, 0.8 * i, 0, {upright}});
  run.imposed_noise.Fx = 0.05;
  experiment.runs = {run};
  return experiment;
}

/// Angle of the link by Newton's method on its one equation.
double angle_under(double force) {
  double q = upright;
  for (int i = 0; i < 30; ++i)
    q -= (stiffness * (q - upright) + force * length * std::sin(q)) /
         (stiffness + force * length * std::cos(q));
  return q;
}

}  // namespace

TEST_CASE(
    "noise of an imposed force reaches place and angle through the compliance of the link at each reading") {
  const Experiment experiment = pushed_link();
  const Measurements measurements(experiment);
  std::size_t compared = 0;
  for (const Series& series : measurements.series()) {
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const double force = experiment.runs[0].readings[series.readings[i]].Fx, q = angle_under(force);
      const double turn = -length * std::sin(q) / (stiffness + force * length * std::cos(q));  // dq/dF
      const double slope = series.channel.name == Channel::Name::x   ? -length * std::sin(q) * turn
                           : series.channel.name == Channel::Name::y ? length * std::cos(q) * turn
                                                                     : turn;
      const double expected =
          std::hypot(series.channel.sigma(experiment.noise), slope * experiment.runs[0].imposed_noise.Fx);
      // The difference over one standard deviation of the force, which turns the link by 7 mrad, is off its
      // derivative by some share of that.
      CHECK(measurements.sigma()(static_cast<Eigen::Index>(series.first + i)) ==
            doctest::Approx(expected).epsilon(0.01));
      ++compared;
    }
  }
  CHECK(compared == 18);
}

TEST_CASE("a run whose imposed channels have no noise passes none on") {
  Experiment experiment = pushed_link();
  experiment.runs[0].imposed_noise = {};
  CHECK(variance_by_imposed(experiment).empty());
  const Measurements measurements(experiment);
  for (const Series& series : measurements.series())
    CHECK(measurements.sigma()(static_cast<Eigen::Index>(series.first)) ==
          series.channel.sigma(experiment.noise));
}

TEST_CASE("noise of commanded angles is that of the angles of a free chain") {
  Experiment experiment = pushed_link();
  Run& run = experiment.runs[0];
  run.imposed_noise = {};
  run.imposed_noise.q = 5e-3;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    Reading& reading = run.readings[i];
    reading.rest = {upright + 0.1 * static_cast<double>(i)};
    reading.Fx = 0;
  }
  const Measurements measurements(experiment);
  for (const Series& series : measurements.series())
    if (series.channel.name == Channel::Name::q)
      for (std::size_t i = 0; i < series.readings.size(); ++i)
        CHECK(measurements.sigma()(static_cast<Eigen::Index>(series.first + i)) ==
              doctest::Approx(std::hypot(1e-3, 5e-3)));
}
