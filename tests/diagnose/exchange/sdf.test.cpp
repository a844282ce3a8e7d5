/// \file
/// Written and edited SDF and URDF, as sdformat reads them, at work in MuJoCo.
#include <doctest/doctest.h>

#include <algorithm>

#include "diagnose/exchange/edit_sdf.hpp"
#include "diagnose/exchange/edit_urdf.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/exchange/ways.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/exchange/proof.hpp"
#include "tests/diagnose/exchange/sdf_in_mujoco.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study, test::apart;

/// A robot of somebody's that stands upright in another corner, links along z as it is drawn, a joint that
/// turns the other way, a mesh, a camera, a plugin; at rest it has the angles 0.3, -0.5, 0.4.
constexpr const char* sdf_robot = R"(<?xml version="1.0"?>
<sdf version="1.7">
  <!-- drawn by hand -->
  <world name="lab">
    <gravity>0 0 0</gravity>
    <light name="lamp" type="point"><pose>0 0 3 0 0 0</pose></light>
    <model name="leg">
      <plugin name="talk" filename="libtalk.so"><rate>50</rate></plugin>
      <link name="thigh">
        <inertial><mass>1e-5</mass><inertia><ixx>1e-4</ixx><iyy>1e-4</iyy><izz>1e-4</izz></inertia></inertial>
        <visual name="femur"><geometry><mesh><uri>model://leg/femur.dae</uri></mesh></geometry></visual>
      </link>
      <joint name="hip" type="revolute">
        <parent>world</parent><child>thigh</child>
        <axis><xyz>0 0 1</xyz><dynamics><damping>0.05</damping><spring_reference>0.3</spring_reference><spring_stiffness>2</spring_stiffness></dynamics></axis>
      </joint>
      <link name="shin">
        <pose>0.2 0 0 0 0 1.5707963267948966</pose>
        <inertial><mass>1e-5</mass><inertia><ixx>1e-4</ixx><iyy>1e-4</iyy><izz>1e-4</izz></inertia></inertial>
        <sensor name="eye" type="camera"><camera><horizontal_fov>1.0</horizontal_fov><image><width>64</width><height>64</height></image><clip><near>0.1</near><far>10</far></clip></camera></sensor>
      </link>
      <joint name="knee" type="revolute">
        <parent>thigh</parent><child>shin</child>
        <axis><xyz>0 0 -1</xyz><dynamics><damping>0.05</damping><spring_reference>0.5</spring_reference><spring_stiffness>1.5</spring_stiffness></dynamics></axis>
      </joint>
      <link name="foot">
        <pose relative_to="shin">0 -0.25 0 1.5707963267948966 0 0</pose>
        <inertial><mass>1e-5</mass><inertia><ixx>1e-4</ixx><iyy>1e-4</iyy><izz>1e-4</izz></inertia></inertial>
      </link>
      <joint name="ankle" type="revolute">
        <parent>shin</parent><child>foot</child>
        <axis><xyz expressed_in="shin">0 0 1</xyz><dynamics><damping>0.05</damping><spring_reference>0.4</spring_reference><spring_stiffness>1</spring_stiffness></dynamics></axis>
      </joint>
      <frame name="toe_tip" attached_to="foot"><pose relative_to="shin">0 -0.4 0 0 0 0</pose></frame>
    </model>
  </world>
</sdf>
)";

