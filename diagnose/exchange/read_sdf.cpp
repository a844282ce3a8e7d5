#include "diagnose/exchange/read_sdf.hpp"

#include <cmath>
#include <limits>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/model_gravity.hpp"
#include "diagnose/exchange/physical_body.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;
using pugi::xml_node;

class SdfReader {
 public:
  explicit SdfReader(const std::filesystem::path& file) : tree_(file) {}

  ReadModel read() {
    result_.rows = catalogue_rows_in(tree_.source.document, tree_.file());
    for (const auto& [name, part] : tree_.parts())
      if (is(part, "joint") && !is_fixed(part)) add_joint(name, part);
    for (const auto& [name, part] : tree_.parts()) {
      if (is(part, "link")) add_link(name, part);
      if (is(part, "frame")) add_frame(name);
    }
    add_gravity();
    if (tree_.world && tree_.world.child("include")) result_.left_out.emplace_back("what the world includes");
    return std::move(result_);
  }

 private:
  using Part = SdfTree::Part;
  static bool is(const Part& part, const std::string& kind) { return part.element.name() == kind; }
  static bool is_fixed(const Part& joint) { return type_of(joint) == "fixed"; }
  static std::string type_of(const Part& joint) { return joint.element.attribute("type").value(); }
  [[nodiscard]] std::string place(const Part& part) const { return place_of(tree_.file(), part.element); }

  [[nodiscard]] double number(xml_node holder, const char* child, double otherwise, const Part& part) const {
    const xml_node said = holder.child(child);
    return said ? number_in(said.text().get(), place(part) + ": " + child) : otherwise;
  }

  /// The joint that a link moves with: its own, or of the link to which it is fixed.
  [[nodiscard]] std::string joint_of(std::string link) const {
    for (std::size_t steps = 0; steps <= tree_.parts().size(); ++steps) {
      const std::string holder = tree_.holder_of(link);
      if (holder.empty()) return "";
      const Part& joint = tree_.parts().at(holder);
      if (!is_fixed(joint)) return files::shown(holder);
      link = tree_.link_of(tree_.named_by(joint, "parent"));
    }
    throw Error(tree_.file(), "links that hang by each other", "a tree of links");
  }

  void add_joint(const std::string& name, const Part& own) {
    const std::string type = type_of(own);
    ReadJoint joint;
    joint.name = files::shown(name);
    joint.carrier = joint_of(tree_.link_of(tree_.named_by(own, "parent")));
    joint.type = type;
    joint.motion = motion_of(type);
    joint.anchor = tree_.pose(name).translation();
    joint.turn = tree_.pose(tree_.link_of(tree_.named_by(own, "child"))).linear();
    const xml_node axis = own.element.child("axis"), dynamics = axis.child("dynamics"),
                   limit = axis.child("limit");
    if (!axis && joint.motion == JointMotion::hinge) throw Error(place(own), "no <axis>", "one");
    joint.axis = tree_.pose(tree_.frame_of_axis(name)).linear() * direction_of(axis, own);
    joint.stiffness = number(dynamics, "spring_stiffness", 0, own);
    joint.rest = number(dynamics, "spring_reference", 0, own);
    joint.friction = number(dynamics, "friction", 0, own);
    joint.range = {bound(limit, "lower", -unbounded, own), bound(limit, "upper", unbounded, own)};
    if (const xml_node mimic = axis.child("mimic"))
      joint.follows = files::shown(mimic.attribute("joint").value());
    result_.joints.push_back(joint);
  }

  static JointMotion motion_of(const std::string& type) {
    if (type == "revolute" || type == "continuous") return JointMotion::hinge;
    return type == "prismatic" ? JointMotion::slide : JointMotion::other;
  }

  static constexpr double unbounded = 1e16;  ///< the format's word for a limit that is none

