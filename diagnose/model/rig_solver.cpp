#include "diagnose/model/rig_solver.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

constexpr double largest_turn = 0.3;     // rad: longest Newton step
constexpr double nearby = 0.6;           // rad: a joint that turned further between readings has snapped
constexpr double angle_accuracy = 1e-7;  // rad: a Newton step this short leaves an error of its square
// Along one branch each Newton step is at most half as long as the last; a step that is not has left it, or
// stands at a kink of a joint law, which spoils the ratio of short steps only.
constexpr double contraction = 0.5;
constexpr double felt_turn = 1e-3;        // rad
constexpr double shortest_stride = 1e-3;  // share of the way between two readings
constexpr int newton_limit = 40;
constexpr int joint_changes = 8;  // iterations that may change all contacts at once
constexpr int descent_limit = 400;

Imposed between(const Imposed& from, const Imposed& to, double share) {
  return {to.control, from.value + share * (to.value - from.value)};
}

double largest_stiffness(const RunRig& run) {
  double result = 0;
  for (const JointLaw& law : run.joint) result = std::max(result, law.stiffness);
  return result;
}

}  // namespace

RigSolver::RigSolver(const Layout& layout)
    : equations_(layout), step_(layout.nodes()), column_x_(layout.nodes()), column_y_(layout.nodes()) {}

bool RigSolver::factorise(const RunRig& run, ControlMode control, double damping) {
  BandMatrix& matrix = equations_.stiffness;
  const Layout& layout = equations_.layout;
  for (std::size_t i = 0; damping > 0 && i < layout.nodes(); ++i) {
    matrix(i, i) += i + 1 < layout.nodes() ? 2 * damping : damping;
    if (i > 0) matrix(i, i - 1) -= damping;
  }
  const std::size_t negative = matrix.factorise(1e-6 * largest_stiffness(run));
  if (control == ControlMode::force) return negative == 0;
  column_x_ = equations_.by_force_x;
  column_y_ = equations_.by_force_y;
  matrix.solve(column_x_);
  matrix.solve(column_y_);
  flexibility_ = equations_.compliance;
  flexibility_(0, 0) += run.rig.train_compliance;
  for (std::size_t i = 0; i < layout.nodes(); ++i) {
    flexibility_(0, 0) -= equations_.arm_x[i] * column_x_[i];
    flexibility_(0, 1) -= equations_.arm_x[i] * column_y_[i];
    flexibility_(1, 0) -= equations_.arm_y[i] * column_x_[i];
    flexibility_(1, 1) -= equations_.arm_y[i] * column_y_[i];
  }
  // Stable under an imposed end point: as many negative pivots as constraints in the whole bordered matrix.
  const double det = flexibility_.determinant(), trace = flexibility_.trace();
  const std::size_t positive = det < 0 ? 1 : (trace > 0 ? 2 : 0);
  return negative + positive == 2;
}

double RigSolver::solve(const RunRig& run, const Imposed& imposed, const Posture& posture) {
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = -equations_.residual[i];
  equations_.stiffness.solve(step_);
  force_step_.setZero();
  if (imposed.control == ControlMode::displacement) {
    Vector2 gap = imposed.value - equations_.end_point;
    gap.x() -= run.rig.train_compliance * posture.force.x();
    for (std::size_t i = 0; i < step_.size(); ++i)
      gap -= Vector2(equations_.arm_x[i], equations_.arm_y[i]) * step_[i];
    const double det = flexibility_.determinant();
    force_step_ = Vector2(flexibility_(1, 1) * gap.x() - flexibility_(0, 1) * gap.y(),
                          flexibility_(0, 0) * gap.y() - flexibility_(1, 0) * gap.x()) /
                  det;
    for (std::size_t i = 0; i < step_.size(); ++i)
      step_[i] -= column_x_[i] * force_step_.x() + column_y_[i] * force_step_.y();
  }
  double largest = 0;
  for (const double turn : step_) largest = std::max(largest, std::abs(turn));
  return largest;
}

void RigSolver::apply(double share, Posture& posture) const {
  for (std::size_t i = 0; i < step_.size(); ++i) posture.angle[i] += share * step_[i];
  posture.force += share * force_step_;
}

bool RigSolver::settle_contacts(const RunRig& run, const TimeStep& interval,
                                const std::vector<JointMemory>& memory, bool all, Posture& posture) const {
  if (interval.relaxed || !equations_.layout.dry) return false;
  bool changed = false;
  for (std::size_t i = 0; i < run.joint.size(); ++i) {
    if (run.joint[i].stiffness <= 0) continue;
    const double q = equations_.layout.joint_angle(posture, i);
    if (run.joint[i].friction <= 0) {
      // Nothing is carried, but what little friction would be is against the way that the joint goes.
      posture.contact[i] = q < memory[i].angle ? Contact::slips_down : Contact::slips_up;
      continue;
    }
    const Contact next = run.joint[i].next(q, memory[i], posture.contact[i]);
    if (next == posture.contact[i]) continue;
    posture.contact[i] = next;
    changed = true;
    if (!all) break;
  }
  return changed;
}

