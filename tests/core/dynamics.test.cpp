#include <cmath>
#include <plumbline/dynamics/time_step.hpp>

#include "tests/close_to.hpp"
#include "tests/core/drawn_moving_arm.hpp"
#include "tests/property.hpp"

using namespace plumbline;

namespace {

const double pi = std::acos(-1.0);

/// A point mass on a massless rod of 0.8 m, hinged across gravity.
MovingArm<double> pendulum() {
  SerialArm<double> arm;
  arm.links.resize(1);
  arm.links[0].axis = {0, 1, 0};
  arm.links[0].mass = 1.3;
  arm.links[0].centre = {0, 0, -0.8};
  return MovingArm<double>(arm);
}

/// A block of 2 kg that slides along x.
MovingArm<double> slider() {
  SerialArm<double> arm;
  arm.links.resize(1);
  arm.links[0].kind = JointKind::prismatic;
  arm.links[0].axis = {1, 0, 0};
  arm.links[0].mass = 2;
  return MovingArm<double>(arm);
}

auto constant_forces(double drive, double damping, double dry) {
  return [=](const ArmState<double>& at) {
    const auto all = [&](double value) { return Vector<double>::Constant(at.q.size(), value).eval(); };
    return JointForces<double>{all(drive), all(damping), all(dry)};
  };
}

ArmState<double> one(double q, double v) {
  return {Vector<double>::Constant(1, q), Vector<double>::Constant(1, v)};
}

}  // namespace

TEST_CASE(
    "the mass matrix is the Hessian of the kinetic energy, column by column of recursive Newton-Euler") {
  check_property("M e_k = drive(e_k) - drive(0)", [] {
    const MovingArm<double> moving = drawn_moving_arm();
    const ArmState<double> state = drawn_state(moving);
    const Matrix<double> mass = mass_matrix(moving, state.q);
    const Vector<double> none = Vector<double>::Zero(state.q.size());
    const Vector<double> bias = inverse_dynamics(moving, state, none);
    for (Eigen::Index k = 0; k < state.q.size(); ++k) {
      Vector<double> unit = none;
      unit(k) = 1;
      const Vector<double> column = inverse_dynamics(moving, state, unit) - bias;
      // both sum at most a hundred products of numbers no larger than these
      const double rounding = 1e-13 * (mass.norm() + bias.norm() + 1);
      RC_ASSERT((column - mass.col(k)).norm() < rounding);
    }
  });
}

TEST_CASE("a drive does the work by which the mechanical energy grows") {
  check_property("d(energy)/dt = drive . v", [] {
    const MovingArm<double> moving = drawn_moving_arm();
    const ArmState<double> state = drawn_state(moving);
    const Vector<double> a = drawn_rates(moving);
    const double power = inverse_dynamics(moving, state, a).dot(state.v);
    // Central difference along q(t), v(t) with accelerations a: an error of h^2 f'''/6 and one of eps E / h.
    const double h = 1e-5;
    const auto energy = [&](double t) {
      return mechanical_energy<double>(moving, {state.q + t * state.v + t * t / 2 * a, state.v + t * a});
    };
    const double scale = std::abs(energy(0)) + std::abs(power) + state.v.squaredNorm() + a.squaredNorm() + 1;
    RC_ASSERT(std::abs((energy(h) - energy(-h)) / (2 * h) - power) < 1e-6 * scale);
  });
}

TEST_CASE("at rest the drives hold the loads of the same arm in statics") {
  check_property("drive(v = 0, a = 0) = -loads", [] {
    const MovingArm<double> moving = drawn_moving_arm();
    ArmState<double> state = drawn_state(moving);
    state.v.setZero();
    const std::vector<ArmWrench<double>> wrench{
        {OnLink<double>{moving.arm.size() - 1, moving.arm.tip}, {3, -2, 5}, {0.4, 0.1, -0.7}}};
    const Vector<double> held =
        inverse_dynamics<double>(moving, state, Vector<double>::Zero(state.q.size()), wrench);
    const Vector<double> loads = arm_loads(moving.arm, ArmPosture<double>(moving.arm, state.q), wrench).force;
    RC_ASSERT((held + loads).norm() < 1e-12 * (loads.norm() + 1));
  });
}

