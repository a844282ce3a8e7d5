#include "diagnose/bench/read_arm.hpp"

#include <doctest/doctest.h>

#include <map>
#include <numbers>
#include <plumbline/base/error.hpp>
#include <span>

#include "diagnose/bench/read_experiment.hpp"
#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

constexpr std::ptrdiff_t first_of_point = Channel(Channel::Name::place, 0, 2).column;

const std::string arm_settings = R"(format = "chain-experiment/1"
name = "two axes"
[arm]
tip_xyz = [0.3, 0, 0]
[[arm.joint]]
name = "shoulder"
xyz = [0, 0, 0.4]
mass = 2
centre = [0.1, 0, 0]
stiffness = 5000
[[arm.joint]]
name = "elbow"
xyz = [0.25, 0, 0]
axis = [0, 2, 0]
[noise]
place = 0.01
[units]
place = "mm"
angle = "deg"
[[run]]
id = "one"
samples = "one.csv"
)";
const std::string arm_table =
    "t,q_command1,q_command2,tip_x,tip_y,tip_z,weight\n0,0,0,550,0,400,0\n1,90,0,0,550,400,1.5\n";

/// An experiment with a text of its arm_settings, and of its arm_table, replaced.
Experiment read(const std::string& old_settings = "", const std::string& new_settings = "",
                const std::string& old_table = "", const std::string& new_table = "") {
  std::map<std::string, std::string> files{{"experiment.toml", arm_settings}, {"one.csv", arm_table}};
  const auto replace = [&](const std::string& file, const std::string& from, const std::string& to) {
    if (from.empty()) return;
    const std::size_t at = files[file].find(from);
    REQUIRE(at != std::string::npos);
    files[file].replace(at, from.size(), to);
  };
  replace("experiment.toml", old_settings, new_settings);
  replace("one.csv", old_table, new_table);
  return read_experiment("arm", [&](const std::string& name, const std::string&) { return files.at(name); });
}

}  // namespace

TEST_CASE("an arm is read joint by joint, its poses in their units") {
  const Experiment experiment = read();
  REQUIRE(experiment.arm);
  const SerialArm<double>& arm = experiment.arm->arm;
  REQUIRE(arm.size() == 2);
  CHECK(experiment.arm->joint[1] == "elbow");
  CHECK(arm.links[0].joint_compliance == close_to(1.0 / 5000));
  CHECK(arm.links[1].joint_compliance == 0);
  CHECK(arm.links[1].axis == Vector3<double>(0, 1, 0));
  CHECK(experiment.link_length == std::vector<double>{0.25, 0.3});
  CHECK(experiment.noise[Channel::Name::place] == close_to(1e-5));
  const Reading& second = experiment.runs[0].readings[1];
  CHECK(second.rest[0] == close_to(std::numbers::pi / 2));
  CHECK(second[first_of_point + 1] == close_to(0.55));
  CHECK(std::isnan(second[first_of_point + 3]));
  CHECK(second.wrench[2] == close_to(-1.5 * 9.81));
  const std::vector<Channel> measured = experiment.runs[0].measured();
  CHECK(std::find(measured.begin(), measured.end(), Channel(Channel::Name::place, 2, 2)) != measured.end());
}

TEST_CASE("a pose is read as a rotation from the nominal orientation") {
  // the arm turned by a quarter about z, and by 0.1 rad more
  const double half = (std::numbers::pi / 2 + 0.1) / 2;
  const std::string quaternion = std::to_string(std::cos(half)) + ",0,0," + std::to_string(std::sin(half));
  const Experiment experiment = read("place = 0.01", "place = 0.01\nturn = 0.1", arm_table,
                                     "q_command1,q_command2,tip_qw,tip_qx,tip_qy,tip_qz\n90,0," + quaternion +
                                         "\n0,0,1,0,0,0\n0,0,1,0,0,0\n");
  // six digits after the point
  CHECK(experiment.runs[0].readings[0][first_of_point + 5] == doctest::Approx(0.1).epsilon(1e-4));
  CHECK(std::abs(experiment.runs[0].readings[1][first_of_point + 5]) < 1e-15);
}

