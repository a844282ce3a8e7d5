#include <algorithm>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/exchange/arm_document.hpp"
#include "diagnose/exchange/read_urdf.hpp"
#include "diagnose/exchange/urdf_parts.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using pugi::xml_node;

void place(xml_node element, const Isometry3d& at) {
  xml_node origin = element.child("origin");
  if (!origin) origin = element.prepend_child("origin");
  set(origin, "xyz", numbers_of(at.translation()));
  set(origin, "rpy", numbers_of(diagnose::roll_pitch_yaw(at.linear())));
}

class UrdfArm : public ArmDocument {
 public:
  UrdfArm(const std::filesystem::path& file, const ArmEnds& ends)
      : read_(read_urdf(file)),
        path_(read_, file.string(), ends),
        tree_(file),
        base_(tree_.place(path_.base().name)) {
    for (const std::size_t j : path_.joints()) {
      joints_.push_back(named(tree_.root(), "joint", read_.joints[j].name));
      frames_.push_back(tree_.place(link_of(joints_.back(), "child")));
    }
    for (const ReadFrame& one : read_.frames) add_part(one);
  }

  Edit set_joint(std::size_t joint, const Isometry3d& frame, const Vector3d& axis) override {
    xml_node own = joints_[joint];
    const Isometry3d& before = joint > 0 ? frames_[joint - 1] : base_;
    place(own, tree_.place(link_of(own, "parent")).inverse() * before * frame);
    if (!own.child("axis")) own.append_child("axis");
    set(own.child("axis"), "xyz", numbers_of(axis));
    return {true, "as the origin and the axis of the joint"};
  }

  Edit set_tip(const Isometry3d& tip) override {
    xml_node holder = tree_.holder_of(path_.tip().name);
    if (holder == joints_.back())
      return {false, "the tip is the link that the last joint moves: a fixed link at the tip"};
    const Isometry3d now = frames_.back() * tip;
    moved_ = now * path_.tip().at.inverse();
    place(holder, tree_.place(link_of(holder, "parent")).inverse() * now);
    return {true, "as the origin of the fixed joint of " + path_.tip().name};
  }

  Edit set_gravity(const Vector3d& gravity) override {
    return {false, "URDF knows no gravity: it is to be " + numbers_of(gravity) +
                       " m/s^2 in the frame of the root link"};
  }

  Edit set_stiffness(std::size_t joint, double stiffness) override {
    const std::string name = joints_[joint].attribute("name").value();
    xml_node own = tree_.gazebo_of(name);
    if (!own) set(own = tree_.root().append_child("gazebo"), "reference", name);
    set_child(own, "springStiffness", number(stiffness));
    if (!own.child("springReference")) set_child(own, "springReference", "0");
    return {true, "as the spring that Gazebo has at the joint, whose reference is to be the command"};
  }

  Edit set_friction(std::size_t joint, double friction) override {
    xml_node dynamics = joints_[joint].child("dynamics");
    if (!dynamics) dynamics = joints_[joint].append_child("dynamics");
    set(dynamics, "friction", number(friction));
    return {true, "as the friction of the joint"};
  }

  [[nodiscard]] std::vector<ArmPart> parts() const override {
    std::vector<ArmPart> all;
    for (const Part& one : parts_) {
      const Isometry3d at = frames_[one.link].inverse() * (one.at_tip ? moved_ * one.at : one.at);
      const double mass = one.inertial.child("mass").attribute("value").as_double();
      const auto said = one.inertial.child("origin").attribute("xyz");
      all.push_back(
          {one.link, at, mass, at * (said ? vector_in(said.value(), "xyz") : Vector3d(Vector3d::Zero()))});
    }
    return all;
  }

  Edit set_part(std::size_t part, double factor, const Vector3d& centre) override {
    xml_node own = parts_[part].inertial;
    const Vector3d xyz = parts()[part].at.inverse() * centre;
    if (!own.child("origin")) own.prepend_child("origin");
    set(own.child("origin"), "xyz", numbers_of(xyz));
    set(own.child("mass"), "value", number(own.child("mass").attribute("value").as_double() * factor));
    for (pugi::xml_attribute one : own.child("inertia").attributes())
      one = number(one.as_double() * factor).c_str();
    return {true, "as the inertias of the links that move with it"};
  }

  Edit add_weight(const std::string& name, std::size_t link, double mass, const Vector3d& at) override {
    if (named(tree_.root(), "link", name)) return {false, "a link " + name + " is there already"};
    Body body{name, link_of(joints_[link], "child"), {0, 0}, mass, {}, 0, {}, moment_of_ball(mass)};
    append(tree_.root(), urdf_link(body));
    append(tree_.root(), urdf_joint(body, at, Vector3d::UnitZ()));
    return {true, "as the link " + name};
  }

  std::string text(const std::vector<std::string>& lines) override { return tree_.source.text(lines); }

 private:
  struct Part {
    xml_node inertial;
    std::size_t link;
    Isometry3d at;  ///< of the link in the file, as it was
    bool at_tip;
  };

  void add_part(const ReadFrame& frame) {
    const std::size_t link = path_.link_of(frame.carrier);
    const xml_node inertial = named(tree_.root(), "link", frame.name).child("inertial");
    if (link == 0 || link == ArmPath::elsewhere || !inertial) return;
    if (inertial.child("mass").attribute("value").as_double() > 0)
      parts_.push_back({inertial, link - 1, frame.at, hangs_on_tip(frame.name)});
  }

  [[nodiscard]] bool hangs_on_tip(std::string link) const {
    while (link != path_.tip().name) {
      const xml_node holder = tree_.holder_of(link);
      if (!holder) return false;
      link = link_of(holder, "parent");
    }
    return true;
  }

  ReadModel read_;
  ArmPath path_;
  UrdfTree tree_;
  Isometry3d base_, moved_ = Isometry3d::Identity();  ///< what the tip moves by, in the root's frame
  std::vector<xml_node> joints_;
  std::vector<Isometry3d> frames_;  ///< of the links, as the file had them, all in the root's frame
  std::vector<Part> parts_;
};

}  // namespace

std::unique_ptr<ArmDocument> arm_in_urdf(const std::filesystem::path& file, const ArmEnds& ends) {
  return std::make_unique<UrdfArm>(file, ends);
}

}  // namespace plumbline::exchange
