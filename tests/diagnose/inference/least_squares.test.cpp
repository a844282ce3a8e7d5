#include "diagnose/inference/least_squares.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// What rounding may leave of numbers of about one.
constexpr double of_rounding = 1e-12;

}  // namespace

TEST_CASE("least squares of three values on two columns, by hand") {
  const Eigen::MatrixXd columns{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}};
  const LeastSquares line(columns);
  CHECK(line.rank() == 2);
  // 1, 2, 6: the slope is 5 / 2, the middle 3
  const Eigen::VectorXd found = line.solve(Eigen::Vector3d(1, 2, 6));
  CHECK(found(0) == close_to(0.5));
  CHECK(found(1) == close_to(2.5));
  const Eigen::MatrixXd basis = line.orthonormal();
  REQUIRE(basis.rows() == 3);
  REQUIRE(basis.cols() == 2);
  CHECK((basis.transpose() * basis - Eigen::Matrix2d::Identity()).norm() < of_rounding);
  CHECK((columns - basis * (basis.transpose() * columns)).norm() < of_rounding);
}

TEST_CASE("a column that depends on others does not count; none at all are no columns") {
  const LeastSquares twice(Eigen::MatrixXd{{1.0, 2.0}, {1.0, 2.0}, {0.0, 0.0}});
  CHECK(twice.rank() == 1);
  const Eigen::VectorXd found = twice.solve(Eigen::Vector3d(3, 5, 7));
  CHECK(found(0) + 2 * found(1) == close_to(4));
  CHECK(found.array().abs().minCoeff() == 0);
  const LeastSquares nothing(Eigen::MatrixXd::Zero(3, 2));
  CHECK(nothing.rank() == 0);
  CHECK(nothing.solve(Eigen::Vector3d(1, 2, 3)) == Eigen::Vector2d(0, 0));
  const LeastSquares none(Eigen::MatrixXd(3, 0));
  CHECK(none.rank() == 0);
  CHECK(none.solve(Eigen::Vector3d(1, 2, 3)).size() == 0);
  CHECK(none.orthonormal().size() == 0);
}

TEST_CASE("a triangular factor has the lengths and angles of its columns") {
  const Eigen::MatrixXd columns{{1.0, -2.0}, {0.5, 1.0}, {3.0, 4.0}, {0.0, 1.0}};
  const Eigen::MatrixXd factor = triangular_factor(columns);
  REQUIRE(factor.rows() == 2);
  CHECK(factor(1, 0) == 0);
  CHECK((factor.transpose() * factor - columns.transpose() * columns).norm() < 40 * of_rounding);
  const Eigen::MatrixXd wide = triangular_factor(Eigen::MatrixXd{{3.0, 1.0, 2.0}, {4.0, 0.0, 1.0}});
  CHECK(wide.rows() == 2);
  CHECK(std::abs(wide(0, 0)) == close_to(5));
}
