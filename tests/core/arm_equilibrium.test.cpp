#include <plumbline/arm/arm_equilibrium.hpp>

#include <plumbline/loaded/equilibrium.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using Eigen::Matrix3d, Eigen::Vector3d, Eigen::VectorXd;

namespace {

Vector3d random_vector(int size) {
  return {random_hundredths(-size, size), random_hundredths(-size, size), random_hundredths(-size, size)};
}

Pose<double> random_pose() {
  Pose<double> pose = Pose<double>::Identity();
  pose.linear() = rotation_by(random_vector(2));
  pose.translation() = random_vector(1);
  return pose;
}

/// One to six links on joints about any axes, one in three of which slides; one link in three yields.
SerialArm<double> random_arm() {
  SerialArm<double> arm;
  arm.base = random_pose();
  arm.gravity = random_vector(10);
  arm.tip = random_pose();
  arm.links.resize(static_cast<std::size_t>(*rc::gen::inRange(1, 7)));
  for (ArmLink<double>& link : arm.links) {
    link.kind = *rc::gen::inRange(0, 3) == 0 ? JointKind::prismatic : JointKind::revolute;
    link.frame = random_pose();
    link.axis = (random_vector(1) + Vector3d(0, 0, 1.5)).normalized();
    link.joint_compliance = random_hundredths(0, 2) * 1e-4;
    link.mass = random_hundredths(0, 10);
    link.centre = random_vector(1);
    if (*rc::gen::inRange(0, 3) > 0) continue;
    const Matrix6<double> half = 1e-3 * Matrix6<double>::Random();
    link.compliance = half * half.transpose();
    link.far_mass = random_hundredths(0, 10);
    link.far_centre = random_vector(1);
  }
  return arm;
}

std::vector<ArmWrench<double>> random_wrenches(const SerialArm<double>& arm) {
  std::vector<ArmWrench<double>> all;
  for (std::size_t i = 0; i < arm.size(); ++i)
    all.push_back({{i, random_pose()}, random_vector(20), random_vector(5)});
  return all;
}

VectorXd random_coordinates(Eigen::Index count) {
  VectorXd q(count);
  for (double& one : q) one = random_hundredths(-3, 3);
  return q;
}

Eigen::Index size_of(const SerialArm<double>& arm) {
  return static_cast<Eigen::Index>(arm.size());
}

/// What gravity and the forces of the wrenches have done, J.
double work(const SerialArm<double>& arm, const std::vector<ArmWrench<double>>& wrenches, const VectorXd& u) {
  const ArmPosture<double> posture(arm, u);
  double sum = 0;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmLink<double>& link = arm.links[i];
    sum += arm.gravity.dot(link.mass * (posture.frame(i) * link.centre) +
                           link.far_mass * (posture.far_frame(i) * link.far_centre));
  }
  for (const ArmWrench<double>& one : wrenches) sum += one.force.dot(posture.of(one.at).translation());
  return sum;
}

/// Links along x, joints about z: the chain in the plane.
SerialArm<double> planar(const std::vector<double>& length, const std::vector<double>& stiffness) {
  SerialArm<double> arm;
  for (std::size_t i = 0; i < length.size(); ++i) {
    ArmLink<double> link;
    if (i > 0) link.frame.translation() = Vector3d(length[i - 1], 0, 0);
    link.joint_compliance = 1 / stiffness[i];
    link.centre = Vector3d(length[i] / 2, 0, 0);
    arm.links.push_back(link);
  }
  arm.tip.translation() = Vector3d(length.back(), 0, 0);
  return arm;
}

}  // namespace

TEST_CASE(
    "generalised forces on an arm are the derivatives of the work, and their stiffness its second ones") {
  check_property("derivatives", [] {
    const SerialArm<double> arm = random_arm();
    std::vector<ArmWrench<double>> wrenches = random_wrenches(arm);
    for (ArmWrench<double>& one : wrenches) one.moment.setZero();
    const VectorXd u = random_coordinates(static_cast<Eigen::Index>(freedoms(arm)));
    const ArmLoads<double> loads = arm_loads(arm, ArmPosture<double>(arm, u), wrenches);
    // central differences err by h^2 of third derivatives, and by rounding over h: work of 1e3 J at most
    const double h = 1e-5, slack = 1e-4;
    for (Eigen::Index k = 0; k < u.size(); ++k) {
      VectorXd ahead = u, behind = u;
      ahead(k) += h, behind(k) -= h;
      const double slope = (work(arm, wrenches, ahead) - work(arm, wrenches, behind)) / (2 * h);
      RC_ASSERT(std::abs(loads.force(k) - slope) < slack);
      const VectorXd change = arm_loads(arm, ArmPosture<double>(arm, ahead), wrenches).force -
                              arm_loads(arm, ArmPosture<double>(arm, behind), wrenches).force;
      RC_ASSERT((loads.stiffness.col(k) - change / (2 * h)).cwiseAbs().maxCoeff() < slack);
    }
  });
}

