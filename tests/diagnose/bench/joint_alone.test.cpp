/// \file
/// Tables of a joint alone: torque against angle, force against stroke.

#include <doctest/doctest.h>

#include <numbers>
#include <plumbline/base/error.hpp>
#include <string>

#include "diagnose/bench/conversion.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/rig/characteristic_scales.hpp"
#include "tests/folder.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

const std::string turning_joint = R"(format = "chain-experiment/1"
name = "a joint"
[nominal]
joint = "revolute"
joint_stiffness = [20]
[columns]
angle = { column = "deg", unit = "deg" }
torque = { column = "Nmm", unit = "N mm" }
[noise]
angle = 0.1
torque = 5
[[run]]
id = "loop"
control = "angle"
samples = "loop.csv"
)";
const std::string loop_table = "deg,Nmm\n0,1\n1,350\n2,699\n1,352\n";

std::string joint_with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

Experiment joint_from(const std::string& toml, const std::string& table = loop_table) {
  const Folder folder;
  folder.write("experiment.toml", toml);
  folder.write("loop.csv", table);
  return read_experiment(folder.path());
}

std::string joint_fault(const std::string& toml, const std::string& table = loop_table) {
  try {
    joint_from(toml, table);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool is_told(const std::string& message, const std::string& words) {
  INFO(message);
  return message.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("an imposed angle: the torque is measured") {
  const Experiment experiment = joint_from(turning_joint);
  const Run& run = experiment.runs.at(0);
  CHECK(experiment.device == Device::turning_joint);
  CHECK(run.holds_end_point());
  CHECK(run.rest == std::vector{0.0});
  CHECK(run.imposed() == std::vector<Channel>{Channel(Channel::Name::angle)});
  CHECK(run.measured() == std::vector<Channel>{Channel(Channel::Name::torque)});
  CHECK(run.imposed_at(run.readings[2]).x() == doctest::Approx(2 * std::numbers::pi / 180));
  CHECK(run.measured()[0].of(run.readings[2]) == doctest::Approx(0.699));
  CHECK(run.measured()[0].sigma(experiment.noise) == doctest::Approx(0.005));
  CHECK(run.measured()[0].unit() == "N m");
  CHECK(run.turning_points() == std::vector{false, false, true, false});
  const CharacteristicScales scales = characteristic_scales(experiment);
  CHECK(scales.load_cell);
  CHECK(scales.measures_force);
  CHECK(scales.axes == 1);
  CHECK_FALSE((scales.weighs || scales.end_is_loaded));
}

TEST_CASE("an imposed torque: the angle is measured, and weights have no sensor") {
  const std::string loaded = joint_with(turning_joint, "\"angle\"", "\"torque\"");
  const Experiment experiment = joint_from(loaded);
  const Run& run = experiment.runs.at(0);
  CHECK_FALSE(run.holds_end_point());
  CHECK(run.imposed() == std::vector<Channel>{Channel(Channel::Name::torque)});
  CHECK(run.measured() == std::vector<Channel>{Channel(Channel::Name::angle)});
  CHECK(characteristic_scales(experiment).load_cell);
  CHECK_FALSE(characteristic_scales(experiment).measures_force);
  const std::string hung = joint_with(loaded, "control", "loaded_by = \"weights\"\ncontrol");
  CHECK_FALSE(characteristic_scales(joint_from(hung)).load_cell);
}

TEST_CASE("a joint that slides: force against stroke") {
  const std::string slid = R"(format = "chain-experiment/1"
name = "a buffer"
[nominal]
joint = "prismatic"
joint_stiffness = [4]
rest = [1]
[units]
joint_stiffness = "N/mm"
rest = "mm"
[columns]
x = { column = "deg", unit = "mm" }
Fx = "Nmm"
[noise]
Fx = 0.1
[[run]]
id = "loop"
control = "displacement"
samples = "loop.csv"
)";
  const Experiment experiment = joint_from(slid);
  CHECK(experiment.device == Device::sliding_joint);
  CHECK(experiment.joint_stiffness[0] == doctest::Approx(4000));
  CHECK(experiment.runs[0].rest[0] == doctest::Approx(0.001));
  CHECK(experiment.runs[0].imposed() == std::vector<Channel>{Channel(Channel::Name::x)});
  CHECK(experiment.runs[0].measured() == std::vector<Channel>{Channel(Channel::Name::Fx)});
  CHECK(experiment.runs[0].readings[1][column_x] == doctest::Approx(0.001));
}

TEST_CASE("what is wrong with a joint alone is said in one line") {
  const auto nominal = [](const std::string& line) {
    return joint_with(turning_joint, "joint = \"revolute\"", line);
  };
  CHECK(is_told(joint_fault(nominal("")), "neither link_length nor joint"));
  CHECK(is_told(joint_fault(nominal("joint = \"ball\"")), "expected \"revolute\" or \"prismatic\""));
  CHECK(
      is_told(joint_fault(nominal("joint = \"revolute\"\nlink_length = [1]")), "a joint alone has no link"));
  CHECK(is_told(
      joint_fault(joint_with(turning_joint, "[noise]", "[bench]\ngravity_plane = \"vertical\"\n[noise]")),
      "a joint alone has no weight"));
  CHECK(
      is_told(joint_fault(joint_with(turning_joint, "[noise]", "[noise]\nFx = 1")), "an angle and a torque"));
  CHECK(is_told(joint_fault(joint_with(turning_joint, "torque = {", "y = \"Nmm\"\ntorque = {")),
                "an angle and a torque"));
  CHECK(is_told(joint_fault(joint_with(turning_joint, "\"angle\"\n", "\"displacement\"\n")),
                "\"angle\", \"torque\" or \"command\""));
  CHECK(is_told(joint_fault(joint_with(turning_joint, "torque = 5\n", "")), "noise.torque"));
  CHECK(is_told(joint_fault(turning_joint, "deg,Nmm\n0,1\n,2\n1,3\n2,4\n"), "the commanded angle"));
  CHECK(is_told(joint_fault(joint_with(turning_joint, "\"N mm\"", "\"N\"")), "a unit of a torque"));
  const std::string chain = joint_with(nominal("link_length = [0.3]"), "\"angle\"\n", "\"displacement\"\n");
  CHECK(is_told(joint_fault(chain), "angle and torque are of a joint alone"));
}

TEST_CASE("the other units of a joint alone are those of its angle, torque and stiffness") {
  bool degrees = false;
  for (const Conversion& one : conversions(joint_from(turning_joint))) {
    CHECK((one.what == "angle" || one.what == "torque" || one.what == "joint_stiffness"));
    degrees = degrees || (one.what == "angle" && one.looks_like == "rad");
  }
  CHECK(degrees);
}