TEST_CASE("slips in an arm's experiment are told in one line") {
  const auto complaint = [](const std::string& a, const std::string& b, const std::string& c = "",
                            const std::string& d = "") {
    try {
      static_cast<void>(read(a, b, c, d));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint("name = \"elbow\"", "name = \"shoulder\"").find("\"shoulder\" again") != std::string::npos);
  CHECK(complaint("axis = [0, 2, 0]", "axis = [0, 0, 0]").find("a direction, which is not zero") !=
        std::string::npos);
  CHECK(complaint("mass = 2", "mass = -2").find("mass") != std::string::npos);
  CHECK(complaint("angle = \"deg\"", "angle = \"rad\"").find("units.angle = \"deg\"") != std::string::npos);
  CHECK(complaint("tip_xyz", "tip_rpy = [0, 90, 0]\ntip_xyz").find("in radians") != std::string::npos);
  CHECK(complaint("[arm]\n", "[arm]\nmodel = \"a.urdf\"\n").find("arm.model and arm.joint") !=
        std::string::npos);
  CHECK(complaint("[noise]", "[[arm.point]]\nname = \"ball\"\nbody = \"hand\"\n[noise]")
            .find("found \"hand\"") != std::string::npos);
  CHECK(complaint("[noise]", "[[arm.point]]\nname = \"a\"\n[[arm.point]]\nname = \"a\"\n[noise]")
            .find("\"a\" again") != std::string::npos);
  CHECK(complaint("", "", "weight", "mass").find("a column 'mass'") != std::string::npos);
  CHECK(complaint("", "", "q_command2", "elbow").find("a column 'elbow'") != std::string::npos);
  CHECK(complaint("", "", "1,90,0,0", "1,,0,0").find("an empty q_command, expected the commanded angle") !=
        std::string::npos);
  CHECK(complaint("", "", "tip_x,tip_y,tip_z,weight\n0,0,0,550,0,400,0\n",
                  "tip_qw,tip_qx,tip_qy,tip_qz\n0,0,0,1,1,0,0\n")
            .find("a quaternion of length") != std::string::npos);
  CHECK(complaint("place = 0.01", "place = 0").find("noise.place") != std::string::npos);
}

TEST_CASE("sensors beside the tracker are read in their units, each with columns of its own") {
  const Experiment experiment =
      read("[noise]\n",
           "[[arm.sensor]]\nname = \"bar\"\nkind = \"distance\"\nxyz = [1, 2, 3]\n"
           "[[arm.sensor]]\nname = \"cam\"\nkind = \"camera\"\nfocal_length = 900\n"
           "[[arm.sensor]]\nname = \"level\"\nkind = \"inclinometer\"\n"
           "[[arm.sensor]]\nname = \"floor\"\nkind = \"plane\"\n"
           "[noise]\ndistance = 0.02\npixel = 0.1\ninclination = 0.01\nheight = 0.03\n",
           "tip_x,tip_y,tip_z,weight\n0,0,0,550,0,400,0\n1,90,0,0,550,400,1.5\n",
           "bar,cam_u,cam_v,level_x,level_y,floor,weight\n0,0,0,1500,12.5,-7,3,-45,250,0\n"
           "1,90,0,,12,-8,3,-45,250,1.5\n");
  const Run& run = experiment.runs[0];
  REQUIRE(run.of_sensors.size() == 6);
  const std::vector<double> wanted{1.5, 12.5, -7, 3 * std::numbers::pi / 180, -std::numbers::pi / 4, 0.25};
  const std::vector<std::string> labels{"d1", "u2", "v2", "tilt_x3", "tilt_y3", "h4"};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK(run.of_sensors[i].of(run.readings[0]) == close_to(wanted[i]));
    CHECK(run.of_sensors[i].label() == labels[i]);
  }
  CHECK(std::isnan(run.of_sensors[0].of(run.readings[1])));
  const std::vector<Channel> measured = run.measured();
  CHECK(std::ranges::equal(std::span(measured).last(6), run.of_sensors));
  CHECK(experiment.noise[Channel::Name::distance] == close_to(2e-5));
  CHECK(experiment.noise[Channel::Name::pixel] == 0.1);
  const std::vector<ArmSensor>& sensors = experiment.arm_bench.sensors;
  CHECK(sensors[0].at.translation() == Vector3<double>(1, 2, 3));
  CHECK(sensors[1].focal_length == 900);
  CHECK(sensors[2].at.linear().col(2) == Vector3<double>(0, 0, 1));  // against gravity
}

