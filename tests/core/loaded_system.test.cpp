#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <plumbline/loaded/nominal_model.hpp>
#include <plumbline/loaded/settle.hpp>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;

namespace {

/// The nominal chain and all that a model may have beside it: a next neighbour (bandwidth 2), a base that
/// yields, weight, and a load that acts beside the end of the last link.
class FullModel {
 public:
  using Real = double;
  static constexpr int bandwidth = 2;

  FullModel(NominalModel<double> nominal, double coupling, Eigen::Vector2d yields, double eccentricity)
      : nominal_(std::move(nominal)), coupling_(coupling), yields_(yields), eccentricity_(eccentricity) {}

  [[nodiscard]] std::size_t size() const { return nominal_.size(); }

  void expand(const Vector<double>& theta, const Point<double>& force, Expansion<double, 2>& at) const {
    Expansion<double, 1> plain;
    nominal_.expand(theta, force, plain);
    const Eigen::Index n = theta.size();
    at.residual = plain.residual;
    at.energy = plain.energy;
    at.hessian.setZero(3, n);
    at.hessian.topRows<2>() = plain.hessian;
    // a spring between links that are not neighbours, at its rest where they are parallel
    for (Eigen::Index i = 0; i + 2 < n; ++i) {
      const double turn = theta(i + 2) - theta(i);
      at.energy += coupling_ * turn * turn / 2;
      at.residual(i + 2) += coupling_ * turn;
      at.residual(i) -= coupling_ * turn;
      at.hessian(0, i) += coupling_;
      at.hessian(0, i + 2) += coupling_;
      at.hessian(2, i) -= coupling_;
    }
    at.end_point = {plain.end_point.x + yields_.x() * force.x, plain.end_point.y + yields_.y() * force.y};
    at.energy += (yields_.x() * force.x * force.x + yields_.y() * force.y * force.y) / 2;
    at.compliance = yields_.asDiagonal();
    at.end_point_gradient = at.force_gradient = plain.end_point_gradient;
    const Eigen::Vector2d u(std::cos(theta(n - 1)), std::sin(theta(n - 1)));
    at.residual(n - 1) += eccentricity_ * (u.x() * force.x + u.y() * force.y);
    at.hessian(0, n - 1) += eccentricity_ * (u.x() * force.y - u.y() * force.x);
    at.force_gradient.row(n - 1) -= eccentricity_ * u.transpose();
  }

 private:
  NominalModel<double> nominal_;
  double coupling_;
  Eigen::Vector2d yields_;
  double eccentricity_;
};

NominalModel<double> heavy_chain() {
  return NominalModel<double>(
      Chain<double>({0.9, 1.1, 1.0, 0.8, 1.2}, {2, 1.5, 1, 1.2, 0.8}, {0.4, -0.7, 0.6, -0.5, 0.3}),
      {{0, -0.02}, {0.01, -0.03}, {0, -0.01}, {0, -0.04}, {0, -0.02}});
}

FullModel full(double eccentricity) {
  return {heavy_chain(), 0.3, {0.02, 0.05}, eccentricity};
}

double entry() {
  return *rc::gen::inRange(-1000, 1001) / 1000.0;
}

template <int B>
Eigen::MatrixXd dense(const Band<double, B>& band) {
  const Eigen::Index n = band.cols();
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index d = 0; d <= B && i + d < n; ++d) full(i + d, i) = full(i, i + d) = band(d, i);
  return full;
}

// Central differences of step h of functions whose derivatives are of order one to ten: error h^2 and
// rounding over h, 1e-10 each.
constexpr double h = 1e-5, near_enough = 1e-8;

}  // namespace

