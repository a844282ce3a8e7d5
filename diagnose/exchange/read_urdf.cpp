#include "diagnose/exchange/read_urdf.hpp"

#include <plumbline/base/error.hpp>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/exchange/model_gravity.hpp"
#include "diagnose/exchange/physical_body.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using pugi::xml_node;

/// xyz and, about fixed axes one after the other, rpy.
Isometry3d origin_of(xml_node element, const std::string& place) {
  const xml_node origin = element.child("origin");
  const auto vector = [&](const char* name) {
    const auto said = origin.attribute(name);
    return said ? vector_in(said.value(), place + ": " + name) : Vector3d(Vector3d::Zero());
  };
  const Vector3d turn = vector("rpy");
  require_radians(turn, place + ": rpy");
  Isometry3d at = Isometry3d::Identity();
  at.translate(vector("xyz"));
  at.rotate(diagnose::from_roll_pitch_yaw(turn));
  return at;
}

bool is_fixed(xml_node joint) {
  return std::string(joint.attribute("type").value()) == "fixed";
}

void refuse_macros(const pugi::xml_document& document, const std::string& file) {
  const xml_node macro =
      document.find_node([](const xml_node one) { return std::string(one.name()).starts_with("xacro:"); });
  if (macro)
    throw Error(file, "the macro <" + std::string(macro.name()) + ">",
                "the URDF that xacro writes: xacro FILE > arm.urdf");
}

}  // namespace

std::string link_of(xml_node joint, const char* end) {
  return joint.child(end).attribute("link").value();
}

UrdfTree::UrdfTree(const std::filesystem::path& file) : source(file), file_(file.string()) {
  if (std::string(root().name()) != "robot")
    throw Error(file_, "the root <" + files::shown(root().name()) + ">", "the root <robot> of URDF");
  refuse_macros(source.document, file_);
  for (const xml_node link : root().children("link"))
    if (const std::string name = link.attribute("name").value(); !links_.emplace(name, link).second)
      throw Error(file_, "two links " + files::shown(name), "a name for each");
  find_holders();
  place_links();
}

void UrdfTree::find_holders() {
  for (const xml_node joint : root().children("joint")) {
    for (const char* end : {"parent", "child"})
      if (!links_.contains(link_of(joint, end)))
        throw Error(place_of(file_, joint) + ": " + end,
                    "the link \"" + files::shown(link_of(joint, end)) + "\"", "a link that the file has");
    if (!holders_.emplace(link_of(joint, "child"), joint).second)
      throw Error(file_, "link " + files::shown(link_of(joint, "child")) + " on two joints",
                  "a serial chain");
  }
}

void UrdfTree::place_links() {
  std::multimap<std::string, xml_node> carried;
  for (const auto& [child, joint] : holders_) carried.emplace(link_of(joint, "parent"), joint);
  std::vector<std::string> open;
  for (const auto& [name, link] : links_)
    if (!holders_.contains(name)) open.push_back(name);
  if (open.size() != 1)
    throw Error(file_, std::to_string(open.size()) + " links that hang by no joint", "one, the root link");
  places_.emplace(open.front(), Isometry3d::Identity());
  while (!open.empty()) {
    const std::string link = open.back();
    open.pop_back();
    const auto [first, last] = carried.equal_range(link);
    for (auto one = first; one != last; ++one) {
      const std::string child = link_of(one->second, "child");
      places_.emplace(child, places_.at(link) * origin_of(one->second, place_of(file_, one->second)));
      open.push_back(child);
    }
  }
  if (places_.size() != links_.size()) throw Error(file_, "links that hang by each other", "a tree of links");
}

xml_node UrdfTree::holder_of(const std::string& link) const {
  const auto own = holders_.find(link);
  return own == holders_.end() ? xml_node() : own->second;
}

const Isometry3d& UrdfTree::place(const std::string& link) const {
  const auto own = places_.find(link);
  if (own == places_.end()) throw Error(file_, "no link " + files::shown(link), "a link that the file has");
  return own->second;
}

xml_node UrdfTree::gazebo_of(const std::string& joint) const {
  xml_node own;
  for (const xml_node one : root().children("gazebo"))
    if (one.attribute("reference").value() == joint && (!own || one.child("springStiffness"))) own = one;
  return own;
}

namespace {

class UrdfReader {
 public:
  explicit UrdfReader(const std::filesystem::path& file) : tree_(file) {}

  ReadModel read() {
    result_.rows = catalogue_rows_in(tree_.source.document, tree_.file());
    for (const xml_node joint : tree_.root().children("joint"))
      if (!is_fixed(joint)) add_joint(joint);
    for (const xml_node link : tree_.root().children("link")) add_link(link);
    const std::optional<Vector3d> gravity = gravity_in(tree_.source.document, tree_.file());
    result_.gravity = gravity.value_or(Vector3d(0, 0, -9.8));
    if (!gravity) result_.left_out.emplace_back("no gravity of its own: -9.8 along z");
    return std::move(result_);
  }