TEST_CASE("accelerations invert the drives, in fifty digits as in double") {
  const MovingArm<double> moving = drawn_moving_arm_of(7);
  const ArmState<double> state = drawn_state_of(moving, 7);
  const Vector<double> drive = drawn_state_of(moving, 8).v;
  const Vector<double> a = forward_dynamics(moving, state, drive);
  CHECK((inverse_dynamics(moving, state, a) - drive).norm() < 1e-11 * (1 + a.norm()));

  SerialArm<Mpfr50> arm;
  arm.links.resize(1);
  arm.links[0].axis = {Mpfr50(0), Mpfr50(1), Mpfr50(0)};
  arm.links[0].mass = Mpfr50(2);
  arm.links[0].centre = {Mpfr50(0), Mpfr50(0), Mpfr50(-3) / Mpfr50(10)};
  const MovingArm<Mpfr50> swinging(arm);
  const ArmState<Mpfr50> here{Vector<Mpfr50>::Constant(1, Mpfr50(1) / Mpfr50(2)),
                              Vector<Mpfr50>::Constant(1, Mpfr50(3))};
  const Mpfr50 fall = forward_dynamics<Mpfr50>(swinging, here, Vector<Mpfr50>::Zero(1))(0);
  using std::sin;
  const Mpfr50 expected = -Mpfr50(981) / Mpfr50(100) / (Mpfr50(3) / Mpfr50(10)) * sin(Mpfr50(1) / Mpfr50(2));
  CHECK(abs(fall - expected) < 100 * epsilon<Mpfr50>() * abs(expected));
}

TEST_CASE("a pendulum's period at 90 degrees is that of the elliptic integral") {
  // T = 4 K(sin 45 deg) sqrt(l/g), K = Gamma(1/4)^2 / (4 sqrt(pi))
  const double quarter = std::tgamma(0.25) * std::tgamma(0.25) / (4 * std::sqrt(pi)) * std::sqrt(0.8 / 9.81);
  ArmState<double> state = one(pi / 2, 0);
  for (int i = 0; i < 400; ++i) state = after(pendulum(), state, quarter / 400, constant_forces(0, 0, 0));
  const double step = quarter / 400 * std::sqrt(9.81 / 0.8);
  CHECK(std::abs(state.q(0)) < step * step);  // it hangs straight then; an error of second order
}

TEST_CASE("a step of half the length leaves a quarter of the error") {
  const MovingArm<double> moving = drawn_moving_arm_of(5);
  const auto end = [&](int steps) {
    ArmState<double> state = drawn_state_of(moving, 5);
    for (int i = 0; i < steps; ++i) state = after(moving, state, 0.1 / steps, constant_forces(0.3, 0.2, 0));
    return state.q;
  };
  const Vector<double> exact = (4 * end(400) - end(200)) / 3;  // Richardson
  CHECK((end(25) - exact).norm() / (end(50) - exact).norm() == doctest::Approx(4).epsilon(0.1));
}

TEST_CASE("energy neither grows nor falls over twenty thousand steps without friction") {
  const MovingArm<double> moving = drawn_moving_arm_of(3);
  ArmState<double> state = drawn_state_of(moving, 3);
  const double before = mechanical_energy(moving, state);
  const double kinetic = state.v.dot(mass_matrix(moving, state.q) * state.v) / 2;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    state = after(moving, state, 1e-4, constant_forces(0, 0, 0));
    worst = std::max(worst, std::abs(mechanical_energy(moving, state) - before));
  }
  CHECK(worst < 1e-3 * kinetic);
}