TEST_CASE("moments on an arm: their stiffness is the derivative of their generalised forces") {
  check_property("moments", [] {
    const SerialArm<double> arm = random_arm();
    const std::vector<ArmWrench<double>> wrenches = random_wrenches(arm);
    const VectorXd u = random_coordinates(static_cast<Eigen::Index>(freedoms(arm)));
    const ArmLoads<double> loads = arm_loads(arm, ArmPosture<double>(arm, u), wrenches);
    const double h = 1e-5, slack = 1e-4;  // as above
    for (Eigen::Index k = 0; k < u.size(); ++k) {
      VectorXd ahead = u, behind = u;
      ahead(k) += h, behind(k) -= h;
      const VectorXd change = arm_loads(arm, ArmPosture<double>(arm, ahead), wrenches).force -
                              arm_loads(arm, ArmPosture<double>(arm, behind), wrenches).force;
      RC_ASSERT((loads.stiffness.col(k) - change / (2 * h)).cwiseAbs().maxCoeff() < slack);
    }
  });
}

TEST_CASE("at rest the arm yields by compliance times load") {
  check_property("balance", [] {
    const SerialArm<double> arm = random_arm();
    const std::vector<ArmWrench<double>> wrenches = random_wrenches(arm);
    const VectorXd q = random_coordinates(size_of(arm)), u = equilibrium(arm, q, wrenches);
    const VectorXd yielded = compliance(arm) * arm_loads(arm, ArmPosture<double>(arm, u), wrenches).force;
    // rounding of coordinates up to three
    RC_ASSERT((u - commanded(arm, q) - yielded).cwiseAbs().maxCoeff() < 1e-14);
  });
}

TEST_CASE("an arm whose axes are parallel is the chain in the plane") {
  check_property("plane", [] {
    const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 6));
    std::vector<double> length, stiffness;
    VectorXd q(static_cast<Eigen::Index>(n)), theta(q.size());
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      length.push_back(random_hundredths(1, 3));
      stiffness.push_back(random_hundredths(50, 90));
      q(static_cast<Eigen::Index>(i)) = random_hundredths(-1, 1);
      theta(static_cast<Eigen::Index>(i)) = sum += q(static_cast<Eigen::Index>(i));
    }
    SerialArm<double> arm = planar(length, stiffness);
    arm.gravity = {0, -1, 0};
    std::vector<Point<double>> weight;
    for (ArmLink<double>& link : arm.links) {
      link.mass = random_hundredths(0, 1);
      weight.push_back({0, -link.mass});
    }
    const Point<double> force{random_hundredths(-1, 1), random_hundredths(-1, 1)};
    const NominalModel<double> model(
        Chain<double>(length, stiffness, std::vector<double>(q.begin(), q.end())), weight);
    const Equilibrium<double> chain =
        EquilibriumSolver<NominalModel<double>>(model).under_force(force, theta);
    const VectorXd u = equilibrium(arm, q, {{{n - 1, arm.tip}, Vector3d(force.x, force.y, 0)}});
    double before = 0;
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      // the chain's solver stops at residuals of 1e-12 of its stiffest joint
      RC_ASSERT(std::abs(u(i) - (chain.theta(i) - before)) < 1e-10);
      before = chain.theta(i);
    }
  });
}

