#include "diagnose/outside/departure.hpp"

#include <doctest/doctest.h>

#include "diagnose/priors.hpp"
#include "tests/diagnose/outside/drawn_bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// White noise, and some values far off.
struct Left : test::DrawnBench {
  Left() : DrawnBench(7) {}
  /// \param off  values of the flat list that lie 30 sigma off
  [[nodiscard]] double factor(const std::vector<Eigen::Index>& off) const {
    VectorXd moved = residual;
    NoiseEstimate noise{{}, NoiseShape(study.measurements())};
    for (const Eigen::Index i : off) moved(i) = 30, noise.shape.outlier[static_cast<std::size_t>(i)] = true;
    for (const Block& block : study.measurements().blocks())
      noise.channels.push_back({block.channel, 1, 0, 1});
    return log_departure(study.measurements(), moved, noise, in_order_of_reading(study.measurements()));
  }
  /// Place of a value in the flat list.
  [[nodiscard]] Eigen::Index at(std::size_t series, std::size_t reading) const {
    return static_cast<Eigen::Index>(study.measurements().series()[series].first + reading);
  }
};

}  // namespace

TEST_CASE("readings that stand off together are one event, those that stand off apart are outliers") {
  const Left left;
  CHECK(left.factor({}) < 0);
  CHECK(left.factor({left.at(0, 7)}) < 0);                                   // one value
  CHECK(left.factor({left.at(0, 3), left.at(1, 9), left.at(2, 15)}) < 0);    // three, apart
  CHECK(left.factor({left.at(0, 18), left.at(0, 19), left.at(0, 20)}) > 0);  // three in a row
  // The same readings in two channels.
  CHECK(left.factor({left.at(0, 18), left.at(0, 19), left.at(4, 18), left.at(4, 19)}) > 0);
}

TEST_CASE("no value adds more than the odds against an outlier") {
  const Left left;
  const std::vector<Eigen::Index> row{left.at(0, 17), left.at(0, 18), left.at(0, 19), left.at(0, 20)};
  for (std::size_t count = 1; count <= row.size(); ++count)
    CHECK(left.factor({row.begin(), row.begin() + static_cast<std::ptrdiff_t>(count)}) <=
          -static_cast<double>(count) * std::log(priors::outlier_share));
}
