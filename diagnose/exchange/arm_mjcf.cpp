#include <fmt/format.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/arm_document.hpp"
#include "diagnose/exchange/edit_servo.hpp"
#include "diagnose/exchange/mjcf_parts.hpp"
#include "diagnose/exchange/read_mjcf.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using pugi::xml_node;

/// In place of whatever way the file had to say it.
void place_anew(xml_node element, const Isometry3d& at) {
  for (const char* other : {"euler", "axisangle", "xyaxes", "zaxis"}) element.remove_attribute(other);
  const Eigen::Quaterniond turn(at.linear());
  set(element, "pos", numbers_of(at.translation()));
  set(element, "quat", numbers({turn.w(), turn.x(), turn.y(), turn.z()}));
}

class MjcfArm : public ArmDocument {
 public:
  MjcfArm(const std::filesystem::path& file, const ArmEnds& ends)
      : scene_(file),
        actuators_(actuators_of(scene_)),
        read_(model_in(scene_, actuators_)),
        path_(read_, file.string(), ends),
        arm_(spatial_arm(read_, file.string(), ends).nominal.arm) {
    for (const std::size_t j : path_.joints()) {
      const ReadJoint& joint = read_.joints[j];
      Isometry3d at = Isometry3d::Identity();
      at.linear() = joint.turn;
      at.translation() = joint.anchor;
      frames_.push_back(at);
      references_.push_back(joint.reference);
    }
    for (std::size_t b = 1; b < scene_.bodies.size(); ++b) add_part(b);
  }

  Edit set_joint(std::size_t joint, const Isometry3d& frame, const Vector3d& axis) override {
    if (own_body(joint).joints.size() != 1) return {false, "joints that share a body"};
    if (own(joint).element.parent() != own_body(joint).element) return {false, "a joint within a <frame>"};
    arm_.links[joint].frame = frame;
    arm_.links[joint].axis = axis;
    const Isometry3d &before = joint > 0 ? frames_[joint - 1] : path_.base().at,
                     held = before.inverse() * own_body(joint).held,
                     in_link = frames_[joint].inverse() * own_body(joint).at;
    place_anew(own_body(joint).element, held.inverse() * frame * moved_by(joint) * in_link);
    set(own(joint).element, "axis", numbers_of(axis));
    return {true, "as the pose of the body and the axis of the joint"};
  }

  Edit set_tip(const Isometry3d& tip) override {
    if (path_.tip().kind == "site") {
      const MjcfSite& site = *std::find_if(scene_.sites.begin(), scene_.sites.end(),
                                           [&](const MjcfSite& one) { return one.name == path_.tip().name; });
      if (scene_.defaults.attribute(site.element, "fromto")) return {false, "a site that is given by fromto"};
      place_anew(site.element, (frames_.back().inverse() * site.held).inverse() * tip);
      return {true, "as the pose of the site " + site.name};
    }
    const MjcfBody& body = tip_body();
    if (!body.joints.empty())
      return {false, "the tip is the body that the last joint moves: a site at the tip"};
    moved_ = frames_.back() * tip * body.at.inverse();
    place_anew(body.element, (frames_.back().inverse() * body.held).inverse() * tip);
    return {true, "as the pose of the body " + body.name};
  }

  Edit set_gravity(const Vector3d& gravity) override {
    xml_node option = scene_.document.root().child("option");
    if (!option) option = scene_.document.root().prepend_child("option");
    for (const xml_node one : scene_.document.root().children("option"))
      if (one.attribute("gravity")) option = one;
    set(option, "gravity", numbers_of(gravity));
    return {true, "as the gravity of <option>"};
  }

  Edit set_stiffness(std::size_t joint, double stiffness) override {
    double servos = 0;
    for (const MjcfServo* one : servos_of(joint)) servos += one->stiffness();
    for (const MjcfServo* one : servos_of(joint))
      edit_servo(*one, stiffness / servos, 0, scene_.document.file());
    if (servos > 0) return {true, "as the gain of the servo"};
    if (!(own(joint).stiffness > 0))
      return {false, "the joint has neither a servo nor a spring in this file"};
    set(own(joint).element, "stiffness", number(stiffness));
    return {true, "as the stiffness of the joint"};
  }

  Edit set_friction(std::size_t joint, double friction) override {
    set(own(joint).element, "frictionloss", number(friction));
    return {true, "as the frictionloss of the joint"};
  }

  [[nodiscard]] std::vector<ArmPart> parts() const override {
    std::vector<ArmPart> all;
    for (const Part& one : parts_) {
      const Isometry3d at = frames_[one.link].inverse() * (one.at_tip ? moved_ * one.at : one.at);
      all.push_back({one.link, at, one.mass, at * one.centre});
    }
    return all;
  }

