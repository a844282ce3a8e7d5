#include "diagnose/motion/read_bench.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <plumbline/base/error.hpp>
#include <set>
#include <string>

#include "support/files/output_file.hpp"
#include "support/files/temporary_folder.hpp"
#include "tests/close_to.hpp"

namespace plumbline::motion {
namespace {

/// A folder with one log, whose text and settings are changed.
struct Folder {
  files::TemporaryFolder folder;
  std::string settings =
      "format = \"motion/1\"\nname = \"x\"\n[logs]\nfiles = [\"a.csv\"]\n[servo]\ngain = 2\n[load]\nmass = "
      "0.5\nlength = 0.1\n[drive]\nstall_torque = \"unknown\"\n[noise]\nposition = 1e-3\n";
  std::string header = "t,command,position\n", rows;

  Folder() {
    for (int k = 0; k < 50; ++k)
      rows += std::to_string(0.01 * k) + ",0.1," + std::to_string(0.1 * std::sin(0.1 * k)) + "\n";
  }
  void replace(const std::string& what, const std::string& with) {
    const std::size_t at = settings.find(what);
    REQUIRE(at != std::string::npos);
    settings.replace(at, what.size(), with);
  }
  [[nodiscard]] Bench read() const {
    files::write_text(folder.path() / "experiment.toml", settings);
    files::write_text(folder.path() / "a.csv", header + rows);
    return read_bench(folder.path());
  }
  /// The error without the folder.
  [[nodiscard]] std::string refused() const {
    try {
      static_cast<void>(read());
    } catch (const Error& error) {
      std::string text = error.what();
      const std::string own = folder.path().string() + "/";
      for (std::size_t at = text.find(own); at != std::string::npos; at = text.find(own))
        text.erase(at, own.size());
      return text;
    }
    return "";
  }
};

}  // namespace

TEST_CASE(
    "temperatures are departures from their mean, and rows of ripple those of the counts that are said") {
  Folder folder;
  folder.replace("stall_torque = \"unknown\"\n",
                 "stall_torque = \"unknown\"\nperiods_per_turn = [7, 24]\n[columns]\ntemperature = "
                 "\"heat\"\nbase_acceleration = \"shake\"\n");
  folder.header = "t,command,position,heat,shake\n";
  std::string rows;
  for (int k = 0; k < 50; ++k)
    rows += std::to_string(0.01 * k) + ",0.1," + std::to_string(0.1 * std::sin(0.1 * k)) + "," +
            (k < 25 ? "20" : "30") + ",0.5\n";
  folder.rows = rows;
  const Bench bench = folder.read();
  CHECK(bench.logs.front().warmer.front() == close_to(-5));
  CHECK(bench.logs.front().base_acceleration.back() == close_to(0.5));
  std::set<std::string> ids;
  const Study study(bench);
  for (const Row& row : study.rows()) ids.insert(row.id);
  for (const char* id : {"cogging(7)", "torque_ripple(24)", "friction_warming", "base_motion"})
    CHECK(ids.count(id) == 1);
  CHECK(ids.count("cogging(31)") == 0);
}

TEST_CASE("motions that are planned are commands of the rig, each with a gain of its own") {
  Folder folder;
  folder.settings += "[[motion]]\nkind = \"sine\"\nsize = 0.4\nfrequency = 2\nduration = 1\ngain = 3\n";
  static_cast<void>(folder.read());  // logs are read beside them
  const Bench planned = read_planned_bench(folder.folder.path());
  REQUIRE(planned.logs.size() == 1);
  const MotionLog& log = planned.logs.front();
  CHECK(log.gain == close_to(3));
  CHECK(log.time.size() == 100);
  CHECK(log.command[25] == close_to(0.4 * std::sin(2 * std::numbers::pi * 2 * 0.25)));
  CHECK(log.name.find("gain 3") != std::string::npos);
  folder.replace("frequency = 2\n", "");
  static_cast<void>(folder.read());
  CHECK_THROWS_AS(static_cast<void>(read_planned_bench(folder.folder.path())), Error);
}

TEST_CASE("a log alone is read in SI, and a point mass is its load") {
  const Bench bench = Folder().read();
  REQUIRE(bench.logs.size() == 1);
  const MotionLog& log = bench.logs.front();
  CHECK(log.time.size() == 50);
  CHECK(log.inertia == close_to(0.5 * 0.01));
  CHECK(log.gravity == close_to(0.5 * 9.81 * 0.1));
  CHECK(log.gain == close_to(2));
  CHECK(bench.unknown == std::vector<Term>{Term::stall_torque});
}

TEST_CASE("what cannot be a log is refused in one line") {
  Folder back;
  back.rows += "0.2,0.1,0.1\n";
  CHECK(back.refused() ==
        "a.csv, reading 51: found a clock that goes from 0.49 to 0.2 s, expected time that goes forward");
  Folder still;
  still.rows.clear();
  for (int k = 0; k < 50; ++k) still.rows += std::to_string(0.01 * k) + ",0.1,0.5\n";
  CHECK(
      still.refused().starts_with("a.csv: found a position that never changes, expected a joint in motion"));
  Folder saturated;
  saturated.replace("gain = 2", "gain = 1e6");
  CHECK(saturated.refused().starts_with("a.csv: found a drive that is saturated all along"));
  Folder few;
  few.rows.resize(few.rows.size() / 2);
  few.rows.resize(few.rows.rfind('\n') + 1);
  CHECK(few.refused().starts_with("a.csv: found 2"));
  Folder word;
  word.rows += "0.6,0.1,up\n";
  CHECK(word.refused() == "a.csv:52, column position: found 'up', expected a number");
  Folder other;
  other.header = "t,command,angle\n";
  CHECK(other.refused() == "a.csv:1: found no column 'position' in a.csv, expected one of t command angle");
  Folder column;
  column.replace("gain = 2", "gain = \"kp\"");
  CHECK(column.refused().ends_with(
      "servo.gain: found the name of a column, 'kp', without logs.index, expected a number"));
  Folder outside;
  outside.replace("a.csv", "../a.csv");
  CHECK(outside.refused().ends_with(
      "logs.files: found ../a.csv, expected a file in the folder of the experiment"));
  Folder unknown;
  unknown.replace("stall_torque", "torque");
  CHECK(unknown.refused().find("drive.torque: found an unknown key, expected one of armature") !=
        std::string::npos);
  Folder load;
  load.replace("mass = 0.5\nlength = 0.1", "mass = 0");
  CHECK(load.refused().find("an inertia of 0 kg m^2") != std::string::npos);
}

TEST_CASE("a log of BAM tells its rig itself") {
  Folder one;
  std::string entries;
  for (int k = 0; k < 50; ++k)
    entries += std::string(k == 0 ? "" : ",") + "{\"timestamp\": " + std::to_string(0.01 * k) +
               ", \"position\": " + std::to_string(0.1 * std::sin(0.1 * k)) +
               ", \"goal_position\": 0.1, \"torque_enable\": " + (k < 30 ? "true" : "false") + "}";
  files::write_text(
      one.folder.path() / "a.json",
      "{\"kp\": 8, \"mass\": 0.5, \"length\": 0.2, \"arm_mass\": 0, \"entries\": [" + entries + "]}");
  one.replace("a.csv", "a.json");
  one.replace("gain = 2", "gain = \"kp\"\nduty_per_error = 0.25");
  one.replace("mass = 0.5\nlength = 0.1", "mass = \"mass\"\nlength = \"length\"");
  one.settings += "[columns]\nt = \"timestamp\"\ncommand = \"goal_position\"\npowered = \"torque_enable\"\n";
  const Bench bench = one.read();
  REQUIRE(bench.logs.size() == 1);
  const MotionLog& log = bench.logs.front();
  CHECK(log.gain == close_to(2));
  CHECK(log.inertia == close_to(0.5 * 0.04));
  CHECK(log.powered.front());
  CHECK(!log.powered.back());
}

TEST_CASE("a current is a torque by the torque constant, and so is its noise") {
  Folder one;
  one.header = "t,command,position,speed,amps\n";
  one.rows.clear();
  for (int k = 0; k < 50; ++k)
    one.rows += std::to_string(0.01 * k) + ",0.1," + std::to_string(0.1 * std::sin(0.1 * k)) + "," +
                std::to_string(std::cos(0.1 * k)) + "," + std::to_string(0.01 * (k - 20)) + "\n";
  one.replace("gain = 2", "gain = 2\ntorque_constant = 0.5");
  one.settings += "velocity = 0.02\ncurrent = 0.004\n[columns]\nvelocity = \"speed\"\ncurrent = \"amps\"\n";
  const Bench bench = one.read();
  const MotionLog& log = bench.logs.front();
  REQUIRE(log.beside.size() == 2);
  CHECK(log.beside[0].channel == Channel::velocity);
  CHECK(log.beside[1].channel == Channel::torque);
  CHECK(log.beside[1].value[22] == close_to(0.01));
  CHECK(bench.sigma_beside[0] == close_to(0.02));
  CHECK(bench.sigma_beside[2] == close_to(0.002));
  CHECK(bench.channels.size() == 2);

  one.replace("torque_constant = 0.5", "");
  CHECK(one.refused().find("servo.torque_constant") != std::string::npos);
  one.replace("current = \"amps\"", "torque = \"amps\"");
  CHECK(one.refused().find("noise.torque") != std::string::npos);
}

TEST_CASE("an isolated reading far from its neighbours is replaced, and counted") {
  Folder spiked;
  spiked.rows += "0.50,0.1,0.05\n0.51,0.1,0.90\n0.52,0.1,0.05\n";
  const Bench bench = spiked.read();
  CHECK(bench.logs.front().spikes == 1);
  CHECK(bench.logs.front().position[51] == close_to(0.05));
}

}  // namespace plumbline::motion
