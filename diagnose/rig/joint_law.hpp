#pragma once
/// \file
/// The torque law of one joint: spring, play, stop, sliders and Maxwell arms in parallel.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "diagnose/rig/rig.hpp"
#include "diagnose/rig/stated.hpp"
#include "diagnose/rig/torque.hpp"

namespace plumbline::diagnose {

/// The state of a slider.
enum class Contact : signed char { slips_down = -1, sticks = 0, slips_up = 1 };

/// A slider (Jenkins element): a spring in series with a dry contact that slips at a torque. Dry friction is
/// a very stiff slider. A widening slider moves along d^2/2, so that its torque grows with the deflection d.
/// A slider with a profile carries a fraction of that profile, between -1 and 1.
struct JointSlider {
  /// Units N m/rad, N m; for a widening slider N m/rad^3, N m/rad; for one with a profile 1/rad, 1.
  double stiffness = 0, yield = 0;
  FrictionLaw law = {};  ///< dependence of the slip torque on deflection, direction and speed
  bool widens = false;
  bool from_rest = false;  ///< is loaded from rest on; others start relaxed at the first reading
  std::optional<TorqueTable> profile = std::nullopt;
  /// Rubs in the bearing: the turn of the joint moves it, and a command does not. Others are parts of the
  /// spring, which its deflection from the commanded angle moves.
  bool in_bearing = false;

  /// Relative margin of the slip torque by which a contact changes its state: above rounding.
  static constexpr double rounding = 1e-7;

  [[nodiscard]] bool acts() const { return yield > 0 || law.growth > 0; }
  /// Slip torque in direction `side`, 1 or -1, at a speed in rad/s.
  [[nodiscard]] double slip(double deflection, double side, double speed) const {
    return (yield + law.growth * std::abs(deflection)) * share(side, speed);
  }
  /// The slider's coordinate at a deflection, and its derivative.
  [[nodiscard]] double way(double deflection) const {
    return widens ? deflection * deflection / 2 : deflection;
  }
  [[nodiscard]] double lever(double deflection) const { return widens ? deflection : 1; }
  /// Factor of the slip torque by direction and speed.
  [[nodiscard]] double share(double side, double speed) const {
    const double moving = law.fall == 0 ? 1 : 1 + law.fall * std::exp(-speed / law.speed);
    return (1 + side * law.uneven) * moving;
  }
};

/// Largest numbers of Maxwell arms and sliders of a joint: those of three effects, of a free law and of the
/// nominal model. They comprise five elements of all joints, five of one joint, dry friction, and a slider
/// that represents the direction of motion.
inline constexpr std::size_t most_law_arms = 3, most_law_sliders = 7;
inline constexpr std::size_t most_nominal_arms = 3 + most_law_arms,
                             most_nominal_sliders = 10 + most_law_sliders;
inline constexpr std::size_t most_arms = most_nominal_arms + 3 + most_law_arms,
                             most_sliders = most_nominal_sliders + 12 + most_law_sliders;

/// The memory of a joint at the last reading.
struct JointMemory {
  double angle = 0;                              ///< q
  double led = 0;                                ///< change of the rest angle since then, rad
  std::array<double, most_sliders> slider = {};  ///< forces of the sliders along their coordinates
  std::array<double, most_arms> arm = {};        ///< torques of the Maxwell arms
  double set = 0;                                ///< plastic change of the rest angle
  double carried = 0;                            ///< largest torque of the spring beyond its yield
  double turn = 0;                               ///< |change of q| in the last step
  double speed = 0;                              ///< expected speed in the next step, rad/s
};

/// One joint's parameters. `rest` includes the rest error.
struct JointLaw {
  double stiffness = 0, rest = 0, backlash = 0;
  double stop = std::numeric_limits<double>::infinity(), stop_stiffness = 0, hardening = 0, asymmetry = 0;
  double knee = std::numeric_limits<double>::infinity(), give = 0;
  Travel travel = {};
  double yield = std::numeric_limits<double>::infinity(), flow = 0;
  bool hardens = true;  ///< the yield rises to the largest torque so far
  std::array<double, most_arms> arm_stiffness = {};
  std::vector<JointSlider> slider = {};  ///< the first is the dry friction
  std::vector<TorqueTable> table = {};
  std::vector<StatedTorque> stated = {};
  /// The slider that represents the direction of motion, between -1 and 1, instead of a torque; none where no
  /// expression uses the direction.
  std::size_t direction = std::numeric_limits<std::size_t>::max();