constexpr const char* urdf_robot = R"(<?xml version="1.0"?>
<robot name="leg">
  <!-- drawn by hand -->
  <link name="world"/>
  <link name="thigh">
    <inertial><mass value="1e-5"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="package://leg/femur.dae"/></geometry></visual>
  </link>
  <joint name="hip" type="continuous">
    <parent link="world"/><child link="thigh"/><axis xyz="0 0 1"/><dynamics damping="0.05"/>
  </joint>
  <link name="shin">
    <inertial><mass value="1e-5"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="knee" type="continuous">
    <origin xyz="0.2 0 0" rpy="0 0 1.5707963267948966"/>
    <parent link="thigh"/><child link="shin"/><axis xyz="0 0 -1"/><dynamics damping="0.05"/>
  </joint>
  <link name="foot">
    <inertial><mass value="1e-5"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="ankle" type="continuous">
    <origin xyz="0 -0.25 0" rpy="1.5707963267948966 0 0"/>
    <parent link="shin"/><child link="foot"/><axis xyz="0 1 0"/><dynamics damping="0.05"/>
  </joint>
  <link name="toe_tip"/>
  <joint name="sole" type="fixed"><origin xyz="0 0 0.15"/><parent link="foot"/><child link="toe_tip"/></joint>
  <transmission name="drive"><type>transmission_interface/SimpleTransmission</type><joint name="knee"/></transmission>
  <gazebo reference="hip"><springStiffness>2</springStiffness><springReference>0.3</springReference></gazebo>
  <gazebo reference="knee"><springStiffness>1.5</springStiffness><springReference>0.5</springReference></gazebo>
  <gazebo reference="ankle"><springStiffness>1</springStiffness><springReference>0.4</springReference></gazebo>
</robot>
)";

const std::vector<double> rest{0.3, -0.5, 0.4};

struct Case {
  const char* name;
  Format format;
  const char* robot;
};
constexpr Case cases[]{{"robot.sdf", Format::sdf, sdf_robot}, {"robot.urdf", Format::urdf, urdf_robot}};

/// What MuJoCo makes of a file.
Prediction in_mujoco(const Folder& folder, const char* name, const std::string& text, const Model& model,
                     const std::string& end, test::Pace pace, const test::Names& names) {
  folder.write(name, text);
  const std::array<double, 2>& own = model.experiment.gravity;
  // URDF has no gravity: what weighs does so as on earth.
  const bool weighs =
      std::any_of(model.experiment.effects.begin(), model.experiment.effects.end(),
                  [](const auto& one) { return one.id == "gravity" || one.id == "tip_payload"; });
  const double weight = weighs ? -9.80665 : 0;
  const std::string mjcf = test::mjcf_of(folder / name, end, {own[0], own[1] + weight, 0});
  Prediction all;
  for (const diagnose::Run& run : model.experiment.runs)
    all.runs.push_back(test::MujocoBench(mjcf, pace, names).run(run));
  return all;
}

/// A bench on which the robot rests as it is drawn, with its nominal chain.
Experiment lab(const std::filesystem::path& model) {
  Experiment experiment = diagnose::test::full_bench();
  static_cast<diagnose::NominalChain&>(experiment) = read_model(model).chain;
  experiment.runs.clear();
  diagnose::test::press(experiment, rest, {-0.06, 0}, 12, true);
  diagnose::test::press(experiment, rest, {-0.05, 0.03}, 10, false, 2.5);
  diagnose::test::load(experiment, rest, {0, 0}, {-2.0, 1.0}, 10);
  return experiment;
}

}  // namespace

TEST_CASE("what SDF and URDF carry does in MuJoCo what the diagnosis found" * doctest::test_suite("long")) {
  for (const Case& one : cases) {
    const Study bare(diagnose::test::full_bench());
    for (const EffectAt& at : test::carried(bare, one.format, 0)) {
      CAPTURE(one.name);
      CAPTURE(at.label());
      const std::vector<double> amount = test::amount_of(bare, at);
      Model model = corrected_models(bare, test::found(bare, at, amount)).front().model;
      const Prediction wanted = predict(bare, {{at}}, amount);
      const test::Pace pace = test::pace_of(at.effect->id);
      Prediction all;
      const Folder folder;
      const std::vector<diagnose::Run> runs = model.experiment.runs;
      for (const diagnose::Run& run : runs) {
        model.rest = run.rest;
        const std::string text = written(model, one.format).text;
        model.experiment.runs = {run};
        all.runs.push_back(in_mujoco(folder, one.name, text, model, "end", pace, {}).runs.front());
        model.experiment.runs = runs;
      }
      const double gap = apart(bare, bare.nominal(), wanted), left = apart(bare, all, wanted);
      CAPTURE(gap);
      CHECK(left < (pace == test::Pace::interpolated ? 0.5 + 0.06 * gap : 0.5));
    }
  }
}