TEST_CASE("without load the tip yields by J C J', as virtual-joint models have it") {
  check_property("compliance", [] {
    SerialArm<double> arm = random_arm();
    arm.gravity.setZero();
    const VectorXd q = random_coordinates(size_of(arm)), start = commanded(arm, q);
    const ArmPosture<double> free(arm, start);
    const OnLink<double> tip{arm.size() - 1, arm.tip};
    const Vector3d place = free.of(tip).translation(), push = random_vector(1);
    Eigen::Matrix3Xd jacobian(3, start.size());
    for (Eigen::Index k = 0; k < start.size(); ++k)
      jacobian.col(k) = free.freedoms()[static_cast<std::size_t>(k)].velocity(place);
    const double small = 1e-4;  // N: what is of second order is below 1e-8 of the first
    const ArmPosture<double> loaded(arm, equilibrium(arm, q, {{tip, small * push}}));
    const Vector3d yielded = (loaded.of(tip).translation() - place) / small;
    // positions of a few metres are rounded to 1e-15, over 1e-4 N
    RC_ASSERT((yielded - jacobian * compliance(arm) * jacobian.transpose() * push).norm() < 1e-9);
  });
}

TEST_CASE("a rigid motion of everything moves the arm at rest as it is") {
  check_property("invariance", [] {
    SerialArm<double> arm = random_arm();
    std::vector<ArmWrench<double>> wrenches = random_wrenches(arm);
    const VectorXd q = random_coordinates(size_of(arm)), u = equilibrium(arm, q, wrenches);
    const Pose<double> motion = random_pose();
    arm.base = motion * arm.base;
    arm.gravity = motion.linear() * arm.gravity;
    for (ArmWrench<double>& one : wrenches) {
      one.force = motion.linear() * one.force;
      one.moment = motion.linear() * one.moment;
    }
    RC_ASSERT((equilibrium(arm, q, wrenches) - u).cwiseAbs().maxCoeff() < 1e-13);
  });
}

TEST_CASE("units: loads times ten with stiffnesses times ten move nothing") {
  check_property("scaling", [] {
    SerialArm<double> arm = random_arm();
    std::vector<ArmWrench<double>> wrenches = random_wrenches(arm);
    const VectorXd q = random_coordinates(size_of(arm)), u = equilibrium(arm, q, wrenches);
    arm.gravity *= 10;
    for (ArmLink<double>& link : arm.links) link.joint_compliance /= 10, link.compliance /= 10;
    for (ArmWrench<double>& one : wrenches) one.force *= 10, one.moment *= 10;
    RC_ASSERT((equilibrium(arm, q, wrenches) - u).cwiseAbs().maxCoeff() < 1e-13);
  });
}

TEST_CASE("a horizontal cantilever on a soft joint hangs where its moment balances the spring") {
  SerialArm<double> arm = planar({1}, {20});
  arm.gravity = {0, -10, 0};
  arm.links[0].mass = 2;
  const double q = equilibrium(arm, VectorXd(VectorXd::Zero(1)), {})(0);
  CHECK(20 * q == close_to(-10 * std::cos(q)));
}

TEST_CASE("a mass that moves with the far end of a link turns it as a weight there, and loads the base") {
  SerialArm<double> arm = planar({1}, {20});
  arm.gravity = {0, -10, 0};
  arm.links[0].joint_compliance = 0;
  arm.links[0].compliance(5, 5) = 1e-2;
  arm.links[0].far_mass = 2, arm.links[0].far_centre = {1.5, 0, 0};
  require_physical(arm);
  const VectorXd u = equilibrium(arm, VectorXd(VectorXd::Zero(1)), {});
  const double turn = u(6);
  CHECK(turn == close_to(-1e-2 * 20 * 0.5 * std::cos(turn)));
  CHECK(moment_on_base(arm, ArmPosture<double>(arm, u), {}).z() ==
        close_to(-20 * (1 + 0.5 * std::cos(turn))));
  arm.links[0].compliance.setZero();
  CHECK_THROWS_WITH_AS(require_physical(arm), doctest::Contains("far end, which does not yield"), Error);
}

TEST_CASE("an arm that buckles is told") {
  const SerialArm<double> arm = planar({1}, {2});  // it buckles at 2 N
  const auto pushed = [&](double force) {
    return equilibrium(arm, VectorXd(VectorXd::Zero(1)), {{{0, arm.tip}, Vector3d(-force, 0, 0)}});
  };
  CHECK(pushed(1.99).norm() == 0);
  CHECK_THROWS_WITH_AS(pushed(2.01), doctest::Contains("arm: found no stable rest near its command"), Error);
}

TEST_CASE("rotation vectors and rotations are each other's inverse") {
  check_property("round trip", [] {
    const Vector3d vector = random_vector(1);
    RC_ASSERT((rotation_vector<double>(rotation_by(vector)) - vector).norm() < 1e-14);
  });
}