  [[nodiscard]] double bound(xml_node limit, const char* side, double otherwise, const Part& own) const {
    const double value = number(limit, side, otherwise, own);
    return std::abs(value) < unbounded ? value
                                       : std::copysign(std::numeric_limits<double>::infinity(), value);
  }

  [[nodiscard]] Vector3d direction_of(xml_node axis, const Part& own) const {
    const xml_node xyz = axis.child("xyz");
    const Vector3d along =
        xyz ? vector_in(xyz.text().get(), place(own) + ": xyz") : Vector3d(Vector3d::UnitZ());
    if (!(along.norm() > 1e-14)) throw Error(place(own), "an axis of no length", "a direction");
    return along;
  }

  void add_link(const std::string& name, const Part& own) {
    const std::string carrier = joint_of(name), holder = tree_.holder_of(name);
    const bool fixed = !holder.empty() && is_fixed(tree_.parts().at(holder));
    if (fixed) add_end("link", name, name);
    const std::string parent =
        holder.empty() ? "" : tree_.link_of(tree_.named_by(tree_.parts().at(holder), "parent"));
    result_.frames.push_back({"link", files::shown(name), carrier,
                              parent == "world" ? "" : files::shown(parent), tree_.pose(name)});
    if (fixed && result_.rows.added.contains(files::shown(name))) return;
    const xml_node inertial = own.element.child("inertial");
    if (inertial.attribute("auto").as_bool()) {
      result_.left_out.push_back("mass of " + files::shown(name) + ", which its shape has");
      return;
    }
    const double mass = number(inertial, "mass", 1, own);
    require_mass(mass, place(own));
    const Eigen::Isometry3d at = tree_.pose(name) * written_pose(inertial, place(own));
    const Vector3d middle = at.translation();
    const Eigen::Matrix3d turn = at.linear(), tensor = tensor_of(inertial.child("inertia"), own);
    result_.inertias.push_back({files::shown(name), carrier, mass, middle, turn * tensor * turn.transpose()});
    for (ReadJoint& joint : result_.joints)
      if (joint.name == carrier) add_mass(joint, mass, middle);
  }

  /// Moments that are not said are 1, as sdformat has it.
  [[nodiscard]] Eigen::Matrix3d tensor_of(xml_node inertia, const Part& own) const {
    const auto said = [&](const char* name, double otherwise) {
      return number(inertia, name, otherwise, own);
    };
    Eigen::Matrix3d tensor;
    tensor << said("ixx", 1), said("ixy", 0), said("ixz", 0), 0, said("iyy", 1), said("iyz", 0), 0, 0,
        said("izz", 1);
    return tensor.selfadjointView<Eigen::Upper>();
  }

  void add_frame(const std::string& name) {
    const std::string link = tree_.link_of(name);
    add_end("frame", name, link);
    const bool of_world = link == "world";
    result_.frames.push_back({"frame", files::shown(name), of_world ? "" : joint_of(link),
                              of_world ? "" : files::shown(link), tree_.pose(name)});
  }

  void add_end(const char* kind, const std::string& name, const std::string& link) {
    if (const std::string carrier = joint_of(link); !carrier.empty())
      result_.ends.push_back({kind, files::shown(name), carrier, tree_.pose(name).translation()});
  }

  void add_gravity() {
    const std::optional<Vector3d> gravity = gravity_in(tree_.source.document, tree_.file());
    Vector3d g(0, 0, -9.8);
    if (const xml_node said = tree_.world.child("gravity"))
      g = vector_in(said.text().get(), tree_.file() + ": gravity");
    result_.placed = tree_.placed();
    result_.gravity = gravity.value_or(tree_.placed().linear().transpose() * g);
    if (!tree_.world && !gravity) result_.left_out.emplace_back("no gravity of its own: -9.8 along z");
  }

  SdfTree tree_;
  ReadModel result_;
};

}  // namespace

ReadModel read_sdf(const std::filesystem::path& file) {
  return SdfReader(file).read();
}

}  // namespace plumbline::exchange
