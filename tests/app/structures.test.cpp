// Chains with other ends and loads than the paper's, as a user has them.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"

TEST_CASE("the first line of critical says its case") {
  const Workplace here;
  const struct {
    const char *file, *words, *answer;
  } cases[] = {
      {"lengths = [1, 1]\nstiffness = [1, 1]\n",
       "2 links, base sprung, end point guided, dead force at the end point",
       "Critical force 2.50000000000000"},
      {"lengths = [1, 1]\nstiffness = [0, 1]\nbase = \"pinned\"\n", "base pinned, end point guided",
       "2.00000000000000"},
      {"lengths = [1, 1]\nstiffness = [1, 1]\nend_point = \"free\"\n", "base sprung, end point free",
       "Critical force 0.381966011250105"},
      {"lengths = [1, 1, 1]\nstiffness = [1, 1, 1]\nend_point = \"clamped\"\n", "end point clamped",
       "Critical force"},
      {"lengths = [1, 1, 1]\nstiffness = [0, 1, 1]\nbase = \"clamped\"\n", "base clamped", "Critical force"},
      {"lengths = [1, 1]\nstiffness = [1, 1]\nfoundation = 0.5\n", "1 joint held or sprung across",
       "Critical force"},
      {"lengths = [1, 1]\nstiffness = [1, 1]\nend_point = \"free\"\nloads = [{ weight = 1 }]\n",
       "dead forces at 2 places", "Critical factor of the loads"},
      {"lengths = [1, 1]\nstiffness = [1, 1]\nend_point = \"free\"\nmasses = [2, 1]\nloads = [{ follower = 1 "
       "}]\n",
       "follower force", "2.08578643762690: flutter"},
      {"beam = { EI = 1, length = 1, links = 10 }\n", "10 links", "The rod itself: 9.86960440108936,"},
      // u tan u = 1 and pi: Timoshenko, Gere 1961, 2.3 and 2.2
      {"beam = { EI = 1, length = 1, links = 10 }\nbase = { turn = 1 }\nend_point = \"free\"\n", "10 links",
       "The rod itself: 0.740173884394967,"},
      {"beam = { EI = 1, length = 1, links = 10 }\nbase = \"clamped\"\n"
       "end_point = { across = \"free\", turn = \"held\" }\n",
       "10 links", "The rod itself: 9.86960440108936,"},
      {"lengths = [1, 1]\njoints = [{ axes = [[0, 0, 1], [0, 1, 0]], stiffness = [1, 2] }, "
       "{ axes = [[0, 0, 1], [0, 1, 0]], stiffness = [1, 2] }]\n",
       "in space, base jointed, end point guided", "Critical factor of the loads 2.50000000000000"},
      {"lengths = [1, 1]\njoints = [{ axes = [[0, 1, 0], [0, 0, 1]], stiffness = [1, 1] }, "
       "{ axes = [[0, 1, 0], [0, 0, 1]], stiffness = [1, 1] }]\nloads = [{ torque = \"axial\" }]\n",
       "axial torque at the end point", "The torque has no energy here"},
  };
  for (const auto& [file, words, answer] : cases) {
    CAPTURE(file);
    here.write("c.toml", file);
    const Outcome done = here.plumbline("critical c.toml");
    CHECK(done.status == 0);
    CHECK(contains(done.out.substr(0, done.out.find('\n')), words));
    CHECK(contains(done.out, answer));
    const Outcome json = here.plumbline("critical c.toml --json");
    CHECK(json.status == 0);
    CHECK(nlohmann::json::parse(json.out)["chains"].size() == 1);
  }
}

TEST_CASE("what a chain file says wrong of ends and loads is named in one line") {
  const Workplace here;
  const std::string chain = "lengths = [1, 1]\nstiffness = [1, 1]\n";
  const struct {
    std::string file, said;
  } cases[] = {
      {chain + "base = \"clamped\"\n", "clamped base"},
      {chain + "base = \"welded\"\n", "found welded, expected \"pinned\""},
      {chain + "base = \"pinned\"\n", "beside a spring at joint 1"},
      {chain + "end_point = { across = \"loose\" }\n", "found loose, expected \"free\", \"held\""},
      {chain + "end_point = { sideways = 1 }\n", "sideways"},
      {chain + "supports = [{ at = 3, across = 1 }]\n", "joint from 2 to 2"},
      {chain + "loads = [{ force = [-1, 1] }]\n", "across the straight chain"},
      {chain + "loads = [{ force = [-1, 0], weight = 1 }]\n", "2 of force, follower, moment, weight"},
      {chain + "loads = [{ weight = 1, direction = [1, 1] }]\n", "length is not 1"},
      {chain + "loads = [{ force = [1, 0] }]\n", "they pull"},
      {chain + "loads = [{ force = [-1, 0], fixed = true }]\n", "none that is multiplied"},
      {chain + "masses = [1]\nloads = [{ follower = 1 }]\n", "masses"},
      {"beam = { EI = 1, E = 1, length = 1, links = 3 }\n", "EI"},
      {"beam = { EI = 1, length = 1, links = 2.5 }\n", "whole number"},
      {chain + "beam = { EI = 1, length = 1, links = 3 }\n", "beside a beam"},
      {"lengths = [1]\njoints = [{ axes = [[0, 0]], stiffness = [1] }]\n", "three"},
      {"lengths = [1, 1]\njoints = [{ axes = [[0, 0, 1]], stiffness = [1] }]\n", "one for each link"},
  };
  for (const auto& [file, said] : cases) {
    CAPTURE(file);
    here.write("c.toml", file);
    const Outcome refused = here.plumbline("critical c.toml");
    check_refused(refused);
    CHECK(contains(refused.err, said));
  }
}

