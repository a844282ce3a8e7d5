#pragma once
/// \file
/// What one joint answers to a deflection: spring, play, stop, sliders and Maxwell arms side by side.

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

/// A spring in series with a dry contact that slips at a torque. Dry friction is a very stiff one. One that
/// widens slides along d^2/2, and so gives a torque that goes with the deflection. One with a profile carries
/// a share of that, up to all of it, either way.
struct JointSlider {
  /// N m/rad, N m; of one that widens N m/rad^3, N m/rad; of a share 1/rad, 1.
  double stiffness = 0, yield = 0;
  FrictionLaw law = {};  ///< how the torque at which it slips departs from the yield
  bool widens = false;
  bool from_rest = false;  ///< has come along from rest to the first reading; others are at ease there
  std::optional<TorqueTable> profile = std::nullopt;

  /// A contact changes its state only by more than this share of the slip torque, which rounding cannot fake.
  static constexpr double rounding = 1e-7;

  [[nodiscard]] bool acts() const { return yield > 0 || law.growth > 0; }
  /// Torque at which it slips towards that side, 1 or -1, at a speed in rad/s.
  [[nodiscard]] double slip(double deflection, double side, double speed) const {
    return (yield + law.growth * std::abs(deflection)) * share(side, speed);
  }
  /// How far it has slid at a deflection, and its derivative.
  [[nodiscard]] double way(double deflection) const {
    return widens ? deflection * deflection / 2 : deflection;
  }
  [[nodiscard]] double lever(double deflection) const { return widens ? deflection : 1; }
  /// By which side and speed multiply it.
  [[nodiscard]] double share(double side, double speed) const {
    const double moving = law.fall == 0 ? 1 : 1 + law.fall * std::exp(-speed / law.speed);
    return (1 + side * law.uneven) * moving;
  }
};

/// As many Maxwell arms, and sliders, as a joint can have: of three effects that act together each brings its
/// own, beside those of a free law and of the nominal model: five elements of all joints and five of one, dry
/// friction, and a slider that is kept for the direction of motion.
inline constexpr std::size_t most_law_arms = 3, most_law_sliders = 7;
inline constexpr std::size_t most_nominal_arms = 3 + most_law_arms,
                             most_nominal_sliders = 10 + most_law_sliders;
inline constexpr std::size_t most_arms = most_nominal_arms + 3 + most_law_arms,
                             most_sliders = most_nominal_sliders + 12 + most_law_sliders;

/// What a joint remembers of its history, at the last reading.
struct JointMemory {
  double angle = 0;                              ///< q
  std::array<double, most_sliders> slider = {};  ///< what the sliders carry along their way
  std::array<double, most_arms> arm = {};        ///< torques that the Maxwell arms carry
  double set = 0;                                ///< how far the rest angle has moved
  double carried = 0;                            ///< largest torque of the spring beyond its yield
  double turn = 0;                               ///< |change of q| in the step before
  double speed = 0;                              ///< that it has in the step to come, rad/s
};

/// One joint's parameters. `rest` includes the rest error.
struct JointLaw {
  double stiffness = 0, rest = 0, backlash = 0;
  double stop = std::numeric_limits<double>::infinity(), stop_stiffness = 0, hardening = 0, asymmetry = 0;
  double knee = std::numeric_limits<double>::infinity(), give = 0;
  double yield = std::numeric_limits<double>::infinity(), flow = 0;
  std::array<double, most_arms> arm_stiffness = {};
  std::vector<JointSlider> slider = {};  ///< the first is the dry friction
  std::vector<TorqueTable> table = {};
  std::vector<StatedTorque> stated = {};
  /// The slider whose torque, between -1 and 1, is no torque but the direction in which the joint moves; none
  /// where nothing asks for it.
  std::size_t direction = std::numeric_limits<std::size_t>::max();

  /// Dry friction sticks as a spring this much stiffer than the joint's own: as good as rigid (it yields the
  /// slip torque after 1e-5 of the deflection that the spring needs for it) and still solved to ten digits.
  static constexpr double sticking = 1e5;
  /// A joint that turns back has another direction after so many rad, twice: less than angles are measured
  /// to, and enough to be solved to ten digits.
  static constexpr double turning = 1e-5;

