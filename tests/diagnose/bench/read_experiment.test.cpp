#include "diagnose/bench/read_experiment.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <plumbline/base/error.hpp>
#include <utility>
#include <vector>

#include "tests/folder.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

const std::string good_toml = R"(format = "chain-experiment/1"
name = "two"

[nominal]
link_length = [0.3, 0.2]
joint_stiffness = [2.0, 1.5]

[bench]
gravity_plane = "vertical"
gravity_direction = [0.0, -1.0]

[noise]
x = 0.001
y = 0.001
Fx = 0.02
Fy = 0.02
q = 0.001

[[run]]
id = "press"
control = "displacement"
rest = [0.4, -0.9]
samples = "press.csv"

[[run]]
id = "pull"
control = "force"
rest = [0.4, -0.9]
samples = "pull.csv"
)";
// End point of the rest shape: 0.3 (cos 0.4, sin 0.4) + 0.2 (cos 0.5, -sin 0.5) = (0.4518, 0.0209).
const std::string good_press =
    "t,x,y,Fx,Fy,q1,q2\n0,0.4518,0.0209,0,0,0.4,-0.9\n1,0.4500,0.0209,-0.1,,0.41,\n";
const std::string good_pull = "t,x,y,Fx,Fy\r\n0,,0.0209,0,0\r\n2,0.453,0.02,0.1,+1e-2\r\n";

struct Files {
  std::string toml = good_toml, press = good_press, pull = good_pull;
};

void lay(const Folder& folder, const Files& files) {
  folder.write("experiment.toml", files.toml);
  folder.write("press.csv", files.press);
  folder.write("pull.csv", files.pull);
}

