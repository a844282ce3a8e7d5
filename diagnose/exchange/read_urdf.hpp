#pragma once
/// \file
/// URDF, with the springs that Gazebo has in it.

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <string>

#include "diagnose/exchange/planar_chain.hpp"
#include "diagnose/exchange/xml_document.hpp"
#include "diagnose/exchange/xml_file.hpp"

namespace plumbline::exchange {

/// Links and joints of a URDF, and where they are in its reference configuration.
class UrdfTree {
 public:
  /// \throws Error where the file is no URDF, or no tree of links
  explicit UrdfTree(const std::filesystem::path& file);

  XmlFile source;

  [[nodiscard]] pugi::xml_node root() const { return source.document.document_element(); }
  /// The joint that a link hangs by; none for the root link.
  [[nodiscard]] pugi::xml_node holder_of(const std::string& link) const;
  /// Where a link is, in the frame of the root link. \throws Error where there is none of the name
  [[nodiscard]] const Eigen::Isometry3d& place(const std::string& link) const;
  /// The element <gazebo> that has words on a joint's spring, or else any on the joint; or none.
  [[nodiscard]] pugi::xml_node gazebo_of(const std::string& joint) const;

  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  void find_holders();
  void place_links();

  std::string file_;
  std::map<std::string, pugi::xml_node> links_, holders_;
  std::map<std::string, Eigen::Isometry3d> places_;
};

/// The link that a joint names as "parent" or "child".
std::string link_of(pugi::xml_node joint, const char* end);

/// \throws Error as UrdfTree does, and where a number is none
ReadModel read_urdf(const std::filesystem::path& file);

}  // namespace plumbline::exchange
