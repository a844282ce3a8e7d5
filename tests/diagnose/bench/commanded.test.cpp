/// \file
/// Experiments whose tables hold a command to every joint beside what was reached.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/rig/characteristic_scales.hpp"
#include "diagnose/screening/conventions.hpp"
#include "tests/folder.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

constexpr double one_degree = std::numbers::pi / 180;

const std::string one_joint = R"(format = "chain-experiment/1"
name = "one servo"
[nominal]
link_length = [0.4]
joint_stiffness = [20]
[columns]
q_command = { column = "sent", unit = "deg" }
q = { column = "reached", unit = "deg" }
[noise]
q = 0.1
[[run]]
id = "sweep"
control = "command"
samples = "sweep.csv"
)";
const std::string swept_table = "sent,reached\n10,9\n20,18.5\n30,28\n20,19\n";

const std::string two_joints = R"(format = "chain-experiment/1"
name = "two servos"
[nominal]
link_length = [0.4, 0.3]
joint_stiffness = [20, 10]
[noise]
q = 0.002
[[run]]
id = "poses"
control = "command"
samples = "sweep.csv"
)";

std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

Experiment read_from(const std::string& toml, const std::string& table) {
  const Folder folder;
  folder.write("experiment.toml", toml);
  folder.write("sweep.csv", table);
  return read_experiment(folder.path());
}

std::string fault_in(const std::string& toml, const std::string& table) {
  try {
    read_from(toml, table);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool tells(const std::string& message, const std::string& words) {
  INFO(message);
  return message.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a table of commands and reached angles is a run without a force") {
  const Experiment experiment = read_from(one_joint, swept_table);
  const Run& run = experiment.runs.at(0);
  CHECK(run.control == Control::force);
  CHECK(run.commands_joints());
  CHECK(run.by_weights);  // exactly no force: no load cell is in question
  CHECK_FALSE(run.begins_moving);
  REQUIRE(run.readings.size() == 4);
  CHECK(run.rest[0] == doctest::Approx(10 * one_degree));
  CHECK(run.readings[2].rest[0] == doctest::Approx(30 * one_degree));
  CHECK(run.readings[2][column_q + 0] == doctest::Approx(28 * one_degree));
  CHECK(run.readings[2][column_Fx] == 0);
  CHECK(run.turning_points() == std::vector{false, false, true, false});
  CHECK(run.turns_back());
  CHECK_FALSE(characteristic_scales(experiment).load_cell);
  CHECK_FALSE(characteristic_scales(experiment).imposes_force);
}

TEST_CASE(
    "commands of several joints: own names in any order, signs, zeros, angles against x, a force beside "
    "them") {
  const Experiment plain =
      read_from(two_joints, "q1,q_command2,q2,q_command1,Fy\n0.1,0.5,0.4,0.2,-3\n0.1,0.6,0.5,0.3,-3\n");
  const Run& run = plain.runs.at(0);
  CHECK(run.readings[1].rest == std::vector{0.3, 0.6});
  CHECK(run.readings[1].angles(2) == std::vector{0.1, 0.5});
  CHECK(run.readings[1][column_Fx] == 0);
  CHECK(run.readings[1][column_Fy] == -3);
  CHECK_FALSE(run.by_weights);
  const std::string keys =
      "[columns]\nq_command = { column = [\"a\", \"b\"], sign = [1, -1], zero = [0, 0.1], absolute = true "
      "}\n[noise]";
  const Experiment turned =
      read_from(edited(two_joints, "[noise]", keys), "a,b,q1,q2\n0.2,-0.4,0.2,0.3\n0.2,-0.3,0.2,0.3\n");
  CHECK(turned.runs[0].readings[0].rest[0] == doctest::Approx(0.2));
  CHECK(turned.runs[0].readings[0].rest[1] == doctest::Approx(0.5 - 0.2));
}

TEST_CASE("what is wrong with commands is said in one line") {
  CHECK(tells(fault_in(two_joints, "q_command1,q1,q2\n0.2,0.2,0.1\n"),
              "no column 'q_command2', which the run imposes"));
  CHECK(
      tells(fault_in(one_joint, "sent,reached\n10,9\n,8\n30,27\n"), "sweep.csv:3: found an empty q_command"));
  CHECK(
      tells(fault_in(edited(one_joint, "samples", "rest = [0]\nsamples"), swept_table), "q_command says it"));
  CHECK(tells(fault_in(edited(one_joint, "samples", "begins = \"late\"\nsamples"), swept_table),
              "\"relaxed\" or \"moving\""));
  const std::string pressed =
      edited(edited(one_joint, "\"command\"", "\"displacement\"\nbegins = \"moving\"\nrest = [0]"),
             "[columns]\n", "[columns]\nx = \"reached\"\ny = \"reached\"\n");
  CHECK(tells(fault_in(pressed, "a,reached\n0,0\n"), "where the end point is put"));
  const std::string forced = edited(one_joint, "\"command\"", "\"force\"\nrest = [0]");
  CHECK(tells(
      fault_in(edited(forced, "[columns]\n", "[columns]\nFx = { constant = 0 }\nFy = { constant = 0 }\n"),
               swept_table),
      "a column 'sent' of commanded joint angles, expected control = \"command\""));
}

TEST_CASE("reached angles in another unit than their commands are asked about") {
  const std::string mixed = edited(one_joint, "\"reached\", unit = \"deg\" }", "\"reached\" }");
  const auto doubt = suspected_convention(Study(read_from(mixed, swept_table)));
  REQUIRE(doubt);
  CHECK(doubt->what == "q");
  CHECK(doubt->looks_like == "degrees");
  CHECK_FALSE(suspected_convention(Study(read_from(one_joint, swept_table))));
}