std::string fault(const Files& files) {
  const Folder folder;
  lay(folder, files);
  try {
    read_experiment(folder.path());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string toml_fault(const std::string& from, const std::string& to) {
  return fault({.toml = replaced(good_toml, from, to)});
}

std::string press_fault(const std::string& from, const std::string& to) {
  return fault({.press = replaced(good_press, from, to)});
}

bool says(const std::string& message, const std::vector<std::string>& words) {
  INFO(message);
  bool all = message.find('\n') == std::string::npos;
  for (const std::string& word : words) {
    const bool found = message.find(word) != std::string::npos;
    CHECK_MESSAGE(found, word);
    all = all && found;
  }
  return all;
}

}  // namespace

TEST_CASE("a good experiment is read as it stands") {
  const Folder folder;
  lay(folder, {});
  const Experiment experiment = read_experiment(folder.path());
  CHECK(experiment.name == "two");
  CHECK(experiment.link_length == std::vector{0.3, 0.2});
  CHECK(experiment.link_mass == std::vector{0.0, 0.0});
  CHECK(experiment.gravity == std::array{0.0, 0.0});
  CHECK(experiment.bench.plane == Bench::Plane::vertical);
  CHECK(experiment.bench.gravity_direction == std::array{0.0, -1.0});
  CHECK(experiment.noise[Channel::Name::q] == 0.001);
  REQUIRE(experiment.runs.size() == 2);
  const Run& press = experiment.runs[0];
  CHECK(press.control == Control::end_point);
  REQUIRE(press.readings.size() == 2);
  CHECK(press.readings[1][column_Fx] == -0.1);
  CHECK(std::isnan(press.readings[1][column_Fy]));
  CHECK(press.readings[1][column_q + 0] == 0.41);
  CHECK(std::isnan(press.readings[1][column_q + 1]));
  const Run& pull = experiment.runs[1];
  CHECK(pull.control == Control::force);
  CHECK_FALSE(pull.reads_angles());
  CHECK(std::isnan(pull.readings[0][column_x]));
  CHECK(pull.readings[1][column_Fy] == 0.01);
  const auto q2 = std::find_if(press.origins.begin(), press.origins.end(),
                               [](const Origin& one) { return one.what == "q2"; });
  REQUIRE(q2 != press.origins.end());
  CHECK(q2->source == "q2");
  CHECK(q2->unit == "rad");
}

TEST_CASE("absolute time stamps count from the first reading of all runs") {
  const auto times = [](const std::string& first, const std::string& second, const std::string& third,
                        const std::string& fourth) {
    Files files;
    files.press = replaced(replaced(files.press, "\n0,", "\n" + first + ","), "\n1,", "\n" + second + ",");
    files.pull = replaced(replaced(files.pull, "\n0,", "\n" + third + ","), "\n2,", "\n" + fourth + ",");
    const Folder folder;
    lay(folder, files);
    std::vector<double> all;
    for (const Run& run : read_experiment(folder.path()).runs)
      for (const Reading& reading : run.readings) all.push_back(reading.t);
    return all;
  };
  CHECK(times("1700000000", "1700000001.5", "1700000100", "1700000102") ==
        std::vector<double>{0, 1.5, 100, 102});
  CHECK(times("3", "4", "10", "12") == std::vector<double>{3, 4, 10, 12});  // a drift that began 3 s before
}

TEST_CASE("forces straight down and without noise are those of weights, unless the settings say otherwise") {
  std::string pull_alone = good_toml;  // no force is read, and its noise may be zero
  pull_alone.erase(pull_alone.find("[[run]]"), pull_alone.rfind("[[run]]") - pull_alone.find("[[run]]"));
  const auto exact = [](std::string toml) {
    const std::string noise = "Fx = 0.02\nFy = 0.02";
    return toml.replace(toml.find(noise), noise.size(), "Fx = 0\nFy = 0");
  };
  const auto by_weights = [](const std::string& toml, const std::string& forces) {
    const Folder folder;
    lay(folder, {toml, "", "t,x,y,Fx,Fy\n" + forces});
    return read_experiment(folder.path()).runs.at(0).by_weights;
  };
  const std::string down = "0,,0.0209,0,0\n2,0.453,0.02,0,-0.1\n";
  CHECK(by_weights(exact(pull_alone), down));
  CHECK_FALSE(by_weights(pull_alone, down));                                          // read with noise
  CHECK_FALSE(by_weights(exact(pull_alone), "0,0.45,0,0,0\n2,0.45,0,0,0.1\n"));       // up
  CHECK_FALSE(by_weights(exact(pull_alone), "0,0.45,0,0,0\n2,0.45,0,0.001,-0.1\n"));  // aslant
  CHECK_FALSE(
      by_weights(exact(pull_alone), "0,0.45,0,0,0\n2,0.45,0,0,-0.1\n3,0.45,0,0.1,0\n"));  // one of three
  CHECK_FALSE(by_weights(exact(pull_alone), "0,0.45,0,0,0\n2,0.45,0,0,0\n"));             // nothing hangs
  const auto with = [&](const std::string& before, const std::string& after) {
    std::string toml = exact(pull_alone);
    return toml.replace(toml.find(before), before.size(), after);
  };
  CHECK_FALSE(by_weights(with("\"force\"", "\"force\"\nloaded_by = \"servo\""), down));
  const auto inferred = [](const std::string& toml, const std::string& forces) {
    const Folder folder;
    lay(folder, {toml, "", "t,x,y,Fx,Fy\n" + forces});
    return read_experiment(folder.path()).runs.at(0).weights_inferred;
  };
  CHECK(inferred(exact(pull_alone), down));
  CHECK_FALSE(inferred(pull_alone, down));
  CHECK_FALSE(inferred(with("\"force\"", "\"force\"\nloaded_by = \"weights\""), down));
  CHECK_FALSE(by_weights(with("gravity_plane = \"vertical\"\n", ""), down));
  CHECK(by_weights(with("[0.0, -1.0]", "[0.447, -0.894]"), "0,0.45,0,0,0\n2,0.45,0,0.05,-0.1\n"));
  CHECK(
      by_weights(with("\"force\"", "\"force\"\nloaded_by = \"weights\""), "0,0.45,0,0,0\n2,0.45,0,0,0.1\n"));
}

TEST_CASE("a fault of experiment.toml is named by its key") {
  CHECK(says(toml_fault("chain-experiment/1", "chain-experiment/2"), {"format", "chain-experiment/2"}));
  CHECK(says(toml_fault("format =", "formt ="), {"format", "no such key"}));
  CHECK(says(toml_fault("name = \"two\"", "name = 2"), {"name", "found 2"}));
  CHECK(says(toml_fault("[bench]", "[bnch]"), {"bnch", "unknown key", "bench"}));
  CHECK(says(toml_fault("gravity_plane", "plane"), {"bench.plane", "unknown key"}));
  CHECK(says(toml_fault("\"vertical\"", "\"upright\""), {"bench.gravity_plane", "upright", "horizontal"}));
  CHECK(says(toml_fault("[0.0, -1.0]", "[0.0, -2.0]"), {"gravity_direction", "length 2", "unit"}));
  CHECK(says(toml_fault("\"vertical\"", "\"horizontal\""), {"gravity_direction", "horizontal plane"}));
  CHECK(says(toml_fault("\"force\"", "\"force\"\nloaded_by = \"crane\""),
             {"run[2].loaded_by", "crane", "weights"}));
  CHECK(says(toml_fault("\"displacement\"", "\"displacement\"\nloaded_by = \"weights\""),
             {"run[1].loaded_by", "weights", "end point"}));
  CHECK(says(toml_fault("[0.3, 0.2]", "[0.3, -0.2]"), {"nominal.link_length[2]", "-0.2", "positive"}));
  CHECK(says(toml_fault("[0.3, 0.2]", "[0.3, \"a\"]"), {"nominal.link_length[2]", "a", "finite"}));
  CHECK(says(toml_fault("[0.3, 0.2]", "0.3"), {"nominal.link_length", "0.3", "list"}));
  CHECK(says(toml_fault("[0.3, 0.2]", "[]"), {"nominal.link_length", "0 values"}));
  CHECK(says(toml_fault("[2.0, 1.5]", "[2.0, -1.5]"), {"joint_stiffness[2]", "-1.5"}));
  CHECK(says(toml_fault("[2.0, 1.5]", "[2.0, inf]"), {"joint_stiffness[2]", "inf", "finite"}));
  CHECK(says(toml_fault("[2.0, 1.5]", "[2.0, 1.5, 1.0]"), {"joint_stiffness", "3 values", "2 numbers"}));
  CHECK(says(toml_fault("Fy = 0.02", "Fy = -0.02"), {"noise.Fy", "-0.02"}));
  CHECK(says(toml_fault("Fy = 0.02", "Fy = 0"), {"noise.Fy", "press"}));
  CHECK(says(toml_fault("q = 0.001", ""), {"noise.q", "press"}));
  CHECK(says(toml_fault("Fy = 0.02", ""), {"noise.Fy", "press"}));
  CHECK(says(toml_fault("rest = [0.4, -0.9]", "rest = [0.4]"),
             {"run[1].rest", "1 values", "2, one for each link of the nominal chain"}));
  CHECK(says(toml_fault("id = \"pull\"", "id = \"press\""), {"run[2].id", "\"press\" again"}));
  CHECK(says(toml_fault("\"force\"", "\"torque\""), {"run[2].control", "torque", "displacement"}));
  CHECK(says(toml_fault("\"pull.csv\"", "\"push.csv\""), {"push.csv"}));
  CHECK(says(toml_fault("\"pull.csv\"", "\"../pull.csv\""), {"run[2].samples", "inside"}));
  CHECK(says(toml_fault("\"pull.csv\"", "\"/etc/passwd\""), {"run[2].samples", "inside"}));
  CHECK(says(toml_fault("\"pull.csv\"", "\".\""), {"found"}));
  CHECK(says(toml_fault("[noise]", "[noise"), {"experiment.toml:12"}));
}

TEST_CASE("a fault of a sample file is named by its line") {
  CHECK(says(press_fault("t,x,y", "t,y,x"), {"press.csv:1", "t,y,x", "t,x,y,Fx,Fy,q1,q2"}));
  CHECK(says(press_fault("-0.1", "abc"), {"press.csv:3, Fx", "'abc'", "finite number"}));
  CHECK(says(press_fault("-0.1", "nan"), {"press.csv:3, Fx", "'nan'"}));
  CHECK(says(press_fault("-0.1", "1e999"), {"press.csv:3, Fx", "'1e999'"}));
  CHECK(says(press_fault("-0.1", "1.0x"), {"press.csv:3, Fx", "'1.0x'"}));
  CHECK(says(press_fault("-0.1,", ""), {"press.csv:3", "6 fields", "7"}));
  CHECK(says(press_fault("1,0.4500", ",0.4500"), {"press.csv:3, t", "empty"}));
  CHECK(says(press_fault("1,0.4500", "1,"), {"press.csv:3", "imposed"}));
  CHECK(says(press_fault("1,0.4500", "-1,0.4500"), {"press.csv:3, t", "-1", "not before"}));
  CHECK(says(press_fault("-0.1", "\"-0.1"), {"press.csv"}));
  CHECK(says(fault({.press = "t,x,y,Fx,Fy\n"}), {"press.csv", "header alone"}));
  CHECK(says(fault({.press = ""}), {"press.csv", "empty"}));
}

TEST_CASE("values that cannot be physical are refused") {
  CHECK(says(press_fault("1,0.4500", "1,0.5200"), {"press", "reading 2", "0.52", "0.5 m"}));
  CHECK(says(press_fault("1,0.4500,0.0209", "1,0.0500,0.0209"), {"press", "reading 2", "0.1 m", "folded"}));
  CHECK(says(press_fault("0.4,-0.9\n", "22.9,-51.6\n"), {"press", "joint angles", "radians"}));
  CHECK(says(fault({.press = "t,x,y,Fx,Fy\n0,0.4518,0.0209,0,0\n", .pull = "t,x,y,Fx,Fy\n0,,,0,0\n"}),
             {"2 measured values", "at least 3"}));
}

TEST_CASE("two passive joints are allowed while the end point is held, three are not") {
  CHECK(toml_fault("[2.0, 1.5]", "[0, 0]").empty());
  std::string toml = replaced(good_toml, "[0.3, 0.2]", "[0.3, 0.1, 0.1]");
  toml = replaced(toml, "[2.0, 1.5]", "[0, 0, 0]");
  for (int run = 0; run < 2; ++run) toml = replaced(toml, "[0.4, -0.9]", "[0.4, -0.9, 0.0]");
  const std::string press = "t,x,y,Fx,Fy\n0,0.4518,0.0209,0,0\n";
  CHECK(says(fault({.toml = toml, .press = press}), {"joint_stiffness", "3 passive joints", "mechanism"}));
}

TEST_CASE("a missing folder, and an experiment.toml that is a folder") {
  const Folder folder;
  CHECK_THROWS_WITH_AS(read_experiment(folder.path() / "nowhere"), doctest::Contains("no such folder"),
                       Error);
  CHECK_THROWS_WITH_AS(read_experiment(folder.path()), doctest::Contains("experiment.toml"), Error);
  std::filesystem::create_directory(folder.path() / "experiment.toml");
  CHECK_THROWS_WITH_AS(read_experiment(folder.path()), doctest::Contains("experiment.toml"), Error);
}

TEST_CASE("a plan is read without measurements") {
  const Folder folder;
  lay(folder, {.toml = replaced(good_toml, "samples = \"pull.csv\"\n", ""),
               .press = "t,x,y\n0,0.4518,0.0209\n1,0.4500,0.0209\n"});
  const Experiment bench = read_plan(folder.path());
  REQUIRE(bench.runs.size() == 2);
  CHECK(bench.runs[0].readings[1][column_x] == 0.45);
  CHECK(std::isnan(bench.runs[0].readings[1][column_Fx]));
  CHECK(bench.runs[0].measured().back() == Channel(Channel::Name::q, 1));  // as [noise] has a figure for them
  CHECK(bench.runs[1].readings.empty());
  CHECK(bench.runs[1].control == Control::force);
}

TEST_CASE("a plan ignores measured columns") {
  const Folder folder;
  lay(folder, {});
  const Experiment bench = read_plan(folder.path());
  CHECK(std::isnan(bench.runs[0].readings[1][column_Fx]));
  CHECK(std::isnan(bench.runs[1].readings[1][column_x]));
  CHECK(bench.runs[1].readings[1][column_Fx] == 0.1);
}

TEST_CASE("an experiment without measurements, and a plan that would measure nothing, are refused") {
  CHECK(
      says(fault({.press = "t,x,y\n0,0.4518,0.0209\n1,0.4500,0.0209\n", .pull = "t,Fx,Fy\n0,0,0\n2,0.1,0\n"}),
           {"press.csv:1", "the header 't,x,y'"}));
  const Folder folder;
  lay(folder, {.toml = replaced(replaced(replaced(good_toml, "Fx = 0.02\n", ""), "Fy = 0.02\n", ""),
                                "q = 0.001\n", "")});
  std::string complaint;
  try {
    read_plan(folder.path());
  } catch (const Error& error) {
    complaint = error.what();
  }
  CHECK(says(complaint, {"noise", "\"press\"", "Fx, Fy, q"}));
}
