#pragma once
/// \file
/// The torque of an arm's drives, linear in its inertias and frictions.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_arm.hpp"

namespace plumbline::motion {

inline constexpr Eigen::Index terms_of_link = 10, terms_of_joint = 4;

/// A number that the torque is linear in.
struct BalanceTerm {
  std::string name;  ///< "m(2)", "mx(2)", "Izz(1)", "dry friction(1)"
  std::string unit;
};

/// Of every link: mass, first moments about the origin of its frame (on its joint), moments and products of
/// inertia about that origin, in the axes of the link. Of every joint: armature, viscous and dry friction,
/// and a torque that always acts. Links first, from the base on.
std::vector<BalanceTerm> balance_terms(std::size_t joints);

/// Generalised forces of the drives for each term at one: rows are joints, columns terms.
Eigen::MatrixXd balance_columns(const diagnose::NominalArm& arm, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& v, const Eigen::VectorXd& a);

/// Masses, first moments and inertias that a model states; zero for all else.
/// \param inertia  by link, about the origin of its frame, kg m^2
Eigen::VectorXd stated_terms(const diagnose::NominalArm& arm, const std::vector<Eigen::Matrix3d>& inertia);

}  // namespace plumbline::motion
