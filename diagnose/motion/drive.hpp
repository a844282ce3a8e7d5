#pragma once
/// \file
/// A joint that a position servo drives: the terms of its equation of motion, and one step in time.

#include <array>

#include "diagnose/motion/dual.hpp"

namespace plumbline::motion {

/// The numbers of servo, gear and joint. Each is zero where the drive does not have it.
enum class Term : std::size_t {
  stall_torque,    ///< at duty one, per volt of the supply, N m/V
  back_emf,        ///< torque lost with speed while powered, N m s/rad
  armature,        ///< inertia of the rotor as the joint feels it, kg m^2
  zero,            ///< the joint's angle where the encoder reads zero, rad
  dry,             ///< dry friction, N m
  viscous,         ///< viscous friction, N m s/rad
  command_delay,   ///< s
  drive_lag,       ///< time constant from duty to torque, s
  dead_band,       ///< of the servo's error, rad
  duty_missing,    ///< one less the largest duty
  command_offset,  ///< added to the command, rad
  command_scale,   ///< of the command, less one
  encoder_scale,   ///< angle of the joint over the reading, less one
  torque_offset,   ///< a torque that always acts, N m
  dry_rising,      ///< dry friction at rest over that of fast motion (Stribeck), N m
  rising_speed,    ///< speed at which it has fallen to 1/e, rad/s
  drag,            ///< friction with the square of speed, N m s^2/rad^2
  loss_driving,    ///< share of the torque through the gear that is lost where it drives the load
  loss_driven,     ///< the same where the load drives it
  direction,       ///< dry friction that is added one way and missing the other, N m
  load_mass,       ///< of the load over the stated one, less one
  spring,          ///< of the surroundings about the zero, N m/rad
  brake,           ///< torque lost with speed while not powered, N m s/rad
  count
};

template <class Real>
class Drive {
 public:
  Drive() { values_.fill(Real(0)); }
  Real& operator[](Term term) { return values_[static_cast<std::size_t>(term)]; }
  const Real& operator[](Term term) const { return values_[static_cast<std::size_t>(term)]; }
  /// Whether a term is there at all.
  [[nodiscard]] bool has(Term term) const { return value_of((*this)[term]) != 0; }

 private:
  std::array<Real, static_cast<std::size_t>(Term::count)> values_;
};

/// What is imposed during a step.
template <class Real>
struct Imposed {
  Real command;   ///< mean over the step, rad
  double gain;    ///< duty per rad of error
  double supply;  ///< V
  bool powered;
  double inertia;  ///< of the load, kg m^2
  double gravity;  ///< moment of the load's weight where it is horizontal, N m
};

/// A state of the joint.
template <class Real>
struct Motion {
  Real q, v;       ///< as the encoder reads them, rad and rad/s
  Real acting{0};  ///< duty that acts, behind the lag
};

template <class Real>
Real limited(const Real& x, const Real& limit) {
  return x > limit ? limit : x < -limit ? -limit : x;
}

/// The duty that the servo asks for.
template <class Real>
Real asked_duty(const Drive<Real>& drive, const Imposed<Real>& now, const Real& q) {
  Real error = (1 + drive[Term::command_scale]) * now.command + drive[Term::command_offset] - q;
  error = error - limited(error, drive[Term::dead_band]);
  return limited<Real>(now.gain * error, 1 - drive[Term::duty_missing]);
}

/// The state a time h later: half a step of the angle, a whole one of the speed, half a step of the angle
/// (Störmer-Verlet). Friction is that of Moreau's scheme of impulses: a joint that sticks has the speed zero
/// to the last bit.
///
/// A gear loses a share of the torque that passes it, another one by the direction in which power flows
/// (Hamon, Gautier and Garrec 2010); that torque follows from the balance without the loss.
template <class Real>
Motion<Real> after(const Drive<Real>& drive, const Imposed<Real>& now, const Motion<Real>& from, double h) {
  using std::sin, std::exp, std::abs;
  const Real q = from.q + h / 2 * from.v;
  Motion<Real> next = from;
  next.acting = asked_duty(drive, now, q);
  if (drive.has(Term::drive_lag))
    next.acting = next.acting + (from.acting - next.acting) * exp(Real(-h) / drive[Term::drive_lag]);
  const Real scale = 1 + drive[Term::encoder_scale], mass = 1 + drive[Term::load_mass];
  const Real angle = scale * q + drive[Term::zero];
  const Real load = now.inertia * mass, inertia = load + drive[Term::armature];
  const Real against =
      now.gravity * mass * sin(angle) + drive[Term::spring] * angle - drive[Term::torque_offset];
  const Real motor = now.powered ? drive[Term::stall_torque] * now.supply * next.acting : Real(0);
  const Real damping = drive[Term::viscous] + drive[now.powered ? Term::back_emf : Term::brake];
  const Real pushed = (inertia - h / 2 * damping) * scale * from.v + h * (motor - against);
  const double way = value_of(pushed) > 0 ? 1 : -1;
  const Real passed = (against * drive[Term::armature] + motor * load) / inertia;
  const Real& loss = drive[value_of(passed) * way > 0 ? Term::loss_driving : Term::loss_driven];
  Real friction = drive[Term::dry] + way * drive[Term::direction] + loss * abs(passed);
  if (drive.has(Term::drag)) friction = friction + drive[Term::drag] * from.v * from.v;
  if (drive.has(Term::dry_rising))
    friction = friction + drive[Term::dry_rising] * exp(-(abs(from.v) / drive[Term::rising_speed]));
  const Real sliding = (pushed - way * h * friction) / ((inertia + h / 2 * damping) * scale);
  next.v = value_of(sliding) * way > 0 ? sliding : Real(0);
  next.q = q + h / 2 * next.v;
  return next;
}

}  // namespace plumbline::motion
