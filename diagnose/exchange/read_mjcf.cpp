#include "diagnose/exchange/read_mjcf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnose/exchange/physical_body.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using pugi::xml_node;

/// How many elements the sections of this name hold, but for those that a correction added.
std::size_t elements_in(xml_node root, const char* section, const std::set<std::string>& added) {
  std::size_t count = 0;
  for (const xml_node one : root.children(section))
    for (const xml_node child : one.children())
      if (child.type() == pugi::node_element && !added.contains(child.attribute("name").value())) ++count;
  return count;
}

class MjcfReader {
 public:
  MjcfReader(const MjcfScene& scene, const MjcfActuators& actuators) : scene_(scene), actuators_(actuators) {}

  ReadModel read() {
    result_.rows = catalogue_rows_in(scene_.document.whole(), scene_.document.file());
    result_.left_out = scene_.left_out;
    result_.notes = actuators_.notes;
    for (std::size_t j = 0; j < scene_.joints.size(); ++j) add_joint(j);
    for (const MjcfServo& servo : actuators_.servos) add_spring(servo);
    for (std::size_t b = 1; b < scene_.bodies.size(); ++b) add_mass(b);
    for (std::size_t s = 0; s < scene_.sites.size(); ++s) {
      const MjcfSite& site = scene_.sites[s];
      result_.ends.push_back(
          {"site", site.name, joint_name(scene_.last_joint(site.body)), site.at.translation(), s});
    }
    add_frames();
    add_constraints();
    result_.gravity = gravity();
    leave_out();
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::string joint_name(std::size_t j) const {
    return j < scene_.joints.size() ? scene_.joints[j].name : "";
  }

  void add_joint(std::size_t j) {
    const MjcfJoint& own = scene_.joints[j];
    const MjcfBody& body = scene_.bodies[own.body];
    ReadJoint joint;
    joint.name = own.name;
    joint.carrier = joint_name(j > body.joints.front() ? j - 1 : scene_.last_joint(body.parent));
    joint.type = own.type;
    joint.motion = motion_of(own.type);
    joint.axis = own.axis;
    joint.anchor = own.anchor;
    joint.turn = body.at.linear();
    joint.reference = own.ref;
    joint.range = own.range;
    joint.friction = scene_.defaults.number(own.element, "frictionloss", 0);
    joint.stiffness = own.stiffness;
    joint.rest = own.springref - own.ref;
    result_.joints.push_back(std::move(joint));
  }

  static JointMotion motion_of(const std::string& type) {
    if (type == "hinge") return JointMotion::hinge;
    if (type == "slide") return JointMotion::slide;
    return type == "free" ? JointMotion::free : JointMotion::other;
  }

  void add_frames() {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      const MjcfBody& body = scene_.bodies[b];
      result_.frames.push_back({"body", body.name, joint_name(scene_.last_joint(b)),
                                b > 0 ? scene_.bodies[body.parent].name : "", body.at});
    }
    for (const MjcfSite& site : scene_.sites)
      result_.frames.push_back({"site", site.name, joint_name(scene_.last_joint(site.body)),
                                scene_.bodies[site.body].name, site.at});
  }

