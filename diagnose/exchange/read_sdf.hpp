#pragma once
/// \file
/// SDF, read without any simulator.

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <string>

#include "diagnose/exchange/planar_chain.hpp"
#include "diagnose/exchange/xml_document.hpp"
#include "diagnose/exchange/xml_file.hpp"

namespace plumbline::exchange {

/// The pose as it is written, in whatever frame.
/// \throws Error at the place
Eigen::Isometry3d written_pose(pugi::xml_node element, const std::string& place);

/// The links, joints and frames of the one model in an SDF. A part of a model within the model is named as
/// SDF does: "arm::elbow".
class SdfTree {
 public:
  /// \throws Error where the file is no SDF, or holds no model or several that move
  explicit SdfTree(const std::filesystem::path& file);

  XmlFile source;
  pugi::xml_node world;  ///< none where the model stands alone
  pugi::xml_node model;

  struct Part {
    pugi::xml_node element;
    std::string scope;  ///< "arm::"; empty in the model itself
  };
  [[nodiscard]] const std::map<std::string, Part>& parts() const { return parts_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  /// The version, 1.7 as 7.
  [[nodiscard]] int version() const { return version_; }
  /// The model in its world.
  [[nodiscard]] const Eigen::Isometry3d& placed() const { return placed_; }

  /// Where a part is in the frame of the model. \throws Error where it is not there, or said in a circle
  [[nodiscard]] Eigen::Isometry3d pose(const std::string& name) const;
  /// The link that a link, frame or joint moves with; "world" for that. \throws Error as pose()
  [[nodiscard]] std::string link_of(const std::string& name) const;
  /// A name that is said in a scope, as the model has it.
  [[nodiscard]] std::string resolved(const std::string& name, const std::string& scope) const;
  /// The joint that a link hangs by; empty without one.
  [[nodiscard]] std::string holder_of(const std::string& link) const;
  /// The name that a child element has, as the model has it.
  [[nodiscard]] std::string named_by(const Part& part, const char* child) const;
  /// The part in whose frame a part's pose is said; empty for that of the model.
  [[nodiscard]] std::string base_of(const Part& part) const;
  /// The part in whose frame the axis of a joint is said; empty for that of the model.
  [[nodiscard]] std::string frame_of_axis(const std::string& joint) const;

 private:
  void find_model();
  void add_parts(pugi::xml_node holder, const std::string& scope);
  void find_holders();
  [[nodiscard]] const Part& part(const std::string& name) const;

  std::string file_;
  int version_ = 0;
  Eigen::Isometry3d placed_ = Eigen::Isometry3d::Identity();
  std::map<std::string, Part> parts_;
  std::map<std::string, std::string> holders_;
  mutable std::map<std::string, Eigen::Isometry3d> poses_;  ///< those that were asked for
};

/// \throws Error as SdfTree does, and where a number is none
ReadModel read_sdf(const std::filesystem::path& file);

}  // namespace plumbline::exchange
