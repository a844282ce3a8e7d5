#include "diagnose/exchange/read_mjcf.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <plumbline/base/error.hpp>

#include "tests/close_to.hpp"
#include "tests/folder.hpp"
#include "tests/property.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;

ReadModel read(const std::string& text) {
  const Folder folder;
  folder.write("arm.xml", text);
  return read_mjcf(folder / "arm.xml");
}

PlanarChain chain(const std::string& text, const std::vector<std::string>& kept = {}) {
  return planar_chain(read(text), "arm.xml", kept);
}

bool notes(const PlanarChain& chain, const std::string& words) {
  return std::any_of(chain.notes.begin(), chain.notes.end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

struct InMujoco {
  explicit InMujoco(const std::string& text) : model(nullptr, mj_deleteModel), data(nullptr, mj_deleteData) {
    const Folder folder;
    folder.write("arm.xml", text);
    std::array<char, 500> reason{};
    model.reset(mj_loadXML((folder / "arm.xml").c_str(), nullptr, reason.data(), 500));
    REQUIRE_MESSAGE(model, std::string(reason.data()));
    data.reset(mj_makeData(model.get()));
    mj_kinematics(model.get(), data.get());
    mj_comPos(model.get(), data.get());
  }
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data;
};

Vector3d vector_at(const mjtNum* values, int number) {
  return Eigen::Map<const Vector3d>(values + std::ptrdiff_t{3} * number);
}

/// From 0 to below the end, in the first sample as in the last.
int pick(int end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end));
}

/// Numbers with two digits behind the point, as models have them.
std::vector<double> drawn(std::size_t count, int least = -100, int most = 100) {
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back((least + pick(most + 1 - least)) / 100.0);
  return all;
}

std::string words(const std::vector<double>& values) {
  return fmt::format("{}", fmt::join(values, " "));
}

/// In one of the five ways that MJCF has.
std::string drawn_orientation() {
  std::vector<double> turn = drawn(6);
  turn[0] += turn[0] < 0 ? -2 : 2;  // never of no length, never two in one direction
  turn[4] += turn[4] < 0 ? -3 : 3;
  const auto first = [&](std::ptrdiff_t count) { return words({turn.begin(), turn.begin() + count}); };
  switch (pick(6)) {
    case 0:
      return "quat=\"" + first(4) + "\"";
    case 1:
      return "axisangle=\"" + first(4) + "\"";
    case 2:
      return "euler=\"" + first(3) + "\"";
    case 3:
      return "xyaxes=\"" + first(6) + "\"";
    case 4:
      return "zaxis=\"" + first(3) + "\"";
    default:
      return "";
  }
}

std::string drawn_geom() {
  switch (pick(5)) {
    case 0:
      return "<geom size=\"0.05\" pos=\"" + words(drawn(3)) + "\"/>";
    case 1:
      return "<geom type=\"capsule\" size=\"0.02\" fromto=\"0 0 0 " + words(drawn(3, 1, 50)) + "\"/>";
    case 2:
      return "<geom type=\"box\" size=\"0.1 0.2 0.03\" density=\"300\"/>";
    case 3:
      return "<geom type=\"cylinder\" size=\"0.1 0.2\" mass=\"0.7\" pos=\"0.1 0 0\"/>";
    default:
      return "<geom type=\"ellipsoid\" size=\"0.1 0.2 0.3\"/>";
  }
}

std::string drawn_body(int depth) {
  std::string text = fmt::format("<body pos=\"{}\" {}{}>", words(drawn(3)), drawn_orientation(),
                                 pick(2) == 1 ? " childclass=\"soft\"" : "");
  if (pick(4) > 0) {
    std::vector<double> axis = drawn(3);
    axis[2] += 2;
    text += fmt::format("<joint axis=\"{}\" pos=\"{}\"{}/>", words(axis), words(drawn(3)),
                        pick(2) == 1 ? " ref=\"0.3\"" : "");
  }
  if (pick(4) == 0) text += "<inertial pos=\"" + words(drawn(3)) + "\" mass=\"1.5\" diaginertia=\"1 1 1\"/>";
  text += drawn_geom() + drawn_geom();
  return text + (depth > 0 ? drawn_body(depth - 1) : "") + "</body>";
}

}  // namespace

