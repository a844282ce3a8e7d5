#include <doctest/doctest.h>

#include <numbers>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/read_model.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/exchange/arm_in_mujoco.hpp"
#include "tests/diagnose/exchange/drawn_arm.hpp"
#include "tests/diagnose/exchange/sdf_in_mujoco.hpp"
#include "tests/folder.hpp"

// Arms in space out of models: MuJoCo and sdformat judge the kinematics and the weights.
namespace plumbline::exchange {
namespace {

using namespace test;

/// Sums of a dozen turned places of a metre or so, in double precision.
constexpr double frame_rounding = 1e-12;

SpatialArm arm_of(const std::string& name, const std::string& text, const ArmEnds& ends = {}) {
  const Folder folder;
  folder.write(name, text);
  return read_arm(folder / name, ends);
}

std::string arm_answer_to(const std::string& name, const std::string& text, const ArmEnds& ends = {}) {
  try {
    static_cast<void>(arm_of(name, text, ends));
  } catch (const Error& error) {
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "read without a word";
}

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

bool remarks(const SpatialArm& arm, const std::string& words) {
  return std::any_of(arm.notes.begin(), arm.notes.end(),
                     [&](const std::string& note) { return holds(note, words); });
}

/// The arm's tip and the energy of its weights, against those of MuJoCo.
template <class Tip>
void check_as_in(ArmInMujoco& mujoco, const SpatialArm& read, const Tip& tip) {
  const diagnose::NominalArm& own = read.nominal;
  const std::vector<double> zero(own.joint.size(), 0.0);
  mujoco.move(own.joint, zero);
  const double at_zero = mujoco.energy();
  for (int k = 0; k < 3; ++k) {
    const std::vector<double> q = drawn_coordinates(own.joint.size());
    mujoco.move(own.joint, q);
    RC_ASSERT(apart(tip(mujoco), tip_pose(own.arm, q)) < frame_rounding);
    const double change = energy(own.arm, q) - energy(own.arm, zero);
    // dozens of kilograms by metres by gravity: hundreds of joules
    RC_ASSERT(std::abs(mujoco.energy() - at_zero - change) < 1e3 * frame_rounding);
  }
}

/// A model of two hinges and a slide; `more` goes into the joint elbow.
std::string arm_urdf(const std::string& more, const std::string& rest = "") {
  return R"(<robot name="r"><link name="base"/><link name="upper"/><link name="lower"/><link name="tool"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
<joint name="elbow" )" +
         more + R"(<parent link="upper"/><child link="lower"/><origin xyz="1 0 0"/></joint>
<joint name="flange" type="fixed"><parent link="lower"/><child link="tool"/><origin xyz="1 0 0"/></joint>)" +
         rest + "</robot>";
}

}  // namespace

TEST_CASE("arms out of MJCF: poses and weights are MuJoCo's at any joint coordinates") {
  check_property("as MuJoCo compiles it", [] {
    const Folder folder;
    folder.write("arm.xml", arm_in_mjcf(drawn_bodies()));
    ArmInMujoco mujoco(folder / "arm.xml");
    const SpatialArm read = read_arm(folder / "arm.xml");
    RC_ASSERT(read.nominal.base == "base");
    RC_ASSERT(read.nominal.tip == "tip");
    check_as_in(mujoco, read, [](const ArmInMujoco& in) { return in.site("tip"); });
  });
}

TEST_CASE("arms out of URDF: poses and weights are MuJoCo's at any joint coordinates") {
  check_property("as MuJoCo compiles it", [] {
    const Folder folder;
    folder.write("arm.urdf", arm_in_urdf(drawn_bodies()));
    ArmInMujoco mujoco(folder / "arm.urdf");
    SpatialArm read = read_arm(folder / "arm.urdf", {"base", "tip"});
    read.nominal.arm.gravity = {0, 0, -9.81};  // MuJoCo's where the file has none
    check_as_in(mujoco, read, [](const ArmInMujoco& in) { return in.body("tip"); });
  });
}

