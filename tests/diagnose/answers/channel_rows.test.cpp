/// Errors of what is imposed and of what reads it, each planted in a bench of its own.
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/written_bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// An arm whose axes are not parallel, and what it is told.
const char* const arm = R"(format = "chain-experiment/1"
name = "arm"
[arm]
gravity = [0, 0, -9.81]
tip_xyz = [0.2, 0.03, 0.05]
[[arm.joint]]
name = "turntable"
axis = [0, 0, 1]
stiffness = 4000
mass = 2
centre = [0, 0, 0.1]
[[arm.joint]]
name = "shoulder"
xyz = [0, 0, 0.3]
axis = [0, 1, 0]
stiffness = 4000
mass = 1.5
centre = [0.15, 0, 0]
[[arm.joint]]
name = "elbow"
xyz = [0.3, 0, 0]
axis = [0, 1, 0]
stiffness = 2000
mass = 1
centre = [0.1, 0, 0]
[[arm.joint]]
name = "wrist"
xyz = [0.25, 0, 0]
axis = [1, 0, 0]
stiffness = 1000
mass = 0.3
[[run]]
id = "sweep"
samples = "t.csv"
)";

std::vector<TableColumn> commands() {
  return {{"q_command1", sine(0, 0.9, 0.43)},
          {"q_command2", sine(-0.4, 0.5, 0.61, 1)},
          {"q_command3", sine(0.7, 0.6, 0.37, 2)},
          {"q_command4", sine(0, 1.1, 0.53, 0.5)}};
}

/// The arm, with these columns read.
WrittenBench arm_that_reads(const std::string& settings, const std::vector<TableColumn>& read) {
  WrittenBench bench{arm + settings, commands()};
  bench.columns.insert(bench.columns.end(), read.begin(), read.end());
  return bench;
}

std::vector<TableColumn> read_at_joints(const std::string& stem) {
  std::vector<TableColumn> all;
  for (int j = 1; j <= 4; ++j) all.push_back({stem + std::to_string(j), {}, stem + std::to_string(j)});
  return all;
}

WrittenBench tracked_arm() {
  WrittenBench bench = arm_that_reads("[noise]\nq = 1e-4\nplace = 5e-5\n", read_at_joints("q"));
  for (const char* axis : {"x", "y", "z"})
    bench.columns.push_back({std::string("tip_") + axis, {}, axis + std::string("1")});
  return bench;
}

WrittenBench arm_with_gauges() {
  WrittenBench bench = arm_that_reads(R"([[arm.sensor]]
name = "wire"
kind = "distance"
xyz = [0.2, 0.4, 1.6]
[[arm.sensor]]
name = "cam"
kind = "camera"
xyz = [0.3, -2.5, 0.4]
rpy = [-1.5707963267948966, 0, 0]
focal_length = 1500
[[arm.sensor]]
name = "level"
kind = "inclinometer"
[[arm.sensor]]
name = "floor"
kind = "plane"
[noise]
q = 1e-4
distance = 5e-5
pixel = 0.1
inclination = 1e-4
height = 5e-5
)",
                                      read_at_joints("q"));
  for (const auto& [name, label] :
       {std::pair("wire", "d1"), std::pair("cam_u", "u2"), std::pair("cam_v", "v2"),
        std::pair("level_x", "tilt_x3"), std::pair("level_y", "tilt_y3"), std::pair("floor", "h4")})
    bench.columns.push_back({name, {}, label});
  return bench;
}

WrittenBench arm_with_torques() {
  WrittenBench bench = tracked_arm();
  bench.settings += "torque = 0.02\n";
  for (const TableColumn& one : read_at_joints("torque")) bench.columns.push_back(one);
  return bench;
}

/// Two links on springs, with inclinometers on them and a camera that sees the end.
WrittenBench chain_with_levels() {
  return {R"(format = "chain-experiment/1"
name = "chain"
[nominal]
link_length = [0.3, 0.25]
joint_stiffness = [60, 25]
link_mass = [1.2, 0.8]
gravity = [0, -9.81]
[bench]
gravity_plane = "vertical"
[columns]
tilt = ["level1", "level2"]
[noise]
tilt = 2e-4
x = 5e-5
y = 5e-5
[[run]]
id = "sweep"
control = "command"
samples = "t.csv"
)",
          {{"q_command1", sine(0, 0.8, 0.35)},
           {"q_command2", sine(0.5, 0.6, 0.61, 1)},
           {"level1", {}, "tilt1"},
           {"level2", {}, "tilt2"},
           {"x", {}, "x"},
           {"y", {}, "y"}}};
}

const char* const springs = R"(format = "chain-experiment/1"
name = "springs"
[nominal]
link_length = [0.3, 0.25, 0.2]
joint_stiffness = [3, 2, 1.5]
[bench]
gravity_plane = "horizontal"
)";

/// A drive holds the end, whose force is read, and encoders read the joints.
WrittenBench held_chain() {
  WrittenBench bench{std::string(springs) + R"([noise]
Fx = 0.005
Fy = 0.005
q = 2e-4
[[run]]
id = "press"
control = "displacement"
rest = [0.3, -0.5, 0.4]
samples = "t.csv"
)",
                     {{"x", sine(0.66, 0.06, 0.5)}, {"y", sine(0.06, 0.05, 0.37, 1)}}};
  for (const char* one : {"Fx", "Fy", "q1", "q2", "q3"}) bench.columns.push_back({one, {}, one});
  return bench;
}

