#pragma once
/// \file
/// Characteristic lengths, stiffnesses, forces and times of one experiment, by which effects are scaled.

#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

struct CharacteristicScales {
  std::vector<double> joint_stiffness, link_length;  ///< nominal
  double stiffness = 0;                              ///< mean of the elastic joints
  double length = 0, link = 0;                       ///< of the chain, and of its mean link
  double force = 0;       ///< the 90 % quantile of the force on the end point, or its like
  double deflection = 0;  ///< of a joint under such a force, rad
  double duration = 0, sampling_interval = 0;  ///< of the longest run; of the fastest run
  bool links = true;                           ///< a chain; a joint alone has none
  double turn = 1;              ///< unit of the ranges of angles, rad: 1, but for joints that hardly turn
  bool weighs = true;           ///< gravity may act in the plane of the bench
  bool nominal_weight = false;  ///< the nominal links have weight
  bool measures_force = false;  ///< some run imposes the end point and reads the force
  bool imposes_force = false;   ///< some run imposes the force on the end point
  bool load_cell = false;       ///< some run reads the force or controls it by a load cell
  bool load_sensor = false;     ///< the load of a joint alone is read, or controlled, by a sensor
  bool reads_load = false;      ///< it is read
  bool pivot = false;           ///< a drive holds or pulls the end point; weights do not
  bool clock = false;           ///< time stamps are more than the readings' numbers, 0, 1, 2, ...
  bool measures_both_forces = false;  ///< some run reads both components of the force
  bool turned_by_loads = false;       ///< tendons or pressures turn joints
  bool long_tendon = false;           ///< some tendon passes several joints
  std::size_t runs = 0;               ///< of the whole experiment
  bool turns_back = false;            ///< the command of some run reverses
  bool bent_at_rest = false;          ///< some rest angle, other than that of joint 1, is not zero
  double largest_reading = 0;         ///< of |Fx| and |Fy|, where they are read
  std::size_t at_largest = 0;         ///< readings of a force that reach the largest one within their noise
  std::array<bool, channel_names> measured{};  ///< by channel name

  // Of an arm in space.
  std::shared_ptr<const NominalArm> arm;  ///< null for a chain in the plane
  std::vector<bool> moves;                ///< by joint, whether its command changes
  double torque = 0;                      ///< of a joint under a typical load, N m
  double mass = 0;                        ///< of the mean link, kg
  bool yields = false;                    ///< some joint or link yields
  bool warms = false;                     ///< its temperature is noted, and changes
  bool tool_is_measured = false;          ///< some measured point is on the last link

  /// Stiffness of a joint; for a passive joint the mean of the elastic ones.
  [[nodiscard]] double stiffness_at(std::size_t joint) const {
    return joint_stiffness[joint] > 0 ? joint_stiffness[joint] : stiffness;
  }
  /// Displacement of the end point per newton when one mean joint turns with the whole chain as its lever.
  [[nodiscard]] double compliance() const { return length * length / stiffness; }
  /// Whether some run measures a channel of that name.
  [[nodiscard]] bool measures(Channel::Name name) const { return measured[static_cast<std::size_t>(name)]; }
};

CharacteristicScales characteristic_scales(const Experiment& experiment);

/// How far the runs move the joints of the nominal model.
struct Excitation {
  std::vector<double> deflection;  ///< largest of each joint, rad
  double largest = 0;              ///< of all joints, rad
  double torque = 0;               ///< largest of all joints, N m
};

}  // namespace plumbline::diagnose