bool RigSolver::newton(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
                       const std::vector<JointMemory>& memory, Pace pace, Posture& posture) {
  if (imposed.control == ControlMode::force) posture.force = imposed.value;
  double allowed = largest_turn;
  const double scale = largest_stiffness(run) / run.rig.length.front();
  for (int i = 0; i < newton_limit; ++i) {
    equations_.assemble(run, posture, memory, interval, true);
    const bool stable = factorise(run, imposed.control, 0);
    const double turn = solve(run, imposed, posture);
    if (!std::isfinite(turn) || !force_step_.allFinite()) return false;
    if (pace == Pace::careful && turn > std::max(allowed, felt_turn)) return false;
    apply(std::min(1.0, largest_turn / turn), posture);
    const bool settled = !settle_contacts(run, interval, memory, i < joint_changes, posture);
    allowed = settled ? contraction * turn : largest_turn;
    if (settled && turn < angle_accuracy && force_step_.norm() < 1e-7 * (scale + posture.force.norm()))
      return stable;
  }
  return false;
}

bool RigSolver::descend(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
                        const std::vector<JointMemory>& memory, Posture& posture) {
  snapped_ = true;
  const double stiff = largest_stiffness(run);
  double damping = 10 * stiff;
  for (int i = 0; i < descent_limit; ++i) {
    if (imposed.control == ControlMode::force) posture.force = imposed.value;
    equations_.assemble(run, posture, memory, interval, true);
    if (!factorise(run, imposed.control, damping)) {
      damping *= 4;
      if (damping > 1e9 * stiff) return false;
      continue;
    }
    const double turn = solve(run, imposed, posture);
    if (!std::isfinite(turn) || !force_step_.allFinite()) return false;
    if (turn > largest_turn && damping < 1e6 * stiff) {
      damping *= 4;
      continue;
    }
    apply(std::min(1.0, largest_turn / turn), posture);
    settle_contacts(run, interval, memory, false, posture);
    damping *= 0.5;
    if (damping < 1e-3 * stiff) {
      Posture trial = posture;
      if (newton(run, imposed, interval, memory, Pace::careful, trial)) {
        posture = trial;
        return true;
      }
    }
  }
  return false;
}

bool RigSolver::follow(const RunRig& run, const Imposed& before, const Imposed& imposed,
                       const TimeStep& interval, const std::vector<JointMemory>& memory, const Posture& guess,
                       Posture& posture) {
  snapped_ = false;
  const auto near = [&](const Posture& to) {
    for (std::size_t i = 0; i < posture.angle.size(); ++i)
      if (std::abs(to.angle[i] - posture.angle[i]) > nearby) return false;
    return true;
  };
  if (Posture trial = guess; newton(run, imposed, interval, memory, Pace::careful, trial) && near(trial)) {
    posture = std::move(trial);
    return true;
  }
  double done = 0, stride = 1;
  while (done < 1) {
    const Imposed next = between(before, imposed, std::min(1.0, done + stride));
    Posture trial = posture;
    const Pace pace = stride > shortest_stride ? Pace::careful : Pace::free;
    if (newton(run, next, interval, memory, pace, trial) && near(trial)) {
      posture = std::move(trial);
      done = std::min(1.0, done + stride);
      stride *= 2;
    } else if (stride > shortest_stride) {
      stride /= 4;
    } else {
      if (!descend(run, next, interval, memory, posture)) return false;
      done = std::min(1.0, done + stride);
    }
  }
  return true;
}

void RigSolver::settle(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
                       const std::vector<JointMemory>& memory, const Posture& posture) {
  equations_.assemble(run, posture, memory, interval, false);
  solve(run, imposed, posture);
  settled_step_ = step_;
  settled_force_step_ = force_step_;
}

Posture RigSolver::neighbour(const RunRig& run, const Imposed& imposed, const TimeStep& interval,
                             const std::vector<JointMemory>& memory, const Posture& posture) {
  Posture result = posture;
  if (imposed.control == ControlMode::force) result.force = imposed.value;
  equations_.assemble(run, result, memory, interval, false);
  solve(run, imposed, result);
  for (std::size_t i = 0; i < step_.size(); ++i) result.angle[i] += step_[i] - settled_step_[i];
  result.force += force_step_ - settled_force_step_;
  return result;
}

Vector2 RigSolver::end_point(const RunRig& run, const Posture& posture,
                             const std::vector<JointMemory>& memory) {
  equations_.assemble(run, posture, memory, {}, false);
  return equations_.end_point;
}

}  // namespace plumbline::diagnose
