#pragma once
/// \file
/// What one joint answers to a deflection: spring, play, stop, dry friction and Maxwell arm side by side.

#include <cmath>

namespace plumbline::diagnose {

/// A torque, its derivative with respect to the joint angle, and its integral: what the joint stores, or
/// takes in since the last reading where its torque depends on history.
struct Torque {
  double value = 0, slope = 0, energy = 0;

  Torque& operator+=(const Torque& other) {
    value += other.value;
    slope += other.slope;
    energy += other.energy;
    return *this;
  }
};

/// The state of a dry contact.
enum class Contact : signed char { slips_down = -1, sticks = 0, slips_up = 1 };

/// What a joint remembers of its history, at the last reading.
struct JointMemory {
  double angle = 0;     ///< q
  double friction = 0;  ///< torque that the dry friction carries
  double arm = 0;       ///< torque that the Maxwell arm carries
};

/// One joint's parameters. `rest` includes the rest error.
struct JointLaw {
  double stiffness, rest, backlash, stop, stop_stiffness, hardening, friction, arm_stiffness;

  /// A sticking contact is a spring this much stiffer than the joint's own: as good as rigid (it yields the
  /// slip torque after 1e-5 of the deflection that the spring needs for it) and still solved to ten digits.
  static constexpr double sticking = 1e5;
  /// A contact changes its state only by more than this share of the slip torque, which rounding cannot fake.
  static constexpr double rounding = 1e-7;

  /// Spring with play, hardening and stop: what does not depend on history.
  [[nodiscard]] Torque elastic(double angle) const {
    const double d = angle - rest;
    const double size = std::abs(d);
    Torque torque;
    if (const double e = std::copysign(size - backlash, d); size >= backlash) {
      torque = {stiffness * e * (1 + hardening * e * e), stiffness * (1 + 3 * hardening * e * e),
                stiffness * e * e * (1 + hardening * e * e / 2) / 2};
    }
    if (size > stop) {
      torque.value += stop_stiffness * std::copysign(size - stop, d);
      torque.slope += stop_stiffness;
      torque.energy += stop_stiffness * (size - stop) * (size - stop) / 2;
    }
    return torque;
  }

  /// Coulomb friction by return mapping: what the contact carries while it sticks or slips.
  [[nodiscard]] Torque dry(double angle, const JointMemory& last, Contact contact) const {
    if (friction <= 0 || stiffness <= 0) return {};
    const double turn = angle - last.angle;
    switch (contact) {
      case Contact::slips_up:
        return {friction, 0, friction * turn};
      case Contact::slips_down:
        return {-friction, 0, -friction * turn};
      case Contact::sticks:
        break;
    }
    return stretched(last.friction, sticking * stiffness, turn);
  }

  /// The state that follows from a trial in state `contact`. A contact that is turned back sticks first: two
  /// joints can then not keep throwing each other from one direction of slip into the other.
  [[nodiscard]] Contact next(double angle, const JointMemory& last, Contact contact) const {
    const double trial = last.friction + sticking * stiffness * (angle - last.angle);
    const double slack = rounding * friction;
    if (contact == Contact::sticks) {
      if (trial > friction + slack) return Contact::slips_up;
      return trial < -friction - slack ? Contact::slips_down : Contact::sticks;
    }
    const bool goes_on = contact == Contact::slips_up ? trial >= friction - slack : trial <= slack - friction;
    return goes_on ? contact : Contact::sticks;
  }

  /// The Maxwell arm after an interval in which the joint turned at a steady rate: exact.
  /// \param decay  exp(-dt/tau)
  /// \param gain   (1 - exp(-dt/tau)) tau/dt
  [[nodiscard]] Torque viscous(double angle, const JointMemory& last, double decay, double gain) const {
    return stretched(decay * last.arm, arm_stiffness * gain, angle - last.angle);
  }

 private:
  /// A spring that carried a torque before it was turned.
  static Torque stretched(double carried, double spring, double turn) {
    return {carried + spring * turn, spring, carried * turn + spring * turn * turn / 2};
  }
};

}  // namespace plumbline::diagnose