TEST_CASE("arms out of SDF: poses and weights are those of sdformat, in MuJoCo") {
  check_property("as sdformat reads it", [] {
    const Folder folder;
    folder.write("arm.sdf", arm_in_sdf(drawn_bodies()));
    folder.write("arm.xml", mjcf_of(folder / "arm.sdf", "tip", {0, 0, -9.8}));
    ArmInMujoco mujoco(folder / "arm.xml");
    SpatialArm read = read_arm(folder / "arm.sdf");
    RC_ASSERT(read.nominal.tip == "tip");
    // The judge has the model's own frame; the arm stands in the world.
    const Eigen::Isometry3d placed = read.nominal.arm.base;
    read.nominal.arm.base = Eigen::Isometry3d::Identity();
    mujoco.move(read.nominal.joint, std::vector<double>(read.nominal.joint.size(), 0.0));
    check_as_in(mujoco, read, [](const ArmInMujoco& in) { return in.site("end"); });
    RC_ASSERT(apart(placed, read_arm(folder / "arm.sdf", {"base", "tip"}).nominal.arm.base) == 0);
  });
}

TEST_CASE("servos and springs are compliances; limits, friction and names are the file's") {
  const SpatialArm read = arm_of("arm.xml", R"(<mujoco><compiler angle="radian"/>
<default><joint range="-1 2" frictionloss="0.3"/><position kp="50"/></default>
<worldbody><body name="upper"><joint name="a" axis="0 1 0" stiffness="7"/><geom size="0.1"/>
<body name="lower" pos="1 0 0"><joint name="b" type="slide" limited="false"/><geom size="0.1"/>
<body name="hand" pos="1 0 0"><joint name="c" stiffness="20" range="-0.5 0.5"/><geom size="0.1"/>
<site name="tool" pos="0 0 1"/></body></body></body></worldbody>
<actuator><position joint="a" gear="2"/><position joint="b" kp="1000"/></actuator></mujoco>)");
  const diagnose::NominalArm& own = read.nominal;
  CHECK(own.base == "world");
  CHECK(own.joint == std::vector<std::string>{"a", "b", "c"});
  CHECK(own.link == std::vector<std::string>{"upper", "lower", "hand"});
  CHECK(own.arm.links[0].joint_compliance == close_to(1.0 / 200));  // kp times the gear's square
  CHECK(own.arm.links[1].joint_compliance == close_to(1.0 / 1000));
  CHECK(own.arm.links[2].joint_compliance == close_to(1.0 / 20));
  CHECK(own.arm.links[1].kind == JointKind::prismatic);
  CHECK(own.limits[0] == std::array<double, 2>{-1, 2});
  CHECK(std::isinf(own.limits[1][1]));
  CHECK(read.friction == std::vector<double>(3, 0.3));
  CHECK(remarks(read, "spring beside the servo of a"));
  CHECK(remarks(read, "without limits: b"));
}

TEST_CASE("the base is the root, the tip what is named as one, or the only or farthest last link") {
  const std::string two = arm_urdf("type=\"continuous\">");
  CHECK(arm_of("m.urdf", two).nominal.tip == "tool");
  CHECK(arm_of("m.urdf", two).nominal.base == "base");
  CHECK(arm_of("m.urdf", two, {"upper", ""}).nominal.joint == std::vector<std::string>{"elbow"});
  CHECK(arm_of("m.urdf", two, {"", "lower"}).nominal.joint.size() == 2);
  const std::string gripper =
      R"(<robot><link name="world"/><link name="stand"/><link name="a"/><link name="f1"/><link name="f2"/>
<joint name="bolted" type="fixed"><parent link="world"/><child link="stand"/></joint>
<joint name="j" type="continuous"><parent link="stand"/><child link="a"/></joint>
<joint name="g1" type="prismatic"><parent link="a"/><child link="f1"/></joint>
<joint name="g2" type="prismatic"><parent link="a"/><child link="f2"/><mimic joint="g1"/></joint></robot>)";
  CHECK(
      holds(arm_answer_to("m.urdf", gripper), "2 possible tips of an arm, expected one by its name: f1, f2"));
  const SpatialArm held = arm_of("m.urdf", gripper, {"", "a"});
  CHECK(held.nominal.base == "stand");
  CHECK(remarks(held, "held where the model draws them: g1, g2"));
  CHECK(holds(arm_answer_to("m.urdf", gripper, {"", "f2"}), "joint g2: found a joint that follows g1"));
}

