// Inputs are never lost, outputs are whole, and errors are one line.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/process.hpp"

namespace fs = std::filesystem;

namespace {

/// Something of every kind that a verb reads.
void furnish(const Workplace& here) {
  fs::copy(sources + "/docs/examples/four-link.toml", here.path() / "c.toml");
  fs::copy(sources + "/docs/examples/experiment", here.path() / "E");
  fs::create_directory(here.path() / "X");
  fs::copy(sources + "/docs/examples/experiment", here.path() / "X" / "one");
  here.write("X/one/label.json", R"({"effects": [{"id": "joint_friction", "joint": null}]})");
  here.write("C.csv", "chain,lengths,stiffness\nfour,1;1;1,1;1;1\n");
  here.write("V.csv", "chain,mode,force\nfour,1,0.3\n");
  fs::create_symlink("c.toml", here.path() / "link.toml");
  fs::create_hard_link(here.path() / "c.toml", here.path() / "twin.toml");
}

}  // namespace

TEST_CASE("no verb overwrites its inputs, under any name") {
  for (const char* arguments :
       {"diagnose E --html E/u-press.csv", "diagnose E --json E/experiment.toml",
        "diagnose E --effects c.toml --html c.toml", "diagnose E --effects c.toml --json twin.toml",
        "diagnose E --json E/../E/u-press.csv", "check V.csv --chains C.csv --json V.csv",
        "check V.csv --chains C.csv --json C.csv", "trial --experiments X --markdown X/one/label.json",
        "trial --experiments X --json X/one/u-press.csv", "path c.toml --json ./c.toml",
        "path c.toml --svg link.toml", "path link.toml --csv c.toml", "path c.toml --csv twin.toml",
        "equilibria c.toml --json ./c.toml", "critical c.toml --json link.toml",
        "critical c.toml --certify twin.toml", "critical C.csv --csv C.csv"}) {
    CAPTURE(arguments);
    const Workplace here;
    furnish(here);
    const std::string chain = here.read("c.toml"), run = here.read("E/u-press.csv"),
                      settings = here.read("E/experiment.toml"), label = here.read("X/one/label.json");
    const Outcome outcome = here.plumbline(arguments);
    check_refused(outcome);
    CHECK(contains(outcome.err, "the input itself"));
    CHECK(here.read("c.toml") == chain);
    CHECK(here.read("E/u-press.csv") == run);
    CHECK(here.read("X/one/u-press.csv") == run);
    CHECK(here.read("E/experiment.toml") == settings);
    CHECK(here.read("X/one/label.json") == label);
    CHECK(here.read("V.csv") == "chain,mode,force\nfour,1,0.3\n");
    CHECK(here.read("C.csv") == "chain,lengths,stiffness\nfour,1;1;1,1;1;1\n");
  }
}