TEST_CASE("the nominal model with weight: residual, end point and stiffness are derivatives of V - p . F") {
  check_property("central differences", [] {
    const NominalModel<double> model = heavy_chain();
    Vector<double> theta(5);
    for (int i = 0; i < 5; ++i) theta(i) = 2 * entry();
    const Point<double> force{entry(), entry()};
    Expansion<double, 1> here, up, down;
    model.expand(theta, force, here);
    const auto potential = [&](const Expansion<double, 1>& at, const Point<double>& F) {
      return at.energy - at.end_point.x * F.x - at.end_point.y * F.y;
    };
    for (Eigen::Index i = 0; i < 5; ++i) {
      Vector<double> to = theta;
      to(i) += h;
      model.expand(to, force, up);
      to(i) -= 2 * h;
      model.expand(to, force, down);
      RC_ASSERT(std::abs((potential(up, force) - potential(down, force)) / (2 * h) - here.residual(i)) <
                near_enough);
      RC_ASSERT(
          ((up.residual - down.residual) / (2 * h) - dense<1>(here.hessian).col(i)).cwiseAbs().maxCoeff() <
          near_enough);
    }
    const Vector<double> turn = Vector<double>::NullaryExpr(5, [] { return entry(); });
    const Variation<double> way{turn, {entry(), entry()}, 0};
    model.expand(theta + h * turn, {force.x + h * way.force.x, force.y + h * way.force.y}, up);
    model.expand(theta - h * turn, {force.x - h * way.force.x, force.y - h * way.force.y}, down);
    Vector<double> moment;
    Point<double> place{0, 0};
    model.second_derivative(here, force, way, way, moment, place);
    // of the residual: its second difference errs by h^2 and by rounding over h^2
    const Vector<double> bend = (up.residual - 2 * here.residual + down.residual) / (h * h);
    RC_ASSERT((bend - moment).cwiseAbs().maxCoeff() < 1e-4);
  });
}

TEST_CASE("a heavy chain that hangs straight down carries its weight without a moment") {
  const NominalModel<double> model(Chain<double>({1, 2}, {1, 1}, {-std::acos(0.0), 0}), {{0, -3}, {0, -5}});
  Expansion<double, 1> at;
  model.expand(absolute_angles(model.chain().rest()), {0, 0}, at);
  CHECK(at.residual.cwiseAbs().maxCoeff() < 1e-15);
  CHECK(at.energy == close_to(-3 * 0.5 - 5 * 2.0));  // heights of the middles
  CHECK(at.hessian(0, 1) == close_to(1 + 5 * 1.0));  // spring, and the pendulum's m g L / 2
  CHECK_THROWS_AS(NominalModel<double>(Chain<double>({1, 1}, {1, 1}), {{0, 1}}), Error);
}

