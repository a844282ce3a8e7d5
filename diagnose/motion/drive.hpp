#pragma once
/// \file
/// A joint that a position servo drives: the terms of its equation of motion, and what is imposed on it.

#include <array>
#include <bitset>

#include "diagnose/motion/dual.hpp"

namespace plumbline::motion {

/// The numbers of servo, gear and joint. Each is zero where the drive does not have it.
enum class Term : std::size_t {
  stall_torque,      ///< at duty one, per volt of the supply, N m/V
  back_emf,          ///< torque lost with speed while powered, N m s/rad
  armature,          ///< inertia of the rotor as the joint feels it, kg m^2
  zero,              ///< the joint's angle where the encoder reads zero, rad
  dry,               ///< dry friction, N m
  viscous,           ///< viscous friction, N m s/rad
  command_delay,     ///< s
  drive_lag,         ///< time constant from duty to torque, s
  dead_band,         ///< of the servo's error, rad
  duty_missing,      ///< one less the largest duty
  command_offset,    ///< added to the command, rad
  command_scale,     ///< of the command, less one
  encoder_scale,     ///< angle of the joint over the reading, less one
  torque_offset,     ///< a torque that always acts, N m
  dry_rising,        ///< dry friction at rest over that of fast motion (Stribeck), N m
  rising_speed,      ///< speed at which it has fallen to 1/e, rad/s
  drag,              ///< friction with the square of speed, N m s^2/rad^2
  loss_driving,      ///< share of the torque through the gear that is lost where it drives the load
  loss_driven,       ///< the same where the load drives it
  direction,         ///< dry friction that is added one way and missing the other, N m
  load_mass,         ///< of the load over the stated one, less one
  spring,            ///< of the surroundings about the zero, N m/rad
  brake,             ///< torque lost with speed while not powered, N m s/rad
  command_slowness,  ///< one over the largest speed of the servo's reference, s/rad
  clock_rate,        ///< true time over that of the stamps, less one
  play,              ///< angle by which the joint is free against the rotor, rad
  gear_compliance,   ///< of the gear between rotor and joint, rad/(N m)
  gear_damping,      ///< of the same, N m s/rad
  derivative_gain,   ///< duty that the servo takes back with the speed of its reading, s/rad
  integral_gain,     ///< duty over the integral of the servo's error, 1/(rad s)
  gravity_forward,   ///< share of the load's weight that the servo carries beforehand
  periods,           ///< of the motor's torque in a turn of the joint
  cogging_sine,      ///< torque over the sine of so many times the angle, N m
  cogging_cosine,    ///< the same over the cosine, N m
  ripple_sine,       ///< the same over the torque of the motor
  ripple_cosine,     ///< the same over the cosine
  contact_above,     ///< of a spring that acts from an angle on, upward, N m/rad
  above_from,        ///< that angle, rad
  contact_below,     ///< of a spring that acts from an angle on, downward, N m/rad
  below_from,        ///< that angle, rad
  friction_warming,  ///< of all friction, with temperature, share per K
  base_motion,       ///< share of the base's acceleration that moves the joint
  position_delay,    ///< of the reading of position, s
  velocity_scale,    ///< of the reading of velocity, less one
  velocity_zero,     ///< of the same, rad/s
  velocity_delay,    ///< of the same, s
  duty_scale,        ///< of the reading of duty, less one
  duty_zero,         ///< of the same
  duty_delay,        ///< of the same, s
  torque_scale,      ///< of the reading of torque, less one
  torque_zero,       ///< of the same, N m
  torque_delay,      ///< of the same, s
  count
};

template <class Real>
class Drive {
 public:
  Drive() { values_.fill(Real(0)); }
  Real& operator[](Term term) {
    there_.set(static_cast<std::size_t>(term));
    return values_[static_cast<std::size_t>(term)];
  }
  const Real& operator[](Term term) const { return values_[static_cast<std::size_t>(term)]; }
  /// Whether a term was ever set.
  [[nodiscard]] bool has(Term term) const { return there_.test(static_cast<std::size_t>(term)); }
  /// Whether rotor and joint move apart.
  [[nodiscard]] bool gives_way() const { return has(Term::play) || has(Term::gear_compliance); }