  /// Spring with play, hardening and stop, and tables; of history it knows how far its rest angle has moved.
  [[nodiscard]] Torque elastic(double angle, const JointMemory& last = {}) const {
    const double d = angle - rest;
    Torque torque = flow > 0 ? flowing(d, last) : spring(d);
    for (const TorqueTable& one : table) torque += one.at(d);
    torque += felt_beyond(stop, stop_stiffness, d);
    return torque;
  }

  /// A slider by return mapping: what it carries along its way while it sticks or slips.
  [[nodiscard]] Torque along(const JointSlider& one, double carried, double angle, const JointMemory& last,
                             Contact contact) const {
    if (!one.acts()) return {};
    const double d = angle - rest, before = last.angle - rest, moved = one.way(d) - one.way(before);
    if (contact == Contact::sticks) return stretched(carried, one.stiffness, moved);
    const double side = contact == Contact::slips_up ? 1 : -1, share = side * one.share(side, last.speed);
    return {side * one.slip(d, side, last.speed), share * std::copysign(one.law.growth, d),
            share * (one.yield * moved + one.law.growth * (d * std::abs(d) - before * std::abs(before)) / 2)};
  }
  /// The torque that this is at the joint.
  [[nodiscard]] Torque dry(const JointSlider& one, double carried, double angle, const JointMemory& last,
                           Contact contact) const {
    const Torque felt = along(one, carried, angle, last, contact);
    if (one.profile) {
      const double d = angle - rest, before = last.angle - rest;
      const Torque whole = one.profile->at(d);
      return {felt.value * whole.value, felt.slope * whole.value + felt.value * whole.slope,
              one.profile->work(before, d, felt.value - felt.slope * (d - before), felt.value)};
    }
    if (!one.widens) return felt;
    const double lever = one.lever(angle - rest);
    return {felt.value * lever, felt.slope * lever * lever + felt.value, felt.energy};
  }

  /// The state that follows from a trial in state `contact`. A contact that is turned back sticks first: two
  /// joints can then not keep throwing each other from one direction of slip into the other.
  [[nodiscard]] Contact next(const JointSlider& one, double carried, double angle, const JointMemory& last,
                             Contact contact) const {
    const double d = angle - rest,
                 trial = carried + one.stiffness * (one.way(d) - one.way(last.angle - rest));
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

  /// A Maxwell arm after an interval in which the joint turned at a steady rate: exact.
  /// \param decay  exp(-dt/tau)
  /// \param gain   (1 - exp(-dt/tau)) tau/dt
  [[nodiscard]] Torque viscous(std::size_t arm, double angle, const JointMemory& last, double decay,
                               double gain) const {
    return stretched(decay * last.arm[arm], arm_stiffness[arm] * gain, angle - last.angle);
  }

  /// Lets the rest angle move as far as a reading at this angle makes it.
  void flow_to(double angle, JointMemory& memory) const {
    const double d = angle - rest - memory.set, held = held_back(d, memory);
    if (held == d) return;
    memory.set += d - held;
    memory.carried = stiffness * std::abs(held);
  }

 private:
  /// A spring that is felt beyond a deflection alone.
  static Torque felt_beyond(double limit, double stiffness, double d) {
    const double over = std::abs(d) - limit;
    if (!(over > 0)) return {};
    return {stiffness * std::copysign(over, d), stiffness, stiffness * over * over / 2};
  }

  /// Spring with play and hardening, stiffer to one side, that gives way beyond its knee.
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

  /// The deflection that the spring keeps of `d`: beyond the yield the rest follows.
  [[nodiscard]] double held_back(double d, const JointMemory& last) const {
    if (!(flow > 0) || !(stiffness > 0)) return d;
    const double limit = std::max(yield, last.carried) / stiffness, excess = std::abs(d) - limit;
    return excess > 0 ? std::copysign(limit + excess / (1 + flow), d) : d;
  }

  [[nodiscard]] Torque flowing(double d, const JointMemory& last) const {
    const double moved = d - last.set, held = held_back(moved, last);
    Torque torque = spring(held);
    if (held == moved) return torque;
    // From the limit on the joint turns 1 + flow as far as its spring.
    const double limit = std::copysign(std::max(yield, last.carried) / stiffness, moved);
    torque.slope /= 1 + flow;
    torque.energy += flow * (torque.energy - spring(limit).energy);
    return torque;
  }

  /// A spring that carried a torque before it was turned.
  static Torque stretched(double carried, double spring, double turn) {
    return {carried + spring * turn, spring, carried * turn + spring * turn * turn / 2};
  }
};

}  // namespace plumbline::diagnose
