#pragma once
/// \file
/// Lengths, stiffnesses, forces and times that are typical of one experiment: the scales of its effects.

#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

struct Sizes {
  std::vector<double> joint_stiffness, link_length;  ///< nominal
  double stiffness = 0;                              ///< mean of the elastic joints
  double length = 0, link = 0;                       ///< of the chain, and of its mean link
  double force = 0;                                  ///< that nine readings of ten stay below
  double deflection = 0;                             ///< of a joint under such a force, rad
  double duration = 0, pause = 0;                    ///< of the longest run; between readings
  bool weighs = true;                                ///< the bench may feel gravity in its plane
  bool measures_force = false;                       ///< a run imposes the end point and reads the force
  bool clock = false;  ///< time stamps are more than the readings' numbers, 0, 1, 2, ...

  /// Stiffness of a joint, that of a mean one where it is passive.
  [[nodiscard]] double stiffness_at(std::size_t joint) const {
    return joint_stiffness[joint] > 0 ? joint_stiffness[joint] : stiffness;
  }
  /// Yielding of the end point under a force that turns one mean joint by a lever of the whole chain.
  [[nodiscard]] double compliance() const { return length * length / stiffness; }
};

Sizes sizes_of(const Experiment& experiment);

/// What the runs ask of the nominal joints.
struct Exercise {
  std::vector<double> deflection;  ///< largest of each joint, rad
  double torque = 0;               ///< largest of all joints, N m
};

}  // namespace plumbline::diagnose
