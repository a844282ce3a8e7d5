#include "diagnose/rig/rig_solver.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/loaded/settle.hpp>

namespace plumbline::diagnose {
namespace {

constexpr double largest_turn = 0.3;     // rad: longest Newton step
constexpr double nearby = 0.6;           // rad: a larger turn of a joint between readings is a snap
constexpr double angle_accuracy = 1e-7;  // rad: a Newton step this short leaves an error of its square
// Along one branch each Newton step is at most half as long as the last. A longer one has left the branch, or
// is at a kink of a joint law, which affects the ratio of short steps only.
constexpr double contraction = 0.5;
constexpr double felt_turn = 1e-3;        // rad
constexpr double shortest_stride = 1e-3;  // share of the way between two readings
constexpr int newton_limit = 40;
constexpr int joint_changes = 8;  // iterations that may change all contacts at once
constexpr long descent_limit = 400;
constexpr double first_push =
    0.01;  // share of the force that turns a joint by a radian: probes its direction
// A run takes a few steps a reading, and at most 16,000 for 31 readings in the fits of 84 experiments; a rig
// that snaps at every reading takes millions.
constexpr long steps_per_reading = 50, spare_steps = 20000;
// Joints within their play, and passive ones, may make the stiffness singular. Dampers this weak, relative to
// the largest joint stiffness, keep such joints in place; they do not enter the residual.
constexpr double hold = 1e-8;
// A joint that slips beside one that sticks (JointLaw::sticking) leaves a pivot of 1e-5 of its row.
constexpr double smallest_pivot = 1e-6;

Imposed between(const Imposed& from, const Imposed& to, double share) {
  return {to.control, from.value + share * (to.value - from.value), between(from.loads, to.loads, share)};
}

Point<double> point(const Vector2& v) {
  return {v.x(), v.y()};
}

}  // namespace

template <int Bandwidth>
RigSolver<Bandwidth>::RigSolver(const Layout& layout, std::size_t readings)
    : model_(layout),
      system_(model_, smallest_pivot),
      steps_left_(spare_steps + steps_per_reading * static_cast<long>(readings)) {}

template <int Bandwidth>
bool RigSolver<Bandwidth>::settle(const RigStep& step, bool all, Posture& posture) const {
  const Layout& layout = model_.layout();
  const auto angle = [&](std::size_t joint) { return layout.joint_angle(posture.angle, joint); };
  return settle_contacts(step, layout.sliders, all, angle, posture.contact);
}

template <int Bandwidth>
bool RigSolver<Bandwidth>::newton(const RigStep& step, const Imposed& imposed, Pace pace, Posture& posture) {
  model_.become(step, imposed.loads, posture.contact);
  if (imposed.control == Control::force) posture.force = point(imposed.value);
  double allowed = largest_turn;
  const double scale = step.run.largest_stiffness / step.run.rig.length.front();
  for (int i = 0; i < newton_limit && steps_left_ > 0; ++i) {
    --steps_left_;
    system_.expand(posture.angle, posture.force);
    if (!system_.factor(imposed.control, hold * step.run.largest_stiffness)) return false;
    const double turn = system_.step_to(point(imposed.value));
    if (!std::isfinite(turn)) return false;
    if (pace == Pace::careful && turn > std::max(allowed, felt_turn)) return false;
    system_.move(std::min(1.0, largest_turn / turn), posture.angle, posture.force);
    const bool settled = !settle(step, i < joint_changes, posture);
    allowed = settled ? contraction * turn : largest_turn;
    if (settled && turn < angle_accuracy &&
        std::hypot(system_.push().x, system_.push().y) <
            1e-7 * (scale + std::hypot(posture.force.x, posture.force.y)))
      return system_.negative_directions() == 0;
  }
  return false;
}

template <int Bandwidth>
bool RigSolver<Bandwidth>::descend(const RigStep& step, const Imposed& imposed, Posture& posture) {
  snapped_ = true;
  model_.become(step, imposed.loads, posture.contact);
  const auto contacts = [&] {
    --steps_left_;
    settle(step, false, posture);
  };
  const auto at_rest = [&] {
    // Where the tangent is indefinite, Newton's method would ascend.
    system_.expand(posture.angle, posture.force);
    if (!system_.factor(imposed.control, hold * step.run.largest_stiffness)) return false;
    if (system_.negative_directions() > 0) return false;
    trial_ = posture;
    const bool found = newton(step, imposed, Pace::careful, trial_);
    if (found) posture = trial_;
    model_.become(step, imposed.loads, posture.contact);
    return found;
  };
  const auto comes_to_rest = [&] {
    const FlowLimits<double> limits{largest_turn, static_cast<int>(std::min(descent_limit, steps_left_))};
    return flow(system_, imposed.control, point(imposed.value), step.run.largest_stiffness, limits,
                posture.angle, posture.force, contacts, at_rest);
  };
  system_.expand(posture.angle, posture.force);
  if (imposed.control == Control::force || system_.symmetric()) return comes_to_rest();
  // An eccentric force on a held end point may grow in either direction from an unloaded shape: compression
  // is tried first, then tension.
  const Posture from = posture;
  const Vector2 end(system_.at().end_point.x, system_.at().end_point.y);
  const Vector2 push =
      first_push * step.run.largest_stiffness / step.run.rig.length.front() * end.normalized();
  for (const Vector2& first : {Vector2(-push), push}) {
    posture = from;
    posture.force = {from.force.x + first.x(), from.force.y + first.y()};
    if (comes_to_rest()) return true;
  }
  return false;
}

template <int Bandwidth>
bool RigSolver<Bandwidth>::follow(const RigStep& step, const Imposed& before, const Imposed& imposed,
                                  const Posture& guess, Posture& posture) {
  snapped_ = false;
  const auto arrives = [&](const Imposed& at, Pace pace, const Posture& from) {
    trial_ = from;
    if (!newton(step, at, pace, trial_)) return false;
    if ((trial_.angle - posture.angle).cwiseAbs().maxCoeff() > nearby) return false;
    std::swap(posture, trial_);
    return true;
  };
  if (arrives(imposed, Pace::careful, guess)) return true;
  double done = 0, stride = 1;
  while (done < 1) {
    const Imposed next = between(before, imposed, std::min(1.0, done + stride));
    const Pace pace = stride > shortest_stride ? Pace::careful : Pace::free;
    if (arrives(next, pace, posture)) {
      done = std::min(1.0, done + stride);
      stride *= 2;
    } else if (stride > shortest_stride) {
      stride /= 4;
    } else {
      if (!descend(step, next, posture)) return false;
      done = std::min(1.0, done + stride);
    }
  }
  return true;
}

template <int Bandwidth>
void RigSolver<Bandwidth>::balance(const RigStep& step, const Imposed& imposed, const Posture& posture) {
  model_.become(step, imposed.loads, posture.contact);
  system_.balance(posture.angle, posture.force);
  system_.step_to(point(imposed.value));
}

template <int Bandwidth>
void RigSolver<Bandwidth>::prepare(const RigStep& step, const Imposed& imposed, const Posture& posture) {
  balance(step, imposed, posture);
  prepared_turn_ = system_.turn();
  prepared_push_ = system_.push();
}

template <int Bandwidth>
void RigSolver<Bandwidth>::neighbour(const RigStep& step, const Imposed& imposed, const Posture& posture,
                                     Posture& result) {
  result = posture;
  if (imposed.control == Control::force) result.force = point(imposed.value);
  balance(step, imposed, result);
  result.angle += system_.turn() - prepared_turn_;
  result.force.x += system_.push().x - prepared_push_.x;
  result.force.y += system_.push().y - prepared_push_.y;
}

template <int Bandwidth>
Vector2 RigSolver<Bandwidth>::end_point(const RunRig& run, const ChainLoads& loads, const Posture& posture) {
  nothing_remembered_.resize(run.joint.size());
  const RigStep step{run, {}, nothing_remembered_};
  model_.become(step, loads, posture.contact);
  system_.balance(posture.angle, posture.force);
  return {system_.at().end_point.x, system_.at().end_point.y};
}

template class RigSolver<1>;
template class RigSolver<2>;
template class RigSolver<4>;

}  // namespace plumbline::diagnose
