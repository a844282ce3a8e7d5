/// \file
/// The tables [[load]]: what they say, and what is refused.

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/rig/characteristic_scales.hpp"
#include "tests/close_to.hpp"
#include "tests/folder.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Two links with one run of three readings.
/// \param tables  further ones
std::string settings_with(const std::string& load, const std::string& tables = "",
                          const std::string& control = "force") {
  return R"(format = "chain-experiment/1"
name = "finger"
nominal = { link_length = [0.04, 0.03], joint_stiffness = [0.2, 0.1], rest = [0.1, 0.2] }
noise = { x = 1e-4, y = 1e-4, q = 0.002, Fx = 0.1, Fy = 0.1 }
)" + tables +
         "\n[[load]]\n" + load + "\n[[run]]\nid = \"bend\"\ncontrol = \"" + control +
         "\"\nsamples = \"bend.csv\"\n";
}

const std::string finger_table = "tension,q1,q2,Gx,Gy\n0,0.1,0.2,0,0\n2,0.2,0.4,1,-3\n,0.15,0.3,0.5,-1\n";

Experiment read_finger(const std::string& toml, const std::string& csv = finger_table) {
  const Folder folder;
  folder.write("experiment.toml", toml);
  folder.write("bend.csv", csv);
  return read_experiment(folder.path());
}

void check_load_refused(const std::string& toml, const std::vector<std::string>& words,
                        const std::string& csv = finger_table) {
  std::string message;
  try {
    read_finger(toml, csv);
  } catch (const Error& error) {
    message = error.what();
  }
  INFO(message);
  CHECK(message.find('\n') == std::string::npos);
  for (const std::string& one : words) {
    INFO(one);
    CHECK(message.find(one) != std::string::npos);
  }
}

const std::string tendon_keys = "tendon = \"tension\"\nradius = [8, 6]";
const std::string radii_in_mm = "units = { radius = \"mm\" }";

}  // namespace

TEST_CASE("a tendon: its column, radii in a unit, no force on the end point without a column") {
  const Experiment experiment = read_finger(settings_with(tendon_keys, radii_in_mm));
  REQUIRE(experiment.loads.size() == 1);
  const Load& load = experiment.loads[0];
  CHECK(load.kind == Load::Kind::tendon);
  CHECK(load.moment_arm == std::vector{0.008, 0.006});
  CHECK(experiment.covariates == std::vector<std::string>{"tension"});
  const Run& run = experiment.runs.at(0);
  CHECK(run.readings[1].covariates == std::vector{2.0});
  CHECK(run.readings[2].covariates == std::vector{2.0});  // missing: the last one is repeated
  CHECK(run.readings[1][column_Fx] == 0);
  CHECK(run.by_weights);
  REQUIRE(run.loads.size() == 1);
  CHECK(run.loads[0].name == "tension");
  CHECK(run.loads[0].unit == "N");
  // 8 mm over 0.3 of 70 mm
  CHECK((run.loads[0].moves - Eigen::Vector2d(0, 8 / 21.0)).norm() < 1e-12);
  CHECK(run.command(run.readings[1]).y() == close_to(16 / 21.0));
}

TEST_CASE("values of loads have units, signs and zeros, and constants in a run") {
  const std::string columns =
      "columns = { covariate = { tension = { column = \"Gy\", unit = \"mN\", sign = -1, zero = -1 } } }";
  CHECK(read_finger(settings_with(tendon_keys, columns)).runs[0].readings[1].covariates[0] == close_to(2e-3));
  const std::string hung = R"(force = ["wx", "wy"]
link = 1
at = 0.5
[columns.covariate]
wx = { constant = 0 }
wy = { column = "Gy", unit = "gf" })";
  const Experiment experiment = read_finger(settings_with(hung));
  CHECK(experiment.loads[0].link == 0);
  CHECK(experiment.loads[0].at == 0.5);
  CHECK(experiment.runs[0].readings[1].covariates[1] == close_to(-3 * 0.00980665));
  CHECK((experiment.runs[0].loads[1].moves - Eigen::Vector2d(0, 2 / 7.0)).norm() < 1e-12);
}