TEST_CASE("slips in an arm's sensors are told in one line") {
  const auto complaint = [](const std::string& sensor) {
    try {
      static_cast<void>(read("[noise]", "[[arm.sensor]]\n" + sensor + "\n[noise]"));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto tells = [&](const std::string& sensor, const std::string& what) {
    return complaint(sensor).find(what) != std::string::npos;
  };
  CHECK(tells("name = \"a\"\nkind = \"sonar\"", "\"distance\""));
  CHECK(tells("name = \"a\"\nkind = \"plane\"\npoint = \"toe\"", "the name of an [[arm.point]]"));
  CHECK(tells("name = \"tip\"\nkind = \"plane\"", "a name that no other sensor or point has"));
  CHECK(tells("name = \"weight\"\nkind = \"plane\"", "two columns \"weight\""));
  CHECK(tells("name = \"a\"\nkind = \"camera\"", "arm.frames = \"unknown\""));
  CHECK(tells("name = \"a\"\nkind = \"plane\"\nfocal_length = 3", "of a camera alone"));
  CHECK(tells("name = \"a\"\nkind = \"camera\"\nfocal_length = -3", "a positive number, px"));
}

TEST_CASE("a temperature is the covariate of an arm, at every reading") {
  const std::string rows = "weight\n0,0,0,550,0,400,0\n1,90,0,0,550,400,1.5\n";
  const Experiment experiment =
      read("", "", rows, "weight,temperature\n0,0,0,550,0,400,0,21.5\n1,90,0,0,550,400,1.5,23\n");
  CHECK(experiment.covariates == std::vector<std::string>{"temperature"});
  CHECK(experiment.runs[0].readings[1].covariates == std::vector{23.0});
  // a missing one is interpolated in time, as those of a chain
  const Experiment gap = read("", "", "weight\n0,0,0,550,0,400,0\n1,90,0,0,550,400,1.5\n",
                              "weight,temperature\n0,0,0,550,0,400,0,21\n1,90,0,0,550,400,1.5,\n"
                              "2,90,0,0,550,400,1.5,23\n");
  CHECK(gap.runs[0].readings[1].covariates == std::vector{22.0});
  CHECK(gap.runs[0].interpolated == std::vector<std::size_t>{1});
}

TEST_CASE("quaternions whose first number is x are asked about") {
  const std::string header = "q_command1,q_command2,tip_qw,tip_qx,tip_qy,tip_qz\n";
  CHECK_THROWS_WITH_AS(static_cast<void>(read("place = 0.01", "turn = 0.1", arm_table,
                                              header + "0,0,0,0,0,1\n90,0,0,0,0.7071,0.7071\n0,0,0,0,0,1\n")),
                       doctest::Contains("their first number is x"), Error);
}

TEST_CASE("columns of an arm have names, units, signs and zeros of their own, and parts") {
  const Experiment named = read("[[run]]",
                                "[columns]\nq_command = { column = [\"a\", \"b\"], unit = \"rad\", "
                                "sign = [1, -1] }\ntip = [\"X\", \"Y\", \"Z\"]\nweight = { column = \"m\", "
                                "unit = \"g\", zero = 100 }\n[[run]]",
                                arm_table, "t,a,b,X,Y,Z,m\n0,0,0,550,0,400,100\n1,1.5,0.5,0,550,400,1600\n");
  const Reading& second = named.runs[0].readings[1];
  CHECK(second.rest == std::vector<double>{1.5, -0.5});
  CHECK(second[first_of_point + 1] == close_to(0.55));
  CHECK(second.wrench[2] == close_to(-1.5 * 9.81));
  CHECK(named.runs[0].origins[1].source == "a");
}

TEST_CASE("a rigid arm without masses is taken to weigh something, unless loads or drives tell its weight") {
  const std::string rigid = "[[arm.joint]]\nname = \"shoulder\"\nxyz = [0, 0, 0.4]\n",
                    own = rigid + "mass = 2\ncentre = [0.1, 0, 0]\nstiffness = 5000\n";
  const auto density = [&](const std::string& joint, const std::string& header) {
    std::map<std::string, std::string> files{{"experiment.toml", arm_settings}, {"one.csv", arm_table}};
    std::string& settings = files["experiment.toml"];
    settings.replace(settings.find(own), own.size(), joint);
    std::string& table = files["one.csv"];
    table.replace(table.find("weight"), 6, header);
    const Experiment experiment =
        read_experiment("arm", [&](const std::string& name, const std::string&) { return files.at(name); });
    CHECK((experiment.arm_bench.assumed_density > 0) == (experiment.link_mass[1] > 0));
    return experiment.arm_bench.assumed_density;
  };
  CHECK(density(rigid, "temperature") > 0);
  CHECK(density(own, "temperature") == 0);
  CHECK(density(rigid + "mass = 2\n", "temperature") == 0);
  CHECK(density(rigid + "stiffness = 5000\n", "temperature") == 0);
  CHECK(density(rigid, "weight") == 0);
}