 private:
  /// The joint that a link moves with: its own, or of the link to which it is fixed.
  [[nodiscard]] std::string joint_of(std::string link) const {
    for (xml_node holder = tree_.holder_of(link); holder; holder = tree_.holder_of(link)) {
      if (!is_fixed(holder)) return files::shown(holder.attribute("name").value());
      link = link_of(holder, "parent");
    }
    return "";
  }

  void add_joint(xml_node own) {
    const std::string place = place_of(tree_.file(), own), type = own.attribute("type").value();
    const Isometry3d& at = tree_.place(link_of(own, "child"));
    ReadJoint joint;
    joint.name = files::shown(own.attribute("name").value());
    joint.carrier = joint_of(link_of(own, "parent"));
    joint.type = type;
    joint.motion = motion_of(type);
    joint.anchor = at.translation();
    joint.turn = at.linear();
    const auto axis = own.child("axis").attribute("xyz");
    joint.axis =
        at.linear() * (axis ? vector_in(axis.value(), place + ": axis") : Vector3d(Vector3d::UnitX()));
    if (!(joint.axis.norm() > 1e-14)) throw Error(place, "an axis of no length", "a direction");
    const xml_node gazebo = tree_.gazebo_of(own.attribute("name").value());
    const auto spring = [&](const char* name) {
      const xml_node said = gazebo.child(name);
      return said ? number_in(said.text().get(), place + ": " + name) : 0;
    };
    joint.stiffness = spring("springStiffness");
    joint.rest = spring("springReference");
    add_range(joint, own, place);
    if (const xml_node mimic = own.child("mimic"))
      joint.follows = files::shown(mimic.attribute("joint").value());
    result_.joints.push_back(joint);
  }

  static JointMotion motion_of(const std::string& type) {
    if (type == "revolute" || type == "continuous") return JointMotion::hinge;
    if (type == "prismatic") return JointMotion::slide;
    return type == "floating" ? JointMotion::free : JointMotion::other;
  }

  static void add_range(ReadJoint& joint, xml_node own, const std::string& place) {
    const auto number = [&](const char* child, const char* attribute) {
      const auto said = own.child(child).attribute(attribute);
      return said ? number_in(said.value(), place + ": " + attribute) : 0;
    };
    joint.friction = number("dynamics", "friction");
    if (joint.type == "continuous" || !own.child("limit")) return;
    joint.range = {number("limit", "lower"), number("limit", "upper")};
  }

  /// What it weighs, and where it is.
  void add_link(xml_node link) {
    const std::string name = link.attribute("name").value(), carrier = joint_of(name);
    const Isometry3d& at = tree_.place(name);
    const std::string parent = link_of(tree_.holder_of(name), "parent");
    result_.frames.push_back({"link", files::shown(name), carrier, files::shown(parent), at});
    const bool fixed = is_fixed(tree_.holder_of(name));
    if (fixed && !carrier.empty())
      result_.ends.push_back({"link", files::shown(name), carrier, at.translation()});
    const xml_node inertial = link.child("inertial");
    if (!inertial || (fixed && result_.rows.added.contains(files::shown(name)))) return;
    const std::string place = place_of(tree_.file(), link);
    const double mass = number_in(inertial.child("mass").attribute("value").value(), place + ": mass");
    require_mass(mass, place);
    const Isometry3d own = at * origin_of(inertial, place);
    const Vector3d middle = own.translation();
    const Eigen::Matrix3d turn = own.linear(), tensor = tensor_of(inertial.child("inertia"), place);
    result_.inertias.push_back({files::shown(name), carrier, mass, middle, turn * tensor * turn.transpose()});
    for (ReadJoint& joint : result_.joints)
      if (joint.name == carrier) add_mass(joint, mass, middle);
  }

  static Eigen::Matrix3d tensor_of(xml_node inertia, const std::string& place) {
    const auto number = [&](const char* name) {
      const auto said = inertia.attribute(name);
      return said ? number_in(said.value(), place + ": " + name) : 0;
    };
    Eigen::Matrix3d tensor;
    tensor << number("ixx"), number("ixy"), number("ixz"), 0, number("iyy"), number("iyz"), 0, 0,
        number("izz");
    return tensor.selfadjointView<Eigen::Upper>();
  }

  UrdfTree tree_;
  ReadModel result_;
};

}  // namespace

ReadModel read_urdf(const std::filesystem::path& file) {
  return UrdfReader(file).read();
}

}  // namespace plumbline::exchange
