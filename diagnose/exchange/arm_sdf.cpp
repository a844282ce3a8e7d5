#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/exchange/arm_document.hpp"
#include "diagnose/exchange/read_sdf.hpp"
#include "diagnose/exchange/sdf_parts.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using pugi::xml_node;

/// In place of the pose that the element has, in the same frame.
void replace_pose(xml_node element, const Isometry3d& at) {
  if (!element.child("pose")) element.prepend_child("pose");
  xml_node pose = element.child("pose");
  for (const char* format : {"degrees", "rotation_format"}) pose.remove_attribute(format);
  const Vector3d xyz = at.translation(), turn = diagnose::roll_pitch_yaw(at.linear());
  set_text(pose, numbers({xyz.x(), xyz.y(), xyz.z(), turn.x(), turn.y(), turn.z()}));
}

/// Poses of SDF are said in any frame: those are written anew that are no more what they were in theirs.
class SdfArm : public ArmDocument {
 public:
  SdfArm(const std::filesystem::path& file, const ArmEnds& ends)
      : read_(read_sdf(file)),
        path_(read_, file.string(), ends),
        tree_(file),
        arm_(spatial_arm(read_, file.string(), ends).nominal.arm),
        was_(frames()) {
    if (tree_.model.child("model"))
      throw Error(file.string(), "a model that has others in it", "links and joints one by one");
    for (const std::size_t j : path_.joints())
      joints_.push_back(named(tree_.model, "joint", read_.joints[j].name));
    for (const ReadFrame& one : read_.frames) add_part(one);
  }

  Edit set_joint(std::size_t joint, const Isometry3d& frame, const Vector3d& axis) override {
    arm_.links[joint].frame = frame;
    arm_.links[joint].axis = axis;
    return {true, "as the poses of the links and the axis of the joint"};
  }

  Edit set_tip(const Isometry3d& tip) override {
    if (tree_.holder_of(path_.tip().name) == joints_.back().attribute("name").value())
      return {false, "the tip is the link that the last joint moves: a frame at the tip"};
    moved_ = was_.back() * tip * path_.tip().at.inverse();
    return {true, "as the pose of the " + path_.tip().kind + " " + path_.tip().name};
  }

  Edit set_gravity(const Vector3d& gravity) override {
    if (!tree_.world) return {false, "gravity is a world's: it is to be " + numbers_of(gravity) + " m/s^2"};
    set_child(tree_.world, "gravity", numbers_of(gravity));
    return {true, "as the gravity of the world"};
  }

  Edit set_stiffness(std::size_t joint, double stiffness) override {
    set_child(dynamics(joint), "spring_stiffness", number(stiffness));
    return {true, "as the spring of the joint, whose reference is to be the command"};
  }

  Edit set_friction(std::size_t joint, double friction) override {
    set_child(dynamics(joint), "friction", number(friction));
    return {true, "as the friction of the joint"};
  }

  [[nodiscard]] std::vector<ArmPart> parts() const override {
    std::vector<ArmPart> all;
    for (const Part& one : parts_) {
      const Isometry3d at = was_[one.link].inverse() * (hangs_on_tip(one.name) ? moved_ * one.at : one.at);
      const std::vector<double> pose = pose_of(one.inertial);
      all.push_back({one.link, at, mass_of(one.inertial), at * Vector3d(pose[0], pose[1], pose[2])});
    }
    return all;
  }

  Edit set_part(std::size_t part, double factor, const Vector3d& centre) override {
    xml_node own = parts_[part].inertial;
    if (!own) return {false, "a link without <inertial>"};
    const Vector3d place = parts()[part].at.inverse() * centre;
    std::vector<double> pose = pose_of(own);
    std::copy(place.begin(), place.end(), pose.begin());
    if (!own.child("pose")) own.prepend_child("pose");
    set_text(own.child("pose"), numbers(pose));
    set_child(own, "mass", number(mass_of(own) * factor));
    for (xml_node one : own.child("inertia").children())
      set_text(one, number(one.text().as_double() * factor));
    return {true, "as the inertias of the links that move with it"};
  }

  Edit add_weight(const std::string& name, std::size_t link, double mass, const Vector3d& at) override {
    if (named(tree_.model, "link", name)) return {false, "a link " + name + " is there already"};
    const std::string child = text_in(joints_[link], "child");
    const Body body{name, child, {0, 0}, mass, {}, 0, {}, moment_of_ball(mass)};
    added_.push_back(sdf_link(body, tree_.pose(child).inverse() * was_[link] * at, child));
    added_.push_back(sdf_joint(body, Vector3d::UnitZ()));
    return {true, "as the link " + name};
  }

