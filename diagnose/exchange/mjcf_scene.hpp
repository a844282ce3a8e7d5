#pragma once
/// \file
/// The bodies, joints and sites of an MJCF in its reference configuration, as MuJoCo 3 understands the file:
/// defaults, frames and includes resolved; meshes, looks, contacts and sensors are not read.

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "diagnose/exchange/mjcf_defaults.hpp"
#include "diagnose/exchange/mjcf_document.hpp"

namespace plumbline::exchange {

struct MjcfBody {
  pugi::xml_node element;  ///< none for the world, body 0
  std::string name;
  std::size_t parent = 0;
  Eigen::Isometry3d at;             ///< in the world
  Eigen::Isometry3d held;           ///< what its pos counts in: the parent, or a frame in it
  std::vector<std::size_t> joints;  ///< numbers
  double mass = 0;                  ///< kg, that weighs: without what gravcomp carries
  Eigen::Vector3d middle;           ///< centre of mass, in the world
};

struct MjcfJoint {
  pugi::xml_node element;
  std::string name, type;
  std::size_t body = 0;
  Eigen::Vector3d axis, anchor;  ///< in the world
  double ref = 0, springref = 0, stiffness = 0;
  std::array<double, 2> range{-std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};
};

struct MjcfSite {
  pugi::xml_node element;
  std::string name;
  std::size_t body = 0;
  Eigen::Isometry3d held;  ///< what its pos counts in
  Eigen::Isometry3d at;    ///< in the world
};

class MjcfScene {
 public:
  /// \throws Error that names the element: an attribute that is no number, a class that is not there,
  ///         elements that stand for several bodies
  explicit MjcfScene(const std::filesystem::path& file);

  MjcfDocument document;
  MjcfDefaults defaults;
  std::vector<MjcfBody> bodies;  ///< the world is body 0
  std::vector<MjcfJoint> joints;
  std::vector<MjcfSite> sites;
  std::vector<std::string> left_out;  ///< parts of the file that matter to statics and are not represented

  /// The last joint of the body, or of the nearest one that carries it; size of `joints` at the base.
  [[nodiscard]] std::size_t last_joint(std::size_t body) const;

  /// Of a body or a frame, in what holds it.
  [[nodiscard]] Eigen::Isometry3d pose(pugi::xml_node element) const;

 private:
  void add_contents(pugi::xml_node holder, std::size_t body, const Eigen::Isometry3d& frame);
  void add_bodies(pugi::xml_node holder, std::size_t body, const Eigen::Isometry3d& frame);
  void add_body(pugi::xml_node element, std::size_t parent, const Eigen::Isometry3d& frame);
  void add_joint(pugi::xml_node element, std::size_t body, const Eigen::Isometry3d& frame);
  void add_geom(pugi::xml_node element, std::size_t body, const Eigen::Isometry3d& frame);
  void weigh(pugi::xml_node element, std::size_t body);
  void scale_masses();
  [[nodiscard]] double spring_of(const MjcfJoint& joint);
  void read_range(MjcfJoint& joint) const;
  [[nodiscard]] Eigen::Quaterniond orientation(pugi::xml_node element) const;
  [[nodiscard]] std::string place(pugi::xml_node element) const { return place_of(document.file(), element); }
};

}  // namespace plumbline::exchange
