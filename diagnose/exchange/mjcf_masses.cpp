#include "diagnose/exchange/mjcf_masses.hpp"

#include <cmath>
#include <numbers>

#include "diagnose/exchange/physical_body.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;
using pugi::xml_node;

constexpr double water = 1000;  ///< kg/m^3, MuJoCo's density where none is said

/// The ends of a geom that is given from one point to another.
std::vector<double> span_of(xml_node geom, const MjcfDefaults& defaults) {
  return defaults.numbers(geom, "fromto", 6, 6, {});
}

/// \return NaN where the file does not say
double volume_of(xml_node geom, const MjcfDefaults& defaults) {
  using std::numbers::pi;
  const auto said = defaults.attribute(geom, "type");
  const std::string type = said ? said.value() : "sphere";
  if (type == "plane" || type == "hfield") return 0;
  if (defaults.attribute(geom, "mesh") || type == "mesh" || type == "sdf") return NAN;
  std::vector<double> size = defaults.numbers(geom, "size", 1, 3, {0});
  size.resize(3);
  if (const std::vector<double> ends = span_of(geom, defaults); !ends.empty()) {
    const double half =
        (Vector3d(ends[3], ends[4], ends[5]) - Vector3d(ends[0], ends[1], ends[2])).norm() / 2;
    const bool round = type == "capsule" || type == "cylinder";
    size = round ? std::vector{size[0], half, 0.0} : std::vector{size[0], size[0], half};
  }
  const double r = size[0];
  if (type == "capsule") return pi * r * r * (2 * size[1] + 4 * r / 3);
  if (type == "cylinder") return 2 * pi * r * r * size[1];
  if (type == "box") return 8 * r * size[1] * size[2];
  if (type == "ellipsoid") return 4 * pi / 3 * r * size[1] * size[2];
  return 4 * pi / 3 * r * r * r;
}

Vector3d middle_of(xml_node geom, const MjcfDefaults& defaults) {
  const std::vector<double> ends = span_of(geom, defaults);
  if (ends.empty()) return defaults.vector(geom, "pos", Vector3d::Zero());
  return (Vector3d(ends[0], ends[1], ends[2]) + Vector3d(ends[3], ends[4], ends[5])) / 2;
}

class Weighing {
 public:
  explicit Weighing(const MjcfScene& scene)
      : scene_(scene),
        groups_(numbers_in(scene.document.setting("inertiagrouprange", "0 5"),
                           scene.document.file() + ": inertiagrouprange", 2, 2)) {}

  void add_geoms(xml_node holder, const Eigen::Isometry3d& frame) {
    for (const xml_node child : holder.children()) {
      const std::string kind = child.name();
      if (kind == "frame") add_geoms(child, frame * scene_.pose(child));
      if (kind == "geom") add(child, frame);
    }
  }
  MjcfMass result() const { return total_; }

 private:
  void add(xml_node geom, const Eigen::Isometry3d& frame) {
    const MjcfDefaults& defaults = scene_.defaults;
    const double group = defaults.number(geom, "group", 0);
    if (group < groups_[0] || group > groups_[1]) return;
    const auto shell = defaults.attribute(geom, "shellinertia");
    const bool hollow = shell && std::string(shell.value()) == "true";
    const double volume = hollow ? NAN : volume_of(geom, defaults);
    const double mass = defaults.number(geom, "mass", defaults.number(geom, "density", water) * volume);
    if (std::isnan(mass)) {
      ++total_.unknown;
    } else if (mass > 0) {
      const Vector3d at = frame * middle_of(geom, defaults);
      total_.middle = (total_.mass * total_.middle + mass * at) / (total_.mass + mass);
      total_.mass += mass;
    }
  }

  const MjcfScene& scene_;
  std::vector<double> groups_;
  MjcfMass total_;
};

MjcfMass said_in(xml_node inertial, const MjcfScene& scene) {
  const MjcfDefaults& defaults = scene.defaults;
  const MjcfMass own{defaults.number(inertial, "mass", 0),
                     defaults.vector(inertial, "pos", Vector3d::Zero())};
  require_mass(own.mass, place_of(scene.document.file(), inertial.parent()));
  return own;
}

}  // namespace

MjcfMass mass_of(xml_node body, const MjcfScene& scene) {
  const std::string from_geoms = scene.document.setting("inertiafromgeom", "auto");
  if (const xml_node own = body.child("inertial"); own && from_geoms != "true") return said_in(own, scene);
  Weighing weighing(scene);
  if (from_geoms != "false") weighing.add_geoms(body, Eigen::Isometry3d::Identity());
  return weighing.result();
}

}  // namespace plumbline::exchange
