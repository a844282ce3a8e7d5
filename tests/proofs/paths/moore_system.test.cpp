#include "proofs/paths/moore_system.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("the derivative of Moore's system is that of its values, held and under a force") {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> some(-64, 64), positive(16, 128);
  const auto number = [&](auto& from) { return Interval(Rational(from(random), 64)); };
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Interval> length, stiffness, rest;
    for (int i = 0; i < 3; ++i) {
      length.push_back(number(positive));
      stiffness.push_back(number(positive));
      rest.push_back(number(some));
    }
    const Chain<Interval> chain(length, stiffness, rest);
    const Control control = trial % 2 == 0 ? Control::end_point : Control::force;
    const Loading<Interval> loading{control, {number(some), number(some)}, {number(some), number(some)}};
    const IntervalEquations equations(chain, loading);
    const Eigen::Index m = equations.size();
    // as many equations as unknowns but for the load, and a second derivative in all of them
    const LocalEquations local =
        equations.at(IntervalVector::Constant(m + 1, Interval(0)), IntervalVector::Constant(m, Interval(1)));
    CHECK(m == (control == Control::end_point ? 5 : 3));
    CHECK(local.value.size() == m);
    CHECK(local.derivative.rows() == m);
    CHECK(local.derivative.cols() == m + 1);
    CHECK(local.bend.rows() == m + 1);
    CHECK(local.bend.cols() == m + 1);
    Vector<double> near(m + 1);
    for (double& x : near) x = some(random) / 64.0;
    const MooreSystem moore(equations, near);

    IntervalVector w(2 * m + 2);
    for (Interval& x : w) x = number(some);
    const Matrix<Interval> derivative = moore(w).second;
    const Interval step(Rational(1, mp::pow(mp::mpz_int(10), 20)));
    for (Eigen::Index j = 0; j < w.size(); ++j) {
      IntervalVector ahead = w, behind = w;
      ahead(j) = ahead(j) + step;
      behind(j) = behind(j) - step;
      const IntervalVector a = moore(ahead).first, b = moore(behind).first;
      for (Eigen::Index i = 0; i < w.size(); ++i) {
        CAPTURE(i);
        CAPTURE(j);
        // a difference over 1e-20 is off by 1e-40 of third derivatives, and by 64 digits over 1e-20
        const Interval off = (a(i) - b(i)) / (step + step) - derivative(i, j);
        CHECK(off.lower() > Interval::End("-1e-35"));
        CHECK(off.upper() < Interval::End("1e-35"));
      }
    }
  }
}

TEST_CASE("the null vectors of a box hold that of each point in it, and are none where two are") {
  const Chain<Interval> chain({1, 1, 1}, {1, 1, 1});
  const Loading<Interval> push{Control::force, {0, 0}, {-1, 0}};
  const IntervalEquations equations(chain, push);
  Vector<double> crossing = Vector<double>::Zero(4);
  crossing(3) = 0.19806226419516171;  // the least root of det(K - F L), 4 sin^2(pi / 14)
  const MooreSystem moore(equations, crossing);
  const auto around_it = [&](double distance) {
    return IntervalVector(crossing.unaryExpr([=](double x) { return around(x, distance); }));
  };
  const auto box = moore.null_vectors(around_it(1e-4)), point = moore.null_vectors(around_it(0));
  REQUIRE(box);
  REQUIRE(point);
  for (Eigen::Index i = 0; i < 3; ++i) {
    CHECK((*point)(i).inside((*box)(i)));
    CHECK((*point)(i).width() < 1e-14);
    CHECK((*box)(i).width() > 1e-5);
  }
  // psi^T dE/dx = 0, whence the equations for psi hold with tau = 0
  IntervalVector w = IntervalVector::Constant(8, Interval(0));
  w.head(4) = around_it(0);
  w.segment(4, 3) = *point;
  const IntervalVector value = moore(w).first;
  for (Eigen::Index i = 0; i < 8; ++i) CHECK(value(i).contains_zero());
  CHECK_FALSE(moore.null_vectors(around_it(1)));
}
