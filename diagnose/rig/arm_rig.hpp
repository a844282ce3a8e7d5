#pragma once
/// \file
/// An arm in space with the parameters of its effects. The laws and sensors of its joints are the rig's.

#include <Eigen/Core>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Zero additions give the nominal model.
struct ArmRig {
  SerialArm<double> arm;  ///< with errors of geometry, masses and compliances

  double expansion = 0;  ///< of all lengths, 1/K, from the temperature of the first reading on
  /// Turn of the base about its x and y by the moment on it, rad/(N m).
  Eigen::Vector2d mount_compliance = Eigen::Vector2d::Zero();
  // The tool tips about the origin of the last link, in the axes of that link.
  double tool_compliance = 0;  ///< by the moment on it, rad/(N m)
  double tool_play = 0;        ///< by as much as it can, in the direction of the moment, rad
  /// About this axis by as much as its length, to the side to which the moment turns it, rad.
  Vector3<double> tool_hinge = Vector3<double>::Zero();

  std::vector<OnLink<double>> points;  ///< of the bench, with their errors
  OnLink<double> load{0};
  std::vector<ArmSensor> sensors;  ///< beside the tracker, with their errors

  /// The arm and the bench of an experiment, without any error.
  static ArmRig nominal(const Experiment& experiment);
  /// The arm at a command and a temperature, its masses parted where its links yield, see part_mass().
  /// \param growth  of its lengths
  /// \param flexibility  1/EI of the tubes that have slid out, up to the joint, 1/(N m^2)
  [[nodiscard]] SerialArm<double> at(double growth, const std::vector<double>& command,
                                     double flexibility) const;
  /// Rotation vector of the tool in the axes of the last link.
  /// \param moment  on the tool, in these axes, N m
  [[nodiscard]] Vector3<double> tool_turn(const Vector3<double>& moment) const;
  /// What its sensors read of points with these poses in the world, into their columns.
  void read_sensors(const std::vector<Pose<double>>& of_points, Eigen::Ref<Eigen::ArrayXd> row) const;
  /// Lets a link bend and twist as a round tube. \param flexibility  1/EI, 1/(N m^2)
  void bend(std::size_t link, double flexibility);
  /// Lets a link stretch. \param strain  by a newton along it
  void stretch(std::size_t link, double strain);
  friend bool operator==(const ArmRig& a, const ArmRig& b);
};

/// Adds a mass that sits at a place in the link's frame.
void add_mass(ArmLink<double>& link, double added, const Vector3<double>& at);

}  // namespace plumbline::diagnose
