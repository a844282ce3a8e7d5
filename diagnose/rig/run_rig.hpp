#pragma once
/// \file
/// The rig in one run: its unknowns, its history and what is imposed.

#include <plumbline/base/number.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <plumbline/loaded/control.hpp>
#include <span>
#include <vector>

#include "diagnose/rig/chain_loads.hpp"
#include "diagnose/rig/joint_law.hpp"
#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The unknowns: node angles (one a link, three for bending links), the states of the dry contacts, and the
/// force on the end point.
struct Posture {
  Vector<double> angle;
  std::vector<Contact> contact;  ///< of each joint's sliders, see Layout
  Point<double> force{0, 0};
};

/// Time constants of the Maxwell arms, s: first those of every spring, then those of free laws.
std::vector<double> arm_times(const Rig& rig);
/// Number of sliders of a joint without its dry friction.
/// \param joint  from 0
std::size_t slider_count(const Rig& rig, std::size_t joint);
/// Number of sliders of each joint, with dry friction and the direction of motion.
std::size_t contact_count(const Rig& rig);

/// The rig during one run, with the present rest angles of its joints.
struct RunRig {
  /// \param own  the rig in this run
  RunRig(Rig own, const std::vector<double>& commanded_rest);
  /// Commands other rest angles.
  void turn_to(const std::vector<double>& commanded_rest);
  Rig rig;
  std::vector<double> arm_time;  ///< see arm_times()
  std::vector<JointLaw> joint;
  std::vector<double> command;  ///< rest angles that are commanded
  double rest_orientation;      ///< theta_n of the unloaded shape
  double largest_stiffness;     ///< of all joints
  std::vector<Vector2> beyond;  ///< weight of the links beyond link j
};

/// The interval before a reading, for the history of the joints.
struct TimeStep {
  TimeStep() { decay.fill(1), gain.fill(1); }
  bool relaxed = true;  ///< a slow approach before the first reading: no Maxwell arm, few sliders
  double end = 0;       ///< time of the reading, s
  std::span<const double> covariates = {};    ///< at the reading
  std::array<double, most_arms> decay, gain;  ///< of the rig's arms
};

/// A rig between two readings, with the memory of its joints at the first.
struct RigStep {
  const RunRig& run;
  TimeStep interval;
  const std::vector<JointMemory>& memory;
};

/// The interval of that length, s, after an earlier reading; zero where no time passes.
TimeStep time_step(const RunRig& run, double dt);

/// The torque of a joint's sliders and Maxwell arms at an angle.
/// \param contact  the states of its sliders
inline Torque history_torque(const RigStep& step, std::size_t joint, double q, const Contact* contact) {
  const JointLaw& law = step.run.joint[joint];
  const JointMemory& last = step.memory[joint];
  Torque torque;
  for (std::size_t s = 0; s < law.slider.size(); ++s)
    if (s != law.direction && law.slider[s].acts() && (law.slider[s].from_rest || !step.interval.relaxed))
      torque += law.dry(law.slider[s], last.slider[s], q, last, contact[s]);
  if (step.interval.relaxed) return torque;
  for (std::size_t a = 0; a < step.run.arm_time.size(); ++a)
    torque += law.viscous(a, q, last, step.interval.decay[a], step.interval.gain[a]);
  return torque;
}

/// The direction of a joint's motion, which a slider represents for user effects: 1 or -1, or between them
/// while the joint sticks; 0 before the first motion.
Torque direction_of_motion(const RigStep& step, std::size_t joint, double q, const Contact* contact);
/// The variables of user effects at a joint.
/// \param force  on the end point
StatedTorque::Place stated_place(const RigStep& step, std::size_t joint, double q,
                                 const Vector3<double>& force);

/// Brings the memory of a joint to the angle at which it has arrived.
void remember(const RunRig& run, const TimeStep& during, std::size_t joint, double q, const Contact* contact,
              JointMemory& memory);

/// Makes the states of the dry contacts consistent with joint angles: all of them, which is fast but may
/// cycle, or the first inconsistent one, which does not cycle (Murty's rule).
/// \param sliders  of each joint in `contact`
/// \param angle    of a joint, by its number
/// \returns whether one changed
template <class Angle>
bool settle_contacts(const RigStep& step, std::size_t sliders, bool all, Angle angle,
                     std::vector<Contact>& contact) {
  bool changed = false;
  for (std::size_t i = 0; sliders > 0 && i < step.run.joint.size(); ++i) {
    const JointLaw& law = step.run.joint[i];
    const JointMemory& last = step.memory[i];
    const double q = angle(i);
    for (std::size_t s = 0; s < law.slider.size(); ++s) {
      if (step.interval.relaxed && !law.slider[s].from_rest) continue;
      Contact& state = contact[i * sliders + s];
      if (!law.slider[s].acts()) {
        // The slider carries nothing; the direction of vanishing friction opposes the motion.
        state = q < last.angle ? Contact::slips_down : Contact::slips_up;
        continue;
      }
      const Contact next = law.next(law.slider[s], last.slider[s], q, last, state);
      if (next == state) continue;
      state = next;
      changed = true;
      if (!all) return true;
    }
  }
  return changed;
}

/// What is imposed: the true end point or the true force, and the loads along the chain.
struct Imposed {
  Control control;
  Vector2 value;
  ChainLoads loads = {};
};

/// The unknowns and their coupling.
struct Layout {
  std::size_t links;
  bool bending, coupled;
  std::size_t sliders;  ///< of each joint
  [[nodiscard]] std::size_t nodes_per_link() const { return bending ? 3 : 1; }
  [[nodiscard]] std::size_t nodes() const { return links * nodes_per_link(); }
  /// Index of the state of a joint's slider.
  [[nodiscard]] std::size_t contact(std::size_t joint, std::size_t slider) const {
    return joint * sliders + slider;
  }
  [[nodiscard]] std::size_t first(std::size_t link) const { return link * nodes_per_link(); }
  [[nodiscard]] std::size_t last(std::size_t link) const { return first(link) + nodes_per_link() - 1; }
  /// Half-bandwidth of the stiffness: 1, 2 or 4.
  [[nodiscard]] int bandwidth() const { return (bending ? 2 : 1) * (coupled ? 2 : 1); }
  /// q_i of a shape, i from 0.
  [[nodiscard]] double joint_angle(const Vector<double>& angle, std::size_t i) const {
    const double before = i > 0 ? angle(static_cast<Eigen::Index>(last(i - 1))) : 0.0;
    return angle(static_cast<Eigen::Index>(first(i))) - before;
  }
};

}  // namespace plumbline::diagnose
