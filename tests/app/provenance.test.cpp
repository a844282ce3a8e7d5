#include <nlohmann/json.hpp>

#include "support/files/sha256.hpp"
#include "tests/app/process.hpp"

namespace {

using nlohmann::json;

json provenance(const Workplace& here, const std::string& arguments) {
  const Outcome outcome = here.plumbline(arguments);
  REQUIRE_MESSAGE(outcome.status <= 1, arguments, ": ", outcome.err);
  return json::parse(outcome.out)["provenance"];
}

const std::string chain = "lengths = [1, 1]\nstiffness = [1, 1]\n";

}  // namespace

TEST_CASE("every JSON names the program, the command and its inputs") {
  const Workplace here;
  here.write("two links.toml", chain);
  here.write("values.csv", "chain,mode,force\na,1,2.4\n");
  here.write("chains.csv", "chain,lengths,stiffness\na,1;1,1;1\n");
  const std::string version = here.plumbline("--version").out;
  const struct {
    const char *typed, *command;
    std::string inputs;
  } cases[] = {
      {"critical --json - 'two links.toml' --digits=20 --all",
       "plumbline critical 'two links.toml' --digits 20 --all", chain},
      {"critical --json", "plumbline critical", ""},
      {"path 'two links.toml' --to 0.1 --json", "plumbline path 'two links.toml' --to 0.1", chain},
      {"equilibria 'two links.toml' --force -1,0.5 --json",
       "plumbline equilibria 'two links.toml' --force -1,0.5", chain},
      {"check values.csv --chains chains.csv --json", "plumbline check values.csv --chains chains.csv",
       here.read("values.csv") + here.read("chains.csv")},
      {"verify --section 2 --json", "plumbline verify --section 2", ""},
  };
  for (const auto& one : cases) {
    const json found = provenance(here, one.typed);
    CHECK(found["program"].get<std::string>() + "\n" == version);
    CHECK(found["command"] == one.command);
    CHECK(found["inputs_sha256"] ==
          (one.inputs.empty() ? json() : json(plumbline::files::sha256(one.inputs))));
  }
}

TEST_CASE("the digest of an experiment covers its settings and its samples") {
  const Workplace here;
  const std::string source = PLUMBLINE_SOURCE_DIR "/docs/examples/experiment";
  std::filesystem::copy(source, here / "E");
  std::string all;
  for (const char* name : {"experiment.toml", "u-press.csv", "z-press.csv", "u-aside.csv", "u-again.csv"})
    all += here.read("E/" + std::string(name));
  const json report = provenance(here, "diagnose E --json");
  CHECK(report["command"] == "plumbline diagnose E");
  CHECK(report["inputs_sha256"] == plumbline::files::sha256(all));
}

TEST_CASE("standard input and pipes count as input files") {
  const Workplace here;
  here.write("two.toml", chain);
  const std::string digest = plumbline::files::sha256(chain);
  CHECK(provenance(here, "critical - --json <two.toml")["inputs_sha256"] == digest);
  CHECK(provenance(here, "critical two.toml --json")["inputs_sha256"] == digest);
}

TEST_CASE("the bytes of a result depend neither on its path nor on other outputs") {
  const Workplace here;
  here.write("two.toml", chain);
  CHECK(here.plumbline("path two.toml --to 0.1 --json a.json").status == 0);
  CHECK(here.plumbline("path two.toml --to 0.1 --svg b.svg --json b.json --csv b.csv").status == 0);
  CHECK(here.plumbline("path two.toml --svg --to 0.1 >c.svg").status == 0);
  CHECK(here.read("a.json") == here.read("b.json"));
  CHECK(contains(here.read("b.svg"), "<metadata>plumbline "));
  CHECK(contains(here.read("b.svg"), "plumbline path two.toml --to 0.1; SHA-256"));
}

TEST_CASE("a table of chains named as an output is an input, and the command says so") {
  const Workplace here;
  here.write("chains.csv", "chain,lengths,stiffness\na,1;1,1;1\n");
  CHECK(here.plumbline("critical --csv chains.csv --json out.json").status == 0);
  const json found = json::parse(here.read("out.json"))["provenance"];
  CHECK(found["command"] == "plumbline critical --csv chains.csv");
  CHECK(found["inputs_sha256"] == plumbline::files::sha256(here.read("chains.csv")));
}
