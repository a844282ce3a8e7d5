#pragma once
/// \file
/// The torque of a joint beyond MuJoCo's own spring, and what it remembers of the way it came.

#include "trial/simulator/physics.hpp"

namespace plumbline::simulator {

/// A dry contact: a bristle, this many times stiffer than the joint's spring, that bends until it slips.
/// MuJoCo's own dry friction will not do: it has no memory, and where a held end point could carry the load
/// alone it relaxes at once.
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

  /// From now on what it carries depends on the way: contacts stick, arms relax, sliders hold.
  void begin_history() { relaxed_ = false; }
  /// Lets the memory follow the deflection over a time step.
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
  double way_ = 0;      ///< turned since then, there and back
  double rate_ = 0;     ///< |rate|, smoothed over a reading
  double largest_ = 0;  ///< largest |deflection| so far
  double carried_ = 0,
         set_ = 0;  ///< the largest torque beyond the yield, and how far the rest angle has moved
  std::vector<double> arm_,
      slider_;  ///< where the far end of each arm's spring stands; how far each slider's is bent
};

}  // namespace plumbline::simulator
