#pragma once
/// \file
/// Where an arm comes to rest under gravity and wrenches: each freedom yields by its compliance.

#include <Eigen/LU>
#include <plumbline/arm/arm_loads.hpp>

namespace plumbline {

/// Compliance of all freedoms: of the joints, and a block for each link that yields.
template <Floating Real>
Matrix<Real> compliance(const SerialArm<Real>& arm) {
  const auto n = static_cast<Eigen::Index>(freedoms(arm));
  Matrix<Real> all = Matrix<Real>::Zero(n, n);
  Eigen::Index next = 0;
  for (const ArmLink<Real>& link : arm.links) {
    all(next, next) = link.joint_compliance;
    ++next;
    if (!yields(link)) continue;
    all.template block<6, 6>(next, next) = link.compliance;
    next += 6;
  }
  return all;
}

/// Coordinates of all freedoms with the joints at their commands, and links that do not yield.
template <Floating Real>
Vector<Real> commanded(const SerialArm<Real>& arm, const Vector<Real>& command) {
  Vector<Real> all = Vector<Real>::Zero(static_cast<Eigen::Index>(freedoms(arm)));
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    all(next) = command(static_cast<Eigen::Index>(i));
    next += yields(arm.links[i]) ? 7 : 1;
  }
  return all;
}

/// Coordinates u of all freedoms at rest: u = command + C tau(u), by Newton's method.
/// \param command  of the joints
/// \throws Error where no rest is found from the command, or an unstable one: the arm is softer than its loads, or
///         buckles
template <Floating Real>
Vector<Real> equilibrium(const SerialArm<Real>& arm, const Vector<Real>& command,
                         const std::vector<ArmWrench<Real>>& wrenches) {
  const Vector<Real> start = commanded(arm, command);
  const Matrix<Real> soft = compliance(arm), one = Matrix<Real>::Identity(start.size(), start.size());
  constexpr int most = 50;
  Vector<Real> u = start;
  Real last(0);
  for (int iteration = 0; iteration < most; ++iteration) {
    const ArmLoads<Real> loads = arm_loads(arm, ArmPosture<Real>(arm, u), wrenches);
    const Vector<Real> residual = u - start - soft * loads.force;
    const Eigen::PartialPivLU<Matrix<Real>> tangent(one - soft * loads.stiffness);
    const Vector<Real> step = tangent.solve(residual);
    u -= step;
    last = step.template lpNorm<Eigen::Infinity>();
    // A turn and a half, or no number; or more loads than springs.
    if (!(last < Real(10)) || !(tangent.determinant() > Real(0))) break;
    if (last <= Real(8) * epsilon<Real>() * (Real(1) + u.template lpNorm<Eigen::Infinity>())) return u;
  }
  throw Error("arm",
              "no stable rest near its command: the last step of Newton's method was " +
                  std::to_string(static_cast<double>(last)),
              "springs that are stiffer than the loads");
}

}  // namespace plumbline