TEST_CASE("a sliding block stops where its friction has eaten its energy, and never moves again") {
  // 2 kg at 1 m/s against 4 N: 0.25 m in 0.5 s. The step in which it stops overshoots by at most v h / 2 = a
  // h^2 / 2.
  const double h = 1e-3;
  ArmState<double> state = one(0, 1);
  for (int i = 0; i < 600; ++i) state = after(slider(), state, h, constant_forces(0, 0, 4));
  CHECK(state.q(0) == doctest::Approx(0.25).epsilon(4 * h * h));
  CHECK(state.v(0) == 0);
  const double there = state.q(0);
  for (int i = 0; i < 1000; ++i) state = after(slider(), state, h, constant_forces(3.999, 0.3, 4));
  CHECK(state.q(0) == there);
}

TEST_CASE("viscous damping slows a block exponentially at any step length") {
  // v' = -c v / m by the implicit midpoint rule: v falls by (1 - x)/(1 + x), x = c h / (2 m), exactly
  ArmState<double> state = one(0, 1);
  const double x = 50 * 0.1 / 4;
  for (int i = 0; i < 10; ++i) state = after(slider(), state, 0.1, constant_forces(0, 50, 0));
  CHECK(state.v(0) == doctest::Approx(std::pow((1 - x) / (1 + x), 10)).epsilon(1e-12));
}

TEST_CASE("the rates under dry friction are the one minimum, and stuck ones are zero to the last bit") {
  check_property("optimality", [] {
    const auto n = static_cast<Eigen::Index>(*rc::gen::inRange(1, 9));
    const auto drawn = [](Eigen::Index rows, Eigen::Index columns) {
      return Matrix<double>::NullaryExpr(rows, columns, [] { return random_hundredths(-3, 3); }).eval();
    };
    const Matrix<double> root = drawn(n, n);
    const Matrix<double> inertia = root * root.transpose() + 0.05 * Matrix<double>::Identity(n, n);
    const Vector<double> momentum = drawn(n, 1), limit = drawn(n, 1).cwiseAbs();
    const Vector<double> rate = rates_under_dry_friction<double>(inertia, momentum, limit);
    const Vector<double> left = momentum - inertia * rate;
    const double rounding = 1e-10 * (momentum.norm() + limit.norm() + 1);
    for (Eigen::Index i = 0; i < n; ++i) {
      if (rate(i) == 0)
        RC_ASSERT(std::abs(left(i)) <= limit(i) + rounding);
      else
        RC_ASSERT(std::abs(left(i) - std::copysign(limit(i), rate(i))) < rounding);
    }
  });
}

TEST_CASE("without a limit friction changes nothing; with an endless one nothing moves") {
  Matrix<double> inertia(2, 2);
  inertia << 2, 1.9, 1.9, 2;
  const Vector<double> momentum = Eigen::Vector2d(1, -1);
  CHECK((inertia * rates_under_dry_friction<double>(inertia, momentum, Eigen::Vector2d(0, 0)) - momentum)
            .norm() < 1e-14);
  CHECK(rates_under_dry_friction<double>(inertia, momentum, Eigen::Vector2d(9, 9)) == Eigen::Vector2d(0, 0));
}

TEST_CASE("an arm that cannot move as a body is refused in words") {
  MovingArm<double> moving = pendulum();
  moving.inertia[0].diagonal() << 1, 1, 3;
  CHECK_THROWS_WITH(
      require_physical(moving),
      "link 1 of the arm: found an inertia that no body has, expected a symmetric matrix whose principal "
      "moments are each at most the sum of the others");
  moving = pendulum();
  moving.arm.links[0].mass = 0;
  CHECK_THROWS_WITH(
      require_physical(moving),
      "link 1 of the arm: found a joint that moves no mass, expected a mass, an inertia or an armature");
  moving.armature(0) = 0.01;
  CHECK_NOTHROW(require_physical(moving));
  moving.armature(0) = -1;
  CHECK_THROWS(require_physical(moving));
  moving = pendulum();
  moving.arm.links[0].compliance(0, 0) = 1e-6;
  CHECK_THROWS_WITH(require_physical(moving),
                    "link 1 of the arm: found a link that yields, expected rigid links between joints");
}
