#pragma once
/// \file
/// The rows of the catalogue for a joint in motion: what a drive may have that its model lacks.

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/inference/prior.hpp"
#include "diagnose/motion/drive.hpp"
#include "diagnose/motion/motion_log.hpp"

namespace plumbline::motion {

/// Typical sizes in some logs, from which typical sizes of effects follow.
struct Sizes {
  double torque = 0;               ///< N m: the largest moment of the load's weight, or else what moves it
  double inertia = 0;              ///< kg m^2: the largest of a load
  double speed = 0;                ///< rad/s, root mean square of the motion
  double angle = 0;                ///< rad, root mean square about the mean
  double highest = 0, lowest = 0;  ///< rad, angles that are read
  double duty = 0;                 ///< the largest that the servo asks for
  double gain = 0;                 ///< of the servo, mean
  double warmer = 0;               ///< K, the largest departure from the mean temperature
  double base_acceleration = 0;    ///< m/s^2, the largest
  double supply = 0;               ///< V, mean
  std::array<double, channel_count> beside{};  ///< of the channels, root mean square; 0 where none is read
  bool unpowered = false;                      ///< the drive is switched off somewhere

  /// \param nominal  the stated numbers of the drive, or none
  explicit Sizes(const std::vector<MotionLog>& logs, const Drive<double>& nominal = {});
};

/// A parameter of a row. Its value is added to every one of the terms.
struct Parameter {
  diagnose::ParameterRange range;
  std::vector<Term> terms;
  double guess;                        ///< where fits begin
  std::optional<double> periods = {};  ///< in a turn of the joint, of a torque that depends on the angle
};

struct Row {
  std::string id;     ///< "cogging(24)"
  std::string words;  ///< a noun phrase that can follow "caused by"
  std::vector<Parameter> parameters;
  bool refines = false;  ///< holds a simpler row, and is rarer than it
};

/// What a row changes.
std::set<Term> terms_of(const Row& row);

/// A number that models of drives state, and a user may state, leave to the fit, or leave out.
struct Stated {
  Term term;
  std::string_view id, words;
  std::string_view unit;
  double typical;  ///< size
  bool signed_;    ///< may be negative
};

/// Torque, back EMF, armature, zero, dry and viscous friction; then those of the servo's law beside its gain.
std::vector<Stated> stated_numbers(const Sizes& sizes);

/// The rows that can change a reading of such logs.
/// \param nominal   the stated numbers; what is not stated is zero
/// \param unknown   terms that are fitted beside every cause: no row
/// \param periods   in a turn of the joint that its torque may have, by poles, slots and teeth
std::vector<Row> catalogue(const Sizes& sizes, const Drive<double>& nominal, const std::vector<Term>& unknown,
                           const std::vector<double>& periods);

}  // namespace plumbline::motion
