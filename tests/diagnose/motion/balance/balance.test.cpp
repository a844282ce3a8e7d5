#include "diagnose/motion/balance/balance.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <plumbline/dynamics/inverse_dynamics.hpp>
#include <random>

#include "tests/close_to.hpp"

namespace plumbline::motion {
namespace {

constexpr double l1 = 0.3, l2 = 0.25, m1 = 0.6, r1 = 0.25, i1 = 0.004, m2 = 0.5, r2 = 0.18, i2 = 0.003,
                 dry1 = 0.09, dry2 = 0.07, viscous2 = 0.02, rotor2 = 0.002;

/// Two links that swing about z in a vertical plane and hang along -y at zero.
diagnose::NominalArm double_pendulum() {
  diagnose::NominalArm nominal;
  nominal.arm.gravity = {0, -9.81, 0};
  nominal.arm.links.resize(2);
  nominal.arm.links[1].frame.translation() = Eigen::Vector3d(0, -l1, 0);
  nominal.arm.links[0].mass = m1, nominal.arm.links[0].centre = {0, -r1, 0};
  nominal.arm.links[1].mass = m2, nominal.arm.links[1].centre = {0, -r2, 0};
  nominal.arm.tip.translation() = Eigen::Vector3d(0, -l2, 0);
  nominal.joint = {"one", "two"}, nominal.link = {"upper", "lower"};
  return nominal;
}

/// About the joints: of slender rods along y.
std::vector<Eigen::Matrix3d> inertias() {
  std::vector<Eigen::Matrix3d> all(2, Eigen::Matrix3d::Zero());
  all[0](0, 0) = all[0](2, 2) = i1 + m1 * r1 * r1, all[1](0, 0) = all[1](2, 2) = i2 + m2 * r2 * r2;
  return all;
}

MovingArm<double> moving_pendulum() {
  MovingArm<double> moving(double_pendulum().arm);
  moving.inertia[0](2, 2) = i1, moving.inertia[1](2, 2) = i2;
  moving.armature(1) = rotor2;
  return moving;
}

/// Ten seconds at 200 Hz of two sines a joint; torques by the equations of motion, `lead` ahead of the
/// motion.
TorqueLog log_of(double sigma, double lead, unsigned seed,
                 const MovingArm<double>& moving = moving_pendulum()) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0, sigma);
  TorqueLog log{"log", {}, Eigen::MatrixXd(2000, 2), Eigen::MatrixXd(2000, 2)};
  const auto state_at = [&](double t) {
    Eigen::MatrixXd state(2, 3);
    const double w[2][2] = {{2.1, 5.3}, {3.2, 7.7}}, size[2][2] = {{0.9, 0.3}, {0.7, 0.4}};
    for (Eigen::Index j = 0; j < 2; ++j) {
      state.row(j).setZero();
      for (int s = 0; s < 2; ++s) {
        const double rate = w[j][s] + 0.1 * seed, phase = rate * t + static_cast<double>(j);
        state(j, 0) += size[j][s] * std::sin(phase), state(j, 1) += size[j][s] * rate * std::cos(phase);
        state(j, 2) -= size[j][s] * rate * rate * std::sin(phase);
      }
    }
    return state;
  };
  for (Eigen::Index k = 0; k < 2000; ++k) {
    const double t = 0.005 * static_cast<double>(k);
    log.time.push_back(t);
    const Eigen::MatrixXd now = state_at(t), then = state_at(t + lead);
    log.angle.row(k) = now.col(0).transpose();
    Eigen::VectorXd torque =
        inverse_dynamics(moving, {then.col(0), then.col(1)}, Eigen::VectorXd(then.col(2)));
    torque(0) += dry1 * (then(0, 1) > 0 ? 1 : -1);
    torque(1) += dry2 * (then(1, 1) > 0 ? 1 : -1) + viscous2 * then(1, 1);
    for (Eigen::Index j = 0; j < 2; ++j)
      log.angle(k, j) += noise(generator), torque(j) += 30 * noise(generator);
    log.torque.row(k) = torque.transpose();
  }
  return log;
}

std::map<std::string, BalanceNumber> by_name(const Balance& balance) {
  std::map<std::string, BalanceNumber> numbers;
  for (const BalanceNumber& one : balance.numbers) numbers[one.name.substr(0, one.name.find(')') + 1)] = one;
  return numbers;
}

}  // namespace

TEST_CASE("columns times a body's own terms are the torque of its equations of motion") {
  const diagnose::NominalArm nominal = double_pendulum();
  MovingArm<double> moving(nominal.arm);
  moving.inertia[0](2, 2) = i1, moving.inertia[1](2, 2) = i2;
  const Eigen::Vector2d q(0.4, -0.9), v(1.1, 2.3), a(-3, 5);
  const Eigen::VectorXd terms = stated_terms(nominal, inertias());
  // Of inertias about the other axes nothing turns a planar arm.
  const Eigen::VectorXd torque = balance_columns(nominal, q, v, a) * terms;
  const Eigen::VectorXd expected = inverse_dynamics<double>(moving, {q, v}, a);
  for (Eigen::Index j = 0; j < 2; ++j) CHECK(torque(j) == close_to(expected(j)));
}

