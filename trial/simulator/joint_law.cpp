#include "trial/simulator/joint_law.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::simulator {

Contact::Contact(double spring, double response) {
  constexpr double damping_ratio = 0.3;
  stiffness_ = relative_stiffness * spring;
  damping_ = 2 * damping_ratio * std::sqrt(stiffness_ * spring) * response;
}

void Contact::follow(double turn, double slip, double uneven) {
  bend_ += turn;
  const double limit = slip * (1 + std::copysign(uneven, uneven * bend_)) / stiffness_;
  sticks_ = std::abs(bend_) < limit;
  bend_ = std::clamp(bend_, -limit, limit);
}

JointLaw::JointLaw(const Joint& joint, double response, double interval)
    : joint_(joint),
      interval_(interval),
      contact_(joint.stiffness, response),
      arm_(joint.arm.size(), 0),
      slider_(joint.slider.size(), 0) {}

double JointLaw::slip(double deflection) const {
  const Friction& f = joint_.friction;
  return f.torque * (1 + f.growth * std::abs(deflection)) * (1 + f.ripple * std::sin(f.waves * deflection)) *
         (1 + f.fall * std::exp(-rate_ / f.speed)) * std::exp(-way_ / f.run_in) *
         (std::abs(deflection) < f.clear ? 0 : 1);
}

/// The set grows with the torque beyond what has been carried so far.
void JointLaw::yield(double deflection) {
  const double torque = joint_.stiffness * (deflection - set_), limit = std::max(joint_.yield, carried_);
  if (joint_.flow == 0 || std::abs(torque) <= limit) return;
  carried_ = limit + (std::abs(torque) - limit) / (1 + joint_.flow);
  set_ = deflection - std::copysign(carried_, torque) / joint_.stiffness;
}

void JointLaw::remember(double deflection, double dt) {
  const double turn = deflection - last_;
  last_ = deflection;
  yield(deflection);
  for (std::size_t a = 0; a < arm_.size(); ++a)
    arm_[a] += (relaxed_ ? 1.0 : -std::expm1(-dt / joint_.arm[a].time)) * (deflection - arm_[a]);
  largest_ = relaxed_ ? std::abs(deflection) : std::max(largest_, std::abs(deflection));
  if (relaxed_) return;
  time_ += dt;
  way_ += std::abs(turn);
  rate_ += -std::expm1(-dt / interval_) * (std::abs(turn) / dt - rate_);
  for (std::size_t s = 0; s < slider_.size(); ++s) {
    const double limit = joint_.slider[s].yield / (joint_.slider[s].ratio * joint_.stiffness);
    slider_[s] = std::clamp(slider_[s] + turn, -limit, limit);
  }
  if (joint_.friction.torque > 0) contact_.follow(turn, slip(deflection), joint_.friction.uneven);
}

double JointLaw::spring(double deflection) const {
  const double d = deflection - set_;
  const double turned = std::copysign(std::max(0.0, std::abs(d) - joint_.backlash), d);  // behind its play
  const double given = joint_.give * std::copysign(std::max(0.0, std::abs(turned) - joint_.knee), turned);
  const double cubic = joint_.hardening * turned * turned;
  if (joint_.plain()) return -joint_.stiffness * cubic * turned + joint_.stiffness * given;
  const Ageing& age = joint_.ageing;
  const double factor = (1 + std::copysign(joint_.asymmetry, joint_.asymmetry * d)) *
                        std::max(0.2, 1 - joint_.softening * std::max(largest_, std::abs(deflection))) /
                        (1 + age.creep * std::log1p(time_ / age.start)) *
                        (1 + age.loss * std::expm1(-time_ / age.warming));
  return -joint_.stiffness * factor * (1 + cubic) * turned + joint_.stiffness * factor * given;
}

double JointLaw::torque(double d, double rate) const {
  double torque = spring(d);
  const double size = std::abs(d);
  if (size > joint_.stop) torque -= joint_.stop_stiffness * std::copysign(size - joint_.stop, d);
  if (joint_.detent > 0) torque -= joint_.detent * std::sin(joint_.detent_waves * d);
  const double u = (d - joint_.notch.place) / joint_.notch.width;
  torque -= joint_.notch.depth * u * std::exp(-u * u / 2);
  for (std::size_t a = 0; a < arm_.size(); ++a)
    torque -= joint_.arm[a].ratio * joint_.stiffness * (d - arm_[a]);
  for (std::size_t s = 0; s < slider_.size(); ++s)
    torque -= joint_.slider[s].ratio * joint_.stiffness * slider_[s];
  if (!relaxed_ && joint_.friction.torque > 0) torque += contact_.torque(rate);
  return torque;
}

}  // namespace plumbline::simulator