TEST_CASE("places, springs and masses of any tree are MuJoCo's own") {
  check_property("as MuJoCo compiles it", [] {
    const std::string sequence = *rc::gen::element<std::string>("xyz", "zyx", "XYZ", "yxY", "ZXz");
    const std::string text = fmt::format(
        "<mujoco><compiler angle=\"{}\" eulerseq=\"{}\"/><option gravity=\"{}\"/><default><joint "
        "springref=\"0.2\"/><default class=\"soft\"><joint stiffness=\"3\"/></default></default>"
        "<worldbody>{}</worldbody></mujoco>",
        pick(2) == 1 ? "degree" : "radian", sequence, words(drawn(3)), drawn_body(3));
    RC_PRE(text.find("<joint axis") != std::string::npos);
    const InMujoco mujoco(text);
    const mjModel& m = *mujoco.model;
    const ReadModel own = read(text);
    RC_ASSERT(static_cast<int>(own.joints.size()) == m.njnt);
    RC_ASSERT((own.gravity - vector_at(m.opt.gravity, 0)).norm() < 1e-12);
    for (int j = 0; j < m.njnt; ++j) {
      const ReadJoint& joint = own.joints[static_cast<std::size_t>(j)];
      // sums of a few turned places in double precision
      constexpr double rounding = 1e-12;
      RC_ASSERT((joint.axis - vector_at(mujoco.data->xaxis, j)).norm() < rounding);
      RC_ASSERT((joint.anchor - vector_at(mujoco.data->xanchor, j)).norm() < rounding);
      RC_ASSERT(joint.stiffness == m.jnt_stiffness[j]);
      RC_ASSERT(std::abs(joint.rest - (m.qpos_spring[j] - m.qpos0[j])) < rounding);
    }
    double mass = 0, own_mass = 0;
    Vector3d moment(0, 0, 0), own_moment(0, 0, 0);
    for (int b = m.jnt_bodyid[0]; b < m.nbody; ++b) {
      mass += m.body_mass[b];
      moment += m.body_mass[b] * vector_at(mujoco.data->xipos, b);
    }
    for (const ReadJoint& joint : own.joints) {
      own_mass += joint.mass;
      own_moment += joint.mass * joint.middle;
    }
    RC_ASSERT(std::abs(mass - own_mass) < 1e-10 * mass);
    RC_ASSERT((moment - own_moment).norm() < 1e-9 * mass);
  });
}

TEST_CASE("a servo turns its joint as the spring does that it is read as") {
  for (const char* servo : {R"(<position joint="a" kp="50" gear="2"/>)", R"(<position joint="a"/>)",
                            R"(<general joint="a" biastype="affine" gainprm="40" biasprm="3 -60 -5"/>)",
                            R"(<general joint="a" class="servo"/>)"}) {
    CAPTURE(servo);
    const std::string text = std::string(R"(<mujoco><compiler angle="radian"/><option gravity="0 0 0"/>
<default><position kp="30"/><default class="servo"><general biastype="affine" gainprm="7" biasprm="0 -7"/></default></default>
<worldbody><body><joint name="a" ref="0.1" axis="0 0 1"/><geom size="0.1" pos="0.2 0 0"/></body></worldbody>
<actuator>)") + servo + R"(</actuator><keyframe><key ctrl="0.4"/></keyframe></mujoco>)";
    const InMujoco mujoco(text);
    const ReadModel own = read(text);
    mujoco.data->ctrl[0] = 0.4;
    for (const double q : {-0.3, 0.2, 0.9}) {
      mujoco.data->qpos[0] = q;
      mj_forward(mujoco.model.get(), mujoco.data.get());
      const double deflection = q - 0.1 - own.joints[0].rest;
      CHECK(mujoco.data->qfrc_actuator[0] == close_to(-own.joints[0].stiffness * deflection));
    }
  }
}

