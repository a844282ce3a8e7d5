#include "diagnose/outside/outside_cause.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <random>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// White noise on four runs, with something outside of the catalogue in one channel of the first.
struct Outside {
  Study study{bench()};
  CommandStates states{study.experiment()};
  VectorXd residual = VectorXd::Zero(static_cast<Eigen::Index>(study.measurements().size()));
  NoiseShape shape{study.measurements()};

  static Experiment bench() {
    Experiment experiment = test::three_links();
    for (int run = 0; run < 4; ++run)
      test::press(experiment, {0.3, -0.5, 0.4}, {-0.01 * (run + 3), 0}, 20, false);
    return experiment;
  }
  Outside() {
    std::mt19937 engine(17);
    std::normal_distribution<double> normal;
    for (double& one : residual) one = normal(engine);
  }
  void change(const std::function<double(std::size_t reading)>& by, bool outliers = false) {
    const Series& first = study.measurements().series().front();
    for (std::size_t i = 0; i < first.readings.size(); ++i) {
      residual(static_cast<Eigen::Index>(first.first + i)) += by(i);
      if (outliers && by(i) != 0) shape.outlier[first.first + i] = true;
    }
  }
  /// Log likelihood beside each row of the list, over that of noise alone.
  [[nodiscard]] std::vector<double> gains() const {
    const Likelihood likelihood(study.measurements(), states, full_model(), shape, residual);
    const Look look = likelihood.look(residual);
    std::vector<double> all;
    for (const OutsideRow& row : outside_rows)
      all.push_back(row.make()->fit({likelihood, residual, look}).log_likelihood -
                    look.log_by_amplitude.front());
    return all;
  }
};

std::size_t best(const std::vector<double>& gains) {
  return static_cast<std::size_t>(std::max_element(gains.begin(), gains.end()) - gains.begin());
}

std::size_t place_of(std::unique_ptr<OutsideCause> (*make)()) {
  return static_cast<std::size_t>(std::find_if(std::begin(outside_rows), std::end(outside_rows),
                                               [&](const OutsideRow& row) { return row.make == make; }) -
                                  std::begin(outside_rows));
}

}  // namespace

TEST_CASE("the shares of causes outside are those of a whole") {
  double sum = 0;
  for (const OutsideRow& row : outside_rows) sum += row.share;
  CHECK(sum == close_to(1).epsilon(1e-12));
}

TEST_CASE("noise alone is more probable than beside any cause outside") {
  for (const double gain : Outside().gains()) CHECK(gain < 0);
}

TEST_CASE("what a cause outside does is most probable in its own row") {
  {
    Outside step;
    step.change([](std::size_t i) { return i < 8 ? 0.0 : 12.0; });
    CHECK(best(step.gains()) == place_of(step_departure));
  }
  {
    Outside local;
    local.change([](std::size_t i) { return i >= 6 && i < 10 ? 60.0 : 0.0; }, true);
    CHECK(best(local.gains()) == place_of(local_departure));
  }
  {
    // The command grows with the number of the reading: a stop, or the end of a cell's range.
    Outside end;
    end.change([](std::size_t i) { return i >= 13 ? 60.0 : 0.0; }, true);
    CHECK(best(end.gains()) == place_of(departure_at_the_ends));
  }
  {
    std::mt19937 engine(19);
    std::normal_distribution<double> normal;
    Outside scattered;
    for (Eigen::Index i = 0; i < scattered.study.measurements().blocks().front().count; ++i)
      scattered.residual(i) += 30 * normal(engine);
    CHECK(best(scattered.gains()) == place_of(scatter));
  }
}

TEST_CASE("the half-Cauchy prior of sizes is one over all sizes") {
  double sum = 0;
  for (int k = -60; k <= 60; ++k) sum += std::exp(log_size_prior(std::exp2(k)));
  // The trapezoidal rule on a smooth function of the logarithm that decays at both ends.
  CHECK(sum == close_to(1).epsilon(1e-3));
}

TEST_CASE("a cause outside pays for being small") {
  for (const double size : {0.001, 0.01, 0.1}) CHECK(log_size_prior(size) < log_size_prior(10 * size));
  for (const double size : {0.2, 0.5})
    CHECK(log_size_prior(size) == close_to(log_size_prior(1 / size)).epsilon(1e-12));
}