/// A servo imposes both components by its load cell.
WrittenBench pushed_chain() {
  WrittenBench bench{
      std::string(springs) + R"([noise]
x = 5e-5
y = 5e-5
q = 2e-4
[[run]]
id = "push"
control = "force"
rest = [0.3, -0.5, 0.4]
samples = "t.csv"
)",
      {{"x", {}, "x"}, {"y", {}, "y"}, {"Fx", sine(0, 1.5, 0.5)}, {"Fy", sine(0, 1.2, 0.37, 1)}}};
  for (const char* one : {"q1", "q2", "q3"}) bench.columns.push_back({one, {}, one});
  return bench;
}

/// Two tendons bend it to either side.
WrittenBench finger_with_tendons() {
  WrittenBench bench{std::string(springs) + R"([[load]]
tendon = "flexor"
radius = [0.05, 0.04, 0.03]
[[load]]
tendon = "extensor"
radius = [-0.04, -0.04, 0]
[columns]
Fx = { constant = 0 }
Fy = { constant = 0 }
[noise]
q = 2e-4
[[run]]
id = "bend"
control = "force"
rest = [0.1, 0.15, 0.2]
samples = "t.csv"
[columns.covariate]
flexor = "flexor"
extensor = "extensor"
)",
                     {{"flexor", sine(12, 10, 0.45)}, {"extensor", sine(8, 6, 0.31, 2)}}};
  for (const char* one : {"q1", "q2", "q3"}) bench.columns.push_back({one, {}, one});
  return bench;
}

}  // namespace

TEST_CASE("a tracker of an arm in space is late, drifts, has axes that are not square" *
          doctest::test_suite("long")) {
  check_named(tracked_arm(), {{other_form("place_lag")}}, {0.1});
  check_named(tracked_arm(), {{"place_drift"}}, {1e-4, -5e-5, 5e-5});
  check_named(tracked_arm(), {{"camera_skew"}}, {0.004, -0.003, 0.005});
}

TEST_CASE("a draw-wire beside encoders has a wrong zero") {
  check_named(arm_with_gauges(), only("distance_bias"), {0.004});
}

TEST_CASE("sensors of an arm: zero, scale, drift, cross-talk and lag" * doctest::test_suite("long")) {
  check_named(arm_with_gauges(), only("distance_scale"), {0.004});
  check_named(arm_with_gauges(), only("distance_lag"), {0.15});
  check_named(arm_with_gauges(), only("pixel_bias"), {4, -3});
  check_named(arm_with_gauges(), only("pixel_drift"), {0.2, 0.1});
  check_named(arm_with_gauges(), {{other_form("pixel_lag")}}, {0.1});
  check_named(arm_with_gauges(), only("inclination_bias"), {0.004, -0.002});
  check_named(arm_with_gauges(), only("inclination_cross_talk"), {0.01, -0.01});
  check_named(arm_with_gauges(), only("height_scale"), {0.004});
  check_named(arm_with_gauges(), only("height_drift"), {1e-4});
}

TEST_CASE("torques of drives: zero, scale, drift and delay" * doctest::test_suite("long")) {
  check_named(arm_with_torques(), {{{"torque_bias", 2}}}, {0.2});
  check_named(arm_with_torques(), {{{"torque_scale", 3}}}, {0.1});
  check_named(arm_with_torques(), {{{"torque_drift", 2}}}, {0.02});
  check_named(arm_with_torques(), {{other_form("torque_lag")}}, {0.2});
}

TEST_CASE("tilts: zero, scale, drift and delay" * doctest::test_suite("long")) {
  check_named(chain_with_levels(), {{{"tilt_bias", 2}}}, {0.01});
  check_named(chain_with_levels(), {{{"tilt_scale", 1}}}, {0.02});
  check_named(chain_with_levels(), {{{"tilt_drift", 2}}}, {5e-4});
  check_named(chain_with_levels(), {{other_form("tilt_lag")}}, {0.1});
}

TEST_CASE("a drive that holds an end: its scale, its lag, by a time constant or a delay" *
          doctest::test_suite("long")) {
  check_named(held_chain(), only("command_scale"), {0.03});
  check_named(held_chain(), {{other_form("command_delay")}}, {0.15});
  check_named(held_chain(), only("command_delay"), {0.15});
}

TEST_CASE("a servo that imposes both forces by a cell whose components talk into each other") {
  check_named(pushed_chain(), only("cross_talk"), {0.04, -0.03});
}

TEST_CASE("tendons: zeros, scales, drift and delay of their tensions" * doctest::test_suite("long")) {
  check_named(finger_with_tendons(), only("applied_bias"), {0.05, -0.03});
  check_named(finger_with_tendons(), only("applied_scale"), {0.08, 0});
  check_named(finger_with_tendons(), only("applied_drift"), {0.05, 0.02});
  check_named(finger_with_tendons(), {{other_form("applied_lag")}}, {0.15});
}

TEST_CASE("a thermometer that is late on an arm that grows" * doctest::test_suite("long")) {
  WrittenBench bench = tracked_arm();
  bench.columns.push_back({"temperature", sine(25, 10, 0.4)});
  check_named(bench, {{"thermal_expansion", "covariate_lag"}}, {1e-4, 1.5});
}