TEST_CASE("equilibria of a model with all that a model may have") {
  for (const double eccentricity : {0.0, 0.07}) {
    CAPTURE(eccentricity);
    const FullModel model = full(eccentricity);
    EquilibriumSolver<FullModel> solver(model);
    const auto rest = solver.under_force({0, 0}, absolute_angles<double>({0.4, -0.7, 0.6, -0.5, 0.3}));
    const Point<double> place{rest.end_point.x - 0.3, rest.end_point.y + 0.1};
    const auto at = solver.at_end_point(place, rest.theta);
    CHECK(at.end_point.x == close_to(place.x).epsilon(1e-13));
    Expansion<double, 2> expansion;
    model.expand(at.theta, at.force, expansion);
    if (eccentricity == 0) {  // the inertia of the whole bordered matrix, less one for each constraint
      const Eigen::Index n = at.theta.size();
      Eigen::MatrixXd whole(n + 2, n + 2);
      whole << dense<2>(expansion.hessian), expansion.force_gradient,
          expansion.end_point_gradient.transpose(), -expansion.compliance;
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(whole).eigenvalues();
      CHECK(static_cast<std::size_t>((values.array() < 0).count()) == at.negative_directions + 2);
    }
    CHECK(expansion.residual.cwiseAbs().maxCoeff() < 1e-13);

    const auto moved = [&](double dx, double dy) {
      return solver.at_end_point({place.x + dx, place.y + dy}, at.theta, at.force);
    };
    const Eigen::Matrix2d stiffness = solver.tangent_stiffness(at);
    for (int axis = 0; axis < 2; ++axis) {
      const double dx = axis == 0 ? h : 0, dy = axis == 1 ? h : 0;
      const auto up = moved(dx, dy), down = moved(-dx, -dy);
      // rounding of a force is some 1e-14, over h 1e-9; stiffnesses are of order ten
      CHECK((up.force.x - down.force.x) / (2 * h) == close_to(stiffness(0, axis)).epsilon(1e-7));
      CHECK((up.force.y - down.force.y) / (2 * h) == close_to(stiffness(1, axis)).epsilon(1e-7));
      if (eccentricity == 0) {  // a potential: dE/dp is the force
        CHECK((up.energy - down.energy) / (2 * h) ==
              close_to(axis == 0 ? at.force.x : at.force.y).epsilon(1e-7));
      }
    }
    CHECK((solver.tangent_compliance(at) * stiffness - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff() <
          1e-10);
    const auto loaded = solver.under_force(at.force, at.theta);
    CHECK((loaded.theta - at.theta).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("negative directions of a model with compliance and bandwidth 2 agree with dense eigenvalues") {
  check_property("inertia of [H C; J -A], and with dampers", [] {
    const FullModel model = full(0);
    LoadedSystem<FullModel> system(model);
    const Vector<double> theta = Vector<double>::NullaryExpr(5, [] { return 3 * entry(); });
    const Point<double> force{6 * entry(), 6 * entry()};
    const double damping = *rc::gen::element(0.0, 0.5, 3.0), give = *rc::gen::element(0.0, 0.1);
    system.expand(theta, force);
    RC_ASSERT(system.symmetric());
    const Expansion<double, 2> at = system.at();
    RC_PRE(system.factor(Control::end_point, damping, give));
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(7, 7);
    K.topLeftCorner(5, 5) = dense<2>(at.hessian);
    for (int i = 0; i < 5; ++i) {
      const double before = i > 0 ? damping : 0;
      K(i, i) += damping + (i < 4 ? damping : 0);
      if (i > 0) K(i, i - 1) -= before, K(i - 1, i) -= before;
    }
    K.topRightCorner(5, 2) = at.force_gradient;
    K.bottomLeftCorner(2, 5) = at.end_point_gradient.transpose();
    K.bottomRightCorner(2, 2) = -at.compliance - give * Eigen::Matrix2d::Identity();
    const auto eigenvalues = [](const Eigen::MatrixXd& A) {
      return Eigen::VectorXd(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues());
    };
    const Eigen::VectorXd held = eigenvalues(K), free = eigenvalues(K.topLeftCorner(5, 5));
    RC_PRE(held.cwiseAbs().minCoeff() > 1e-6 && free.cwiseAbs().minCoeff() > 1e-6);
    RC_ASSERT(static_cast<Eigen::Index>(system.negative_directions()) == (held.array() < 0).count() - 2);
    system.expand(theta, force);
    RC_PRE(system.factor(Control::force, damping));
    RC_ASSERT(static_cast<Eigen::Index>(system.negative_directions()) == (free.array() < 0).count());
  });
}

TEST_CASE("a force beside the point that is held: every way in which it drives the point wrong is counted") {
  check_property("2 - negative eigenvalues of -A - J H^-1 C where H is positive", [] {
    const FullModel model = full(5 * entry());
    LoadedSystem<FullModel> system(model);
    const Vector<double> theta = Vector<double>::NullaryExpr(5, [] { return 3 * entry(); });
    system.expand(theta, {entry(), entry()});
    const Expansion<double, 2> at = system.at();
    const Eigen::MatrixXd H = dense<2>(at.hessian);
    RC_PRE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().minCoeff() > 1e-3);
    const Eigen::Matrix2d G =
        -at.compliance - at.end_point_gradient.transpose() * H.ldlt().solve(at.force_gradient);
    RC_PRE(std::abs(G.determinant()) > 1e-6 && std::abs(G.trace()) > 1e-6);
    const Eigen::Vector2cd eigenvalues = Eigen::EigenSolver<Eigen::Matrix2d>(G).eigenvalues();
    RC_PRE(system.factor(Control::end_point));
    const auto positive = (eigenvalues.real().array() > 0).count();
    RC_TAG(positive);
    RC_ASSERT(static_cast<Eigen::Index>(system.negative_directions()) == positive);
  });
}

TEST_CASE("where a chain comes to rest it is stable, and its energy has fallen") {
  const FullModel model = full(0);
  EquilibriumSolver<FullModel> solver(model);
  Expansion<double, 2> at;
  int checked = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Vector<double> theta(5);
    for (int i = 0; i < 5; ++i) theta(i) = std::sin(3.0 * trial + 2.1 * i) * 1.5;
    const Loading<double> loading{Control::force, {0, 0}, {-1, 0}};
    model.expand(theta, loading.at(0.3), at);
    const double before = at.energy + 0.3 * at.end_point.x;
    const Equilibrium<double> rest = settle(model, loading, 0.3, theta);
    CHECK(rest.negative_directions == 0);
    CHECK(rest.energy + 0.3 * rest.end_point.x <= before);
    model.expand(rest.theta, rest.force, at);
    CHECK(at.residual.cwiseAbs().maxCoeff() < 1e-12);
    ++checked;
  }
  CHECK(checked == 20);
}

TEST_CASE("a link far from rest, under a force millions of times its stiffness, falls over the near way") {
  // V = theta^2 / 2 - F cos theta falls all the way from either side to its minimum at 0, unless theta is
  // within pi / F of upside down; beyond that the spring is far too weak to bring it back from another turn
  const NominalModel<double> model(Chain<double>({1}, {1}));
  for (const double force : {1e4, 3e6, 3e7, 1e8}) {
    for (const double angle : {0.5, 1.5, 2.0, 3.0, 3.1}) {
      for (const double side : {1, -1}) {
        CAPTURE(force);
        CAPTURE(side * angle);
        const auto rest =
            settle(model, {Control::force, {0, 0}, {1, 0}}, force, Vector<double>::Constant(1, side * angle));
        // the last step of Newton's method is of a few roundings of a radian, and 0 is where it leads
        CHECK(std::abs(rest.theta(0)) < 1e-14);
        CHECK(rest.negative_directions == 0);
      }
    }
  }
}

namespace {

/// A model that can give residual and end point by themselves.
struct ChordModel : NominalModel<double> {
  using NominalModel<double>::NominalModel;
  void balance(const Vector<double>& theta, const Point<double>& force, Expansion<double, 1>& at) const {
    Expansion<double, 1> whole;
    expand(theta, force, whole);
    at.residual = whole.residual;
    at.end_point = whole.end_point;
  }
};

}  // namespace

TEST_CASE(
    "chord steps, with the factors of the first place, lead to the equilibrium that Newton's method finds") {
  const Chain<double> chain({1, 1, 1}, {1, 2, 1}, {0.2, -0.4, 0.3});
  const Vector<double> rest = absolute_angles(chain.rest());
  const Point<double> unloaded = end_point(chain, chain.rest());
  for (const Control control : {Control::end_point, Control::force}) {
    const Point<double> imposed = control == Control::force
                                      ? Point<double>{-0.02, 0.03}
                                      : Point<double>{unloaded.x - 0.02, unloaded.y + 0.01};
    const ChordModel model(chain);
    LoadedSystem<ChordModel> system(model);
    Vector<double> theta = rest;
    Point<double> force = control == Control::force ? imposed : Point<double>{0, 0};
    system.expand(theta, force);
    REQUIRE(system.factor(control));
    // each step leaves a share of the error that grows with the way from the first place, here less than a
    // half
    double turn = 1;
    for (int step = 0; step < 60; ++step) {
      turn = system.step_to(imposed);
      system.move(1, theta, force);
      system.balance(theta, force);
    }
    CHECK(turn < 1e-14);
    CHECK(system.at().residual.cwiseAbs().maxCoeff() < 1e-14);
    EquilibriumSolver<ChordModel> solver(model);
    const auto found = solver.under(control, imposed, rest, force);
    CHECK((found.theta - theta).cwiseAbs().maxCoeff() < 1e-13);
    CHECK(std::abs(found.force.x - force.x) < 1e-13);
    CHECK(std::abs(found.force.y - force.y) < 1e-13);
  }
}
