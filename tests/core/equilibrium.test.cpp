#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <plumbline/chain/strain_energy.hpp>
#include <plumbline/loaded/equilibrium.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;

namespace {

Chain<double> table1_z() {
  return Chain<double>({1, 1, 1, 1}, {1, 1, 1, 1}, {-0.2417, 0.6821, -0.7958, 0.5170});
}

/// [H J^T; J -A], dense.
template <int B>
Eigen::MatrixXd dense(const Expansion<double, B>& at) {
  const auto n = at.residual.size();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + 2, n + 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index d = 0; d <= B && i + d < n; ++d) K(i + d, i) = K(i, i + d) = at.hessian(d, i);
  }
  K.topRightCorner(n, 2) = at.force_gradient;
  K.bottomLeftCorner(2, n) = at.end_point_gradient.transpose();
  return K;
}

}  // namespace

TEST_CASE("a singular band inside a regular bordered matrix is solved and counted") {
  // T = [[0, 0], [0, 0]] with two borders: the exchange matrix, two negative eigenvalues
  BorderedBand<double, 1> matrix;
  Band<double, 1> T = Band<double, 1>::Zero(2, 2);
  matrix.factor(T);
  REQUIRE(matrix.border(Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Identity(2, 2),
                        Eigen::MatrixXd::Zero(2, 2)));
  CHECK(matrix.negative(2) == 2);
  Eigen::VectorXd v(2), w(2);
  v << 3, 4;
  w << 5, 6;
  matrix.solve(v, w);
  CHECK(v(0) == close_to(5));
  CHECK(v(1) == close_to(6));
  CHECK(w(0) == close_to(3));
  CHECK(w(1) == close_to(4));
}

TEST_CASE("bordered band: solution and inertia of random matrices, singular leading blocks included") {
  check_property("against Eigen's dense decompositions", [] {
    const int n = *rc::gen::inRange(1, 9);
    const int p = *rc::gen::inRange(0, 4);
    const auto entry = [] { return static_cast<double>(*rc::gen::inRange(-2, 3)); };
    Band<double, 2> T(3, n);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + p, n + p);
    for (int i = 0; i < n; ++i) {
      for (int d = 0; d <= 2; ++d) {
        T(d, i) = entry();
        if (i + d < n) K(i + d, i) = K(i, i + d) = T(d, i);
      }
    }
    for (int a = 0; a < p; ++a) {
      for (int i = 0; i < n + a + 1; ++i) K(i, n + a) = K(n + a, i) = entry();
    }
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    RC_PRE(eigenvalues.cwiseAbs().minCoeff() > 1e-2);  // integer matrices: singular or not close to it
    BorderedBand<double, 2> matrix;
    matrix.factor(T);
    RC_ASSERT(matrix.border(K.topRightCorner(n, p), K.topRightCorner(n, p), K.bottomRightCorner(p, p)));
    RC_ASSERT(static_cast<Eigen::Index>(matrix.negative(p)) == (eigenvalues.array() < 0).count());
    Eigen::VectorXd right(n + p);
    for (int i = 0; i < n + p; ++i) right(i) = entry();
    Eigen::VectorXd v = right.head(n), w = right.tail(p);
    matrix.solve(v, w);
    Eigen::VectorXd both(n + p);
    both << v, w;
    // a pivot kept is at least eps^(1/4) of its row, so each elimination step loses at most 4 digits
    RC_ASSERT((K * both - right).norm() <= 1e-7 * (1 + both.norm()));
  });
}

TEST_CASE_TEMPLATE("the equilibrium equations hold at the answer, and energy's derivative is the force", Real,
                   double, Mpfr50) {
  const auto chain = convert<Real>(table1_z(), [](double x) { return Real(x); });
  const NominalModel<Real> model(chain);
  EquilibriumSolver<NominalModel<Real>> solver(model);
  const auto rest = absolute_angles(chain.rest());
  const Point<Real> place{Real(37) / Real(10), Real(0)};
  const auto at = solver.at_end_point(place, rest);
  const auto q = joint_angles(at.theta);
  const Vector<Real> torque = spring_torque(chain, q);
  const Vector<Real> load =
      jacobian(chain, q).transpose() * Eigen::Matrix<Real, 2, 1>(at.force.x, at.force.y);
  // residuals of a few roundings, with forces and lengths of order one
  CHECK((torque - load).cwiseAbs().maxCoeff() < Real(1000) * epsilon<Real>());
  CHECK(abs(at.end_point.x - place.x) < Real(100) * epsilon<Real>());
  CHECK(at.force.x < Real(0));
  CHECK(at.negative_directions == 0);
  CHECK(abs(at.energy - strain_energy(chain, q)) < Real(100) * epsilon<Real>());

  // dE/dx = Fx and d2E/dx2 = tangent stiffness, by central differences of step h: error O(h^2) + O(eps/h^2)
  using std::pow;
  const Real h = pow(epsilon<Real>(), Real(1) / Real(4));
  const auto up = solver.at_end_point({place.x + h, place.y}, at.theta, at.force);
  const auto down = solver.at_end_point({place.x - h, place.y}, at.theta, at.force);
  CHECK(abs((up.energy - down.energy) / (h + h) - at.force.x) < Real(1000) * h * h);
  const auto stiffness = solver.tangent_stiffness(at);
  CHECK(abs((up.force.x - down.force.x) / (h + h) - stiffness(0, 0)) < Real(100000) * h * h);
  CHECK((solver.tangent_compliance(at) * stiffness - Eigen::Matrix<Real, 2, 2>::Identity())
            .cwiseAbs()
            .maxCoeff() < Real(10000) * epsilon<Real>());

  // the same shape is the equilibrium under the force it exerts
  const auto loaded = solver.under_force(at.force, at.theta);
  CHECK((loaded.theta - at.theta).cwiseAbs().maxCoeff() < Real(1000) * epsilon<Real>());
}

