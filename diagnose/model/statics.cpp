#include "diagnose/model/statics.hpp"

#include <array>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// What a short piece of a link, of orientation phi, contributes.
struct Piece {
  double residual, stiffness;
  Vector2 moved, arm, along;  // its share of the end point and of its derivative; the unit vector along it
};

Piece piece(double length, double phi, const Vector2& force, double axial) {
  const Vector2 u(std::cos(phi), std::sin(phi));
  const Vector2 n(-u.y(), u.x());
  const double tension = u.dot(force), shear = n.dot(force), stretch = 1 + axial * tension;
  return {-length * stretch * shear, length * (stretch * tension - axial * shear * shear),
          length * stretch * u, length * (stretch * n + axial * shear * u), u};
}

JointLaw joint_law(const Rig& rig, std::size_t i, double rest) {
  return {rig.stiffness[i], rest + rig.rest_error[i],        rig.backlash[i],
          rig.stop[i],      rig.stop_stiffness[i],           rig.hardening,
          rig.friction,     rig.arm_ratio * rig.stiffness[i]};
}

}  // namespace

RunRig::RunRig(const Rig& whole, const std::vector<double>& commanded_rest)
    : rig(whole), rest_orientation(0), beyond(whole.length.size()) {
  const std::size_t n = whole.length.size();
  Vector2 carried = whole.payload;
  for (std::size_t j = n; j-- > 0;) {
    beyond[j] = carried;
    carried += whole.weight[j];
  }
  for (std::size_t i = 0; i < n; ++i) {
    joint.push_back(joint_law(whole, i, commanded_rest[i]));
    rest_orientation += joint.back().rest;
  }
}

Equations::Equations(const Layout& unknowns)
    : layout(unknowns),
      residual(unknowns.nodes()),
      end_point(0, 0),
      stiffness(unknowns.nodes(), unknowns.half_width()),
      arm_x(unknowns.nodes()),
      arm_y(unknowns.nodes()),
      by_force_x(unknowns.nodes()),
      by_force_y(unknowns.nodes()),
      compliance(Eigen::Matrix2d::Zero()) {}

void Equations::assemble(const RunRig& run, const Posture& posture, const std::vector<JointMemory>& memory,
                         const TimeStep& interval, bool tangent) {
  std::fill(residual.begin(), residual.end(), 0.0);
  end_point.setZero();
  if (tangent) {
    stiffness.set_zero();
    compliance.setZero();
  }
  add_joints(run, posture, memory, interval, tangent);
  if (run.rig.coupling != 0) add_coupling(run, posture, tangent);
  for (std::size_t j = 0; j < layout.links; ++j) {
    if (layout.bending) {
      add_bending_link(run, j, posture, tangent);
    } else {
      add_rigid_link(run, j, posture, tangent);
    }
  }
  add_end(run, posture, tangent);
}

void Equations::add_stiffness(std::size_t row, std::size_t column, double value) {
  if (row >= column) {
    stiffness(row, column) += value;
  } else {
    stiffness(column, row) += value;
  }
}

void Equations::add_joints(const RunRig& run, const Posture& posture, const std::vector<JointMemory>& memory,
                           const TimeStep& interval, bool tangent) {
  for (std::size_t i = 0; i < layout.links; ++i) {
    const JointLaw& law = run.joint[i];
    const double q = layout.joint_angle(posture, i);
    Torque torque = law.elastic(q);
    if (!interval.relaxed) {
      const Torque dry = law.dry(q, memory[i], posture.contact[i]);
      const Torque arm = law.viscous(q, memory[i], interval.decay, interval.gain);
      torque.value += dry.value + arm.value;
      torque.slope += dry.slope + arm.slope;
    }
    const std::size_t own = layout.first(i);
    residual[own] += torque.value;
    if (i > 0) residual[layout.last(i - 1)] -= torque.value;
    if (!tangent) continue;
    stiffness(own, own) += torque.slope;
    if (i == 0) continue;
    const std::size_t before = layout.last(i - 1);
    stiffness(before, before) += torque.slope;
    stiffness(own, before) -= torque.slope;
  }
}

