/// Errors of the sensors and drives of a servo arm that is written as a user writes it: joint angles are
/// read, and a camera sees the end. A planar chain and an arm in space name the same one.
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/written_bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const char* const chain = R"(format = "chain-experiment/1"
name = "chain"
[nominal]
link_length = [0.3, 0.25]
joint_stiffness = [60, 25]
link_mass = [1.2, 0.8]
gravity = [0, -9.81]
[bench]
gravity_plane = "vertical"
[noise]
q = 2e-4
x = 5e-5
y = 5e-5
[[run]]
id = "sweep"
control = "command"
samples = "t.csv"
)";

const char* const arm = R"(format = "chain-experiment/1"
name = "arm"
[arm]
gravity = [0, -9.81, 0]
tip_xyz = [0.25, 0, 0]
[[arm.joint]]
name = "shoulder"
link = "upper"
kind = "revolute"
axis = [0, 0, 1]
stiffness = 60
mass = 1.2
centre = [0.15, 0, 0]
[[arm.joint]]
name = "elbow"
link = "fore"
kind = "revolute"
xyz = [0.3, 0, 0]
axis = [0, 0, 1]
stiffness = 25
mass = 0.8
centre = [0.125, 0, 0]
[noise]
q = 2e-4
place = 5e-5
[[run]]
id = "sweep"
samples = "t.csv"
)";

const char* const joint_alone = R"(format = "chain-experiment/1"
name = "a joint, loaded by a servo with a cell, beside a second cell"
[nominal]
joint = "{}"
joint_stiffness = [40]
[noise]
{} = 2e-4
{}_2 = 0.01
[[run]]
id = "load"
control = "{}"
samples = "t.csv"
)";

/// Joints that are swept at changing speeds.
WrittenBench servo_arm(bool in_space) {
  WrittenBench bench{in_space ? arm : chain,
                     {{"q_command1", sine(0, 0.8, 0.35)},
                      {"q_command2", sine(0.5, 0.6, 0.61, 1)},
                      {"q1", {}, "q1"},
                      {"q2", {}, "q2"}}};
  const std::string tip = in_space ? "tip_" : "", point = in_space ? "1" : "";
  for (const std::string axis : {"x", "y", "z"})
    if (in_space || axis != "z") bench.columns.push_back({tip + axis, {}, axis + point});
  return bench;
}

/// A joint alone, turning or sliding.
WrittenBench joint_with_two_cells(bool slides) {
  const std::string place = slides ? "x" : "angle", load = slides ? "Fx" : "torque";
  return {fmt::format(fmt::runtime(joint_alone), slides ? "prismatic" : "revolute", place, load,
                      slides ? "force" : "torque"),
          {{place, {}, place},
           {load, [](double t) { return 4 * std::sin(0.5 * t) * (1 + 0.02 * t); }},
           {load + "_2", {}, load + "_2"}}};
}

void check_in_both(const EffectAt& cause, const std::vector<double>& values) {
  for (const bool in_space : {false, true}) {
    CAPTURE(in_space);
    const Estimate amount = check_named(servo_arm(in_space), {{cause}}, values).estimates.at(0).at(0);
    // 95 % bounds, of which one in twenty misses: half as wide again
    CHECK(std::abs(amount.value - values[0]) < 0.75 * (amount.high - amount.low));
  }
}

}  // namespace

TEST_CASE("a camera that is late is late, by a delay and by a time constant" * doctest::test_suite("long")) {
  check_in_both({other_form("place_lag")}, {0.12});
  check_in_both({"place_lag"}, {0.12});
}

TEST_CASE("angles that are read late are late, beside a camera") {
  check_in_both({other_form("angle_lag")}, {0.1});
}

TEST_CASE("a second cell of a joint alone, turning or sliding, has a zero, drifts or is late" *
          doctest::test_suite("long")) {
  for (const bool slides : {false, true}) {
    check_named(joint_with_two_cells(slides), {{"second_zero"}}, {0.1});
    check_named(joint_with_two_cells(slides), {{"second_drift"}}, {0.01});
    check_named(joint_with_two_cells(slides), {{other_form("second_lag")}}, {0.1});
  }
}

TEST_CASE("angles drift, and talk into each other" * doctest::test_suite("long")) {
  check_in_both({"angle_drift", 2}, {4e-4});
  check_in_both({"angle_cross_talk", 1}, {0.03});
}

TEST_CASE("a frame of places drifts, and a camera's axes are not square" * doctest::test_suite("long")) {
  check_in_both({"place_drift"}, {1e-4, -5e-5, 5e-5});  // the last in space alone
  check_in_both({"camera_skew"}, {0.01, 0, 0});
}

TEST_CASE("a drive follows with a time constant, and the zero of a command drifts" *
          doctest::test_suite("long")) {
  check_in_both({other_form("command_delay")}, {0.12});
  check_in_both({"command_drift", 1}, {6e-4});
}
