#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"

namespace {

const std::string friction =
    R"({"effects": [{"id": "joint_friction", "joint": null, "parameters": {"tau_c": 0.035}}], "strength_sigma": 10})";

/// A folder with the bundled example as its one experiment.
void add_example(const Workplace& here) {
  std::filesystem::create_directories(here.path() / "mine");
  std::filesystem::copy(sources + "/docs/examples/experiment", here.path() / "mine" / "bench");
}

}  // namespace

TEST_CASE("own experiments are diagnosed and scored") {
  const Workplace here;
  add_example(here);
  here.write("mine/bench/label.json", friction);
  const Outcome outcome = here.plumbline("trial --experiments mine --patience 3000 --json result.json");
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "The labels were not sealed"));
  const auto result = nlohmann::json::parse(here.read("result.json"));
  CHECK(result["strong"]["count"] == 1);
  CHECK(result["experiments"][0]["said"] == "identified joint_friction");
}

TEST_CASE("a sealed label is verified, a forged one detected") {
  const Workplace here;
  add_example(here);
  std::filesystem::create_directories(here.path() / "mine" / "labels");
  here.write("label", "salt\n{\"effects\": []}");
  REQUIRE(std::system(
              ("cd '" + here.path().string() + "' && sha256sum label | cut -c1-64 >digest").c_str()) == 0);
  const std::string digest = here.read("digest").substr(0, 64);
  here.write("mine/seals.json", R"({"format": "experiment-seals/1", "seals": {"bench": ")" + digest + "\"}}");
  here.write("mine/labels/bench.json", R"({"salt": "salt", "label": "{\"effects\": []}"})");
  const Outcome honest = here.plumbline("trial --experiments mine --patience 3000");
  CHECK(honest.status == 0);
  CHECK(contains(honest.out, "every seal holds"));
  CHECK(contains(honest.out, "false alarm"));
  here.write("mine/labels/bench.json", R"({"salt": "salt", "label": "{\"effects\": [ ]}"})");
  const Outcome forged = here.plumbline("trial --experiments mine --patience 3000");
  CHECK(forged.status == 1);
  CHECK(contains(forged.out, "1 DO NOT HOLD"));
  CHECK(contains(forged.out, "broken seal"));
}

TEST_CASE("a failed diagnosis is listed in the trial with its reason") {
  const Workplace here;
  add_example(here);
  here.write("mine/bench/label.json", friction);
  here.write("mine/bench/experiment.toml", "format = \"else\"\n");
  const Outcome outcome = here.plumbline("trial --experiments mine");
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "no report"));
  CHECK(contains(outcome.out, "exit status 2: plumbline: "));
}

TEST_CASE("no experiments, no labels, or a folder in use: one line and status 2") {
  const Workplace here;
  add_example(here);
  CHECK(here.plumbline("trial --experiments nowhere").status == 2);
  const Outcome unlabelled = here.plumbline("trial --experiments mine");
  CHECK(unlabelled.status == 2);
  CHECK(contains(unlabelled.err, "neither a seal"));
  CHECK(here.plumbline("trial --experiments mine --out mine").status == 2);
}

#ifdef PLUMBLINE_SIMULATOR
TEST_CASE("a small blind trial: seals hold, every diagnosis reports, most causes are found" *
          doctest::test_suite("long")) {
  const Workplace here;
  const Outcome outcome =
      here.plumbline("trial --trials 6 --seed 12 --patience 3000 --out kept --json result.json");
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "SHA-256 of the seals: "));
  const auto result = nlohmann::json::parse(here.read("result.json"));
  CHECK(result["experiments"].size() == 6);
  CHECK(result["seals"]["sealed"] == 6);
  CHECK(result["seals"]["broken"] == 0);
  CHECK(result["no_report"] == 0);
  // at 80 % right, fewer than 3 of 6 have a chance of 1.7 %
  CHECK(result["found"]["count"].get<int>() >= 3);
  CHECK(result["nominal_error_sigma"]["worst"].get<double>() < 0.05);
  // what was kept is a folder of sealed experiments, and gives the same result again
  const Outcome again = here.plumbline("trial --experiments kept --patience 3000 --json again.json");
  CHECK(again.status == 0);
  CHECK(nlohmann::json::parse(here.read("again.json"))["found"] == result["found"]);
}

TEST_CASE("the second trial is sealed too, and counted by family" * doctest::test_suite("long")) {
  const Workplace here;
  const Outcome outcome =
      here.plumbline("trial --second --trials 4 --seed 3 --patience 3000 --json result.json");
  CHECK(outcome.status == 0);
  const auto result = nlohmann::json::parse(here.read("result.json"));
  CHECK(result["command"] == "plumbline trial --second --trials 4 --seed 3 --patience 3000");
  CHECK(result["seals"]["broken"] == 0);
  std::size_t counted = 0;
  for (const auto& family : result["by_family"]) counted += family["found"]["total"].get<std::size_t>();
  CHECK(counted == 4);
  CHECK(here.plumbline("trial --second --experiments mine").status == 2);
}
#else
TEST_CASE("a program without the simulator says how to build one with it") {
  const Workplace here;
  const Outcome outcome = here.plumbline("trial --trials 3");
  CHECK(outcome.status == 2);
  CHECK(contains(outcome.err, "PLUMBLINE_SIMULATOR"));
}
#endif
