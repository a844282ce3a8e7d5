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

/// The drive by a clock that runs fast or slow: what has the dimension of time, in the time of the stamps.
template <class Real>
Drive<Real> by_stamps(const Drive<Real>& drive) {
  if (!drive.has(Term::clock_rate)) return drive;
  Drive<Real> own = drive;
  const Real rate = 1 + drive[Term::clock_rate];
  for (const Term term : {Term::command_delay, Term::drive_lag, Term::command_slowness, Term::viscous,
                          Term::back_emf, Term::brake, Term::gear_damping, Term::derivative_gain})
    if (drive.has(term)) own[term] = drive[term] / rate;
  for (const Term term : {Term::armature, Term::drag})
    if (drive.has(term)) own[term] = drive[term] / (rate * rate);
  for (const Term term : {Term::rising_speed, Term::integral_gain})
    if (drive.has(term)) own[term] = drive[term] * rate;
  return own;
}

/// What is done at the steps of a roll-out, where nothing is.
struct Nothing {
  template <class... Arguments>
  void operator()(const Arguments&...) const {}
};

/// The duty of the servo's integral part at a reading, from none at the begin of the log: by the errors that
/// were read.
template <class Real>
Real integrated_before(const Drive<Real>& drive, const MotionLog& log, std::size_t reading) {
  Real duty(0);
  if (!drive.has(Term::integral_gain)) return duty;
  HeldSignal command(log.time, log.command);
  for (std::size_t k = 0; k < reading; ++k) {
    const double h = log.time[k + 1] - log.time[k];
    const Real read((log.position[k] + log.position[k + 1]) / 2);
    const Real error = servo_error(drive, command.mean(log.time[k], h, drive[Term::command_delay]), read);
    duty = log.powered[k] ? integrated(drive, duty, error, h) : Real(0);
  }
  return duty;
}

/// Follows a segment from the angle that its encoder reads at the begin, and a speed.
/// \param visit  called with the number of each reading in the segment, the state, and what is imposed
/// \param pass   called at the end of each step with its share of the time to the next reading, the state, and
///               what is imposed
template <class Real, class Visit, class Pass = Nothing>
void roll_out(const Drive<Real>& true_drive, const MotionLog& log, const Segment& segment,
              const Real& reading, const Real& v, const Visit& visit, const Pass& pass = {}) {
  const Drive<Real> drive = by_stamps(true_drive);
  const Real rate = 1 + drive[Term::clock_rate];
  HeldSignal command(log.time, log.command);
  Imposed<Real> now{Real(0), log.gain, 1, true, log.inertia / (rate * rate), log.gravity, log.encoder};
  Motion<Real> state;
  for (std::size_t k = segment.first; k < segment.end; ++k) {
    now.supply = log.supply[k], now.powered = log.powered[k];
    if (!log.warmer.empty()) now.warmer = log.warmer[k];
    if (!log.base_acceleration.empty()) now.base_acceleration = log.base_acceleration[k];
    const double whole = k + 1 < log.time.size() ? log.time[k + 1] - log.time[k] : segment.step;
    const double steps = std::ceil(whole / segment.step), h = whole / steps;
    now.command = command.mean(log.time[k], h, drive[Term::command_delay]);
    if (k == segment.first) state = begun(drive, now, reading, v, integrated_before(drive, log, k), h);
    visit(k - segment.first, state, now);
    if (k + 1 == segment.end) break;
    for (double i = 0; i < steps; ++i) {
      if (i > 0) now.command = command.mean(log.time[k] + i * h, h, drive[Term::command_delay]);
      state = after(drive, now, state, h);
      pass(1 / steps, state, now);
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

/// A channel as it is read, with the errors of its reading, from its means between neighbouring readings:
/// each reading has the mean of those beside it, for where it lies within a held command is not known.
template <class Real>
std::vector<Real> channel_of(const std::vector<Real>& means, const Drive<Real>& drive,
                             const ChannelKind& kind) {
  std::vector<Real> read;
  for (std::size_t k = 0; k <= means.size(); ++k) {
    const Real& before = means[k == 0 ? 0 : k - 1];
    const Real& behind = means[k == means.size() ? k - 1 : k];
    read.push_back((1 + drive[kind.scale.term]) * ((before + behind) / 2.0) + drive[kind.zero.term]);
  }
  return read;
}

/// What a segment of two readings or more reads: of position, then of each channel beside it.
template <class Real>
std::vector<std::vector<Real>> readings_of(const Drive<Real>& drive, const MotionLog& log,
                                           const Segment& segment, const Real& reading, const Real& v) {
  std::vector<std::vector<Real>> read(1 + log.beside.size());
  roll_out(
      drive, log, segment, reading, v,
      [&](std::size_t k, const Motion<Real>& state, const Imposed<Real>& now) {
        read[0].push_back(state.reading(now.encoder));
        if (k + 1 < segment.end - segment.first)
          for (std::size_t i = 1; i < read.size(); ++i) read[i].emplace_back(0);
      },
      [&](double share, const Motion<Real>& state, const Imposed<Real>& now) {
        if (read.size() == 1) return;
        for (std::size_t i = 1; i < read.size(); ++i)
          read[i].back() = read[i].back() + share * quantity_of(log.beside[i - 1].channel, drive, state, now);
      });
  const auto delayed = [&](std::vector<Real>& course, Term term) {
    if (drive.has(term)) course = late(course, log, segment, drive[term]);
  };
  delayed(read[0], Term::position_delay);
  for (std::size_t i = 1; i < read.size(); ++i) {
    const ChannelKind& kind = kind_of(log.beside[i - 1].channel);
    read[i] = channel_of(read[i], drive, kind);
    delayed(read[i], kind.delay.term);
  }
  return read;
}

/// The readings of position of a segment.
template <class Real>
std::vector<Real> angles_of(const Drive<Real>& drive, const MotionLog& log, const Segment& segment,
                            const Real& reading, const Real& v) {
  return readings_of(drive, log, segment, reading, v).front();
}

}  // namespace plumbline::motion