TEST_CASE("certificates of other ends and loads hold for the checker, which nothing of ours feeds") {
  const Workplace here;
  here.write("c.toml",
             "lengths = [1, 2, 1]\nstiffness = [1, 1, 0.5]\nend_point = { across = 0.25, turn = 1 "
             "}\nfoundation = 0.1\n"
             "loads = [{ force = [-1, 0] }, { force = [-0.01, 0], at = 2, fixed = true }]\n");
  here.write("f.toml",
             "lengths = [1, 1]\nstiffness = [1, 1]\nend_point = \"free\"\nloads = [{ follower = 1 }]\n");
  for (const char* chain : {"c.toml", "f.toml"}) {
    REQUIRE(here.plumbline(std::string("critical --all --digits 30 --certify p.json ") + chain).status == 0);
    const std::string check = "python3 -B '" + sources + "/proofs/certificates/check_structures.py' '" +
                              (here / "p.json").string() + "' >/dev/null 2>&1";
    CHECK(std::system(check.c_str()) == 0);
    const auto of = [&](const char* other) {
      const std::string files = "'" + (here / "p.json").string() + "' --of '" + (here / other).string() + "'";
      return std::system(("python3 -B '" + sources + "/proofs/certificates/check_structures.py' " + files +
                          " >/dev/null 2>&1")
                             .c_str());
    };
    CHECK(of(chain) == 0);
    CHECK(of(std::string(chain) == "c.toml" ? "f.toml" : "c.toml") != 0);
    auto forged = nlohmann::json::parse(here.read("p.json"));
    forged["certificates"][0]["chain"]["stiffness"][0] = "2";
    here.write("p.json", forged.dump());
    CHECK(std::system(check.c_str()) != 0);
  }
}

TEST_CASE("path and equilibria follow other ends and loads, and say what they do not take") {
  const Workplace here;
  here.write("c.toml", "lengths = [1, 1]\nstiffness = [1, 1]\nend_point = \"free\"\n");
  const Outcome path = here.plumbline("path c.toml --factor 1 --branches all");
  CHECK(path.status == 0);
  CHECK(contains(path.out, "bifurcation"));
  CHECK(contains(path.out, "0.381966"));
  const auto slow = nlohmann::json::parse(here.plumbline("path c.toml --factor 1 --json").out);
  CHECK(slow["branches"].back()["points"].back()["negative_directions"] == 0);
  const Outcome all = here.plumbline("equilibria c.toml --factor 1 --certify");
  CHECK(all.status == 0);
  CHECK(contains(all.out, "3 equilibria"));
  CHECK(contains(all.out, "certified: these are all in the window"));
  CHECK(contains(here.plumbline("equilibria c.toml --factor 1").out, "3 equilibria"));
  check_refused(here.plumbline("path c.toml --to 0.1"));
  const Outcome proved = here.plumbline("path c.toml --factor 1 --certify");
  CHECK(proved.status == 0);
  CHECK(contains(proved.out, "not covered, a bifurcation"));
  CHECK_FALSE(contains(proved.out, "NOT proved"));
  check_refused(here.plumbline("equilibria c.toml --at 0.1,0"));
  here.write("plain.toml", "lengths = [1, 1]\nstiffness = [1, 1]\n");
  // with the end point guided 5 q^2 / 2 of the springs stands against F q^2: F = 5 / 2
  const auto plain = nlohmann::json::parse(here.plumbline("path plain.toml --factor 4 --json").out);
  CHECK(plain["branches"][0]["end"] == "loss of stability");
  CHECK(plain["branches"][0]["events"].back()["factor"].get<double>() == doctest::Approx(2.5).epsilon(1e-9));
  CHECK(
      contains(here.plumbline("equilibria plain.toml --factor 4 --certify").out, "certified: these are all"));
  check_refused(here.plumbline("path plain.toml --factor 4 --force -1,0"));
  here.write("space.toml",
             "lengths = [1]\njoints = [{ axes = [[0, 0, 1]], stiffness = [1] }]\nend_point = \"free\"\n");
  check_refused(here.plumbline("path space.toml --factor 1 --certify"));
}