  /// What <inertial> says of the moments of a body; a body that its geoms weigh is a point.
  void add_inertia(std::size_t body) {
    const MjcfBody& one = scene_.bodies[body];
    result_.inertias.push_back(
        {one.name, joint_name(scene_.last_joint(body)), one.mass, one.middle, Eigen::Matrix3d::Zero()});
    const xml_node own = one.element.child("inertial");
    if (!own) return;
    const MjcfDefaults& defaults = scene_.defaults;
    const std::vector<double> d = defaults.numbers(own, "diaginertia", 3, 3, {0, 0, 0}),
                              full = defaults.numbers(own, "fullinertia", 6, 6, {});
    Eigen::Matrix3d tensor = Eigen::Vector3d(d[0], d[1], d[2]).asDiagonal();
    if (!full.empty())
      tensor << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5], full[2];
    const Eigen::Matrix3d turn = (one.at * scene_.pose(own)).linear();
    result_.inertias.back().tensor = turn * tensor * turn.transpose();
  }

  /// What equality constraints couple: joints that follow others, and bodies that are tied.
  void add_constraints() {
    for (const xml_node section : scene_.document.root().children("equality"))
      for (const xml_node one : section.children()) {
        const auto active = scene_.defaults.attribute(one, "active");
        if (one.type() != pugi::node_element || (active && std::string(active.value()) == "false")) continue;
        if (std::string(one.name()) == "joint")
          couple(one);
        else
          tie(one);
      }
  }

  void couple(xml_node constraint) {
    const auto second = constraint.attribute("joint2");
    for (std::size_t j = 0; j < scene_.joints.size(); ++j)
      if (std::string(scene_.joints[j].element.attribute("name").value()) ==
          constraint.attribute("joint1").value())
        result_.joints[j].follows = second ? files::shown(second.value()) : "a constant";
  }

  /// Whether a body is one by which programs drag others.
  [[nodiscard]] bool is_handle(const std::string& body) const {
    return std::any_of(scene_.bodies.begin(), scene_.bodies.end(), [&](const MjcfBody& one) {
      return one.name == body && one.element.attribute("mocap").as_bool();
    });
  }

  void tie(xml_node constraint) {
    const std::string name = constraint.attribute("name").value();
    ReadLoop loop{constraint.name() + (name.empty() ? "" : " " + files::shown(name)), {}};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string number = std::to_string(i + 1);
      const auto body = constraint.attribute(("body" + number).c_str()),
                 site = constraint.attribute(("site" + number).c_str());
      for (const ReadFrame& frame : result_.frames)
        if (frame.name == (frame.is_body() ? body : site).value()) loop.carriers[i] = frame.carrier;
      if (is_handle(body.value())) return;
    }
    result_.loops.push_back(std::move(loop));
  }

  /// Beside the joint's own spring.
  void add_spring(const MjcfServo& servo) {
    if (result_.rows.added.contains(servo.name)) return;
    ReadJoint& joint = result_.joints[servo.joint];
    const double rest = servo.rest() - scene_.joints[servo.joint].ref,
                 both = joint.stiffness + servo.stiffness();
    joint.rest = (joint.stiffness * joint.rest + servo.stiffness() * rest) / both;
    joint.stiffness = both;
    joint.servo += servo.stiffness();
    const bool turns = joint.motion == JointMotion::hinge;
    result_.notes.push_back(fmt::format("joint {}: {} is a spring of {:.6g} {} about its command, {:.6g} {}",
                                        joint.name, servo.name, servo.stiffness(), turns ? "N m/rad" : "N/m",
                                        servo.rest(), turns ? "rad" : "m"));
  }

  void add_mass(std::size_t body) {
    const MjcfBody& own = scene_.bodies[body];
    if (own.joints.empty() && result_.rows.added.contains(own.name)) return;
    add_inertia(body);
    const std::size_t carrier = scene_.last_joint(body);
    if (carrier < scene_.joints.size()) exchange::add_mass(result_.joints[carrier], own.mass, own.middle);
  }

  [[nodiscard]] Eigen::Vector3d gravity() const {
    Eigen::Vector3d g(0, 0, -9.81);
    for (const xml_node option : scene_.document.root().children("option"))
      if (const auto said = option.attribute("gravity"))
        g = vector_in(said.value(), place_of(scene_.document.file(), option) + ": gravity");
    return scene_.document.disabled("gravity") ? Eigen::Vector3d::Zero() : g;
  }

  void leave_out() {
    std::vector<std::string>& out = result_.left_out;
    out.insert(out.end(), actuators_.left_out.begin(), actuators_.left_out.end());
    const xml_node root = scene_.document.root();
    if (const auto count = elements_in(root, "tendon", result_.rows.added))
      out.push_back(fmt::format("{} tendons", count));
    if (const auto count = elements_in(root, "equality", result_.rows.added))
      out.push_back(fmt::format("{} equality constraints", count));
  }

  const MjcfScene& scene_;
  const MjcfActuators& actuators_;
  ReadModel result_;
};

}  // namespace

ReadModel model_in(const MjcfScene& scene, const MjcfActuators& actuators) {
  return MjcfReader(scene, actuators).read();
}

ReadModel read_mjcf(const std::filesystem::path& file) {
  const MjcfScene scene(file);
  return model_in(scene, actuators_of(scene));
}

}  // namespace plumbline::exchange