TEST_CASE("a robot's own SDF or URDF is edited: every effect that the format carries does what was found" *
          doctest::test_suite("long")) {
  const test::Names names{"end", "load", {{"hip", 1}, {"knee", -1}, {"ankle", 1}}};
  for (const Case& one : cases) {
    const Folder folder;
    folder.write(one.name, one.robot);
    const Study bare(lab(folder / one.name));
    for (std::size_t j = 0; j < rest.size(); ++j) CHECK(bare.experiment().rest[j] == close_to(rest[j]));
    const Folder edited;
    const Model as_is{"robot", bare.experiment(), rest};
    for (const EffectAt& at : test::carried(bare, one.format, 1)) {
      CAPTURE(one.name);
      CAPTURE(at.label());
      const std::vector<double> amount = test::amount_of(bare, at);
      const Model model =
          corrected_models(bare, test::found(bare, at, amount), folder / one.name).front().model;
      const Written file = written(model, one.format);
      CHECK(file.note == std::string(one.name) + " with the correction in it");
      CHECK(file.text.find("<!-- drawn by hand -->") != std::string::npos);
      CHECK(file.text.find("femur.dae") != std::string::npos);
      const test::Pace pace = test::pace_of(at.effect->id);
      const Prediction wanted = predict(bare, {{at}}, amount);
      const double gap = apart(bare, bare.nominal(), wanted);
      CAPTURE(gap);
      // On the way the robot's own damping drags, with and without the effect.
      const double drag =
          pace == test::Pace::interpolated
              ? 0.06 * gap + apart(bare,
                                   in_mujoco(edited, one.name, one.robot, as_is, "toe_tip", pace, names),
                                   bare.nominal())
              : 0;
      const Prediction now = in_mujoco(edited, one.name, file.text, model, "toe_tip", pace, names);
      CHECK(apart(bare, now, wanted) < 0.5 + drag);
    }
  }
}

TEST_CASE("an edited SDF or URDF is read again as the corrected chain; what is not asked for stays" *
          doctest::test_suite("long")) {
  for (const Case& one : cases) {
    CAPTURE(one.name);
    const Folder folder;
    folder.write(one.name, one.robot);
    const Experiment experiment = lab(folder / one.name);
    Model model{"robot", experiment, rest, folder / one.name};
    model.experiment.effects = {{"joint_stiffness", 2, {{"a", 0.2}}},
                                {"rest_angle", 2, {{"a", 0.05}}},
                                {"link_length", 2, {{"a", 0.1}}},
                                {"position_offset", 0, {{"d_x", 0.01}, {"d_y", 0.02}}}};
    const Folder again;
    again.write(one.name, written(model, one.format).text);
    const PlanarChain chain = read_model(again / one.name);
    const double moved = 0.25 * 0.1;
    CHECK(chain.chain.link_length[0] == close_to(0.2));
    CHECK(chain.chain.link_length[1] == close_to(0.25 + moved));
    CHECK(chain.chain.link_length[2] == close_to(0.15));
    CHECK(chain.chain.joint_stiffness[1] == close_to(1.5 * 1.2));
    // rest angles have no word of their own: the file has the row beside the spring that acts it out
    CHECK(chain.chain.rest[1] == close_to(-0.5));
    CHECK(std::count(chain.chain.effects.begin(), chain.chain.effects.end(),
                     diagnose::NominalEffect{"rest_angle", 2, {{"a", 0.05}}}) == 1);
    CHECK(chain.chain.rest[2] == close_to(0.4));
    CHECK(chain.plane.origin.x() == close_to(-0.01));
    CHECK(chain.plane.origin.y() == close_to(-0.02));
    model.experiment.effects.clear();
    const std::string same = written(model, one.format).text;
    for (const char* word :
         {"drawn by hand", "femur.dae", one.format == Format::sdf ? "libtalk.so" : "drive"})
      CHECK(same.find(word) != std::string::npos);
  }
}

}  // namespace plumbline::exchange
