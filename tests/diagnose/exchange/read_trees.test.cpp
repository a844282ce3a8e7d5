#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "diagnose/exchange/read_sdf.hpp"
#include "diagnose/exchange/read_urdf.hpp"
#include "tests/close_to.hpp"
#include "tests/folder.hpp"

// URDF and SDF as their specifications have them: an arm of two joints, upright, in each of the ways to say
// it.
namespace plumbline::exchange {
namespace {

PlanarChain chain_of_urdf(const std::string& text) {
  const Folder folder;
  folder.write("arm.urdf", text);
  return planar_chain(read_urdf(folder / "arm.urdf"), "arm.urdf");
}
PlanarChain chain_of_sdf(const std::string& text) {
  const Folder folder;
  folder.write("arm.sdf", text);
  return planar_chain(read_sdf(folder / "arm.sdf"), "arm.sdf");
}

bool remarks(const PlanarChain& chain, const std::string& words) {
  return std::any_of(chain.notes.begin(), chain.notes.end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

/// Upper link 0.4 along x, lower one 0.3 straight down; springs 3 and 2; masses in the middles.
void check_arm(const PlanarChain& arm) {
  REQUIRE(arm.chain.link_length.size() == 2);
  CHECK(arm.chain.link_length[0] == close_to(0.4));
  CHECK(arm.chain.link_length[1] == close_to(0.3));
  CHECK(arm.chain.joint_stiffness == std::vector<double>{3, 2});
  CHECK(arm.chain.link_mass[0] == close_to(2));
  CHECK(arm.chain.link_mass[1] == close_to(1));
  CHECK(arm.chain.rest[0] == close_to(-0.25));  // its axis is -y of the plane of x and z: angles change sign
  CHECK(arm.chain.rest[1] == close_to(-std::acos(0.0) + 0.5));
  CHECK(std::abs(arm.chain.gravity[0]) < 1e-12);
  CHECK(arm.chain.gravity[1] < -9.7);
}

const std::string inertia = R"(<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>)";

}  // namespace

TEST_CASE(
    "URDF: origins turn what follows, axes are the child's, Gazebo has the springs, fixed links end the "
    "chain") {
  const PlanarChain arm = chain_of_urdf(R"(<robot name="arm">
  <link name="world"/><link name="stand"><inertial><mass value="50"/>)" +
                                        inertia + R"(</inertial></link>
  <link name="upper"><inertial><origin xyz="0 0.2 0"/><mass value="2"/>)" +
                                        inertia + R"(</inertial></link>
  <link name="lower"><inertial><origin xyz="0.15 0 0" rpy="1 2 3"/><mass value="1"/>)" +
                                        inertia + R"(</inertial></link>
  <link name="flange"/><link name="camera"/>
  <joint name="bolted" type="fixed"><parent link="world"/><child link="stand"/><origin xyz="1 2 3" rpy="0 0 -1.5707963267948966"/></joint>
  <joint name="hip" type="continuous"><parent link="stand"/><child link="upper"/><axis xyz="-1 0 0"/></joint>
  <joint name="knee" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="0 0.4 0" rpy="0 1.5707963267948966 0"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/><dynamics friction="0.1"/></joint>
  <joint name="end" type="fixed"><parent link="lower"/><child link="flange"/><origin xyz="0.3 0 0"/></joint>
  <joint name="lens" type="fixed"><parent link="lower"/><child link="camera"/><origin xyz="0 0 0"/></joint>
  <gazebo reference="hip"><springStiffness>3</springStiffness><springReference>0.25</springReference></gazebo>
  <gazebo reference="knee"><springReference>0.5</springReference><springStiffness>2</springStiffness></gazebo>
</robot>)");
  CHECK(arm.chain.link_length == std::vector<double>{0.4, 0.3});
  CHECK(arm.chain.joint_stiffness == std::vector<double>{3, 2});
  CHECK(arm.chain.link_mass[0] == close_to(2));
  CHECK(arm.chain.link_mass[1] == close_to(1));
  CHECK(arm.chain.gravity[1] == close_to(-9.8));
  CHECK(arm.chain.effects ==
        std::vector<diagnose::NominalEffect>{{"friction_spread", 0, {{"tau_1", 0}, {"tau_2", 0.1}}}});
  for (const char* words : {"end point: link flange", "range of knee", "at 1, 3 of the model"})
    CHECK_MESSAGE(remarks(arm, words), words);
}