namespace {

/// A servo arm as models are written today: no `limited`, attributes of later years, meshes that are not
/// there.
const char* const modern = R"(<mujoco model="arm of 2026">
  <compiler angle="radian" meshdir="nowhere" autolimits="true"/>
  <option integrator="implicitfast" gravity="0 0 -9.81"/>
  <default><default class="arm"><joint frictionloss="0.1" armature="0.005" axis="0 1 0"/><position kp="50" dampratio="1"/>
    <default class="visual"><geom type="mesh" contype="0" group="2"/></default></default></default>
  <asset><mesh file="one.stl"/><material name="grey" rgba="0.5 0.5 0.5 1" metallic="0.3"/></asset>
  <worldbody>
    <body name="stand" childclass="arm">
      <geom class="visual" mesh="one" material="grey"/>
      <frame pos="0 0 0.1" euler="0 0 0">
        <body name="upper" pos="0 0 0.4">
          <joint name="shoulder" range="-1.9 1.9" actuatorfrcrange="-5 5"/>
          <inertial pos="0.1 0 0" mass="0.3" diaginertia="1e-3 1e-3 1e-3"/>
          <geom class="visual" mesh="one"/>
          <body name="lower" pos="0.2 0 0" gravcomp="0.5">
            <joint name="elbow" range="-2.6 2.6"/>
            <inertial pos="0.1 0 0" mass="0.2" diaginertia="1e-3 1e-3 1e-3"/>
            <site name="end" pos="0.18 0 0"/>
          </body>
        </body>
      </frame>
    </body>
    <body name="cube" pos="1 0 0"><freejoint align="auto"/><geom type="box" size="0.1 0.1 0.1"/></body>
  </worldbody>
  <actuator>
    <position class="arm" name="s" joint="shoulder" inheritrange="1"/>
    <pid name="e" joint="elbow" kp="20" ki="3"/>
  </actuator>
</mujoco>)";

}  // namespace

TEST_CASE("a servo arm of today is read, and what statics has no use for is said") {
  const PlanarChain read = chain(modern);
  CHECK(read.chain.link_length == std::vector<double>{0.2, 0.18});
  CHECK(read.chain.joint_stiffness == std::vector<double>{50, 0});
  CHECK(read.chain.link_mass == std::vector<double>{0.3, 0.1});
  CHECK(read.chain.gravity == std::array<double, 2>{0, -9.81});
  CHECK(notes(read, "spring of 50 N m/rad about its command"));
  CHECK(notes(read, "held: joint 3"));
  CHECK(read.chain.effects ==
        std::vector<diagnose::NominalEffect>{{"joint_friction", 0, {{"tau_c", 0.1}}},
                                             {"link_centre", 2, {{"d_x", 0.01}, {"d_y", 0}}}});
  for (const char* left :
       {"friction of elbow", "range of elbow", "pid e", "50 % of the weight of lower, which gravcomp"})
    CHECK_MESSAGE(notes(read, left), left);
  CHECK(notes(read, "at 0, 0.5 of the model"));
}

TEST_CASE("switches of <flag>: no gravity, no springs, no servos") {
  std::string text = modern;
  text.insert(text.find("<default>"), R"(<option><flag gravity="disable" actuation="disable"/></option>)");
  const PlanarChain read = chain(text);
  CHECK(read.chain.joint_stiffness == std::vector<double>{0, 0});
  CHECK(read.chain.gravity == std::array<double, 2>{0, 0});
}

TEST_CASE("an arm whose first axis stands is refused, with the part of it that is a planar chain") {
  std::string text = modern;
  text.replace(text.find("<body name=\"stand\""), 0,
               "<body name=\"column\"><joint name=\"pan\" axis=\"0 0 1\"/>");
  text.replace(text.find("<body name=\"cube\""), 0, "</body>");
  CHECK_THROWS_WITH_AS(
      chain(text),
      doctest::Contains("turned by 90 degrees from that of joint pan, expected a planar chain: "
                        "parallel axes; plumbline chain --joints shoulder,elbow keeps"),
      Error);
  const PlanarChain kept = chain(text, {"elbow", "shoulder"});
  CHECK(kept.chain.link_length == std::vector<double>{0.2, 0.18});
  CHECK(notes(kept, "held: pan, joint 4"));
  // What a joint that is held moves weighs on the one before it.
  CHECK(chain(text, {"shoulder"}).chain.link_mass[0] == close_to(0.4));
  CHECK_THROWS_WITH_AS(chain(text, {"wrist"}), doctest::Contains("no joint wrist, expected some of pan"),
                       Error);
}

TEST_CASE("a stiffness that is given by what MuJoCo computes of the inertia is refused, growth is said") {
  std::string text = modern;
  text.replace(text.find("<joint name=\"elbow\""), 0,
               "<joint name=\"extra\" pos=\"0 0 0.01\" springdamper=\"0.1 1\"/>");
  CHECK_THROWS_WITH_AS(chain(text), doctest::Contains("springdamper"), Error);
  text.replace(text.find("springdamper=\"0.1 1\""), 20, "stiffness=\"3 1\"");
  CHECK(notes(chain(text), "growth of the stiffness of extra"));
}

}  // namespace plumbline::exchange