  std::string text(const std::vector<std::string>& lines) override {
    now_ = frames();
    for (const auto& [name, part] : tree_.parts()) {
      const std::string frame = tree_.base_of(part);
      const Isometry3d was = tree_.pose(frame).inverse() * tree_.pose(name),
                       is = pose_now(frame).inverse() * pose_now(name);
      if ((was.matrix() - is.matrix()).cwiseAbs().maxCoeff() > last_digit) replace_pose(part.element, is);
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) point_axis(i);
    for (const Xml& one : added_) append(tree_.model, one);
    return tree_.source.text(lines);
  }

 private:
  struct Part {
    xml_node inertial;
    std::string name;
    std::size_t link;
    Isometry3d at;  ///< of the link in the model, as it was
  };

  void add_part(const ReadFrame& frame) {
    const std::size_t link = path_.link_of(frame.carrier);
    if (link == 0 || link == ArmPath::elsewhere || !frame.is_body()) return;
    const xml_node inertial = named(tree_.model, "link", frame.name).child("inertial");
    if (mass_of(inertial) > 0 && !inertial.attribute("auto").as_bool())
      parts_.push_back({inertial, frame.name, link - 1, frame.at});
  }

  /// Of the arm's links in the model, all joints at zero.
  [[nodiscard]] std::vector<Isometry3d> frames() const {
    std::vector<Isometry3d> all;
    Isometry3d at = path_.base().at;
    for (const ArmLink<double>& link : arm_.links) all.push_back(at = at * link.frame);
    return all;
  }

  /// Of a part in the model, as the joints and the tip stand now; of the model itself for an empty name.
  [[nodiscard]] Isometry3d pose_now(const std::string& name) const {
    Isometry3d at = tree_.pose(name);
    if (name.empty() || name == "world") return at;
    const std::string carrier = tree_.link_of(name);
    const auto link = std::find_if(read_.frames.begin(), read_.frames.end(), [&](const ReadFrame& one) {
      return one.is_body() && one.name == files::shown(carrier);
    });
    const std::size_t number = link == read_.frames.end() ? 0 : path_.link_of(link->carrier);
    if (number == 0 || number == ArmPath::elsewhere) return at;
    if (hangs_on_tip(name)) at = moved_ * at;
    return now_[number - 1] * was_[number - 1].inverse() * at;
  }

  [[nodiscard]] bool hangs_on_tip(const std::string& name) const {
    std::string own = name;
    for (std::size_t steps = 0; steps <= tree_.parts().size() && own != path_.tip().name; ++steps) {
      const auto found = tree_.parts().find(own);
      if (found == tree_.parts().end()) return false;
      const std::string kind = found->second.element.name();
      if (kind == "frame")
        own = tree_.resolved(found->second.element.attribute("attached_to").value(), "");
      else if (kind == "joint")
        own = tree_.named_by(found->second, "child");
      else if (const std::string holder = tree_.holder_of(own); holder.empty())
        return false;
      else
        own = tree_.named_by(tree_.parts().at(holder), "parent");
    }
    return own == path_.tip().name;
  }

  void point_axis(std::size_t joint) {
    const std::string name = joints_[joint].attribute("name").value();
    const std::string frame = tree_.frame_of_axis(name);
    const Vector3d was = tree_.pose(frame).linear().transpose() * read_.joints[path_.joints()[joint]].axis,
                   is =
                       pose_now(frame).linear().transpose() * (now_[joint].linear() * arm_.links[joint].axis);
    if ((was.normalized() - is).norm() <= last_digit) return;
    xml_node xyz = joints_[joint].child("axis").child("xyz");
    if (!xyz) xyz = joints_[joint].child("axis").append_child("xyz");
    set_text(xyz, numbers_of(is));
  }

  [[nodiscard]] xml_node dynamics(std::size_t joint) {
    xml_node axis = joints_[joint].child("axis"), own = axis.child("dynamics");
    if (own) return own;
    own = axis.append_child("dynamics");
    for (const char* part : {"spring_reference", "spring_stiffness"}) set_child(own, part, "0");
    return own;
  }

  /// A link without one weighs a kilogram.
  static double mass_of(xml_node inertial) {
    return inertial.child("mass") ? inertial.child("mass").text().as_double() : 1;
  }
  static std::vector<double> pose_of(xml_node inertial) {
    std::vector<double> pose = numbers_in(text_in(inertial, "pose"), "pose", 0, 7);
    pose.resize(std::max<std::size_t>(pose.size(), 6));
    return pose;
  }

  ReadModel read_;
  ArmPath path_;
  SdfTree tree_;
  SerialArm<double> arm_;
  std::vector<Isometry3d> was_, now_;  ///< of the links in the model
  std::vector<xml_node> joints_;
  Isometry3d moved_ = Isometry3d::Identity();  ///< what the tip moves by, in the model as it was
  std::vector<Part> parts_;
  std::vector<Xml> added_;
};

}  // namespace

std::unique_ptr<ArmDocument> arm_in_sdf(const std::filesystem::path& file, const ArmEnds& ends) {
  return std::make_unique<SdfArm>(file, ends);
}

}  // namespace plumbline::exchange
