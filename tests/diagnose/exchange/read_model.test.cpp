#include "diagnose/exchange/read_model.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "diagnose/exchange/corrected.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::NominalChain;

/// A chain of its own for every ending, with weights and rest angles.
Model three_links() {
  Model model{"three links", diagnose::test::full_bench(), {0.3, -0.5, 0.4}};
  model.experiment.link_mass = {0.2, 0.1, 0.3};
  model.experiment.gravity = {0.6, -9.7};
  return model;
}

NominalChain read(const std::string& name, const std::string& text) {
  const Folder folder;
  folder.write(name, text);
  return read_model(folder / name).chain;
}

void check_close(const std::vector<double>& a, const std::vector<double>& b, double accuracy = 1e-6) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == close_to(b[i]).epsilon(accuracy));
}

/// A model in the plane of x and z, as robots stand.
std::string upright(const std::string& second_joint, const std::string& rest = "") {
  return R"(<mujoco><compiler angle="radian"/><option gravity="0 0 -9.81"/><worldbody><body pos="1 2 3">
<joint name="hip" axis="0 1 0" stiffness="3" springref="0.25"/><inertial pos="0.2 0 0" mass="2" diaginertia="1 1 1"/>
<body name="shin" pos="0.4 0.1 0">)" +
         second_joint + R"(<inertial pos="0 0 -0.15" mass="1" diaginertia="1 1 1"/>
<site name="foot" pos="0 0 -0.3"/></body>)" +
         rest + "</body></worldbody></mujoco>";
}

const char* const knee = R"(<joint name="knee" axis="0 -1 0" stiffness="2" springref="0.5"/>)";

std::string refusal(const std::string& name, const std::string& text) {
  try {
    static_cast<void>(read(name, text));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

}  // namespace

TEST_CASE("a chain written in any format is read again") {
  const Model model = three_links();
  for (const auto& [name, format] : {std::pair("a.xml", Format::mjcf), std::pair("a.sdf", Format::sdf),
                                     std::pair("a.urdf", Format::urdf)}) {
    CAPTURE(name);
    const NominalChain chain = read(name, written(model, format).text);
    check_close(chain.link_length, model.experiment.link_length);
    check_close(chain.joint_stiffness, model.experiment.joint_stiffness);
    check_close(chain.rest, model.rest);
    // What holds a massless end has a hundredth of a gram.
    check_close(chain.link_mass, model.experiment.link_mass, 1e-4);
    if (format != Format::urdf) check_close({chain.gravity[0], chain.gravity[1]}, {0.6, -9.7});
  }
}

TEST_CASE("a robot upright is read in its plane, upward as y, each angle from the link before") {
  // The thigh goes along x, the shin down: the joints turn by -atan and so on; the hip's axis is -y of a
  // frame whose x and y are the world's x and z, so its angles change sign.
  const NominalChain chain = read("robot.xml", upright(knee));
  check_close(chain.link_length, {0.4, 0.3});
  check_close(chain.joint_stiffness, {3, 2});
  check_close(chain.link_mass, {2, 1});
  CHECK(chain.rest[0] == close_to(-0.25));
  CHECK(chain.rest[1] == close_to(-std::acos(0.0) + 0.5));
  CHECK(chain.gravity[0] == doctest::Approx(0));
  CHECK(chain.gravity[1] == close_to(-9.81));
}

TEST_CASE("what is no planar serial chain of hinges is refused in one line that says which joint") {
  CHECK(says(refusal("r.xml", upright(R"(<joint name="rail" type="slide" axis="1 0 0"/>)")),
             {"rail", "no hinge"}));
  CHECK(
      says(refusal("r.xml", upright(R"(<joint name="knee" axis="1 0 0"/>)")), {"knee", "axis", "parallel"}));
  CHECK(says(
      refusal(
          "r.xml",
          upright(
              knee,
              R"(<body pos="0 0 1"><joint name="arm" axis="0 1 0"/><inertial pos="1 0 0" mass="1" diaginertia="1 1 1"/></body>)")),
      {"knee", "arm", "serial"}));
  CHECK(says(refusal("r.xml", upright(std::string(knee) + R"(<joint name="again" axis="0 1 0"/>)")),
             {"knee", "same place"}));
  CHECK(says(refusal("r.xml", "<mujoco><worldbody/></mujoco>"), {"no joint"}));
  CHECK(says(refusal("r.xml", "<mujoco>"), {"r.xml:1", "XML"}));
  CHECK(says(refusal("r.sdf", "<sdf>"), {"r.sdf:1", "XML"}));
  CHECK(says(refusal("r.step", "x"), {".step", ".xml"}));
  CHECK(says(refusal("r.toml", "[nominal]\nlink_length = [1]\n"), {"joint_stiffness", "no such key"}));
}

}  // namespace plumbline::exchange