void Equations::add_coupling(const RunRig& run, const Posture& posture, bool tangent) {
  const double kappa = run.rig.coupling;
  // Torque of joint i, on the node behind it and, reversed, on the node before it.
  const auto on_joint = [&](std::size_t i, double torque) {
    residual[layout.first(i)] += torque;
    if (i > 0) residual[layout.last(i - 1)] -= torque;
  };
  for (std::size_t i = 0; i + 1 < layout.links; ++i) {
    on_joint(i, -kappa * (layout.joint_angle(posture, i + 1) - run.joint[i + 1].rest));
    on_joint(i + 1, -kappa * (layout.joint_angle(posture, i) - run.joint[i].rest));
    if (!tangent) continue;
    const std::size_t between = layout.last(i), own = layout.first(i), next = layout.first(i + 1);
    // q_i = own - before, q_{i+1} = next - between: the symmetric part of -kappa q_i q_{i+1}.
    add_stiffness(next, own, -kappa);
    add_stiffness(between, own, between == own ? 2 * kappa : kappa);
    if (i == 0) continue;
    const std::size_t before = layout.last(i - 1);
    add_stiffness(next, before, kappa);
    add_stiffness(between, before, -kappa);
  }
}

void Equations::add_rigid_link(const RunRig& run, std::size_t j, const Posture& posture, bool tangent) {
  const Vector2 force = posture.force + run.beyond[j] + 0.5 * run.rig.weight[j];
  const Piece link = piece(run.rig.length[j], posture.angle[j], force, run.rig.axial);
  residual[j] += link.residual;
  end_point += link.moved;
  if (!tangent) return;
  stiffness(j, j) += link.stiffness;
  arm_x[j] = link.arm.x();
  arm_y[j] = link.arm.y();
  compliance += run.rig.length[j] * run.rig.axial * link.along * link.along.transpose();
}

void Equations::add_bending_link(const RunRig& run, std::size_t j, const Posture& posture, bool tangent) {
  static const double reach = std::sqrt(0.6);
  static const std::array<double, 3> place{(1 - reach) / 2, 0.5, (1 + reach) / 2};
  static const std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
  static const std::array<std::array<double, 3>, 3> curvature{{{7, -8, 1}, {-8, 16, -8}, {1, -8, 7}}};
  const std::size_t first = layout.first(j);
  const double length = run.rig.length[j];
  const double rigidity = 1 / (3 * run.rig.flexibility * length);
  for (std::size_t a = 0; a < 3; ++a) {
    if (tangent) arm_x[first + a] = arm_y[first + a] = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      residual[first + a] += rigidity * curvature[a][b] * posture.angle[first + b];
      if (tangent && b <= a) stiffness(first + a, first + b) += rigidity * curvature[a][b];
    }
  }
  for (std::size_t g = 0; g < 3; ++g) {
    const double s = place[g];
    const std::array<double, 3> shape{(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)};
    double phi = 0;
    for (std::size_t a = 0; a < 3; ++a) phi += shape[a] * posture.angle[first + a];
    const Vector2 force = posture.force + run.beyond[j] + (1 - s) * run.rig.weight[j];
    const Piece part = piece(weight[g] * length, phi, force, run.rig.axial);
    end_point += part.moved;
    if (tangent) compliance += weight[g] * length * run.rig.axial * part.along * part.along.transpose();
    for (std::size_t a = 0; a < 3; ++a) {
      residual[first + a] += shape[a] * part.residual;
      if (!tangent) continue;
      arm_x[first + a] += shape[a] * part.arm.x();
      arm_y[first + a] += shape[a] * part.arm.y();
      for (std::size_t b = 0; b <= a; ++b)
        stiffness(first + a, first + b) += shape[a] * shape[b] * part.stiffness;
    }
  }
}

void Equations::add_end(const RunRig& run, const Posture& posture, bool tangent) {
  const std::size_t tip = layout.nodes() - 1;
  const double phi = posture.angle[tip], e = run.rig.eccentricity;
  const Vector2 u(std::cos(phi), std::sin(phi)), n(-u.y(), u.x());
  residual[tip] += run.rig.tip_stiffness * (phi - run.rest_orientation) + e * u.dot(posture.force);
  end_point += run.rig.base_compliance.cwiseProduct(posture.force);
  if (!tangent) return;
  stiffness(tip, tip) += run.rig.tip_stiffness + e * n.dot(posture.force);
  compliance.diagonal() += run.rig.base_compliance;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    by_force_x[i] = -arm_x[i];
    by_force_y[i] = -arm_y[i];
  }
  by_force_x[tip] += e * u.x();
  by_force_y[tip] += e * u.y();
}

}  // namespace plumbline::diagnose