  Edit set_part(std::size_t part, double factor, const Vector3d& centre) override {
    if (const std::string reason = against_masses(part); !reason.empty()) return {false, reason};
    Part& one = parts_[part];
    const Vector3d pos = parts()[part].at.inverse() * centre;
    one.centre = pos;
    one.mass *= factor;
    xml_node body = scene_.bodies[one.body].element, inertial = body.child("inertial");
    const bool from_geoms = !inertial;
    if (from_geoms) {
      set(inertial = body.prepend_child("inertial"), "diaginertia",
          numbers(std::vector<double>(3, moment_of_ball(one.mass))));
    } else {
      for (const char* moments : {"diaginertia", "fullinertia"}) scale(inertial, moments, factor);
    }
    set(inertial, "pos", numbers_of(pos));
    set(inertial, "mass", number(one.mass));
    return {true, from_geoms ? "as <inertial>, in place of what the geoms weigh"
                             : "as <inertial> of the bodies that move with it"};
  }

  Edit add_weight(const std::string& name, std::size_t link, double mass, const Vector3d& at) override {
    Xml weight("body"), inertial("inertial");
    const Isometry3d in_body = own_body(link).at.inverse() * frames_[link];
    weight.set("name", name).set("pos", numbers_of(in_body * at));
    inertial.set("pos", "0 0 0").set("mass", number(mass));
    inertial.set("diaginertia", numbers(std::vector<double>(3, moment_of_ball(mass))));
    scene_.document.append(own_body(link).element, weight.add(std::move(inertial)));
    return {true, "as the body " + name};
  }

  std::string text(const std::vector<std::string>& lines) override { return scene_.document.text(lines); }

 private:
  struct Part {
    std::size_t body, link;
    Isometry3d at;  ///< of the body in the world, as it was
    double mass;
    Vector3d centre;  ///< in the body
    bool at_tip;
  };

  void add_part(std::size_t b) {
    const MjcfBody& body = scene_.bodies[b];
    const std::size_t joint = scene_.last_joint(b);
    const std::size_t link = joint < read_.joints.size() ? path_.link_of(read_.joints[joint].name) : 0;
    if (link == 0 || link == ArmPath::elsewhere || !(body.mass > 0)) return;
    parts_.push_back({b, link - 1, body.at, body.mass, body.at.inverse() * body.middle, hangs_on_tip(b)});
  }

  [[nodiscard]] bool hangs_on_tip(std::size_t body) const {
    for (; body > 0; body = scene_.bodies[body].parent)
      if (path_.tip().is_body() && scene_.bodies[body].name == path_.tip().name) return true;
    return false;
  }

  [[nodiscard]] const MjcfJoint& own(std::size_t joint) const { return scene_.joints[path_.joints()[joint]]; }
  [[nodiscard]] const MjcfBody& own_body(std::size_t joint) const { return scene_.bodies[own(joint).body]; }
  [[nodiscard]] const MjcfBody& tip_body() const {
    return *std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                         [&](const MjcfBody& one) { return one.name == path_.tip().name; });
  }

  /// What a joint's reference moves its link by.
  [[nodiscard]] Isometry3d moved_by(std::size_t joint) const {
    return joint_motion<double>(arm_.links[joint].kind, arm_.links[joint].axis, references_[joint]);
  }

  [[nodiscard]] std::vector<const MjcfServo*> servos_of(std::size_t joint) const {
    std::vector<const MjcfServo*> all;
    for (const MjcfServo& one : actuators_.servos)
      if (one.joint == path_.joints()[joint]) all.push_back(&one);
    return all;
  }

  [[nodiscard]] std::string against_masses(std::size_t part) const {
    if (scene_.document.is_on("inertiafromgeom", false))
      return "inertiafromgeom=\"true\": bodies weigh what their geoms do";
    if (scene_.document.setting("settotalmass", "-1") != "-1")
      return "settotalmass: all bodies weigh what they do together";
    return scene_.bodies[parts_[part].body].element.attribute("gravcomp") ? "gravcomp, which carries a body"
                                                                          : "";
  }

  static void scale(xml_node element, const char* name, double factor) {
    const auto said = element.attribute(name);
    if (!said) return;
    std::vector<double> all = numbers_in(said.value(), name, 3, 6);
    for (double& one : all) one *= factor;
    set(element, name, numbers(all));
  }

  MjcfScene scene_;
  MjcfActuators actuators_;
  ReadModel read_;
  ArmPath path_;
  SerialArm<double> arm_;
  std::vector<Isometry3d> frames_;  ///< of the links in the reference configuration, as the file had them
  std::vector<double> references_;
  Isometry3d moved_ = Isometry3d::Identity();  ///< what the tip moves by, in the world
  std::vector<Part> parts_;
};

}  // namespace

std::unique_ptr<ArmDocument> arm_in_mjcf(const std::filesystem::path& file, const ArmEnds& ends) {
  return std::make_unique<MjcfArm>(file, ends);
}

}  // namespace plumbline::exchange
