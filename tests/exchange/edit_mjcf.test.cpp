#include "exchange/edit_mjcf.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "exchange/read_model.hpp"
#include "exchange/ways.hpp"
#include "tests/exchange/proof.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

/// A robot of somebody's: in degrees, with classes, a joint that turns the other way, bodies and actuators of
/// its own, a part in another file, a keyframe. At rest it has the angles 0.3, -0.5, 0.4.
const char* const robot = R"(<mujoco model="leg">
  <!-- drawn by hand -->
  <option gravity="0 0 0"/>
  <default>
    <joint damping="0.1" armature="0.01" limited="true" range="-170 170" frictionloss="0"/>
    <general ctrllimited="true" ctrlrange="-1 1"/>
    <default class="bone"><geom type="capsule" size="0.01" mass="0.01" rgba="0.8 0.8 0.7 1" contype="0" conaffinity="0"/></default>
  </default>
  <include file="floor.xml"/>
  <worldbody>
    <body name="thigh" childclass="bone">
      <joint name="hip" axis="0 0 1" stiffness="2" springref="17.188733853924695"/>
      <geom name="femur" fromto="0 0 0 0.2 0 0"/>
      <body name="shin" pos="0.2 0 0">
        <geom name="tibia" fromto="0 0 0 0.25 0 0"/>
        <joint name="knee" axis="0 0 -1" stiffness="1.5" springref="28.64788975654116"/>
        <body name="foot" pos="0.25 0 0" quat="0.7071067811865476 0.7071067811865475 0 0">
          <joint name="ankle" axis="0 1 0" stiffness="1" springref="22.918311805232928"/>
          <geom name="sole" fromto="0 0 0 0.15 0 0"/>
          <site name="toe_tip" pos="0.15 0 0"/>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator><motor name="push" joint="knee"/></actuator>
  <keyframe><key name="bent" qpos="0.1 0.2 0.3" ctrl="0.5"/></keyframe>
</mujoco>
)";
const char* const room =
    R"(<mujocoinclude><worldbody><light name="lamp" pos="0 0 3"/><geom name="floor" type="plane" size="2 2 0.1" pos="0 0 -1" contype="0" conaffinity="0"/></worldbody></mujocoinclude>)";

/// The robot in a folder, and a bench on which it rests as it is drawn.
struct Lab {
  explicit Lab(int steps = 20) {
    folder.write("robot.xml", robot);
    folder.write("floor.xml", room);
    static_cast<diagnose::NominalChain&>(experiment) = read_model(folder / "robot.xml").chain;
    const std::vector<double> rest{0.3, -0.5, 0.4};
    experiment.runs.clear();
    diagnose::test::press(experiment, rest, {-0.06, 0}, steps, true);
    diagnose::test::press(experiment, rest, {-0.05, 0.03}, 3 * steps / 4, false, 2.5);
    diagnose::test::load(experiment, rest, {0, 0}, {-2.0, 1.0}, 3 * steps / 4);
  }
  Folder folder;
  Experiment experiment = diagnose::test::full_bench();
};

/// The foot's axis, +y of its own frame, is +z of the world's; the knee's is -z.
test::Names names() {
  return {"toe_tip", "load", {{"hip", 1}, {"knee", -1}, {"ankle", 1}}};
}

Prediction in_mujoco(const std::string& text, const Experiment& experiment, test::Pace pace) {
  Prediction all;
  for (const diagnose::Run& run : experiment.runs)
    all.runs.push_back(test::MujocoBench(text, pace, names()).run(run));
  return all;
}

/// Root mean square of what two predictions differ by, in standard deviations of the noise.
double apart(const Study& study, const Prediction& a, const Prediction& b) {
  std::vector<double> one = study.residual(a);
  const std::vector<double> other = study.residual(b);
  for (std::size_t i = 0; i < one.size(); ++i) one[i] -= other[i];
  return test::rms(one);
}

std::string file_without_floor() {
  std::string text = robot;
  const std::string include = "<include file=\"floor.xml\"/>";
  return text.erase(text.find(include), include.size());
}

using Compiled = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;

Compiled compiled(const Lab& lab, const std::string& text) {
  lab.folder.write("edited.xml", text);
  std::array<char, 500> reason{};
  Compiled model(mj_loadXML((lab.folder / "edited.xml").c_str(), nullptr, reason.data(), 500),
                 mj_deleteModel);
  REQUIRE_MESSAGE(model, std::string(reason.data()));
  return model;
}

}  // namespace