  /// Stiffness of sticking dry friction over that of the joint's spring: it reaches the slip torque after
  /// 1e-5 of the deflection that the spring needs for it, and is still solved to ten digits.
  static constexpr double sticking = 1e5;
  /// Stiffness of the ends of travel over that of the joint's spring: a command goes on beyond them, and the
  /// joint by a ten-thousandth of that.
  static constexpr double unyielding = 1e4;
  /// Plastic over elastic deflection of a spring that slips at its fixture: its torque rises by a hundredth
  /// of a per cent of what the spring would, and is still solved to ten digits.
  static constexpr double slipping = 1e4;
  /// Half the turn, rad, after which a reversing joint has changed its direction: below the resolution of
  /// measured angles, and still solved to ten digits.
  static constexpr double turning = 1e-5;

  /// Spring with play, hardening, stop and tables; of the history only the plastic change of the rest angle.
  [[nodiscard]] Torque elastic(double angle, const JointMemory& last = {}) const {
    const double d = angle - rest;
    Torque torque = flow > 0 ? flowing(d, last) : spring(d);
    for (const TorqueTable& one : table) torque += one.at(d);
    torque += felt_beyond(stop, stop_stiffness, d);
    torque += felt_at_the_end_of_travel(angle);
    return torque;
  }

  /// The force of a slider along its coordinate, by return mapping.
  [[nodiscard]] Torque along(const JointSlider& one, double carried, double angle, const JointMemory& last,
                             Contact contact) const {
    if (!one.acts()) return {};
    const double d = angle - rest, before = last_place(one, last), moved = one.way(d) - one.way(before);
    if (contact == Contact::sticks) return stretched(carried, one.stiffness, moved);
    const double side = contact == Contact::slips_up ? 1 : -1, share = side * one.share(side, last.speed);
    return {side * one.slip(d, side, last.speed), share * std::copysign(one.law.growth, d),
            share * (one.yield * moved + one.law.growth * (d * std::abs(d) - before * std::abs(before)) / 2)};
  }
  /// The torque of a slider at the joint.
  [[nodiscard]] Torque dry(const JointSlider& one, double carried, double angle, const JointMemory& last,
                           Contact contact) const {
    const Torque felt = along(one, carried, angle, last, contact);
    if (one.profile) {
      const double d = angle - rest, before = last_place(one, last);
      const Torque whole = one.profile->at(d);
      return {felt.value * whole.value, felt.slope * whole.value + felt.value * whole.slope,
              one.profile->work(before, d, felt.value - felt.slope * (d - before), felt.value)};
    }
    if (!one.widens) return felt;
    const double lever = one.lever(angle - rest);
    return {felt.value * lever, felt.slope * lever * lever + felt.value, felt.energy};
  }

  /// The state that follows from a trial in state `contact`. A reversing contact sticks first, so that two
  /// joints cannot alternate between directions of slip without end.
  [[nodiscard]] Contact next(const JointSlider& one, double carried, double angle, const JointMemory& last,
                             Contact contact) const {
    const double d = angle - rest,
                 trial = carried + one.stiffness * (one.way(d) - one.way(last_place(one, last)));
    const auto beyond = [&](double side, double rounding) {
      return side * trial > one.slip(d, side, last.speed) * (1 + rounding);
    };
    if (contact == Contact::sticks) {
      if (beyond(1, JointSlider::rounding)) return Contact::slips_up;
      return beyond(-1, JointSlider::rounding) ? Contact::slips_down : Contact::sticks;
    }
    const double side = contact == Contact::slips_up ? 1 : -1;
    return beyond(side, -JointSlider::rounding) ? contact : Contact::sticks;
  }

