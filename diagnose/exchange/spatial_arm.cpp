#include "diagnose/exchange/spatial_arm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/physical_body.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

Isometry3d place_of(const ReadJoint& joint) {
  Isometry3d at = Isometry3d::Identity();
  at.linear() = joint.turn;
  at.translation() = joint.anchor;
  return at;
}

class ArmBuilder {
 public:
  ArmBuilder(const ReadModel& model, const std::string& source, const ArmEnds& ends)
      : model_(model), source_(source), path_(model, source, ends) {}

  SpatialArm result() {
    if (!model_.rows.empty())
      throw Error(source_, "corrections of a chain in the plane", "the model without them");
    require_no_loop();
    SerialArm<double>& arm = result_.nominal.arm;
    result_.nominal.base = path_.base().name;
    result_.nominal.tip = path_.tip().name;
    arm.base = model_.placed * path_.base().at;
    arm.gravity = model_.placed.linear() * model_.gravity;
    Isometry3d before = path_.base().at;
    for (std::size_t i = 0; i < path_.joints().size(); ++i) add_link(i, before);
    arm.tip = before.inverse() * path_.tip().at;
    weigh();
    add_inertias();
    add_notes();
    require_physical(arm);
    result_.joints = path_.joints();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const ReadJoint& joint(std::size_t i) const { return model_.joints[path_.joints()[i]]; }

  [[noreturn]] void refuse(const ReadJoint& own, const std::string& found,
                           const std::string& expected) const {
    throw Error(fmt::format("{}: joint {}", source_, own.name), found, expected);
  }

  /// \param before  the frame of the link before, in the reference configuration; then that of this one
  void add_link(std::size_t i, Isometry3d& before) {
    const ReadJoint& own = joint(i);
    require_simple(own);
    require_limits(own);
    const Isometry3d at = place_of(own);
    ArmLink<double> link;
    link.kind = own.motion == JointMotion::hinge ? JointKind::revolute : JointKind::prismatic;
    link.axis = (own.turn.transpose() * own.axis).normalized();
    link.frame = before.inverse() * at * joint_motion<double>(link.kind, link.axis, -own.reference);
    const double stiffness = own.servo > 0 ? own.servo : own.stiffness;
    if (stiffness > 0) link.joint_compliance = 1 / stiffness;
    result_.nominal.arm.links.push_back(link);
    result_.nominal.joint.push_back(own.name);
    result_.nominal.link.push_back(path_.link_name(i));
    result_.nominal.limits.push_back(own.range);
    result_.friction.push_back(own.friction);
    if (own.friction > 0) result_.effects.push_back({"joint_friction", i + 1, {{"tau_c", own.friction}}});
    before = at;
  }

  void require_simple(const ReadJoint& own) const {
    if (own.motion == JointMotion::free)
      refuse(own, "a body that floats", "a base beyond it, or hinges and slides");
    if (own.motion == JointMotion::other)
      refuse(own, "the type " + own.type, "revolute, continuous or prismatic from base to tip");
    if (!own.follows.empty())
      refuse(own, "a joint that follows " + own.follows, "joints that move for themselves from base to tip");
    if (own.stiffness < 0) refuse(own, "a negative stiffness", "zero or a positive one");
  }

  void require_limits(const ReadJoint& own) const {
    if (own.range[0] > own.range[1])
      refuse(own, fmt::format("limits from {:.6g} to {:.6g}", own.range[0], own.range[1]),
             "the lower one first");
    // Joints of many turns have limits too, and some files say hundreds of turns for none.
    constexpr double five_turns = 30, unlimited = 720;
    for (const double limit : own.range)
      if (own.motion == JointMotion::hinge && std::abs(limit) > five_turns && std::abs(limit) <= unlimited)
        refuse(own, fmt::format("a limit of {:.6g} rad", limit),
               fmt::format("{:.6g}, if that is degrees, or the type continuous", limit * degree));
  }

  /// Bodies that are tied to each other beside the joints, unless no joint of the path moves between them.
  void require_no_loop() const {
    for (const ReadLoop& loop : model_.loops) {
      const std::size_t a = path_.link_of(loop.carriers[0]), b = path_.link_of(loop.carriers[1]);
      const bool on_arm = a != ArmPath::elsewhere && b != ArmPath::elsewhere;
      if (on_arm && a != b)
        throw Error(source_,
                    fmt::format("a closed loop: {} ties link {} of the arm to {}", loop.name, std::max(a, b),
                                std::min(a, b) == 0 ? "the base" : fmt::format("link {}", std::min(a, b))),
                    "a serial arm");
    }
  }

  /// Every joint's masses on the link of the arm that they move with.
  void weigh() {
    std::vector<ReadJoint> lumped(path_.joints().size());
    for (const ReadJoint& one : model_.joints) {
      const std::size_t link = path_.link_of(one.name);
      if (link == 0 || link == ArmPath::elsewhere) continue;
      add_mass(lumped[link - 1], one.mass, one.middle);
      if (one.name != joint(link - 1).name) held_.push_back(one.name);
    }
    for (std::size_t i = 0; i < lumped.size(); ++i) {
      ArmLink<double>& link = result_.nominal.arm.links[i];
      link.mass = lumped[i].mass;
      if (link.mass > 0) link.centre = place_of(joint(i)).inverse() * lumped[i].middle;
    }
  }

  [[nodiscard]] std::size_t arm_size() const { return path_.joints().size(); }

  /// From 0; beyond the arm where it is not on a link of it.
  [[nodiscard]] std::size_t link_of(const ReadInertia& one) const {
    const std::size_t link = path_.link_of(one.carrier);
    return link == 0 || link == ArmPath::elsewhere ? arm_size() : link - 1;
  }

  /// Every body's moments about the origin of its link.
  void add_inertias() {
    result_.inertia.assign(arm_size(), Eigen::Matrix3d::Zero());
    for (const ReadInertia& one : model_.inertias) {
      const std::size_t link = link_of(one);
      if (link == arm_size()) continue;
      const Isometry3d into = place_of(joint(link)).inverse();
      const Vector3d at = into * one.middle;
      result_.inertia[link] +=
          into.linear() * one.tensor * into.linear().transpose() +
          one.mass * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
    }
  }

  void note(const std::string& words, const std::vector<std::string>& names) {
    if (!names.empty()) result_.notes.push_back(fmt::format("{}: {}", words, fmt::join(names, ", ")));
  }

  void add_notes() {
    std::vector<std::string> rigid, unbounded, springs, out = model_.left_out;
    double widest = 0;
    for (std::size_t i = 0; i < path_.joints().size(); ++i) {
      const ReadJoint& own = joint(i);
      if (result_.nominal.arm.links[i].joint_compliance == 0) rigid.push_back(own.name);
      if (!own.bounded() && own.type != "continuous") unbounded.push_back(own.name);
      if (own.servo > 0 && own.stiffness > own.servo) out.push_back("spring beside the servo of " + own.name);
      if (own.motion == JointMotion::hinge)
        widest = std::max({widest, std::abs(own.range[0]), std::abs(own.range[1])});
    }
    note("held where the model draws them", held_);
    note("rigid, without a servo or spring", rigid);
    note("without limits", unbounded);
    constexpr double radians_as_degrees = 2 * std::numbers::pi * degree;
    if (widest > 0 && widest < radians_as_degrees)
      result_.notes.push_back(fmt::format(
          "all limits are within {:.3g} degrees: are they radians, read as degrees?", widest / degree));
    for (const ReadInertia& one : model_.inertias)
      if (const std::string words = impossible_inertia(one.tensor);
          !words.empty() && link_of(one) < arm_size())
        result_.notes.push_back(
            fmt::format("inertia of {}: {}, as no body has (statics does not use it)", one.body, words));
    result_.notes.insert(result_.notes.end(), model_.notes.begin(), model_.notes.end());
    note("left out", out);
  }

  const ReadModel& model_;
  const std::string& source_;
  ArmPath path_;
  SpatialArm result_;
  std::vector<std::string> held_;
};

}  // namespace

SpatialArm spatial_arm(const ReadModel& model, const std::string& source, const ArmEnds& ends) {
  return ArmBuilder(model, source, ends).result();
}

}  // namespace plumbline::exchange
