#pragma once
/// \file
/// A user's own model of an arm, to be edited: what is not touched stays as it stands.

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "diagnose/exchange/spatial_arm.hpp"
#include "diagnose/exchange/xml.hpp"

namespace plumbline::exchange {

/// What became of a change.
struct Edit {
  bool carried;
  std::string how;  ///< as what, or why not
};

/// A body that weighs.
struct ArmPart {
  std::size_t link;        ///< of the arm, from 0
  Eigen::Isometry3d at;    ///< of the body, in the frame of the link
  double mass;             ///< kg
  Eigen::Vector3d centre;  ///< in the frame of the link
};

/// The arm of a model's file, in the terms of SerialArm. Joints and links count from 0.
class ArmDocument {
 public:
  virtual ~ArmDocument() = default;

  /// \param frame  of the link in that of the link before, at coordinate zero
  /// \param axis   a unit vector in the frame of the link
  virtual Edit set_joint(std::size_t joint, const Eigen::Isometry3d& frame, const Eigen::Vector3d& axis) = 0;
  /// Moves the tip with what hangs on it. \param tip  in the frame of the last link
  virtual Edit set_tip(const Eigen::Isometry3d& tip) = 0;
  /// \param gravity  in the world
  virtual Edit set_gravity(const Eigen::Vector3d& gravity) = 0;
  virtual Edit set_stiffness(std::size_t joint, double stiffness) = 0;
  virtual Edit set_friction(std::size_t joint, double friction) = 0;

  /// As the joints and the tip stand now.
  [[nodiscard]] virtual std::vector<ArmPart> parts() const = 0;
  /// Mass and moments of inertia times a factor; the centre in the frame of the link.
  virtual Edit set_part(std::size_t part, double factor, const Eigen::Vector3d& centre) = 0;
  /// A point that weighs, in the frame of a link.
  virtual Edit add_weight(const std::string& name, std::size_t link, double mass,
                          const Eigen::Vector3d& place) = 0;

  /// The file, with these lines as a comment before the root.
  virtual std::string text(const std::vector<std::string>& lines) = 0;
};

/// \throws Error as read_arm() does, and where the file cannot be edited
std::unique_ptr<ArmDocument> arm_document(const std::filesystem::path& file, const ArmEnds& ends);

// One format each.
std::unique_ptr<ArmDocument> arm_in_urdf(const std::filesystem::path& file, const ArmEnds& ends);
std::unique_ptr<ArmDocument> arm_in_mjcf(const std::filesystem::path& file, const ArmEnds& ends);
std::unique_ptr<ArmDocument> arm_in_sdf(const std::filesystem::path& file, const ArmEnds& ends);

/// Moment of inertia, kg m², of a ball of this mass, as dense as water: for bodies of which a file knows the
/// mass alone.
double moment_of_ball(double mass);

}  // namespace plumbline::exchange
