#pragma once
/// \file
/// Roll-outs: from the command and an initial state to the motion.

#include <vector>

#include "diagnose/motion/motion_log.hpp"
#include "diagnose/motion/step.hpp"

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

/// The drive by a clock that runs fast or slow: what has the dimension of time, in the time of the stamps.
template <class Real>
Drive<Real> by_stamps(const Drive<Real>& drive) {
  if (!drive.has(Term::clock_rate)) return drive;
  Drive<Real> own = drive;
  const Real rate = 1 + drive[Term::clock_rate];
  for (const Term term : {Term::command_delay, Term::drive_lag, Term::command_slowness, Term::viscous,
                          Term::back_emf, Term::brake, Term::gear_damping})
    if (drive.has(term)) own[term] = drive[term] / rate;
  for (const Term term : {Term::armature, Term::drag})
    if (drive.has(term)) own[term] = drive[term] / (rate * rate);
  if (drive.has(Term::rising_speed)) own[Term::rising_speed] = drive[Term::rising_speed] * rate;
  return own;
}

/// Follows a segment from the angle that its encoder reads at the begin, and a speed.
/// \param visit  called with the number of each reading in the segment, the state, and what is imposed
template <class Real, class Visit>
void roll_out(const Drive<Real>& true_drive, const MotionLog& log, const Segment& segment,
              const Real& reading, const Real& v, const Visit& visit) {
  const Drive<Real> drive = by_stamps(true_drive);
  const Real rate = 1 + drive[Term::clock_rate];
  HeldSignal command(log.time, log.command);
  Imposed<Real> now{Real(0), log.gain, 1, true, log.inertia / (rate * rate), log.gravity, log.encoder};
  Motion<Real> state;
  for (std::size_t k = segment.first; k < segment.end; ++k) {
    now.supply = log.supply[k], now.powered = log.powered[k];
    const double whole = k + 1 < log.time.size() ? log.time[k + 1] - log.time[k] : longest_step;
    const double steps = std::ceil(whole / longest_step), h = whole / steps;
    now.command = command.mean(log.time[k], h, drive[Term::command_delay]);
    if (k == segment.first) state = begun(drive, now, reading, v, h);
    visit(k - segment.first, state, now);
    if (k + 1 == segment.end) break;
    state = after(drive, now, state, h);
    for (double i = 1; i < steps; ++i) {
      now.command = command.mean(log.time[k] + i * h, h, drive[Term::command_delay]);
      state = after(drive, now, state, h);
    }
  }
}

/// A course of a segment that is read late: between its readings and before the first on straight lines.
template <class Real>
std::vector<Real> late(const std::vector<Real>& course, const MotionLog& log, const Segment& segment,
                       const Real& delay) {
  std::vector<Real> read;
  std::size_t from = 0;
  for (std::size_t k = 0; k < course.size(); ++k) {
    const double* const time = &log.time[segment.first];
    const double then = time[k] - value_of(delay);
    while (from + 2 < course.size() && time[from + 1] <= then) ++from;
    const Real share = (time[k] - delay - time[from]) / (time[from + 1] - time[from]);
    read.push_back(course[from] + share * (course[from + 1] - course[from]));
  }
  return read;
}

/// What a segment reads: of position, then of each channel beside it.
template <class Real>
std::vector<std::vector<Real>> readings_of(const Drive<Real>& drive, const MotionLog& log,
                                           const Segment& segment, const Real& reading, const Real& v) {
  std::vector<std::vector<Real>> read(1 + log.beside.size());
  roll_out(drive, log, segment, reading, v,
           [&](std::size_t, const Motion<Real>& state, const Imposed<Real>& now) {
             read[0].push_back(state.reading(now.encoder));
             for (std::size_t i = 0; i < log.beside.size(); ++i) {
               const Channel channel = log.beside[i].channel;
               const ChannelKind& kind = kind_of(channel);
               read[1 + i].push_back((1 + drive[kind.scale.term]) * quantity_of(channel, drive, state, now) +
                                     drive[kind.zero.term]);
             }
           });
  if (read[0].size() < 2) return read;
  const auto delayed = [&](std::vector<Real>& course, Term term) {
    if (drive.has(term)) course = late(course, log, segment, drive[term]);
  };
  delayed(read[0], Term::position_delay);
  for (std::size_t i = 0; i < log.beside.size(); ++i)
    delayed(read[1 + i], kind_of(log.beside[i].channel).delay.term);
  return read;
}

/// The readings of position of a segment.
template <class Real>
std::vector<Real> angles_of(const Drive<Real>& drive, const MotionLog& log, const Segment& segment,
                            const Real& reading, const Real& v) {
  return readings_of(drive, log, segment, reading, v).front();
}

}  // namespace plumbline::motion
