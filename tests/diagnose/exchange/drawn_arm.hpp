#pragma once
/// \file
/// Random arms as models of three formats; to be called inside a property.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string>
#include <vector>

#include "tests/property.hpp"

namespace plumbline::exchange::test {

/// From 0 to below the end, in the first sample as in the last.
inline int choice(int end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end));
}

/// Between -1 and 1, with three digits as models have them.
inline double drawn_number() {
  return (choice(2001) - 1000) / 1000.0;
}

struct DrawnJoint {
  bool slides;
  std::array<double, 3> axis, place, turn;  ///< turn: roll, pitch and yaw
};

struct DrawnBody {
  DrawnJoint joint;
  double mass;
  std::array<double, 3> centre;
  bool carries_finger;  ///< beside the arm, on a joint of its own
};

inline std::array<double, 3> drawn_vector() {
  return {drawn_number(), drawn_number(), drawn_number()};
}

inline DrawnBody drawn_body() {
  DrawnBody body{{choice(4) == 0, drawn_vector(), drawn_vector(), drawn_vector()},
                 0.1 + choice(50) / 10.0,
                 drawn_vector(),
                 choice(3) == 0};
  body.joint.axis[2] += 2;
  return body;
}

inline std::vector<DrawnBody> drawn_bodies() {
  std::vector<DrawnBody> all(static_cast<std::size_t>(1 + choice(7)));
  for (DrawnBody& one : all) one = drawn_body();
  return all;
}

inline std::vector<double> drawn_coordinates(std::size_t count) {
  std::vector<double> all(count);
  for (double& one : all) one = 3 * drawn_number();
  return all;
}

inline std::string words(const std::array<double, 3>& v) {
  return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

inline std::string inertial_of_urdf(const DrawnBody& one) {
  return fmt::format(
      R"(<inertial><origin xyz="{}"/><mass value="{}"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>)",
      words(one.centre), one.mass);
}

inline std::string joint_of_urdf(const std::string& name, const char* type, const std::string& parent,
                                 const std::string& child, const DrawnJoint& joint) {
  return fmt::format(
      R"(<joint name="{}" type="{}"><parent link="{}"/><child link="{}"/><origin xyz="{}" rpy="{}"/><axis xyz="{}"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>)",
      name, type, parent, child, words(joint.place), words(joint.turn), words(joint.axis));
}

/// Links l1, l2 … on joints j1, j2 …, a fixed link between each, fingers beside it, and a fixed link tip.
inline std::string arm_in_urdf(const std::vector<DrawnBody>& bodies) {
  std::string text =
                  R"(<robot name="arm"><mujoco><compiler fusestatic="false"/></mujoco><link name="base"/>)",
              last = "base";
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const DrawnBody& one = bodies[i];
    const std::string link = fmt::format("l{}", i + 1), flange = fmt::format("f{}", i + 1),
                      finger = fmt::format("finger{}", i + 1);
    text += fmt::format(R"(<link name="{}">{}</link><link name="{}">{}</link>)", link, inertial_of_urdf(one),
                        flange, inertial_of_urdf(one));
    text += joint_of_urdf(fmt::format("j{}", i + 1), one.joint.slides ? "prismatic" : "revolute", last, link,
                          one.joint);
    text += joint_of_urdf(flange + "_fixed", "fixed", link, flange, bodies[bodies.size() - 1 - i].joint);
    if (one.carries_finger) {
      text += fmt::format(R"(<link name="{}">{}</link>)", finger, inertial_of_urdf(one));
      text += joint_of_urdf(finger + "_joint", "prismatic", link, finger, one.joint);
    }
    last = flange;
  }
  text +=
      R"(<link name="tip"><inertial><mass value="0.1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>)";
  return text + joint_of_urdf("tip_fixed", "fixed", last, "tip", bodies.front().joint) + "</robot>";
}

/// The same chain of bodies in MJCF: joints off the origins of their bodies, with references, in degrees.
inline std::string arm_in_mjcf(const std::vector<DrawnBody>& bodies) {
  std::string
      text =
          R"(<mujoco><compiler autolimits="true"/><option gravity="1 2 -9"/><worldbody><body name="base" pos="0.1 0.2 0.3" axisangle="1 2 3 40">)",
      tail = "</body></worldbody></mujoco>";
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const DrawnBody& one = bodies[i];
    text += fmt::format(R"(<body name="l{}" pos="{}" euler="{} {} {}">)", i + 1, words(one.joint.place),
                        90 * one.joint.turn[0], 90 * one.joint.turn[1], 90 * one.joint.turn[2]);
    text += fmt::format(R"(<joint name="j{}" type="{}" axis="{}" pos="{}" ref="{}"/>)", i + 1,
                        one.joint.slides ? "slide" : "hinge", words(one.joint.axis), words(one.centre),
                        one.joint.slides ? 0.2 : 20);
    text += fmt::format(R"(<inertial pos="{}" mass="{}" diaginertia="0.1 0.1 0.1"/>)", words(one.centre),
                        one.mass);
    if (one.carries_finger)
      text += fmt::format(
          R"(<body name="finger{}" pos="{}"><joint name="finger{}_joint" axis="{}"/><geom size="0.1"/></body>)",
          i + 1, words(one.joint.turn), i + 1, words(one.joint.axis));
    tail = "</body>" + tail;
  }
  return text + R"(<site name="tip" pos="0.1 0.2 0.3" xyaxes="1 2 0 0 1 1"/>)" + tail;
}

/// The same in SDF: poses in the model, in the link before or in a frame; axes in various frames, joints off
/// their links.
inline std::string arm_in_sdf(const std::vector<DrawnBody>& bodies) {
  std::string text =
      R"(<sdf version="1.9"><world name="w"><gravity>1 2 -9</gravity><model name="arm"><pose>0.1 0.2 0.3 0.4 0.5 0.6</pose><link name="base"/><joint name="bolted" type="fixed"><parent>world</parent><child>base</child></joint>)";
  std::string last = "base";
  const auto link = [&](const std::string& name, const DrawnBody& one, const std::string& in) {
    text += fmt::format(
        R"(<link name="{}"><pose relative_to="{}">{} {}</pose><inertial><pose>{} 0 0 0</pose><mass>{}</mass></inertial></link>)",
        name, in, words(one.joint.place), words(one.joint.turn), words(one.centre), one.mass);
  };
  const auto joint = [&](const std::string& name, const DrawnBody& one, const std::string& child,
                         const std::string& in) {
    text += fmt::format(
        R"(<joint name="{}" type="{}"><pose>{} {}</pose><parent>{}</parent><child>{}</child><axis><xyz expressed_in="{}">{}</xyz></axis></joint>)",
        name, one.joint.slides ? "prismatic" : "revolute", words(one.centre), words(one.joint.place), last,
        child, in, words(one.joint.axis));
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const DrawnBody& one = bodies[i];
    const std::string name = fmt::format("l{}", i + 1), finger = fmt::format("finger{}", i + 1);
    link(name, one, i % 3 == 0 ? "" : i % 3 == 1 ? last : "base");
    joint(fmt::format("j{}", i + 1), one, name, i % 3 == 0 ? last : i % 3 == 1 ? "__model__" : "");
    last = name;
    if (!one.carries_finger) continue;
    link(finger, one, name);
    joint(finger + "_joint", one, finger, "");
  }
  link("tip", bodies.front(), last);
  text += fmt::format(R"(<joint name="tip_fixed" type="fixed"><parent>{}</parent><child>tip</child></joint>)",
                      last);
  return text + "</model></world></sdf>";
}

}  // namespace plumbline::exchange::test
