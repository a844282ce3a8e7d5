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
  double duration = 0, pause = 0;                    ///< of the longest run; between readings of the fastest
  bool weighs = true;                                ///< the bench may feel gravity in its plane
  bool nominal_weight = false;                       ///< the nominal links weigh something
  bool measures_force = false;                       ///< a run imposes the end point and reads the force
  bool load_cell = false;                            ///< or sets an imposed force by it
  bool pivot = false;                 ///< something holds or pulls the end point that weights do not
  bool clock = false;                 ///< time stamps are more than the readings' numbers, 0, 1, 2, ...
  bool measures_both_forces = false;  ///< and both components of it
  std::size_t runs = 0;               ///< of the whole experiment
  bool turns_back = false;            ///< what a run imposes goes back on its way
  bool bent_at_rest = false;          ///< a rest angle after the first joint's is not zero
  double largest_reading = 0;         ///< of |Fx| and |Fy|, where they are read
  std::size_t at_largest = 0;         ///< readings of a force that are no smaller, within their noise
  std::array<bool, channel_names> measured{};  ///< by name

  /// Stiffness of a joint, that of a mean one where it is passive.
  [[nodiscard]] double stiffness_at(std::size_t joint) const {
    return joint_stiffness[joint] > 0 ? joint_stiffness[joint] : stiffness;
  }
  /// Yielding of the end point under a force that turns one mean joint by a lever of the whole chain.
  [[nodiscard]] double compliance() const { return length * length / stiffness; }
  /// Whether some run measures channels of that name.
  [[nodiscard]] bool measures(Channel::Name name) const { return measured[static_cast<std::size_t>(name)]; }
};

Sizes sizes_of(const Experiment& experiment);

/// What the runs ask of the nominal joints.
struct Exercise {
  std::vector<double> deflection;  ///< largest of each joint, rad
  double largest = 0;              ///< of all joints, rad
  double torque = 0;               ///< largest of all joints, N m
};

}  // namespace plumbline::diagnose
