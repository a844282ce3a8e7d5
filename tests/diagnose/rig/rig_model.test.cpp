#include "diagnose/rig/rig_model.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "diagnose/rig/nominal.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const std::vector<double> rest_of_rig{0.3, -0.5, 0.4};

/// Every part of a rig that the equations of one shape know, each of another size; links bend and joints
/// couple where asked.
Rig full_rig(bool bending, bool coupled) {
  Rig rig = nominal_rig(three_links());
  rig.rest_error = {0.01, -0.02, 0.03};
  rig.hardening = {0.7, -0.3, 1.1};
  rig.asymmetry = {0.1, -0.05, 0.2};
  rig.knee = {0.05, 0.3, 0.1};
  rig.give = {0.3, 0.6, 0.2};
  rig.coupling = coupled ? 0.4 : 0;
  rig.flexibility = bending ? 0.6 : 0;
  rig.axial = 0.011;
  rig.tip_stiffness = 0.35;
  rig.weight = {{0.1, -0.7}, {-0.2, -0.5}, {0.3, -0.4}};
  rig.payload = {0.15, -0.6};
  rig.base_compliance = {0.002, 0.003};
  rig.train_compliance = 0.004;
  return rig;
}

/// Moments at the joints, and forces at the end, within and at the beginning of links.
ChainLoads loads_along() {
  return {{0.3, -0.2, 0.15}, {{2, 1, {0.4, -0.6}}, {1, 0.35, {-0.7, 0.2}}, {0, 0, {3, 5}}}};
}

/// A rig that carries no history, and its model at one shape under one force and loads along the chain.
template <int Bandwidth>
struct Loaded {
  explicit Loaded(const Rig& rig, ChainLoads along = {})
      : run(rig, rest_of_rig),
        loads(std::move(along)),
        memory(3),
        step{run, {}, memory},
        layout{3, rig.flexibility > 0, rig.coupling != 0, 0},
        model(layout) {
    angle.resize(static_cast<Eigen::Index>(layout.nodes()));
    for (Eigen::Index i = 0; i < angle.size(); ++i) angle(i) = 0.25 + 0.4 * std::sin(1.7 * double(i) + 0.3);
    model.become(step, loads, contact);
  }

  Expansion<double, Bandwidth> at(const Vector<double>& shape, const Point<double>& load) const {
    Expansion<double, Bandwidth> one;
    model.expand(shape, load, one);
    return one;
  }

  RunRig run;
  ChainLoads loads;
  std::vector<JointMemory> memory;
  RigStep step;
  std::vector<Contact> contact;
  Layout layout;
  RigModel<Bandwidth> model;
  Vector<double> angle;
  Point<double> force{-1.3, 0.8};
};

/// Central differences by 1e-5 err by rounding over the step, 1e-11, and by its square, 1e-10.
constexpr double difference_step = 1e-5;

doctest::Approx quotient(double value) {
  return doctest::Approx(value).epsilon(1e-8).scale(1);
}

/// The stiffness between two unknowns; nothing beyond the band.
template <int Bandwidth>
double stiffness(const Expansion<double, Bandwidth>& at, Eigen::Index i, Eigen::Index j) {
  const Eigen::Index apart = std::abs(i - j);
  return apart > Bandwidth ? 0 : at.hessian(apart, std::min(i, j));
}

/// Derivatives at any shape and force: first ones of energy and end point, second ones of the energy. An
/// eccentric load has a residual of its own.
template <int Bandwidth>
void check_derivatives(const Rig& rig, const ChainLoads& loads = {}) {
  const Loaded<Bandwidth> loaded(rig, loads);
  const auto here = loaded.at(loaded.angle, loaded.force);
  for (Eigen::Index i = 0; i < loaded.angle.size(); ++i) {
    CAPTURE(i);
    Vector<double> up = loaded.angle, down = up;
    up(i) += difference_step, down(i) -= difference_step;
    const auto above = loaded.at(up, loaded.force), below = loaded.at(down, loaded.force);
    const double per = 1 / (2 * difference_step);
    const double dx = (above.end_point.x - below.end_point.x) * per,
                 dy = (above.end_point.y - below.end_point.y) * per;
    CHECK(here.end_point_gradient(i, 0) == quotient(dx));
    CHECK(here.end_point_gradient(i, 1) == quotient(dy));
    if (rig.eccentricity == 0)
      CHECK(here.residual(i) ==
            quotient((above.energy - below.energy) * per - loaded.force.x * dx - loaded.force.y * dy));
    for (Eigen::Index j = 0; j < loaded.angle.size(); ++j)
      CHECK(stiffness(here, j, i) == quotient((above.residual(j) - below.residual(j)) * per));
  }
  for (const int axis : {0, 1}) {
    Point<double> more = loaded.force, less = more;
    (axis == 0 ? more.x : more.y) += difference_step;
    (axis == 0 ? less.x : less.y) -= difference_step;
    const auto above = loaded.at(loaded.angle, more), below = loaded.at(loaded.angle, less);
    const double per = 1 / (2 * difference_step);
    CHECK(here.compliance(0, axis) == quotient((above.end_point.x - below.end_point.x) * per));
    CHECK(here.compliance(1, axis) == quotient((above.end_point.y - below.end_point.y) * per));
    // The stored energy is Phi + F . p, and -dPhi/dF is the end point p.
    const double work = loaded.force.x * (above.end_point.x - below.end_point.x) +
                        loaded.force.y * (above.end_point.y - below.end_point.y);
    CHECK((above.energy - below.energy) * per == quotient(work * per));
    for (Eigen::Index i = 0; i < loaded.angle.size(); ++i)
      CHECK(here.force_gradient(i, axis) == quotient(-(above.residual(i) - below.residual(i)) * per));
  }
}

