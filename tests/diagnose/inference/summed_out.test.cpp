#include "diagnose/inference/summed_out.hpp"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

namespace plumbline::diagnose::test {

using Eigen::MatrixXd, Eigen::VectorXd;

TEST_CASE("squares of whitened values are those by the covariance, random effects summed out") {
  std::srand(5);
  const MatrixXd random = 3 * MatrixXd::Random(12, 4);
  const VectorXd values = VectorXd::Random(12);
  const MatrixXd covariance = MatrixXd::Identity(12, 12) + random * random.transpose();
  const double expected = values.dot(covariance.ldlt().solve(values));
  // The condition of the covariance is about a hundred: a hundred roundings.
  CHECK(Whitening(MatrixXd(12, 0), random)(values).squaredNorm() == doctest::Approx(expected).epsilon(1e-12));
}

TEST_CASE("an unknown of any size leaves no trace, and is the limit of a large random effect") {
  std::srand(6);
  const MatrixXd unknown = MatrixXd::Random(12, 3), random = MatrixXd::Random(12, 2);
  const VectorXd values = VectorXd::Random(12), moved = values + 1e3 * unknown * VectorXd::Random(3);
  const Whitening whitening(unknown, random);
  CHECK((whitening(values) - whitening(moved)).norm() < 1e-10);  // 1e3 times a dozen roundings of 1e-16
  MatrixXd both(12, 5);
  constexpr double large = 1e4;
  both << large * unknown, random;
  const MatrixXd covariance = MatrixXd::Identity(12, 12) + both * both.transpose();
  // What is left of an unknown is 1 / large^2 of it.
  CHECK(whitening(values).squaredNorm() ==
        doctest::Approx(values.dot(covariance.ldlt().solve(values))).epsilon(1e-6));
}

TEST_CASE("without effects values stay as they are") {
  const VectorXd values = VectorXd::LinSpaced(5, -1, 1);
  CHECK(Whitening()(values) == values);
}

}  // namespace plumbline::diagnose::test