  /// The torque of a Maxwell arm after an interval at constant speed of its deflection (exact).
  /// \param decay  exp(-dt/tau)
  /// \param gain   (1 - exp(-dt/tau)) tau/dt
  [[nodiscard]] Torque viscous(std::size_t arm, double angle, const JointMemory& last, double decay,
                               double gain) const {
    return stretched(decay * last.arm[arm], arm_stiffness[arm] * gain, angle - last.angle - last.led);
  }

  /// Updates the plastic change of the rest angle after a reading at this angle.
  void flow_to(double angle, JointMemory& memory) const {
    const double d = angle - rest - memory.set, held = held_back(d, memory);
    if (held == d) return;
    memory.set += d - held;
    if (hardens) memory.carried = stiffness * (std::abs(held) - backlash);
  }

 private:
  /// The deflection at the last reading as a slider counts it.
  [[nodiscard]] double last_place(const JointSlider& one, const JointMemory& last) const {
    return one.in_bearing ? last.angle - rest : last.angle - (rest - last.led);
  }

  /// A spring that acts beyond a deflection.
  static Torque felt_beyond(double limit, double stiffness, double d) {
    const double over = std::abs(d) - limit;
    if (!(over > 0)) return {};
    return {stiffness * std::copysign(over, d), stiffness, stiffness * over * over / 2};
  }

  [[nodiscard]] Torque felt_at_the_end_of_travel(double angle) const {
    const double over = angle > travel.high ? angle - travel.high : std::min(angle - travel.low, 0.0);
    if (over == 0) return {};
    const double stiff = unyielding * stiffness;
    return {stiff * over, stiff, stiff * over * over / 2};
  }

  /// Spring with play, hardening, asymmetry and a softer slope beyond its knee.
  [[nodiscard]] Torque spring(double d) const {
    const double size = std::abs(d);
    if (size < backlash) return {};
    const double e = std::copysign(size - backlash, d),
                 k = stiffness * (1 + std::copysign(1.0, d) * asymmetry);
    Torque torque{k * e * (1 + hardening * e * e), k * (1 + 3 * hardening * e * e),
                  k * e * e * (1 + hardening * e * e / 2) / 2};
    torque += felt_beyond(knee, -give * k, e);
    return torque;
  }

  /// The deflection at which the spring, past its play, yields.
  [[nodiscard]] double yields_at(const JointMemory& last) const {
    return backlash + std::max(yield, last.carried) / stiffness;
  }

  /// The elastic part of a deflection; beyond the yield the remainder is plastic.
  [[nodiscard]] double held_back(double d, const JointMemory& last) const {
    if (!(flow > 0) || !(stiffness > 0)) return d;
    const double limit = yields_at(last), excess = std::abs(d) - limit;
    return excess > 0 ? std::copysign(limit + excess / (1 + flow), d) : d;
  }

  [[nodiscard]] Torque flowing(double d, const JointMemory& last) const {
    const double moved = d - last.set, held = held_back(moved, last);
    Torque torque = spring(held);
    if (held == moved) return torque;
    // Beyond the limit the joint turns 1 + flow times as far as its spring.
    torque.slope /= 1 + flow;
    torque.energy += flow * (torque.energy - spring(std::copysign(yields_at(last), moved)).energy);
    return torque;
  }

  /// A spring with an initial torque, after a turn.
  static Torque stretched(double carried, double spring, double turn) {
    return {carried + spring * turn, spring, carried * turn + spring * turn * turn / 2};
  }
};

}  // namespace plumbline::diagnose