TEST_CASE("SDF: poses by any frame, in degrees or as quaternions, axes in any frame, parts of parts") {
  const std::string head = R"(<sdf version="1.9"><world name="w"><gravity>0 0 -9.81</gravity>
<include><uri>model://sun</uri></include><model name="ground"><static>true</static><link name="l"/></model><model name="arm">)",
                    tail = "</model></world></sdf>";
  const std::string
      spring =
          R"(<dynamics><spring_stiffness>3</spring_stiffness><spring_reference>0.25</spring_reference></dynamics>)",
      knee =
          R"(<dynamics><spring_stiffness>2</spring_stiffness><spring_reference>0.5</spring_reference></dynamics>)";
  const std::string hip =
      R"(<joint name="hip" type="revolute"><parent>world</parent><child>upper</child><axis><xyz>0 1 0</xyz>)" +
      spring + "</axis></joint>";
  // by the frame of the model
  check_arm(chain_of_sdf(
      head + hip +
      R"(<link name="upper"><pose>1 2 3 0 0 0</pose><inertial><pose>0.2 0 0 0 0 0</pose><mass>2</mass></inertial></link>
<link name="lower"><pose>1.4 2 3 0 1.5707963267948966 0</pose><inertial><pose>0.15 0 0 0 0 0</pose><mass>1</mass></inertial></link>
<joint name="knee" type="revolute"><parent>upper</parent><child>lower</child><axis><xyz>0 -1 0</xyz>)" +
      knee + R"(</axis></joint>
<frame name="tool_tip" attached_to="lower"><pose>0.3 0 0 0 0 0</pose></frame>)" +
      tail));
  // by each other, in degrees and as a quaternion, the axis in the frame of the model, the end a fixed link
  check_arm(chain_of_sdf(
      head + hip +
      R"(<link name="upper"><pose>1 2 3 0 0 0</pose><inertial><pose>0.2 0 0 0 0 0</pose><mass>2</mass></inertial></link>
<frame name="elbow" attached_to="upper"><pose degrees="true">0.4 0 0 0 90 0</pose></frame>
<link name="lower"><pose relative_to="elbow"/><inertial><pose rotation_format="quat_xyzw">0.15 0 0 0 0 0 1</pose><mass>1</mass></inertial></link>
<joint name="knee" type="revolute"><parent>elbow</parent><child>lower</child><axis><xyz expressed_in="__model__">0 -1 0</xyz>)" +
      knee + R"(</axis></joint>
<link name="end"><pose relative_to="lower">0.3 0 0 0 0 0</pose><inertial><mass>1e-9</mass></inertial></link>
<joint name="glue" type="fixed"><parent>lower</parent><child>end</child></joint>)" +
      tail));
  // the lower part a model in the model
  check_arm(chain_of_sdf(
      head + hip +
      R"(<link name="upper"><pose>1 2 3 0 0 0</pose><inertial><pose>0.2 0 0 0 0 0</pose><mass>2</mass></inertial></link>
<model name="fore"><pose relative_to="upper">0.4 0 0 0 1.5707963267948966 0</pose><link name="lower"><inertial><pose>0.15 0 0 0 0 0</pose><mass>1</mass></inertial></link>
<frame name="tip"><pose rotation_format="quat_xyzw">0.3 0 0 0 0 0.7071 0.7071</pose></frame></model>
<joint name="knee" type="revolute"><parent>upper</parent><child>fore::lower</child><axis><xyz>0 -1 0</xyz>)" +
      knee + "</axis></joint>" + tail));
}

TEST_CASE("centres of mass are nominal where they lie off the middle, along a link or across it") {
  // the lower link hangs: across it, counter-clockwise, is forward, along the z of its turned frame
  const PlanarChain arm = chain_of_sdf(R"(<sdf version="1.9"><world name="w"><model name="arm">
<link name="upper"><inertial><pose>0.25 0 0 0 0 0</pose><mass>2</mass></inertial></link>
<link name="lower"><pose>0.4 0 0 0 1.5707963267948966 0</pose><inertial><pose>0.15 0 0.02 0 0 0</pose><mass>1</mass></inertial></link>
<joint name="hip" type="revolute"><parent>world</parent><child>upper</child><axis><xyz>0 -1 0</xyz></axis></joint>
<joint name="knee" type="revolute"><parent>upper</parent><child>lower</child><axis><xyz>0 -1 0</xyz></axis></joint>
<frame name="tip" attached_to="lower"><pose>0.3 0 0 0 0 0</pose></frame></model></world></sdf>)");
  CHECK(arm.chain.effects ==
        std::vector<diagnose::NominalEffect>{{"link_centre", 1, {{"d_x", 0.05}, {"d_y", 0}}},
                                             {"link_centre", 2, {{"d_x", 0}, {"d_y", 0.02}}}});
}

TEST_CASE("SDF until 1.4 has axes in the frame of the model; a model that lies has gravity along it") {
  const auto arm = [](const std::string& version) {
    return R"(<sdf version=")" + version +
           R"("><world name="w"><model name="arm"><pose>0 0 0 1.5707963267948966 0 0</pose>
<link name="a"><pose>0 0 0 0 0 0.5</pose><inertial><pose>0.1 0 0 0 0 0</pose><mass>1</mass></inertial></link>
<joint name="j" type="revolute"><parent>world</parent><child>a</child><axis><xyz>0 0 1</xyz></axis></joint></model></world></sdf>)";
  };
  for (const char* version : {"1.4", "1.9"}) {
    const PlanarChain read = chain_of_sdf(arm(version));
    CHECK(read.chain.link_length[0] == close_to(0.2));  // twice as far as the centre of mass
    CHECK(read.chain.gravity[1] == close_to(-9.8));
  }
}

}  // namespace plumbline::exchange
