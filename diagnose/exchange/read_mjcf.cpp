#include "diagnose/exchange/read_mjcf.hpp"

#include <fmt/format.h>

namespace plumbline::exchange {
namespace {

using pugi::xml_node;

/// How many elements the sections of this name hold.
std::size_t elements_in(xml_node root, const char* section) {
  std::size_t count = 0;
  for (const xml_node one : root.children(section))
    for (const xml_node child : one.children())
      if (child.type() == pugi::node_element) ++count;
  return count;
}

class MjcfReader {
 public:
  MjcfReader(const MjcfScene& scene, const MjcfActuators& actuators) : scene_(scene), actuators_(actuators) {}

  ReadModel read() {
    result_.left_out = scene_.left_out;
    result_.notes = actuators_.notes;
    for (std::size_t j = 0; j < scene_.joints.size(); ++j) add_joint(j);
    for (const MjcfServo& servo : actuators_.servos) add_spring(servo);
    for (std::size_t b = 1; b < scene_.bodies.size(); ++b) add_mass(b);
    for (std::size_t s = 0; s < scene_.sites.size(); ++s) {
      const MjcfSite& site = scene_.sites[s];
      result_.ends.push_back({"site", site.name, joint_name(scene_.last_joint(site.body)), site.at, s});
    }
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
    joint.hinge = own.type == "hinge";
    joint.free = own.type == "free";
    joint.axis = own.axis;
    joint.anchor = own.anchor;
    joint.stiffness = own.stiffness;
    joint.rest = own.springref - own.ref;
    result_.joints.push_back(std::move(joint));
  }

  /// Beside the joint's own spring.
  void add_spring(const MjcfServo& servo) {
    ReadJoint& joint = result_.joints[servo.joint];
    const double rest = servo.rest() - scene_.joints[servo.joint].ref,
                 both = joint.stiffness + servo.stiffness();
    joint.rest = (joint.stiffness * joint.rest + servo.stiffness() * rest) / both;
    joint.stiffness = both;
    result_.notes.push_back(
        fmt::format("joint {}: {} is a spring of {:.6g} N m/rad about its command, {:.6g} rad", joint.name,
                    servo.name, servo.stiffness(), servo.rest()));
  }

  void add_mass(std::size_t body) {
    const MjcfBody& own = scene_.bodies[body];
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
    for (const MjcfJoint& joint : scene_.joints) {
      const auto limited = scene_.defaults.attribute(joint.element, "limited");
      const bool free = limited && std::string(limited.value()) == "false";
      if (scene_.defaults.number(joint.element, "frictionloss", 0) > 0)
        out.push_back("frictionloss of " + joint.name);
      if (scene_.defaults.attribute(joint.element, "range") && !free) out.push_back("range of " + joint.name);
    }
    out.insert(out.end(), actuators_.left_out.begin(), actuators_.left_out.end());
    const xml_node root = scene_.document.root();
    if (const auto count = elements_in(root, "tendon")) out.push_back(fmt::format("{} tendons", count));
    if (const auto count = elements_in(root, "equality"))
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