TEST_CASE(
    "a double pendulum's inertias, first moments and frictions are found, and what no log tells apart is "
    "one") {
  TorqueBench bench{"pendulum",
                    double_pendulum(),
                    inertias(),
                    {log_of(1e-4, 0, 1), log_of(1e-4, 0, 2)},
                    {log_of(1e-4, 0, 3)}};
  const Balance balance = balance_of(bench);
  auto number = by_name(balance);
  const std::map<std::string, double> truth{{"Izz(1)", i1 + m1 * r1 * r1 + m2 * l1 * l1},
                                            {"Izz(2)", i2 + m2 * r2 * r2},
                                            {"my(1)", -(m1 * r1 + m2 * l1)},
                                            {"my(2)", -m2 * r2},
                                            {"dry friction(1)", dry1},
                                            {"dry friction(2)", dry2},
                                            {"viscous friction(2)", viscous2},
                                            {"armature(2)", rotor2}};
  for (const auto& [name, value] : truth) {
    CAPTURE(name);
    REQUIRE(number.count(name) == 1);
    CHECK(number[name].low <= number[name].high);
    // The intervals are those of the noise; the window's own error of derivatives, (w dt)^4 / 24 of the
    // fastest sine (7.9 rad/s, 50 ms), is a thousandth, and friction changes sides within a mean of 0.1 s.
    CHECK(number[name].value == doctest::Approx(value).epsilon(0.03));
  }
  for (const char* name : {"Izz(1)", "Izz(2)", "my(1)", "my(2)"})  // no rotor or friction is stated
    CHECK(number[name].stated == doctest::Approx(truth.at(name)).epsilon(1e-3));
  CHECK(number["Izz(1)"].name.find("m(2)") != std::string::npos);
  CHECK(number["Izz(1)"].name.find("armature(1)") != std::string::npos);
  CHECK(balance.lead == 0);
  for (const double left : balance.left.back().found)
    CHECK(left < 0.02);  // noise of 3e-3 N m, and friction's turns
}

TEST_CASE(
    "what no torque depends on is in no number: first moments of a link that turns about the vertical") {
  diagnose::NominalArm upright = double_pendulum();
  upright.arm.gravity = {0, 0, -9.81};  // along the axes
  const Balance balance = balance_of({"pendulum", upright, inertias(), {log_of(1e-4, 0, 1)}, {}});
  REQUIRE(!balance.numbers.empty());
  for (const BalanceNumber& one : balance.numbers) {
    CAPTURE(one.name);
    for (const char* term : {"mx(1)", "my(1)", "mz(1)", "mz(2)"})
      CHECK(one.name.find(term) == std::string::npos);
  }
}

TEST_CASE("a model that is right is the first of its changes, and contradicts itself in nothing") {
  const Balance balance = balance_of({"pendulum", double_pendulum(), inertias(), {log_of(1e-4, 0, 1)}, {}});
  CHECK(balance.causes.front().id == "as_stated");
  CHECK(balance.contradictions.empty());
}

TEST_CASE("a load at the tip is told from another torque constant, with its mass") {
  constexpr double load = 0.4;
  MovingArm<double> moving = moving_pendulum();
  ArmLink<double>& link = moving.arm.links[1];
  link.mass = m2 + load, link.centre = {0, -(m2 * r2 + load * l2) / link.mass, 0};
  const double r = -link.centre.y();
  moving.inertia[1](2, 2) = i2 + m2 * (r2 - r) * (r2 - r) + load * (l2 - r) * (l2 - r);
  const Balance balance =
      balance_of({"pendulum", double_pendulum(), inertias(), {log_of(1e-4, 0, 1, moving)}, {}});
  const BalanceCause& first = balance.causes.front();
  CHECK(first.id == "payload");
  CHECK(first.probability > 0.95);
  // As accurate as derivatives and turns of friction within a mean let it be (above).
  CHECK(first.numbers.front().value == doctest::Approx(load).epsilon(0.03));
}

TEST_CASE("a drive whose torque is told a third too large is told by its joint") {
  TorqueLog log = log_of(1e-4, 0, 1);
  log.torque.col(1) *= 1.3;
  const Balance balance = balance_of({"pendulum", double_pendulum(), inertias(), {log}, {}});
  CHECK(balance.causes.front().id == "torque_constant(2)");
  CHECK(balance.causes.front().numbers.front().value == doctest::Approx(0.3).epsilon(0.1));
}

TEST_CASE("an inertia that no body has is told as a contradiction of the model") {
  std::vector<Eigen::Matrix3d> impossible = inertias();
  impossible[1](2, 2) = 0;  // less than that of its mass at its centre
  const Balance balance = balance_of({"pendulum", double_pendulum(), impossible, {log_of(1e-4, 0, 1)}, {}});
  REQUIRE(balance.contradictions.size() == 1);
  CHECK(balance.contradictions.back().find("lower") != std::string::npos);
}

TEST_CASE("a torque that is ahead of its motion is told") {
  TorqueBench bench{"pendulum", double_pendulum(), inertias(), {log_of(1e-4, 0.008, 1)}, {}};
  CHECK(balance_of(bench).lead == close_to(0.008));
}

}  // namespace plumbline::motion
