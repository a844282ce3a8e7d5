#include "diagnose/bench/states.hpp"

#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/folder.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

std::string run(const std::string& id, const std::string& state) {
  return "[[run]]\nid = \"" + id + "\"\ncontrol = \"angle\"\nsamples = \"samples.csv\"\n" +
         (state.empty() ? "" : "state = \"" + state + "\"\n");
}

/// A joint alone with these runs, all of the same samples.
void fill(const Folder& folder, const std::string& runs) {
  folder.write("experiment.toml",
               "format = \"chain-experiment/1\"\nname = \"hinge\"\n[nominal]\njoint = \"revolute\"\n"
               "joint_stiffness = [60]\n[noise]\ntorque = 0.013\n" +
                   runs);
  std::string samples = "t,angle,torque\n";
  for (int k = 0; k < 12; ++k)
    samples += std::to_string(k) + "," + std::to_string(0.01 * k) + "," + std::to_string(0.6 * k) + "\n";
  folder.write("samples.csv", samples);
}

}  // namespace

TEST_CASE("runs of one file are told apart by their state, in the order of the file") {
  const Folder folder;
  fill(folder, run("a", "new") + run("b", "worn") + run("c", "new"));
  CHECK(states_in(folder.path()) == std::vector<std::string>{"new", "worn"});
  const Experiment fresh = read_experiment(folder.path(), settings_of(folder.path(), "new"));
  REQUIRE(fresh.runs.size() == 2);
  CHECK(fresh.runs[1].id == "c");
  CHECK(read_experiment(folder.path(), settings_of(folder.path(), "worn")).runs.front().id == "b");
}

TEST_CASE("runs of several states are no one experiment") {
  const Folder folder;
  fill(folder, run("a", "new") + run("b", "worn"));
  CHECK_THROWS_WITH_AS(
      read_experiment(folder.path()),
      doctest::Contains("found runs of the states \"new\" and \"worn\", expected runs of one state"), Error);
  fill(folder, run("a", "new") + run("b", "new"));
  CHECK(read_experiment(folder.path()).runs.size() == 2);
}

TEST_CASE("a state that no run names is refused with those that runs name") {
  const Folder folder;
  fill(folder, run("a", "new") + run("b", "worn"));
  CHECK_THROWS_WITH_AS(settings_of(folder.path(), "old"), doctest::Contains("expected one of new, worn"),
                       Error);
  fill(folder, run("a", ""));
  CHECK(states_in(folder.path()).empty());
  CHECK_THROWS_AS(settings_of(folder.path(), "old"), Error);
}
