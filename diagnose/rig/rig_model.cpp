#include "diagnose/rig/rig_model.hpp"

#include <array>
#include <cmath>

#include "diagnose/rig/tube.hpp"

namespace plumbline::diagnose {
namespace {

/// Contribution of a short piece of a link.
struct Piece {
  double residual, stiffness, energy;
  Vector2 moved, arm;  // its share of the end point and of its derivative
};

Vector2 unit_vector(double orientation) {
  return {std::cos(orientation), std::sin(orientation)};
}

/// \param u        the unit vector along it
/// \param carried  weight, beside the end force
inline Piece piece(double length, const Vector2& u, const Vector2& force, const Vector2& carried,
                   double axial) {
  const Vector2 n(-u.y(), u.x());
  const double pull = u.dot(carried), tension = u.dot(force) + pull, shear = n.dot(force + carried);
  const double stretch = 1 + axial * tension;
  return {-length * stretch * shear, length * (stretch * tension - axial * shear * shear),
          length * (axial * tension * tension / 2 - stretch * pull), length * stretch * u,
          length * (stretch * n + axial * shear * u)};
}

/// The loads along the chain that a piece of a link carries.
/// \param part  how much of a force on that link, by the share of its length at which it acts
template <class Part>
Vector2 carried_by(const ChainLoads& loads, std::size_t link, Part part) {
  Vector2 carried(0, 0);
  for (const ChainLoads::Force& one : loads.forces) {
    if (one.link > link) carried += one.value;
    if (one.link == link) carried += part(one.at) * one.value;
  }
  return carried;
}

/// The points of Gauss's rule along a link, and their weights.
const double gauss_reach = std::sqrt(0.6);
const std::array<double, 3> gauss_place{(1 - gauss_reach) / 2, 0.5, (1 + gauss_reach) / 2};
constexpr std::array<double, 3> gauss_weight{5.0 / 18, 8.0 / 18, 5.0 / 18};

/// How much of a force at a share of a link a point of Gauss's rule carries, so that the rule is exact for
/// quadratic functions up to that share: the integral of the point's Lagrange polynomial over its weight.
double part_at(std::size_t point, double share) {
  const double end = share - 0.5, square = 0.15;  // of the outer points' distance from the middle
  const double constant = share, linear = (end * end - 0.25) / 2, quadratic = (end * end * end + 0.125) / 3;
  const double side = (static_cast<double>(point) - 1) * gauss_reach / 2;
  return (point == 1 ? constant - quadratic / square : (quadratic + side * linear) / (2 * square)) /
         gauss_weight.at(point);
}

/// How the mass of a link lies along it; beside it lies what is beyond its ends, or across.
Lying lying(const Rig& rig, std::size_t link) {
  return Lying(0.5 + rig.centre[link].x() / rig.length[link]);
}

template <class At>
void add_stiffness(At& at, Eigen::Index row, Eigen::Index column, double value) {
  at.hessian(std::abs(row - column), std::min(row, column)) += value;
}

Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

}  // namespace

template <int Bandwidth>
void RigModel<Bandwidth>::expand(const Vector<double>& angle, const Point<double>& force, At& at) const {
  assemble<true>(angle, force, at);
}

template <int Bandwidth>
void RigModel<Bandwidth>::balance(const Vector<double>& angle, const Point<double>& force, At& at) const {
  assemble<false>(angle, force, at);
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::assemble(const Vector<double>& angle, const Point<double>& end_force,
                                   At& at) const {
  const Eigen::Index nodes = index(layout_.nodes());
  const Vector2 force(end_force.x, end_force.y);
  at.residual.setZero(nodes);
  at.end_point = {0, 0};
  if constexpr (derivatives) {
    at.energy = 0;
    at.hessian.setZero(Bandwidth + 1, nodes);
    at.end_point_gradient.setZero(nodes, 2);
    at.compliance.setZero();
  }
  add_joints<derivatives>(angle, at);
  if constexpr (Bandwidth > 1) {
    if (step_->run.rig.coupling != 0) add_coupling<derivatives>(angle, at);
  }
  if (step_->run.rig.alone) {
    load_joint<derivatives>(angle, force, at);
  } else if (Bandwidth > 1 && layout_.bending) {
    for (std::size_t j = 0; j < layout_.links; ++j) add_bending_link<derivatives>(j, angle, force, at);
    add_end<derivatives>(angle, force, at);
  } else {
    add_rigid_links<derivatives>(angle, force, at);
    add_end<derivatives>(angle, force, at);
  }
  if (step_->run.rig.stated_torques.empty()) return;
  for (std::size_t i = 0; i < layout_.links; ++i)
    add_stated<derivatives>(i, layout_.joint_angle(angle, i), force, at);
}

template <int Bandwidth>
Torque RigModel<Bandwidth>::history(std::size_t joint, double q) const {
  return history_torque(*step_, joint, q, contact_->data() + layout_.contact(joint, 0));
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_joints(const Vector<double>& angle, At& at) const {
  for (std::size_t i = 0; i < layout_.links; ++i) {
    const JointLaw& law = step_->run.joint[i];
    const double q = layout_.joint_angle(angle, i);
    Torque torque = law.elastic(q, step_->memory[i]);
    torque += history(i, q);
    if (const Vector2& balance = step_->run.rig.balance[i]; !balance.isZero(0)) {
      const double c = std::cos(q), s = std::sin(q);
      torque += {-balance.dot(Vector2(c, s)), -balance.dot(Vector2(-s, c)), -balance.dot(Vector2(s, -c))};
    }
    if (!loads_->moment.empty()) torque += {-loads_->moment[i], 0, -loads_->moment[i] * q};
    add_torque<derivatives>(i, torque.value, torque.slope, at);
    if constexpr (derivatives) at.energy += torque.energy;
  }
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_torque(std::size_t joint, double value, double slope, At& at) const {
  const Eigen::Index own = index(layout_.first(joint));
  at.residual(own) += value;
  if constexpr (derivatives) at.hessian(0, own) += slope;
  if (joint == 0) return;
  const Eigen::Index before = index(layout_.last(joint - 1));
  at.residual(before) -= value;
  if constexpr (!derivatives) return;
  at.hessian(0, before) += slope;
  at.hessian(1, before) -= slope;
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_stated(std::size_t joint, double q, const Vector2& force, At& at) const {
  const Torque motion = direction_of_motion(*step_, joint, q, contact_->data() + layout_.contact(joint, 0));
  const StatedTorque::Place place = stated_place(*step_, joint, q, {force.x(), force.y(), 0});
  for (const StatedTorque& one : step_->run.joint[joint].stated) {
    const double value = one.value(place, motion.value);
    if constexpr (!derivatives) {
      add_torque<false>(joint, value, 0, at);
      continue;
    }
    add_torque<true>(joint, value, one.slope(place, motion), at);
    const Vector2 by_force = one.by_force(place, motion.value);
    at.force_gradient.row(index(layout_.first(joint))) -= by_force.transpose();
    if (joint > 0) at.force_gradient.row(index(layout_.last(joint - 1))) += by_force.transpose();
  }
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_coupling(const Vector<double>& angle, At& at) const {
  const double kappa = step_->run.rig.coupling;
  const auto deflection = [&](std::size_t i) {
    return layout_.joint_angle(angle, i) - step_->run.joint[i].rest;
  };
  // Torque of joint i, on the node behind it and, reversed, on the node before it.
  const auto on_joint = [&](std::size_t i, double torque) {
    at.residual(index(layout_.first(i))) += torque;
    if (i > 0) at.residual(index(layout_.last(i - 1))) -= torque;
  };
  for (std::size_t i = 0; i + 1 < layout_.links; ++i) {
    const double d = deflection(i), d_next = deflection(i + 1);
    on_joint(i, -kappa * d_next);
    on_joint(i + 1, -kappa * d);
    if constexpr (!derivatives) continue;
    at.energy -= kappa * d * d_next;
    const Eigen::Index between = index(layout_.last(i)), own = index(layout_.first(i)),
                       next = index(layout_.first(i + 1));
    // q_i = own - before, q_{i+1} = next - between: the symmetric part of -kappa q_i q_{i+1}.
    add_stiffness(at, next, own, -kappa);
    add_stiffness(at, between, own, between == own ? 2 * kappa : kappa);
    if (i == 0) continue;
    const Eigen::Index before = index(layout_.last(i - 1));
    add_stiffness(at, next, before, kappa);
    add_stiffness(at, between, before, -kappa);
  }
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_rigid_links(const Vector<double>& angle, const Vector2& force, At& at) const {
  const RunRig& run = step_->run;
  if (angle.size() != along_at_.size() || angle != along_at_) {
    along_at_ = angle;
    along_.resize(layout_.links);
    for (std::size_t j = 0; j < layout_.links; ++j) along_[j] = unit_vector(angle(index(j)));
  }
  for (std::size_t j = 0; j < layout_.links; ++j) {
    const Eigen::Index i = index(j);
    const Vector2 carried = run.beyond[j] + lying(run.rig, j).centre * run.rig.weight[j] +
                            carried_by(*loads_, j, [](double share) { return share; });
    const Piece link = piece(run.rig.length[j], along_[j], force, carried, run.rig.axial);
    add_beside<derivatives>(j, 1, i, along_[j], at);
    at.residual(i) += link.residual;
    at.end_point.x += link.moved.x();
    at.end_point.y += link.moved.y();
    if constexpr (!derivatives) continue;
    at.energy += link.energy;
    at.hessian(0, i) += link.stiffness;
    at.end_point_gradient(i, 0) = link.arm.x();
    at.end_point_gradient(i, 1) = link.arm.y();
    at.compliance += run.rig.length[j] * run.rig.axial * along_[j] * along_[j].transpose();
  }
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_bending_link(std::size_t j, const Vector<double>& angle, const Vector2& force,
                                           At& at) const {
  static const std::array<std::array<double, 3>, 3> curvature{{{7, -8, 1}, {-8, 16, -8}, {1, -8, 7}}};
  const RunRig& run = step_->run;
  const Eigen::Index first = index(layout_.first(j));
  const double length = run.rig.length[j];
  const double rigidity = 1 / (3 * run.rig.flexibility * length);
  for (Eigen::Index a = 0; a < 3; ++a) {
    for (Eigen::Index b = 0; b < 3; ++b) {
      const double c = rigidity * curvature[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      at.residual(first + a) += c * angle(first + b);
      if constexpr (!derivatives) continue;
      at.energy += c * angle(first + a) * angle(first + b) / 2;
      if (b <= a) at.hessian(a - b, first + b) += c;
    }
  }
  const Lying mass = lying(run.rig, j);
  add_beside<derivatives>(j, 1 - mass.centre, first, unit_vector(angle(first)), at);
  add_beside<derivatives>(j, mass.centre, first + 2, unit_vector(angle(first + 2)), at);
  for (std::size_t g = 0; g < 3; ++g) {
    const double s = gauss_place[g];
    const Eigen::Vector3d shape((1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1));
    const double phi = shape.dot(angle.segment<3>(first));
    const Vector2 carried = run.beyond[j] + mass.carried(s) * run.rig.weight[j] +
                            carried_by(*loads_, j, [g](double share) { return part_at(g, share); });
    const Vector2 along = unit_vector(phi);
    const Piece part = piece(gauss_weight[g] * length, along, force, carried, run.rig.axial);
    at.residual.template segment<3>(first) += part.residual * shape;
    at.end_point.x += part.moved.x();
    at.end_point.y += part.moved.y();
    if constexpr (!derivatives) continue;
    at.energy += part.energy;
    at.compliance += gauss_weight[g] * length * run.rig.axial * along * along.transpose();
    at.end_point_gradient.template middleRows<3>(first) += shape * part.arm.transpose();
    for (Eigen::Index a = 0; a < 3; ++a)
      for (Eigen::Index b = 0; b <= a; ++b)
        at.hessian(a - b, first + b) += shape(a) * shape(b) * part.stiffness;
  }
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_beside(std::size_t link, double share, Eigen::Index node, const Vector2& u,
                                     At& at) const {
  const Rig& rig = step_->run.rig;
  if (rig.centre[link].isZero(0)) return;
  const Vector2 off(rig.centre[link].x() - (lying(rig, link).centre - 0.5) * rig.length[link],
                    rig.centre[link].y());
  const Vector2 n(-u.y(), u.x()), weight = share * rig.weight[link];
  at.residual(node) -= weight.dot(off.x() * n - off.y() * u);
  if constexpr (!derivatives) return;
  const double lifted = weight.dot(off.x() * u + off.y() * n);
  at.energy -= lifted;
  at.hessian(0, node) += lifted;
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::load_joint(const Vector<double>& angle, const Vector2& force, At& at) const {
  at.residual(0) -= force.x();
  // Nothing acts across: a unit compliance there leaves no force where the place 0 is imposed.
  at.end_point = {angle(0), force.y()};
  if constexpr (derivatives) {
    at.energy += force.y() * force.y() / 2;
    at.end_point_gradient(0, 0) = 1;
    at.compliance(1, 1) = 1;
    at.force_gradient = at.end_point_gradient;
  }
}

template <int Bandwidth>
template <bool derivatives>
void RigModel<Bandwidth>::add_end(const Vector<double>& angle, const Vector2& force, At& at) const {
  const RunRig& run = step_->run;
  const Eigen::Index tip = index(layout_.nodes()) - 1;
  const double turned = angle(tip) - run.rest_orientation;
  const Vector2 yields = run.rig.base_compliance + Vector2(run.rig.train_compliance, 0);
  at.residual(tip) += run.rig.tip_stiffness * turned;
  at.end_point.x += yields.x() * force.x();
  at.end_point.y += yields.y() * force.y();
  if constexpr (derivatives) {
    at.energy += run.rig.tip_stiffness * turned * turned / 2 + force.dot(yields.cwiseProduct(force)) / 2;
    at.hessian(0, tip) += run.rig.tip_stiffness;
    at.compliance.diagonal() += yields;
    at.force_gradient = at.end_point_gradient;
  }
  const double e = run.rig.eccentricity;
  if (e == 0) return;
  const Vector2 u(std::cos(angle(tip)), std::sin(angle(tip)));
  at.residual(tip) += e * u.dot(force);
  if constexpr (!derivatives) return;
  at.hessian(0, tip) += e * (u.x() * force.y() - u.y() * force.x());
  at.force_gradient.row(tip) -= e * u.transpose();
}

template class RigModel<1>;
template class RigModel<2>;
template class RigModel<4>;

}  // namespace plumbline::diagnose
