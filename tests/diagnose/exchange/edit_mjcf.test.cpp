#include "diagnose/exchange/edit_mjcf.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "diagnose/exchange/ways.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/exchange/lab.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

using test::Lab, test::robot, test::in_mujoco, test::apart;

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

TEST_CASE("a robot's own file is edited: every effect that MJCF carries does in MuJoCo what was found" *
          doctest::test_suite("long")) {
  // What lags is taken to go straight from reading to reading: these are close for it.
  const Lab lab, fine(40);
  CHECK(lab.experiment.rest[1] == close_to(-0.5));
  for (const EffectAt& at : test::carried(Study(lab.experiment), Format::mjcf, 1)) {
    CAPTURE(at.label());
    const Experiment experiment = test::bench_in(at.effect->id == "sensor_lag" ? fine : lab, at);
    const Study bare(experiment);
    const std::vector<double> amount = test::amount_of(bare, at);
    Model model =
        corrected_models(bare, test::found(bare, at, amount), lab.folder / "robot.xml").front().model;
    const Written file = edit_mjcf(model);
    REQUIRE(file.effects.size() == 1);
    if (!file.effects.front().carried) {
      // A payload or one mass alone cannot weigh while the robot's own links do not.
      CHECK(adds_weight(at.effect->id));
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
        pace == test::Pace::interpolated
            ? 0.06 * gap + apart(bare, in_mujoco(test::robot_alone(), experiment, pace), bare.nominal())
            : 0;
    CHECK(left < 0.5 + drag);
  }
}

TEST_CASE("what the cause does not ask for stays as it is") {
  const Lab lab;
  const Compiled old = compiled(lab, robot);
  const auto edited = [&](std::vector<diagnose::NominalEffect> effects) {
    Model model{"robot", lab.experiment, lab.experiment.rest, lab.folder / "robot.xml"};
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
  CHECK(now->body_pos[3 * mj_name2id(now.get(), mjOBJ_BODY, "foot")] == close_to(0.275));
}

TEST_CASE(
    "a file with dry friction and a centre of mass of its own keeps them where something else is corrected") {
  const Folder folder;
  folder.write("arm.xml", R"(<mujoco><compiler angle="radian"/><worldbody>
<body name="l1"><joint name="j1" axis="0 -1 0" frictionloss="0.05"/>
<inertial pos="0.18 0 0" mass="1.2" diaginertia="1e-3 1e-3 1e-3"/>
<body name="l2" pos="0.3 0 0"><joint name="j2" axis="0 -1 0"/>
<inertial pos="0.125 0 0" mass="0.8" diaginertia="1e-3 1e-3 1e-3"/>
<site name="tool" pos="0.25 0 0"/></body></body></worldbody><actuator><position joint="j1" kp="60"/>
<position joint="j2" kp="25"/></actuator></mujoco>)");
  Model model{"arm", {}, {0, 0}, folder / "arm.xml"};
  static_cast<diagnose::NominalChain&>(model.experiment) = read_model(model.source).chain;
  const std::vector<diagnose::NominalEffect> own = model.experiment.effects;
  REQUIRE(own.size() == 2);
  model.experiment.effects.push_back({"joint_stiffness", 2, {{"a", 0.2}}});
  const Written file = written(model, Format::mjcf);
  CHECK(file.note.find("a chain of its own") == std::string::npos);
  folder.write("edited.xml", file.text);
  const diagnose::NominalChain again = read_model(folder / "edited.xml").chain;
  CHECK(again.effects == own);
  CHECK(again.joint_stiffness[1] == close_to(30));
}

TEST_CASE("a file that cannot be edited gives a chain of its own, which says why") {
  const Lab lab;
  std::string text = robot;
  text.insert(text.find("<option"), "<compiler inertiafromgeom=\"true\"/>");
  lab.folder.write("robot.xml", text);
  const Model model{"robot", lab.experiment, lab.experiment.rest, lab.folder / "robot.xml"};
  CHECK_THROWS_WITH_AS(edit_mjcf(model), doctest::Contains("inertiafromgeom"), Error);
  const Written file = written(model, Format::mjcf);
  CHECK(file.note.find("a chain of its own") == 0);
  CHECK(file.text.find("name=\"q1\"") != std::string::npos);
}

}  // namespace plumbline::exchange