TEST_CASE("inertia under both controls agrees with dense eigenvalues") {
  const NominalModel<double> model(table1_z());
  EquilibriumSolver<NominalModel<double>> solver(model);
  int checked = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Eigen::VectorXd theta(4);
    for (int j = 0; j < 4; ++j) theta(j) = std::sin(7.0 * trial + 1.3 * j * j + trial * j) * 2;
    Equilibrium<double> at;
    try {
      at = solver.at_end_point({3.1, 0.2}, theta);
    } catch (const Error&) {
      continue;  // this start leads nowhere
    }
    ++checked;
    Expansion<double, 1> expansion;
    model.expand(at.theta, at.force, expansion);
    CHECK(expansion.residual.cwiseAbs().maxCoeff() <
          1e-10 * (1 + std::abs(at.force.x) + std::abs(at.force.y)));
    const Eigen::MatrixXd K = dense(expansion);
    const auto negative = [](const Eigen::MatrixXd& A) {
      return (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().array() < 0).count();
    };
    CHECK(static_cast<Eigen::Index>(at.negative_directions) == negative(K) - 2);
    CHECK(static_cast<Eigen::Index>(solver.under_force(at.force, at.theta).negative_directions) ==
          negative(K.topLeftCorner(4, 4)));
  }
  CHECK(checked > 100);
}

TEST_CASE("end points that cannot be, and chains without freedom, are refused in one line") {
  const auto solve = [](const Chain<double>& chain, Point<double> place, Point<double> force = {0, 0}) {
    const NominalModel<double> model(chain);
    return EquilibriumSolver<NominalModel<double>>(model).at_end_point(place, absolute_angles(chain.rest()),
                                                                       force);
  };
  CHECK_THROWS_AS(solve(table1_z(), {4.0, 0}), Error);
  CHECK_THROWS_AS(solve(table1_z(), {5.0, 0}), Error);
  CHECK_THROWS_AS(solve(table1_z(), {NAN, 0}), Error);
  CHECK_THROWS_AS(solve(Chain<double>({3, 1}, {1, 1}, {0, 1}), {1.5, 0}), Error);
  CHECK_THROWS_AS(solve(Chain<double>({1}, {1}), {1, 0}), Error);

  // two links: isolated shapes; the right angle has F = (k (q1 - rest1)…) by hand: p = (1, 1), theta = (0,
  // pi/2)
  const Chain<double> two({1, 1}, {2, 3}, {0.1, 1.2});
  const auto at = solve(two, {1, 1});
  const double right = std::acos(0.0);
  CHECK(at.theta(0) == doctest::Approx(0).epsilon(1e-12));
  CHECK(at.theta(1) == close_to(right));
  CHECK(at.negative_directions == 0);
  CHECK(at.force.x == close_to(-3 * (right - 1.2)));                 // moment about joint 2
  CHECK(at.force.y == close_to(2 * (0 - 0.1) - 3 * (right - 1.2)));  // moment about joint 1: Fy - Fx
}

TEST_CASE("one link under a force: k (theta - rest) = L (Fy cos theta - Fx sin theta)") {
  const NominalModel<double> model(Chain<double>({2}, {3}, {0.4}));
  const auto at =
      EquilibriumSolver<NominalModel<double>>(model).under_force({-0.5, 0.7}, absolute_angles<double>({0.4}));
  const double t = at.theta(0);
  CHECK(3 * (t - 0.4) == close_to(2 * (0.7 * std::cos(t) + 0.5 * std::sin(t))));
  CHECK(at.negative_directions == 0);
}

TEST_CASE("a passive base joint leaves no moment at the base") {
  const Chain<double> chain({1, 1, 1}, {0, 1, 1}, {0, -0.8, -1.0});
  const NominalModel<double> model(chain);
  EquilibriumSolver<NominalModel<double>> solver(model);
  Eigen::VectorXd start(3);
  start << 0.9, 0.1, -0.9;
  const auto at = solver.at_end_point({2.2, 0}, start);
  CHECK(at.negative_directions == 0);
  CHECK(at.force.y == doctest::Approx(0).epsilon(1e-12));  // x Fy = 0 with y = 0
}

TEST_CASE("intervals enclose what the solver finds") {
  const Chain<Rational> exact({1, 1, 1}, {0, 1, 2}, {0, Rational(1, 3), Rational(-1, 5)});
  const NominalModel<Interval> model(from_rational<Interval>(exact));
  Vector<Interval> theta(3);
  theta << Interval(Rational(1, 10)), Interval(Rational(2, 10)), Interval(Rational(-1, 10));
  Expansion<Interval, 1> at;
  model.expand(theta, {Interval(1), Interval(2)}, at);
  // residual of link 3: k_3 (theta_3 - theta_2 - rest_3) + Fx sin theta_3 - Fy cos theta_3
  const Interval last = Interval(Rational(-2, 10)) + sin(theta(2)) - Interval(2) * cos(theta(2));
  CHECK((at.residual(2) - last).contains_zero());
  CHECK(at.energy.contains(Rational(1, 2) * (Rational(7, 30) * Rational(7, 30) + 2 * Rational(1, 100))));
}
