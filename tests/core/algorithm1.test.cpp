#include <plumbline/straight/algorithm1.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <plumbline/straight/buckling_mode.hpp>

#include "verify/sampled/algorithm1_instances.hpp"

using namespace plumbline;

TEST_CASE_TEMPLATE("Algorithm 1 and the recursion agree on the unit chain of four links", Real, double,
                   Mpfr50) {
  const Chain<Real> chain({1, 1, 1, 1}, {1, 1, 1, 1});
  const auto modes = algorithm1(chain);
  REQUIRE(modes.size() == 3);
  for (std::size_t m = 0; m < 3; ++m) {
    // the error of Algorithm 1 in double on this chain is a few units of 1e-15
    const Real step = Real(64) * epsilon<Real>();
    CHECK(count_below(chain, Real(modes[m].force * (Real(1) - step))) == m);
    CHECK(count_below(chain, Real(modes[m].force * (Real(1) + step))) == m + 1);
  }
}

TEST_CASE("Algorithm 1 in 50 digits finds the same forces and shapes") {
  const Chain<Mpfr50> chain({0.3, 2, 7, 0.2, 1, 5}, {4, 0.5, 0.2, 3, 9, 1});
  const auto peer = algorithm1(chain);
  const auto modes = critical_modes(chain, 9);
  REQUIRE(modes.size() == peer.size());
  for (std::size_t m = 0; m < peer.size(); ++m) {
    CHECK(abs(modes[m].force / peer[m].force - 1) < Mpfr50(1e-40));
    for (std::size_t i = 0; i < 6; ++i) CHECK(abs(modes[m].q[i] - peer[m].q[i]) < Mpfr50(1e-38));
  }
}

TEST_CASE("an eigenvector that a solver returned wrong is repaired, a right one only scaled") {
  // the second difference of three points: 2 - sqrt 2 with (1, sqrt 2, 1), 2 with (1, 0, -1)
  Matrix<double> C(3, 3);
  C << 2, -1, 0,  //
      -1, 2, -1,  //
      0, -1, 2;
  const double root = std::sqrt(2.0);
  const auto off = [&](double lambda, const Vector<double>& given, const Vector<double>& right) {
    return (detail::checked_eigenvector(C, lambda, given) - right.normalized()).norm();
  };
  Vector<double> lowest(3), odd(3), wrong(3);
  lowest << 1, root, 1;
  odd << 1, 0, -1;
  wrong << -0.9, 0.3, 0.2;
  CHECK(off(2 - root, -7 * lowest, lowest) < 1e-15);
  CHECK(off(2, -odd, odd) < 1e-15);
  // two steps of inverse iteration, each of which leaves sqrt(eps) lambda / gap of what is wrong: 4e-16 here
  CHECK(off(2 - root, wrong, lowest) < 1e-14);
  CHECK(off(2, wrong, odd) < 1e-14);
}