TEST_CASE("a force acts at the end of the last link unless it is said where; a pressure has volumes") {
  const Load force = read_finger(settings_with("force = [\"Gx\", \"Gy\"]")).loads[0];
  CHECK(force.link == 1);
  CHECK(force.at == 1);
  const Load pressure =
      read_finger(settings_with("pressure = \"tension\"\nvolume = [200, 0]", "units = { volume = \"mm^3\" }"))
          .loads[0];
  CHECK(pressure.kind == Load::Kind::pressure);
  CHECK(pressure.moment_arm == std::vector{2e-7, 0.0});
}

TEST_CASE("the command of a held end point moves by what the load would move it") {
  const Experiment experiment =
      read_finger(settings_with(tendon_keys, radii_in_mm, "displacement"),
                  "t,x,y,Fx,Fy,tension\n0,0.06,0.02,0,0,0\n1,0.06,0.02,0.1,0.2,2\n2,0.06,0.02,0.1,0.1,1\n");
  const Run& run = experiment.runs[0];
  // 8 / 21 N, times 0.07 m squared over 0.2 N m/rad
  CHECK(run.loads[0].moves.y() == close_to(8 / 21.0 * 0.0049 / 0.2));
  CHECK(run.turning_points() == std::vector{false, true, false});
  CHECK(characteristic_scales(experiment).turns_back);
}

TEST_CASE("loads that are refused, each in one line") {
  check_load_refused(settings_with("tendon = \"tension\""),
                     {"experiment.toml:", "load[1].radius", "no such key"});
  check_load_refused(settings_with("tendon = \"tension\"\nradius = [8, 6, 4]"),
                     {"load[1].radius", "3 values", "2, one for each joint"});
  check_load_refused(settings_with("tendon = \"tension\"\nradius = [0, 0]"),
                     {"load[1].radius", "0 at every joint"});
  check_load_refused(settings_with("tendon = \"pull\"\nradius = [8, 6]"),
                     {"bend.csv:1", "one column 'pull'", "load[1].tendon"});
  check_load_refused(settings_with("tendon = \"Fx\"\nradius = [8, 6]"), {"load[1].tendon", "\"Fx\""});
  check_load_refused(settings_with(tendon_keys, "units = { radius = \"N\" }"),
                     {"units.radius", "a unit of a length"});
  check_load_refused(settings_with(tendon_keys + "\n[columns.covariate]\ntension = { unit = \"bar\" }"),
                     {"columns.covariate.tension.unit", "\"bar\"", "a unit of a force"});
  check_load_refused(settings_with("radius = [8, 6]"),
                     {"a load without a kind", "tendon, pressure and force"});
  check_load_refused(settings_with(tendon_keys + "\npressure = \"p\""),
                     {"load[1].pressure", "nothing beside tendon"});
  check_load_refused(settings_with(tendon_keys + "\nlink = 1"),
                     {"load[1].link", "nothing beside tendon", "of a force"});
  check_load_refused(settings_with(tendon_keys + "\nlever = 1"), {"load[1].lever", "an unknown key"});
  check_load_refused(settings_with("force = [\"Gx\"]"), {"load[1].force", "two names of columns"});
  check_load_refused(settings_with("force = [\"Gx\", \"Gy\"]\nlink = 3"),
                     {"load[1].link", "3", "a link from 1 to 2"});
  check_load_refused(settings_with("force = [\"Gx\", \"Gy\"]\nat = 1.2"),
                     {"load[1].at", "1.2", "from 0 to 1"});
  check_load_refused(settings_with(tendon_keys + "\n[[load]]\n" + tendon_keys),
                     {"load[2].tendon", "\"tension\" again"});
}

TEST_CASE("a joint alone and an arm in space have no loads along a chain") {
  check_load_refused(R"(format = "chain-experiment/1"
name = "joint"
nominal = { joint = "revolute", joint_stiffness = [2] }
noise = { angle = 0.01 }
[[load]]
tendon = "tension"
radius = [0.01]
[[run]]
id = "turn"
control = "torque"
samples = "bend.csv"
)",
                     {"load", "a joint alone", "along a planar chain"});
  check_load_refused(R"(format = "chain-experiment/1"
name = "arm"
arm = { model = "arm.urdf" }
[[load]]
tendon = "tension"
)",
                     {"load", "loads act along a planar chain", "a wrench"});
}
