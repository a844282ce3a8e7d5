#include "diagnose/model/band_matrix.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <random>

using plumbline::diagnose::BandMatrix;

namespace {

/// The same random numbers within the band, here and there.
std::pair<BandMatrix, Eigen::MatrixXd> random_band(std::size_t size, std::size_t width,
                                                   std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::pair<BandMatrix, Eigen::MatrixXd> both{
      BandMatrix(size, width),
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size))};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i > width ? i - width : 0; j <= i; ++j) {
      const double value = uniform(random);
      both.first(i, j) = value;
      both.second(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = value;
      both.second(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = value;
    }
  }
  return both;
}

}  // namespace

TEST_CASE("a band matrix is solved as a dense one, and its negative eigenvalues are counted") {
  std::mt19937 random(1);
  for (const std::size_t width : {1U, 2U, 5U}) {
    for (std::size_t size = 1; size <= 12; ++size) {
      CAPTURE(width);
      CAPTURE(size);
      auto [band, dense] = random_band(size, width, random);
      const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues();
      const Eigen::VectorXd b = Eigen::VectorXd::Random(static_cast<Eigen::Index>(size));
      std::vector<double> x(b.data(), b.data() + b.size());
      CHECK(band.factorise(1e-300) == static_cast<std::size_t>((eigenvalues.array() < 0).count()));
      band.solve(x);
      const Eigen::VectorXd left =
          dense * Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(size)) - b;
      // without pivoting errors grow with the inverse of the smallest pivot: random ones are above 1e-4
      CHECK(left.cwiseAbs().maxCoeff() < 1e-9);
    }
  }
}

TEST_CASE("a pivot that vanishes is put at the least size, with its sign") {
  BandMatrix zero(1, 0);
  zero(0, 0) = 0;
  CHECK(zero.factorise(1e-6) == 0);
  CHECK(zero(0, 0) == doctest::Approx(1e6));
  BandMatrix barely(1, 0);
  barely(0, 0) = -1e-9;
  CHECK(barely.factorise(1e-6) == 1);
  CHECK(barely(0, 0) == doctest::Approx(-1e6));
}
