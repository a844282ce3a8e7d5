#pragma once
/// \file
/// Roll-outs: from the command and an initial state to the motion.

#include <vector>

#include "diagnose/motion/drive.hpp"
#include "diagnose/motion/motion_log.hpp"

namespace plumbline::motion {

/// A signal that is held from each of its stamps to the next.
class HeldSignal {
 public:
  HeldSignal(const std::vector<double>& time, const std::vector<double>& value)
      : time_(time), value_(value) {}

  /// Its mean over a step of length h that begins at time t, where it comes late: exact, so that the delay
  /// has a derivative. Calls go forward in time.
  template <class Real>
  Real mean(double t, double h, const Real& delay) {
    const double begin = t - value_of(delay), end = begin + h;
    while (now_ + 1 < time_.size() && time_[now_ + 1] <= begin) ++now_;
    double integral = 0, from = begin;
    std::size_t k = now_;
    for (; k + 1 < time_.size() && time_[k + 1] < end; ++k) {
      integral += value_[k] * (time_[k + 1] - from);
      from = time_[k + 1];
    }
    integral += value_[k] * (end - from);
    return composed(integral / h, (value_[now_] - value_[k]) / h, delay);
  }

 private:
  const std::vector<double>&time_, &value_;
  std::size_t now_ = 0;
};

/// The longest step of a roll-out, s.
inline constexpr double longest_step = 0.002;

/// The angles at the readings of a segment.
template <class Real>
std::vector<Real> roll_out(const Drive<Real>& drive, const MotionLog& log, const Segment& segment,
                           const Real& q, const Real& v) {
  Motion<Real> state{q, v};
  HeldSignal command(log.time, log.command);
  std::vector<Real> angles{q};
  Imposed<Real> now{Real(0), log.gain, 1, true, log.inertia, log.gravity};
  bool begun = false;
  for (std::size_t k = segment.first; k + 1 < segment.end; ++k) {
    const double whole = log.time[k + 1] - log.time[k];
    const double steps = std::ceil(whole / longest_step), h = whole / steps;
    now.supply = log.supply[k], now.powered = log.powered[k];
    for (double i = 0; i < steps; ++i) {
      now.command = command.mean(log.time[k] + i * h, h, drive[Term::command_delay]);
      if (!begun) state.acting = asked_duty(drive, now, q), begun = true;
      state = after(drive, now, state, h);
    }
    angles.push_back(state.q);
  }
  return angles;
}

}  // namespace plumbline::motion