 private:
  std::array<Real, static_cast<std::size_t>(Term::count)> values_;
  std::bitset<static_cast<std::size_t>(Term::count)> there_;
};

/// The same drive in another type of numbers.
template <class Real>
Drive<Real> carried_by(const Drive<double>& drive) {
  Drive<Real> carried;
  for (std::size_t t = 0; t < static_cast<std::size_t>(Term::count); ++t)
    if (const auto term = static_cast<Term>(t); drive.has(term)) carried[term] = Real(drive[term]);
  return carried;
}

/// The side of the gear at which the servo and the log read the position.
enum class EncoderSide { joint, motor };

/// What is imposed during a step.
template <class Real>
struct Imposed {
  Real command;   ///< mean over the step, rad
  double gain;    ///< duty per rad of error
  double supply;  ///< V
  bool powered;
  Real inertia;    ///< of the load, kg m^2
  double gravity;  ///< moment of the load's weight where it is horizontal, N m
  EncoderSide encoder = EncoderSide::joint;
  double warmer = 0;             ///< than the mean of the logs, K
  double base_acceleration = 0;  ///< horizontal, in the direction in which a hanging load rises, m/s^2
};

/// A state of joint and rotor.
template <class Real>
struct Motion {
  Real q, v;           ///< of the joint, as an encoder there reads them: rad and rad/s
  Real asked{0};       ///< duty that the servo asked for, at the middle of the step
  Real acting{0};      ///< duty that acts, behind the lag
  Real reference{0};   ///< that the servo follows: the command where its speed is not limited
  Real integrated{0};  ///< duty of the servo's integral part
  Real speeding{0};    ///< acceleration of the reading over the step, rad/s^2
  Real twist{0};       ///< of the rotor against the joint, rad
  Real twisting{0};    ///< its speed, rad/s

  /// The reading of position, and its speed.
  [[nodiscard]] Real reading(EncoderSide side) const { return side == EncoderSide::joint ? q : q + twist; }
  [[nodiscard]] Real speed(EncoderSide side) const { return side == EncoderSide::joint ? v : v + twisting; }
};

/// The joint's angle, or speed, where its encoder reads this one; and the other way round.
template <class Real>
Real joint_angle(const Drive<Real>& drive, const Real& reading) {
  return drive.has(Term::encoder_scale) ? (1 + drive[Term::encoder_scale]) * reading : reading;
}
template <class Real>
Real encoder_angle(const Drive<Real>& drive, const Real& angle) {
  return drive.has(Term::encoder_scale) ? angle / (1 + drive[Term::encoder_scale]) : angle;
}

template <class Real>
Real limited(const Real& x, const Real& limit) {
  return x > limit ? limit : x < -limit ? -limit : x;
}

/// The error that the servo acts on.
template <class Real>
Real servo_error(const Drive<Real>& drive, const Real& reference, const Real& reading) {
  Real error = reference - reading;
  if (drive.has(Term::command_scale)) error = error + drive[Term::command_scale] * reference;
  if (drive.has(Term::command_offset)) error = error + drive[Term::command_offset];
  if (drive.has(Term::dead_band)) error = error - limited(error, drive[Term::dead_band]);
  return error;
}

/// The duty of the servo's integral part a time later; none is kept beyond the whole duty.
template <class Real>
Real integrated(const Drive<Real>& drive, const Real& duty, const Real& error, double time) {
  return limited<Real>(duty + time * (drive[Term::integral_gain] * error), Real(1));
}

/// The duty that the servo asks for.
/// \param speed       of the reading
/// \param integrated  its integral part
template <class Real>
Real asked_duty(const Drive<Real>& drive, const Imposed<Real>& now, const Real& error, const Real& reading,
                const Real& speed, const Real& integrated) {
  using std::sin;
  Real duty = now.gain * error;
  if (drive.has(Term::derivative_gain)) duty = duty - drive[Term::derivative_gain] * speed;
  if (drive.has(Term::integral_gain)) duty = duty + integrated;
  if (drive.has(Term::gravity_forward) && value_of(drive[Term::stall_torque]) > 0)
    duty = duty + drive[Term::gravity_forward] * (now.gravity / now.supply) * sin(reading) /
                      drive[Term::stall_torque];
  return limited<Real>(duty, 1 - drive[Term::duty_missing]);
}

}  // namespace plumbline::motion
