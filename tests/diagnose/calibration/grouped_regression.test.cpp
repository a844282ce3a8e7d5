#include "diagnose/calibration/grouped_regression.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace plumbline::diagnose::test {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

struct Made {
  MatrixXd unknown, columns;
  std::vector<ColumnGroup> groups{{0, 20}, {20, 20}, {40, 1}, {41, 1}};
  VectorXd values;
};

/// Two groups of twenty coefficients and two single columns; noise of standard deviation 0.5.
Made made(double first, double second, double single) {
  std::mt19937 dice(7);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(dice); };
  Made all;
  all.unknown = MatrixXd::NullaryExpr(400, 3, draw);
  all.columns = MatrixXd::NullaryExpr(400, 42, draw);
  VectorXd coefficients = VectorXd::NullaryExpr(42, draw);
  coefficients.head(20) *= first, coefficients.segment(20, 20) *= second;
  coefficients(40) = single, coefficients(41) = 0;
  all.values = 100 * all.unknown * VectorXd::Ones(3) + all.columns * coefficients +
               0.5 * VectorXd::NullaryExpr(400, draw);
  return all;
}

}  // namespace

TEST_CASE("sizes of groups and the noise are learned from the values") {
  const Made all = made(3, 0.2, 0);
  const GroupedFit fit = GroupedRegression(all.unknown, all.columns, all.groups, all.values).fit({0, 1});
  // A standard deviation of 20 numbers is known to 1 / sqrt(40), of 400 to 1 / sqrt(800); four of these.
  CHECK(std::abs(std::log(fit.size[0] / 3)) < 4 / std::sqrt(40.0));
  CHECK(std::abs(std::log(fit.size[1] / 0.2)) < 4 / std::sqrt(40.0));
  CHECK(std::abs(std::log(fit.noise / 0.5)) < 4 / std::sqrt(700.0));
}

TEST_CASE("a column that sticks out of the groups is found, and one of nothing is not") {
  const Made with = made(1, 1, 2), without = made(1, 1, 0);
  const auto groups = [](const Made& all) {
    return GroupedRegression(all.unknown, all.columns, all.groups, all.values)
        .extended({0, 1}, {2, 3})
        .groups;
  };
  CHECK(groups(with) == std::vector<std::size_t>{0, 1, 2});
  CHECK(groups(without) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("a member that its group cannot be as large as is found, and leaves the group to the others") {
  Made all = made(0.05, 1, 0);
  all.groups.push_back({5, 1});
  const auto fit = [&] {
    return GroupedRegression(all.unknown, all.columns, all.groups, all.values).extended({0, 1}, {2, 3, 4});
  };
  CHECK(fit().groups == std::vector<std::size_t>{0, 1});
  all.values += 3 * all.columns.col(5);
  const GroupedFit out = fit();
  REQUIRE(out.groups == std::vector<std::size_t>{0, 1, 4});
  // Of its neighbours' 0.05, known to 1 / sqrt(40) and by a noise of 0.025 each; four of these.
  CHECK(std::abs(std::log(out.size[0] / 0.05)) < 4 / std::sqrt(40.0) * std::hypot(1.0, 0.5));
}

TEST_CASE("an unknown of any size changes no coefficient") {
  Made all = made(1, 1, 0);
  const GroupedFit before = GroupedRegression(all.unknown, all.columns, all.groups, all.values).fit({0, 1});
  all.values += 1e3 * all.unknown.col(1);
  const GroupedFit after = GroupedRegression(all.unknown, all.columns, all.groups, all.values).fit({0, 1});
  // Rounding of values of a thousand, over columns of twenty: 1e-13 each, sixty iterations.
  CHECK((before.mean - after.mean).norm() < 1e-9);
}

}  // namespace plumbline::diagnose::test
