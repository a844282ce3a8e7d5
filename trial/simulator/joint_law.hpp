#pragma once
/// \file
/// The torque of a joint beyond MuJoCo's own spring, with its memory.

#include "trial/simulator/physics.hpp"

namespace plumbline::simulator {

/// A dry contact: a bristle, much stiffer than the joint's spring, that slips. MuJoCo's own dry friction has
/// no memory, and relaxes where a held end point can carry the load.
class Contact {
 public:
  /// \param response  of the model, see Pace
  Contact(double spring, double response);

  /// \param slip  torque at which it slips
  /// \param uneven  it slips at (1 + uneven) of that to the one side and (1 - uneven) to the other
  void follow(double turn, double slip, double uneven = 0);
  [[nodiscard]] double torque(double rate) const {
    return -stiffness_ * bend_ - (sticks_ ? damping_ * rate : 0);
  }

 private:
  static constexpr double relative_stiffness = 300;
  double stiffness_, damping_;  ///< N m/rad, N m s/rad
  double bend_ = 0;             ///< of the bristle, rad
  bool sticks_ = true;
};

class JointLaw {
 public:
  /// \param interval  between two readings, s
  JointLaw(const Joint& joint, double response, double interval);

  /// Starts the history: contacts stick, arms relax, sliders hold.
  void begin_history() { relaxed_ = false; }
  /// Updates the memory after a time step.
  void remember(double deflection, double dt);
  [[nodiscard]] double torque(double deflection, double rate) const;

 private:
  [[nodiscard]] double spring(double deflection) const;
  [[nodiscard]] double slip(double deflection) const;
  void yield(double deflection);

  const Joint& joint_;
  double interval_;
  Contact contact_;
  bool relaxed_ = true;
  double last_ = 0;     ///< deflection after the last time step
  double time_ = 0;     ///< since the history began, s
  double way_ = 0;      ///< path turned since then
  double rate_ = 0;     ///< |rate|, smoothed over a reading
  double largest_ = 0;  ///< largest |deflection| so far
  double carried_ = 0,
         set_ = 0;  ///< the largest torque beyond the yield, and how far the rest angle has moved
  std::vector<double> arm_,
      slider_;  ///< where the far end of each arm's spring stands; how far each slider's is bent
};

}  // namespace plumbline::simulator
