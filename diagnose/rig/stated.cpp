#include "diagnose/rig/stated.hpp"

#include <algorithm>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/joint_law.hpp"

namespace plumbline::diagnose {
namespace {

/// Steps of the difference quotients. At 1e-6 rad the quotient of a smooth torque has nine digits, more than
/// Newton's method needs; the solver treats a kink as any other.
constexpr double turn_step = 1e-6;   // rad
constexpr double force_step = 1e-6;  // N

StatedTorque::Place turned(StatedTorque::Place at, double by) {
  at.q += by;
  at.d += by;
  return at;
}

StatedTorque::Place pushed(StatedTorque::Place at, Eigen::Index axis, double by) {
  at.force(axis) += by;
  return at;
}

}  // namespace

double StatedTorque::towards(const Place& at, double direction) const {
  constexpr std::size_t count = torque_variables.size();
  std::array<double, count + most_covariates> values{at.q, at.d,         direction,    at.t,
                                                     at.k, at.force.x(), at.force.y(), at.force.z()};
  std::copy(at.covariates.begin(), at.covariates.end(), values.begin() + count);
  return formula->at(std::span(values).first(count + at.covariates.size()), parameters);
}

double StatedTorque::value(const Place& at, double motion) const {
  if (!directed()) return towards(at, 0);
  return (1 + motion) / 2 * towards(at, 1) + (1 - motion) / 2 * towards(at, -1);
}

double StatedTorque::slope(const Place& at, const Torque& motion) const {
  const double held =
      (value(turned(at, turn_step), motion.value) - value(turned(at, -turn_step), motion.value)) /
      (2 * turn_step);
  return motion.slope == 0 ? held : held + motion.slope * (towards(at, 1) - towards(at, -1)) / 2;
}

Eigen::Vector2d StatedTorque::by_force(const Place& at, double motion) const {
  Eigen::Vector2d result = Eigen::Vector2d::Zero();
  for (const Eigen::Index axis : {0, 1})
    if (formula->uses(axis == 0 ? "Fx" : "Fy"))
      result(axis) =
          (value(pushed(at, axis, force_step), motion) - value(pushed(at, axis, -force_step), motion)) /
          (2 * force_step);
  return result;
}

}  // namespace plumbline::diagnose
