#pragma once
/// \file
/// Characteristic lengths, stiffnesses, forces and times of one experiment, by which effects are scaled, and
/// what its readings can show.

#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// A value of a load along the chain.
struct AppliedLoad {
  std::size_t covariate;  ///< its number
  double largest = 1;     ///< of its size in all readings
};

struct CharacteristicScales {
  // The device.
  std::vector<double> joint_stiffness, link_length, link_mass;  ///< nominal
  std::vector<bool> rigid;      ///< by joint, whether it stands where it is commanded
  std::vector<bool> slides;     ///< by joint, whether it slides
  std::vector<double> reach;    ///< by joint, distance to the next one, or the tip
  double stiffness = 0;         ///< mean of the elastic joints
  double length = 0, link = 0;  ///< of all links, and of the mean one
  double mass = 0;              ///< of the mean link, or of the typical force, kg
  double gravity = 9.81;        ///< acceleration that the device feels, or would
  double force = 0;             ///< the 90 % quantile of the loads, or their like
  double torque = 0;            ///< of a joint under such a load, N m
  double deflection = 0;        ///< of a joint under such a torque, rad
  double turn = 1;              ///< unit of the ranges of angles, rad: 1, but for joints that hardly turn
  double duration = 0, sampling_interval = 0;  ///< of the longest run; of the fastest run
  std::size_t axes = 2;  ///< of the space in which it moves: of a joint alone, which has no link, 1

  // The bench, and what is read.
  bool weighs = true;           ///< gravity may act
  bool nominal_weight = false;  ///< the nominal links have weight
  bool end_is_loaded = false;   ///< some run holds or loads the end point
  bool measures_force = false;  ///< some run imposes a place or an angle and reads the load that it takes
  bool imposes_force = false;   ///< some run imposes a load
  bool load_cell = false;       ///< some run reads the load or controls it by a sensor
  bool pivot = false;           ///< a drive holds or pulls the end point; weights do not
  bool clock = false;           ///< time stamps are more than the readings' numbers, 0, 1, 2, ...
  bool measures_both_forces = false;    ///< some run reads both components of the force
  bool turned_by_loads = false;         ///< tendons or pressures turn joints
  bool long_tendon = false;             ///< some tendon passes several joints
  std::vector<AppliedLoad> applied;     ///< along the chain
  std::vector<std::size_t> covariates;  ///< numbers of those that are no loads
  std::size_t runs = 0;                 ///< of the whole experiment
  bool turns_back = false;              ///< the command of some run reverses
  bool bent_at_rest = false;            ///< some rest angle, other than that of joint 1, is not zero
  bool drives = false;                  ///< a drive moves what is imposed; weights are hung
  std::vector<bool> moves;              ///< by joint, whether its command changes
  bool led_together = true;  ///< commands of the joints are multiples of one shape, as of one tendon
  std::vector<double> least_command, largest_command;  ///< by joint
  bool warms = false;                                  ///< its temperature is noted, and changes
  bool reads_encoders = false;    ///< joint angles are read by the encoders that lead the servos
  bool tool_is_measured = false;  ///< some measured point is on the last link
  double largest_reading = 0;     ///< of |Fx| and |Fy|, where they are read
  std::size_t at_largest = 0;     ///< readings of a force that reach the largest one within their noise
  std::array<bool, channel_names> measured{};  ///< by channel name

  std::vector<Channel> beside_tracker;  ///< what sensors beside a tracker read

  /// Stiffness of a joint; for a passive joint the mean of the elastic ones.
  [[nodiscard]] double stiffness_at(std::size_t joint) const {
    return joint_stiffness[joint] > 0 ? joint_stiffness[joint] : stiffness;
  }
  /// The typical load of a joint: a force, N, where it slides, else a torque, N m.
  [[nodiscard]] double typical_load(std::size_t joint) const {
    return joint < slides.size() && slides[joint] ? force : torque;
  }
  /// Displacement of the end point per newton when one mean joint turns with the whole chain as its lever.
  [[nodiscard]] double compliance() const { return length * length / stiffness; }
  /// Whether some run measures a channel of that name.
  [[nodiscard]] bool measures(Channel::Name name) const { return measured[static_cast<std::size_t>(name)]; }
  /// The number of kinds of channels that are read.
  [[nodiscard]] std::size_t kinds_read() const;
};

CharacteristicScales characteristic_scales(const Experiment& experiment);

/// How far the runs move the joints of the nominal model.
struct Excitation {
  std::vector<double> deflection;  ///< largest of each joint, rad
  double largest = 0;              ///< of all joints, rad
  double torque = 0;               ///< largest of all joints, N m
};

}  // namespace plumbline::diagnose
