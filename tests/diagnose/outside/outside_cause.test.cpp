#include "diagnose/outside/outside_cause.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <random>

#include "diagnose/inference/size_prior.hpp"
#include "diagnose/priors.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/outside/drawn_bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// White noise, with something outside of the catalogue in one channel of the first run.
struct Outside : test::DrawnBench {
  CommandStates states{study.experiment()};
  NoiseShape shape{study.measurements()};

  Outside() : DrawnBench(17) {}
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

TEST_CASE("the prior of sizes is one over all sizes, and what is smaller than one of them is its sum") {
  double sum = std::exp(log_smaller(std::exp2(-60.5)));
  for (int k = -60; k <= 60; ++k) {
    sum += std::exp(log_size_prior(std::exp2(k)));
    // The midpoint rule on a smooth function of the logarithm, up to half a step above.
    CHECK(sum == close_to(std::exp(log_smaller(std::exp2(k + 0.5)))).epsilon(2e-2));
  }
  CHECK(sum == close_to(1).epsilon(1e-3));
  double on_the_grid = 0;
  for (const GridSize& one : size_grid()) on_the_grid += std::exp(one.log_prior);
  CHECK(on_the_grid == close_to(1).epsilon(1e-12));
}

TEST_CASE("any order of magnitude of a size is as probable from small ones to typical ones, and no other") {
  const double middle = std::sqrt(priors::smallest_typical);
  for (const double factor : {1.5, 3.0, 10.0, 100.0})  // symmetric about the middle, by the logarithm
    CHECK(log_size_prior(middle * factor) == close_to(log_size_prior(middle / factor)).epsilon(1e-12));
  CHECK(log_size_prior(1) > log_size_prior(middle) - std::numbers::ln2);  // half at the ends of that range
  CHECK(log_size_prior(100) < log_size_prior(1) - std::log(30));
}