TEST_CASE("an empty argument, as of an unset variable, is refused") {
  const Workplace here;
  furnish(here);
  for (const char* arguments : {"diagnose ''", "diagnose E --effects ''", "diagnose E --model ''",
                                "check-experiment ''", "critical ''"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.plumbline(arguments);
    check_refused(outcome);
    CHECK(contains(outcome.err, "found an empty text"));
  }
}

TEST_CASE("two outputs to one file are refused before any work") {
  const Workplace here;
  furnish(here);
  fs::create_symlink("a", here.path() / "same");
  for (const char* arguments :
       {"critical --json a --csv a", "critical --json a --csv same", "diagnose --json a --html ./a",
        "verify --json a --html a", "path --csv a --svg a", "trial --experiments X --json a --markdown a",
        "critical --json - --csv -"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.plumbline(arguments);
    check_refused(outcome);
    CHECK(!here.exists("a"));
  }
  CHECK(here.plumbline("critical --json /dev/null --csv /dev/null").status == 0);
}

TEST_CASE("an earlier result may be overwritten") {
  const Workplace here;
  for (int i = 0; i < 2; ++i) {
    CHECK(here.plumbline("critical --json out.json").status == 0);
    CHECK(here.plumbline("critical --csv out.csv").status == 0);
    CHECK(here.plumbline("critical --csv /dev/stdout").status == 0);
  }
  CHECK(nlohmann::json::parse(here.read("out.json"))["chains"].size() == 1);
  here.write("chains.csv", "chain,lengths,stiffness\nmine,1;1,1;1\n");
  CHECK(contains(here.plumbline("critical --csv chains.csv").out, "mine,1,"));
}

TEST_CASE("binary input, endless keys, pipes and devices are refused in one line") {
  const Workplace here;
  here.write("bom.csv", "\xEF\xBB\xBF\n");
  here.write("bom.toml", "\xEF\xBB\xBF\n");
  std::string key = "a";
  for (int i = 0; i < 50000; ++i) key += ".a";
  here.write("deep.toml", key + " = 1\n");
  here.write("latin.toml", "lengths = [1, 1]\nstiffness = [1, 1] # \xE9\n");
  here.write("escape.csv", "chain,lengths,stiffness\n\"a\x1b[31m\nb\",1;1,1;1\n");
  fs::create_directory(here.path() / "deep");
  here.write("deep/experiment.toml", key + " = 1\n");
  fs::copy(sources + "/docs/examples/experiment", here.path() / "E");
  fs::remove(here.path() / "E/u-press.csv");
  mkfifo((here.path() / "E/u-press.csv").c_str(), 0600);
  mkfifo((here.path() / "pipe.toml").c_str(), 0600);
  for (const char* arguments : {"check bom.csv",
                                "critical bom.csv",
                                "critical bom.toml",
                                "critical deep.toml",
                                "diagnose deep",
                                "critical latin.toml",
                                "critical escape.csv",
                                "diagnose E",
                                "critical pipe.toml",
                                "path pipe.toml",
                                "verify --chains -3",
                                "verify --chains 3 --seed -1",
                                "trial --trials 0",
                                "trial --trials -1",
                                "trial --patience nan",
                                "path --to abc",
                                "path --to inf",
                                "path --force 1",
                                "path --force 1,x",
                                "path --step 0",
                                "path --side 2",
                                "equilibria --at 1",
                                "equilibria --at 1,x",
                                "critical --digits 10001",
                                "nonsense",
                                "check",
                                "path --to 1 --force 1,1",
                                "verify --html nosuch/x.html",
                                "verify --html /dev/full",
                                "verify --json /dev/full",
                                "figure 99",
                                "figure 2 --out /proc/nothing",
                                "reference --out /dev/null/x"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.plumbline(arguments);
    CAPTURE(outcome.err);
    check_refused(outcome);
    CHECK(contains(outcome.err, ": found "));
    CHECK(contains(outcome.err, ", expected "));
    for (const char* foreign : {"json.exception", "vector::", "CLI", "Could not convert", "not in range",
                                "The following", "filesystem error", "boost", "Error in function"})
      CHECK(!contains(outcome.err, foreign));
    CHECK(std::none_of(outcome.err.begin(), outcome.err.end() - 1, [](unsigned char c) { return c < 0x20; }));
  }
}

TEST_CASE("invalid noise, and names with control characters, are refused at their place") {
  for (const auto& [before, after] : {std::pair{"Fx", "6e-300"}, std::pair{"name", "\"a\\u001b[31m\""}}) {
    const Workplace here;
    fs::copy(sources + "/docs/examples/experiment", here.path() / "E");
    std::string text;
    std::istringstream lines(here.read("E/experiment.toml"));
    for (std::string line; std::getline(lines, line);) {
      const bool it = line.starts_with(before) && line.find('=') != std::string::npos;
      text += (it ? std::string(before) + " = " + after : line) + "\n";
    }
    here.write("E/experiment.toml", text);
    const Outcome outcome = here.plumbline("diagnose E");
    check_refused(outcome);
    CHECK(contains(outcome.err, before));
  }
}

TEST_CASE("file names that are not text are refused in one line") {
  const Workplace here;
  furnish(here);
  const std::string odd = "odd\xff";
  fs::create_directory(here.path() / "Y");
  fs::copy(here.path() / "X" / "one", here.path() / "Y" / "one", fs::copy_options::recursive);
  fs::copy(here.path() / "X" / "one", here.path() / "Y" / odd);
  fs::copy(here.path() / "X", here.path() / odd, fs::copy_options::recursive);
  for (const std::string& arguments :
       {"trial --experiments " + odd, std::string("trial --experiments Y"), "trial --trials 1 --out " + odd,
        "diagnose E " + odd + "/one --reports R", "critical --certify " + odd,
        "path --json " + odd + " --to 0.1", "diagnose " + odd + "/one", "critical " + odd + ".toml"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.plumbline(arguments);
    check_refused(outcome);
    CHECK(contains(outcome.err, "odd\\xff"));
    CHECK(contains(outcome.err, "UTF-8"));
  }
}

TEST_CASE("an experiment given twice is refused, however its path is written") {
  const Workplace here;
  furnish(here);
  fs::create_directory_symlink("one", here.path() / "X" / "link");
  for (const char* again : {"X/one", "./X/../X/one/", "X/link"}) {
    CAPTURE(again);
    const Outcome outcome = here.plumbline(std::string("diagnose X/one ") + again);
    check_refused(outcome);
    CHECK(contains(outcome.err, "found this folder again, expected each experiment once"));
  }
}

TEST_CASE("check lists every bad row, up to a readable number") {
  const Workplace here;
  here.write("C.csv", "chain,lengths,stiffness\na,1;1;1,1;1;1\n");
  here.write("V.csv", "chain,mode,force\na,0,1\na,3,1\nb,1,1\na,1,x\na,1\na,1,0.3\na,1,0.3\n");
  const Outcome some = here.plumbline("check V.csv --chains C.csv");
  CHECK(some.status == 2);
  CHECK(some.out.empty());
  for (const char* line :
       {"V.csv:2: found mode \"0\"", "V.csv:3: found mode \"3\"", "V.csv:4: found chain \"b\"",
        "V.csv:5: found force \"x\"", "V.csv:6: found 2 fields", "V.csv:8: found mode 1 of a again"})
    CHECK(contains(some.err, line));
  CHECK(std::count(some.err.begin(), some.err.end(), '\n') == 6);
  std::string many = "chain,mode,force\n";
  for (int i = 0; i < 1000; ++i) many += "a,9,1\n";
  here.write("V.csv", many);
  const Outcome lot = here.plumbline("check V.csv --chains C.csv");
  CHECK(std::count(lot.err.begin(), lot.err.end(), '\n') == 51);
  CHECK(contains(lot.err, "and 950 more"));
}

TEST_CASE("a full or closed standard output is an error of one line") {
  const Workplace here;
  for (const char* arguments : {"critical >/dev/full", "critical --json - >/dev/full", "critical --json >&-",
                                "path >/dev/full", "figure 2 >/dev/full"}) {
    CAPTURE(arguments);
    const Outcome outcome = here.plumbline(arguments);
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

TEST_CASE("ten thousand digits of the forces of four links are computed") {
  const Workplace here;
  fs::copy(sources + "/docs/examples/four-link.toml", here.path() / "c.toml");
  const std::string more = here.plumbline("critical c.toml --csv --digits 10000").out,
                    fewer = here.plumbline("critical c.toml --csv --digits 5700").out;
  std::istringstream rows(more), short_rows(fewer);
  std::size_t compared = 0;
  for (std::string row, short_row; std::getline(rows, row) && std::getline(short_rows, short_row);
       ++compared) {
    if (compared == 0) continue;  // the names of the columns
    REQUIRE(row.size() > 10000);
    const std::size_t same = short_row.size() - 10;  // the last digits are rounded
    CHECK(row.substr(0, same) == short_row.substr(0, same));
  }
  CHECK(compared == 4);  // and three forces
}

TEST_CASE("equilibria that stay undecided end with status 1") {
  const Workplace here;
  // at its critical force (k z / L with unit links: 0.3819660112501051...) nothing tells the straight shape
  // from what branches off: two unit links, whose characteristic polynomial is F^2 - 3 F + 1
  here.write("c.toml", "lengths = [1, 1]\nstiffness = [1, 1]\nrest = [0, 0]\n");
  const Outcome outcome = here.plumbline("equilibria c.toml --force=-0.38196601125010515,0 --certify");
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "undecided"));
}
