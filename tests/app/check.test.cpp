#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"

TEST_CASE("the published forces agree with the reference, to all their digits") {
  const Workplace here;
  const Outcome outcome = here.plumbline("check " + sources + "/verify/reference/values/forces.csv --json");
  CHECK(outcome.status == 0);
  const auto report = nlohmann::json::parse(outcome.out);
  CHECK(report["disagree"] == 0);
  for (const auto& value : report["values"]) CHECK(value["digits"].get<double>() > 49);
}

TEST_CASE("the example in Python passes, and its report in the sources is what the command prints") {
  const Workplace here;
  const std::string run = "python3 " + sources + "/docs/examples/python/critical_forces.py " + sources +
                          "/verify/reference/values/chains.csv >" + (here.path() / "VALUES.csv").string();
  REQUIRE(std::system(run.c_str()) == 0);
  const Outcome outcome = here.plumbline("check VALUES.csv");
  CHECK(outcome.status == 0);
  std::ostringstream report;
  report << std::ifstream(sources + "/docs/examples/python/check.txt").rdbuf();
  CHECK(outcome.out == report.str());
}

TEST_CASE("disagreeing values are listed worst first, with status 1") {
  const Workplace here;
  here.write("values.csv",
             "chain,mode,force\npaper-four-link,1,0.924\npaper-three-link,2,3.0000000000000001\n"
             "paper-three-link,1,-1\n");
  const Outcome outcome = here.plumbline("check values.csv");
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "3 values of 2 chains: 1 agree"));
  const auto sign = outcome.out.find("wrong sign"), rounded = outcome.out.find("3 digits: print 17");
  CHECK(sign < rounded);
  CHECK(rounded != std::string::npos);
  CHECK(contains(outcome.out, "line 4: found -1, expected 1.0000000000000000000"));
}

TEST_CASE("values of own chains are compared with certified ones") {
  const Workplace here;
  here.write("chains.csv", "chain,lengths,stiffness\nmine,1;1,0;1\n");
  here.write("values.csv", "chain,mode,force\nmine,1,2.0000000000000004\n");
  CHECK(here.plumbline("check values.csv --chains chains.csv").status == 0);
  here.write("values.csv", "chain,mode,force\nmine,1,2.000000000001\n");
  CHECK(here.plumbline("check values.csv --chains chains.csv").status == 1);
}

TEST_CASE("bad values are refused in one line: place, found, expected") {
  const Workplace here;
  const struct {
    const char *content, *where, *found;
  } cases[] = {
      {"chain,mode\npaper-two-link,1\n", "values.csv:1", "no column force"},
      {"chain,mode,force\n", "values.csv", "no row"},
      {"chain,mode,force\nnobody,1,2\n", "values.csv:2", "chain \"nobody\""},
      {"chain,mode,force\npaper-two-link,2,2\n", "values.csv:2", "mode \"2\""},
      {"chain,mode,force\npaper-two-link,1.0,2\n", "values.csv:2", "mode \"1.0\""},
      {"chain,mode,force\npaper-two-link,1,two\n", "values.csv:2", "force \"two\""},
      {"chain,mode,force\npaper-two-link,1\n", "values.csv:2", "2 fields"},
      {"chain,mode,force\npaper-two-link,1,2\npaper-two-link,1,2\n", "values.csv:3", "again"},
      {"", "values.csv", "empty"},
  };
  for (const auto& [content, where, found] : cases) {
    CAPTURE(content);
    here.write("values.csv", content);
    const Outcome outcome = here.plumbline("check values.csv --json out.json");
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, where));
    CHECK(contains(outcome.err, found));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(!here.exists("out.json"));
  }
  CHECK(here.plumbline("check").status == 2);
  CHECK(here.plumbline("check missing.csv").status == 2);
  CHECK(here.plumbline("check .").status == 2);
}

TEST_CASE("certificates given to check are referred to the program that checks them") {
  const Workplace here;
  for (const auto& [file, checker] : {std::pair{"certificates.json", "check_certificates.py"},
                                      std::pair{"equilibria-certificates.json", "check_equilibria.py"},
                                      std::pair{"path-certificates.json", "check_paths.py"}}) {
    const std::string path = sources + "/verify/reference/values/" + file;
    const Outcome outcome = here.plumbline("check " + path);
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, std::string("python3 proofs/certificates/") + checker + " " + path));
    CHECK(std::filesystem::exists(sources + "/proofs/certificates/" + checker));
  }
  CHECK(contains(here.plumbline("check " + sources + "/verify/reference/values/events.json").err,
                 "found JSON"));
}