TEST_CASE("a robot's own file is edited: every effect that MJCF carries does in MuJoCo what was found") {
  // What lags is taken to go straight from reading to reading: these are close for it.
  const Lab lab, fine(40);
  CHECK(lab.experiment.rest[1] == doctest::Approx(-0.5));
  for (const EffectAt& at : possible_effects(Study(lab.experiment))) {
    if (!way_of(Format::mjcf, at.effect->id).carried || at.joint == 1 || at.joint == 3) continue;
    CAPTURE(at.label());
    Experiment experiment = at.effect->id == "sensor_lag" ? fine.experiment : lab.experiment;
    const bool timed = test::takes_time(at);
    if (timed || at.effect->id == "guide_friction") experiment.runs.pop_back();
    if (timed)
      for (diagnose::Run& run : experiment.runs)
        for (diagnose::Reading& reading : run.readings) reading.t *= test::slowness;
    const Study bare(experiment);
    const std::vector<double> amount = test::amount_of(bare, at);
    Model model =
        corrected_models(bare, test::found(bare, at, amount), lab.folder / "robot.xml").front().model;
    const Written file = edit_mjcf(model);
    REQUIRE(file.effects.size() == 1);
    if (!file.effects.front().carried) {
      // A payload alone cannot weigh while the robot's own links do not.
      CHECK(at.effect->id == "tip_payload");
      continue;
    }
    // In noise of size one. On the way the robot's own damping drags, with and without the effect, and that
    // of what is added by a twentieth of it.
    const test::Pace pace = test::pace_of(at.effect->id);
    const Prediction wanted = predict(bare, {{at}}, amount);
    const double gap = apart(bare, bare.nominal(), wanted),
                 left = apart(bare, in_mujoco(file.text, experiment, pace), wanted);
    CAPTURE(gap);
    const double drag =
        pace == test::Pace::on_the_way
            ? 0.06 * gap + apart(bare, in_mujoco(file_without_floor(), experiment, pace), bare.nominal())
            : 0;
    CHECK(left < 0.5 + drag);
  }
}

TEST_CASE("what the cause does not ask for stays as it is") {
  const Lab lab;
  const Compiled old = compiled(lab, robot);
  const auto edited = [&](std::vector<diagnose::NominalEffect> effects) {
    Model model{"robot", lab.experiment, lab.experiment.rest, {}, lab.folder / "robot.xml"};
    model.experiment.effects = std::move(effects);
    return edit_mjcf(model).text;
  };
  const std::string friction = edited({{"joint_friction", 0, {{"tau_c", 0.03}}}});
  CHECK(friction.find("<!-- drawn by hand -->") != std::string::npos);
  CHECK(friction.find("frictionloss=\"0.03\"") != std::string::npos);
  const std::string several = edited({{"backlash", 2, {{"b", 0.05}}},
                                      {"base_compliance", 0, {{"c_x", 1e-3}, {"c_y", 1e-3}}},
                                      {"link_length", 2, {{"a", 0.1}}},
                                      {"force_gain", 0, {{"g", 0.2}}}});
  for (const std::string& text : {friction, several}) {
    const Compiled now = compiled(lab, text);
    for (int g = 0; g < old->ngeom; ++g) {
      const int same = mj_name2id(now.get(), mjOBJ_GEOM, mj_id2name(old.get(), mjOBJ_GEOM, g));
      REQUIRE(same >= 0);
      CHECK(std::equal(old->geom_size + 3 * g, old->geom_size + 3 * g + 3, now->geom_size + 3 * same));
      CHECK(std::equal(old->geom_pos + 3 * g, old->geom_pos + 3 * g + 3, now->geom_pos + 3 * same));
      CHECK(std::equal(old->geom_rgba + 4 * g, old->geom_rgba + 4 * g + 4, now->geom_rgba + 4 * same));
    }
    for (int b = 1; b < old->nbody; ++b) {
      const int same = mj_name2id(now.get(), mjOBJ_BODY, mj_id2name(old.get(), mjOBJ_BODY, b));
      REQUIRE(same >= 0);
      CHECK(old->body_mass[b] == now->body_mass[same]);
      CHECK(std::equal(old->body_quat + 4 * b, old->body_quat + 4 * b + 4, now->body_quat + 4 * same));
    }
    for (int j = 0; j < old->njnt; ++j) {
      const int same = mj_name2id(now.get(), mjOBJ_JOINT, mj_id2name(old.get(), mjOBJ_JOINT, j));
      REQUIRE(same >= 0);
      CHECK(old->jnt_stiffness[j] == now->jnt_stiffness[same]);
      CHECK(old->qpos_spring[j] == now->qpos_spring[now->jnt_qposadr[same]]);
      CHECK(old->dof_damping[j] == now->dof_damping[now->jnt_dofadr[same]]);
      CHECK(old->jnt_range[2 * j] == now->jnt_range[2 * same]);
      CHECK(old->key_qpos[j] == now->key_qpos[now->jnt_qposadr[same]]);
    }
    CHECK(now->key_ctrl[0] == 0.5);
    CHECK(mj_name2id(now.get(), mjOBJ_LIGHT, "lamp") == 0);
  }
  const Compiled now = compiled(lab, several);
  CHECK(now->body_pos[3 * mj_name2id(now.get(), mjOBJ_BODY, "foot")] == doctest::Approx(0.275));
}

TEST_CASE("a file that cannot be edited gives a chain of its own, which says why") {
  const Lab lab;
  std::string text = robot;
  text.insert(text.find("<option"), "<compiler inertiafromgeom=\"true\"/>");
  lab.folder.write("robot.xml", text);
  const Model model{"robot", lab.experiment, lab.experiment.rest, {}, lab.folder / "robot.xml"};
  CHECK_THROWS_WITH_AS(edit_mjcf(model), doctest::Contains("inertiafromgeom"), Error);
  const Written file = written(model, Format::mjcf);
  CHECK(file.note.find("a chain of its own") == 0);
  CHECK(file.text.find("name=\"q1\"") != std::string::npos);
}

}  // namespace plumbline::exchange