/// Residual and end point alone are those of the whole expansion.
template <int Bandwidth>
void check_balance(const Rig& rig) {
  const Loaded<Bandwidth> loaded(rig);
  const auto here = loaded.at(loaded.angle, loaded.force);
  Expansion<double, Bandwidth> alone;
  loaded.model.balance(loaded.angle, loaded.force, alone);
  CHECK((alone.residual - here.residual).cwiseAbs().maxCoeff() < 1e-14);
  CHECK(alone.end_point.x == close_to(here.end_point.x).epsilon(1e-14));
  CHECK(alone.end_point.y == close_to(here.end_point.y).epsilon(1e-14));
}

}  // namespace

TEST_CASE("the residual is the gradient of energy less work, the stiffness its derivative") {
  check_derivatives<1>(full_rig(false, false));
  check_derivatives<2>(full_rig(false, true));
  check_derivatives<2>(full_rig(true, false));
  check_derivatives<4>(full_rig(true, true));
}

TEST_CASE("so it is under loads along the chain") {
  check_derivatives<1>(full_rig(false, false), loads_along());
  check_derivatives<2>(full_rig(true, false), loads_along());
  check_derivatives<4>(full_rig(true, true), loads_along());
}

TEST_CASE("an eccentric load turns the last link; its stiffness is the derivative of the residual") {
  for (const bool bending : {false, true}) {
    Rig rig = full_rig(bending, false);
    const Loaded<2> without(rig);
    rig.eccentricity = 0.02;
    const Loaded<2> with(rig);
    const auto before = without.at(without.angle, without.force), after = with.at(with.angle, with.force);
    const Eigen::Index tip = with.angle.size() - 1;
    const double along = std::cos(with.angle(tip)) * with.force.x + std::sin(with.angle(tip)) * with.force.y;
    CHECK(after.residual(tip) - before.residual(tip) == close_to(0.02 * along).epsilon(1e-12));
    CHECK((after.residual - before.residual).head(tip).cwiseAbs().maxCoeff() == 0);
    CHECK(after.energy == before.energy);
    check_derivatives<2>(rig);
  }
}

TEST_CASE("residual and end point alone equal those of the whole expansion") {
  check_balance<1>(full_rig(false, false));
  check_balance<2>(full_rig(true, false));
  check_balance<4>(full_rig(true, true));
  Rig beside = full_rig(false, false);
  beside.eccentricity = 0.02;
  check_balance<1>(beside);
}

TEST_CASE("a straight chain of rigid links under its weights, by hand") {
  Rig rig = nominal_rig(three_links());
  rig.weight = {{0, -3}, {0, -5}, {0, -7}};
  rig.payload = {0, -2};
  Loaded<1> loaded(rig);
  loaded.angle.setZero();
  loaded.force = {0, 1.5};
  const auto here = loaded.at(loaded.angle, loaded.force);
  // Each joint's spring, k_i (q_i - rest_i) with q = 0, less that of the next; less the moment of what a link
  // passes on at its end and of half its own weight: -L_j (F_y + payload + weights beyond + own / 2).
  const double spring[] = {2 * -0.3, 1.5 * 0.5, -0.4};
  CHECK(here.residual(0) == close_to(spring[0] - spring[1] - 0.20 * (1.5 - 2 - 7 - 5 - 1.5)));
  CHECK(here.residual(1) == close_to(spring[1] - spring[2] - 0.25 * (1.5 - 2 - 7 - 2.5)));
  CHECK(here.residual(2) == close_to(spring[2] - 0.15 * (1.5 - 2 - 3.5)));
  CHECK(here.end_point.x == close_to(0.6));
  CHECK(here.end_point.y == 0);
}

TEST_CASE("a link of constant curvature stores EI / 2 r^2 per length, and its end lies on the arc") {
  Rig rig = nominal_rig(three_links());
  rig.flexibility = 0.5;  // EI = 2
  Loaded<2> loaded(rig);
  loaded.force = {0, 0};
  // Link 1, 0.2 long, turns by 0.1 between its ends; the others are straight on, and joints keep the rest.
  loaded.angle << 0.3, 0.35, 0.4, -0.1, -0.1, -0.1, 0.3, 0.3, 0.3;
  const auto here = loaded.at(loaded.angle, loaded.force);
  CHECK(here.energy == close_to(2 * 0.1 * 0.1 / (2 * 0.2)).epsilon(1e-12));
  // Of the arc: r (sin 0.4 - sin 0.3, cos 0.3 - cos 0.4) with r = 0.2 / 0.1. Three points of Gauss miss
  // (0.1 / 2)^6 / 15750 of it.
  const double x = 2 * (std::sin(0.4) - std::sin(0.3)) + 0.25 * std::cos(-0.1) + 0.15 * std::cos(0.3);
  const double y = 2 * (std::cos(0.3) - std::cos(0.4)) + 0.25 * std::sin(-0.1) + 0.15 * std::sin(0.3);
  CHECK(here.end_point.x == close_to(x).epsilon(1e-11));
  CHECK(here.end_point.y == close_to(y).epsilon(1e-11));
}