TEST_CASE("what is no serial arm is refused in a line") {
  const auto says = [](const std::string& text, const std::string& words, const ArmEnds& ends = {}) {
    const std::string said = arm_answer_to("m.urdf", text, ends);
    CAPTURE(said);
    CHECK(holds(said, words));
  };
  says(arm_urdf("type=\"planar\">"), "joint elbow: found the type planar, expected revolute");
  says(arm_urdf("type=\"floating\">"), "joint elbow: found a body that floats");
  says(arm_urdf("type=\"revolute\"><mimic joint=\"shoulder\"/>"), "a joint that follows shoulder");
  says(arm_urdf("type=\"revolute\"><axis xyz=\"0 0 0\"/>"), "an axis of no length");
  says(arm_urdf("type=\"revolute\"><limit lower=\"2\" upper=\"-2\"/>"), "limits from 2 to -2");
  says(arm_urdf("type=\"revolute\"><limit lower=\"-170\" upper=\"170\"/>"),
       "a limit of -170 rad, expected -2.96706, if");
  const std::string good = arm_urdf("type=\"continuous\">");
  says(good, "no body or frame gripper, expected one of base, upper, lower, tool", {"", "gripper"});
  says(good, "no joint between link lower and link tool", {"lower", "tool"});
  says(good, "none carries the other", {"lower", "upper"});
  const auto with_link = [](const std::string& inertial) {
    return arm_urdf(
        "type=\"continuous\">",
        R"(<link name="l"><inertial>)" + inertial +
            R"(</inertial></link><joint name="k" type="fixed"><parent link="tool"/><child link="l"/></joint>)");
  };
  says(with_link(R"(<mass value="-1"/>)"), "<link name=\"l\">: mass: found -1, expected kilograms");
  says(with_link(R"(<origin rpy="0 90 0"/><mass value="1"/>)"),
       "an angle of 90, expected radians: 1.5708, if");
  says(good, "read without a word");
  says(arm_urdf("type=\"continuous\">",
                R"(<joint name="elbow" type="fixed"><parent link="base"/><child link="lower"/></joint>)"),
       "link lower on two joints");
}

TEST_CASE("an inertia that no body has is said, and does no harm") {
  for (const auto& [inertia, words] :
       {std::pair(R"(ixx="1" iyy="-2" izz="1")",
                  "inertia of l: a principal moment of -2 kg m^2, as no body has"),
        std::pair(R"(ixx="1" iyy="1" izz="3")",
                  "a principal moment of 3 kg m^2, larger than 1 and 1 together")}) {
    const SpatialArm read = arm_of(
        "m.urdf",
        arm_urdf(
            "type=\"continuous\">",
            R"(<link name="l"><inertial><mass value="2"/><inertia )" + std::string(inertia) +
                R"(/></inertial></link><joint name="k" type="fixed"><parent link="tool"/><child link="l"/></joint>)"));
    CHECK(remarks(read, words));
    CHECK(read.nominal.arm.links[1].mass == 2);
  }
}

TEST_CASE("bodies that are tied close a loop, unless no joint of the arm moves between them") {
  const auto arm = [](const std::string& constraint) {
    return R"(<mujoco><worldbody><body name="a"><joint name="j"/><geom size="0.1"/>
<body name="b" pos="1 0 0"><joint name="k"/><geom size="0.1"/><site name="tool"/>
<body name="f"><joint name="g"/><geom size="0.1"/></body></body></body></worldbody><equality>)" +
           constraint + "</equality></mujoco>";
  };
  CHECK(holds(arm_answer_to("m.xml", arm(R"(<connect name="rod" body1="a" body2="f" anchor="0 0 0"/>)")),
              "a closed loop: connect rod ties link 2 of the arm to link 1"));
  CHECK(holds(arm_answer_to("m.xml", arm(R"(<weld body1="b"/>)")),
              "a closed loop: weld ties link 2 of the arm to the base"));
  CHECK(holds(arm_answer_to("m.xml", arm(R"(<joint joint1="k" joint2="j"/>)")), "a joint that follows j"));
  CHECK(arm_of("m.xml", arm(R"(<connect body1="b" body2="f" anchor="0 0 0"/>)")).nominal.joint.size() == 2);
  CHECK(arm_of("m.xml", arm(R"(<weld body1="b" active="false"/>)")).nominal.joint.size() == 2);
}

TEST_CASE("limits of radians that are read as degrees are asked about") {
  const std::string arm =
      R"(<mujoco><worldbody><body><joint range="-2.9 2.9"/><geom size="0.1"/><site name="tool" pos="1 0 0"/></body></worldbody></mujoco>)";
  CHECK(
      remarks(arm_of("m.xml", arm), "all limits are within 2.9 degrees: are they radians, read as degrees?"));
}

}  // namespace plumbline::exchange
