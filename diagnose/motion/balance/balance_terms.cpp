#include "diagnose/motion/balance/balance_terms.hpp"

#include <fmt/format.h>

#include <array>
#include <plumbline/dynamics/inverse_dynamics.hpp>

namespace plumbline::motion {
namespace {

using Eigen::Index, Eigen::Matrix3d, Eigen::Vector3d;

constexpr std::array of_link{"m", "mx", "my", "mz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};
constexpr std::array of_joint{"armature", "viscous friction", "dry friction", "offset"};
static_assert(std::ssize(of_link) == terms_of_link && std::ssize(of_joint) == terms_of_joint);

/// A link of mass one, its centre here, and no inertia about the origin of its frame. No body is like that,
/// and the equations do not mind.
void set_point(MovingArm<double>& moving, std::size_t link, const Vector3d& centre) {
  moving.arm.links[link].mass = 1;
  moving.arm.links[link].centre = centre;
  moving.inertia[link] = -(centre.squaredNorm() * Matrix3d::Identity() - centre * centre.transpose());
}

Matrix3d unit_inertia(std::size_t number) {
  constexpr std::array<std::array<Index, 2>, 6> places{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  Matrix3d inertia = Matrix3d::Zero();
  const auto [row, column] = places[number];
  inertia(row, column) = inertia(column, row) = 1;
  return inertia;
}

double sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

}  // namespace

std::vector<BalanceTerm> balance_terms(std::size_t joints) {
  std::vector<BalanceTerm> all;
  for (std::size_t i = 1; i <= joints; ++i)
    for (std::size_t k = 0; k < of_link.size(); ++k)
      all.push_back({fmt::format("{}({})", of_link[k], i), k == 0 ? "kg" : k < 4 ? "kg m" : "kg m^2"});
  constexpr std::array units{"kg m^2", "N m s/rad", "N m", "N m"};
  for (std::size_t i = 1; i <= joints; ++i)
    for (std::size_t k = 0; k < of_joint.size(); ++k)
      all.push_back({fmt::format("{}({})", of_joint[k], i), units[k]});
  return all;
}

Eigen::MatrixXd balance_columns(const diagnose::NominalArm& arm, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& v, const Eigen::VectorXd& a) {
  const auto n = static_cast<Index>(arm.arm.size());
  MovingArm<double> empty(arm.arm);
  for (ArmLink<double>& link : empty.arm.links) link.mass = 0, link.centre.setZero();
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(n, n * static_cast<Index>(of_link.size() + of_joint.size()));
  const ArmState<double> state{q, v};
  Index column = 0;
  for (std::size_t i = 0; i < arm.arm.size(); ++i) {
    MovingArm<double> moving = empty;
    set_point(moving, i, Vector3d::Zero());
    const Eigen::VectorXd mass = inverse_dynamics(moving, state, a);
    columns.col(column++) = mass;
    for (Index axis = 0; axis < 3; ++axis) {
      set_point(moving, i, Vector3d::Unit(axis));
      columns.col(column++) = inverse_dynamics(moving, state, a) - mass;
    }
    moving = empty;
    for (std::size_t k = 0; k < 6; ++k) {
      moving.inertia[i] = unit_inertia(k);
      columns.col(column++) = inverse_dynamics(moving, state, a);
    }
  }
  for (Index j = 0; j < n; ++j)
    for (const double one : {a(j), v(j), sign_of(v(j)), 1.0}) columns(j, column++) = one;
  return columns;
}

Eigen::VectorXd stated_terms(const diagnose::NominalArm& arm, const std::vector<Matrix3d>& inertia) {
  const auto per_link = static_cast<Index>(of_link.size());
  const auto n = static_cast<Index>(arm.arm.size());
  Eigen::VectorXd stated = Eigen::VectorXd::Zero(n * (per_link + static_cast<Index>(of_joint.size())));
  for (Index i = 0; i < n; ++i) {
    const ArmLink<double>& link = arm.arm.links[static_cast<std::size_t>(i)];
    stated(per_link * i) = link.mass;
    stated.segment(per_link * i + 1, 3) = link.mass * link.centre;
    const Matrix3d& own = inertia[static_cast<std::size_t>(i)];
    stated.segment(per_link * i + 4, 6) << own(0, 0), own(1, 1), own(2, 2), own(0, 1), own(0, 2), own(1, 2);
  }
  return stated;
}

}  // namespace plumbline::motion
