#include "diagnose/exchange/urdf.hpp"

#include <doctest/doctest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <memory>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using Compiled = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;

/// The chain of the tests with these effects, as MuJoCo has its URDF, nothing merged.
Compiled in_mujoco(std::vector<diagnose::NominalEffect> effects) {
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}};
  model.experiment.effects = std::move(effects);
  std::string text = to_urdf(model).text;
  text.insert(text.find('>', text.find("<robot")) + 1, "<mujoco><compiler fusestatic=\"false\"/></mujoco>");
  const Folder folder;
  folder.write("chain.urdf", text);
  std::array<char, 500> reason{};
  Compiled compiled(mj_loadXML((folder / "chain.urdf").c_str(), nullptr, reason.data(), 500), mj_deleteModel);
  REQUIRE_MESSAGE(compiled, std::string(reason.data()));
  return compiled;
}

int joint(const mjModel& model, const char* name) {
  const int number = mj_name2id(&model, mjOBJ_JOINT, name);
  REQUIRE(number >= 0);
  return number;
}

}  // namespace

TEST_CASE("a written URDF moves in MuJoCo as the corrected chain does") {
  const Compiled model = in_mujoco({{"link_length", 2, {{"a", 0.1}}},
                                    {"backlash", 2, {{"b", 0.05}}},
                                    {"position_offset", 0, {{"d_x", 0.01}, {"d_y", 0.02}}}});
  const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(model.get()), mj_deleteData);
  const auto turn = [&](const char* name, double angle) {
    data->qpos[model->jnt_qposadr[joint(*model, name)]] = angle;
  };
  turn("q1", 0.3), turn("q2", -0.5), turn("q2_play", 0.04), turn("q3", 0.4);
  mj_kinematics(model.get(), data.get());
  const mjtNum* end = data->xpos + 3 * mj_name2id(model.get(), mjOBJ_BODY, "end");
  double x = -0.01, y = -0.02, direction = 0;
  for (const auto& [length, angle] : {std::pair(0.2, 0.3), std::pair(0.275, -0.46), std::pair(0.15, 0.4)}) {
    direction += angle;
    x += length * std::cos(direction);
    y += length * std::sin(direction);
  }
  CHECK(end[0] == close_to(x));
  CHECK(end[1] == close_to(y));
  const int play = joint(*model, "q2_play");
  CHECK(model->jnt_limited[play]);
  CHECK(model->jnt_range[2 * play] == close_to(-0.05));
  CHECK(model->jnt_range[2 * play + 1] == close_to(0.05));
}

TEST_CASE("dry friction and masses of a written URDF are MuJoCo's") {
  const Compiled model = in_mujoco({{"joint_friction", 0, {{"tau_c", 0.03}}}, {"gravity", 0, {{"rho", 2}}}});
  for (const char* name : {"q1", "q2", "q3"})
    CHECK(model->dof_frictionloss[model->jnt_dofadr[joint(*model, name)]] == close_to(0.03));
  // rho is mass by length
  CHECK(model->body_mass[mj_name2id(model.get(), mjOBJ_BODY, "link2")] == close_to(0.5));
}

}  // namespace plumbline::exchange
