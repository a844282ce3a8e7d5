#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"
#include "tests/close_to.hpp"

namespace {

const char* const zigzag = "lengths = [1, 1, 1]\nstiffness = [0, 1, 1]\nrest = [-0.1, 0.3, -0.3]\n";

}  // namespace

TEST_CASE("path: the bundled Z-chain, as text, CSV and JSON") {
  const Workplace here;
  const Outcome text = here.plumbline("path --to 1.5");
  CHECK(text.status == 0);
  CHECK(contains(text.out, "quasi-buckling"));
  const Outcome csv = here.plumbline("path --to 1.5 --csv");
  CHECK(csv.status == 0);
  CHECK(csv.out.starts_with(
      "branch,point,load,x,y,Fx,Fy,energy,stiffness,negative_directions,event,q1,q2,q3,q4\n"));
  CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') > 30);
  CHECK(here.plumbline("path --to 1.5 --json out.json").status == 0);
  const auto json = nlohmann::json::parse(here.read("out.json"));
  const auto& points = json["history"][0]["points"];
  CHECK(points.front()["load"] == 0);
  CHECK(points.back()["load"] == 1.5);
  // work balance: energy gained = integral of the compression, by trapezoids; their error stays below one
  // percent
  double work = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double h = points[i]["load"].get<double>() - points[i - 1]["load"].get<double>();
    work -= h * (points[i]["force"][0].get<double>() + points[i - 1]["force"][0].get<double>()) / 2;
  }
  CHECK(points.back()["energy"].get<double>() == close_to(work).epsilon(0.01));
}

TEST_CASE("path: all branches of a straight chain begin in its buckling modes") {
  const Workplace here;
  here.write("straight.toml", "lengths = [1, 1, 1, 1]\nstiffness = [1, 1, 1, 1]\n");
  const Outcome all = here.plumbline("path straight.toml --to 0.5 --branches all --json");
  REQUIRE(all.status == 0);
  const auto json = nlohmann::json::parse(all.out);
  CHECK(json["branches"].size() == 6);
  // near the straight shape the compressions are the critical forces, Table 2 of the paper:
  // 0.924, 3.000, 4.076
  std::vector<double> forces;
  for (const auto& branch : json["branches"]) {
    const auto& first = branch["points"].front();
    forces.push_back(-first["force"][0].get<double>());
  }
  std::sort(forces.begin(), forces.end());
  CHECK(forces[0] == close_to(0.924028).epsilon(1e-3));
  const Outcome slow = here.plumbline("path straight.toml --to 0.5 --side -1 --json");
  const auto history = nlohmann::json::parse(slow.out)["history"];
  CHECK(history.size() == 1);
  CHECK(history[0]["points"].back()["negative_directions"] == 0);
}

TEST_CASE("path: drawings are SVG") {
  const Workplace here;
  here.write("zigzag.toml", zigzag);
  const Outcome outcome = here.plumbline("path zigzag.toml --to 0.3 --svg out.svg");
  CHECK(outcome.status == 0);
  CHECK(contains(here.read("out.svg"), "<svg"));
}

TEST_CASE("equilibria: certified and sampled lists agree for the bundled chain") {
  const Workplace here;
  const auto read = [&](const std::string& arguments) {
    const Outcome outcome = here.plumbline(arguments);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out);
  };
  const auto certified = read("equilibria --end-point 3.4,0 --certify --digits 30 --json");
  const auto sampled = read("equilibria --end-point 3.4,0 --json");
  CHECK(certified["complete"] == true);
  REQUIRE(certified["equilibria"].size() == sampled["equilibria"].size());
  for (std::size_t i = 0; i < sampled["equilibria"].size(); ++i) {
    CHECK(certified["equilibria"][i]["type"] == sampled["equilibria"][i]["type"]);
    CHECK(certified["equilibria"][i]["energy"].get<std::string>().substr(0, 9) ==
          sampled["equilibria"][i]["energy"].get<std::string>().substr(0, 9));
  }
  const auto forced = read("equilibria --force -0.5,0.1 --certify --json");
  int sum = 0;
  for (const auto& one : forced["equilibria"])
    sum += contains(one["type"], "(1)") || contains(one["type"], "(3)") ? -1 : 1;
  CHECK(sum == 1);  // Euler characteristic of the space of all joint angles
}

TEST_CASE("equilibria: the output says which joint angles are counted, and --turns counts more") {
  const Workplace here;
  here.write("two.toml", "lengths = [1, 1]\nstiffness = [1, 1]\n");
  const Outcome text = here.plumbline("equilibria two.toml --end-point 1,0.2 --certify");
  CHECK(contains(text.out,
                 "2 equilibria, by energy; certified: these are all with joint angles in the window"));
  CHECK(contains(text.out, "joint angles counted: q1 in [-3.1416, 3.1416], q2 in [-3.1416, 3.1416]"));
  const auto read = [&](const std::string& arguments) {
    const Outcome outcome = here.plumbline("equilibria two.toml " + arguments + " --certify --json");
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out);
  };
  const auto narrow = read("--end-point 1,0.2"), wide = read("--end-point 1,0.2 --turns 1");
  CHECK(narrow["balanced"] == true);
  CHECK(narrow["joint_angles_counted"].size() == 2);
  CHECK(wide["equilibria"].size() > narrow["equilibria"].size());
  CHECK(read("--force -0.1,0")["joint_angles_counted"] == "all");
}

TEST_CASE("equilibria: digits that are certain, a passive base by full turns, and a continuum bounded") {
  const Workplace here;
  here.write("tie.toml", "lengths = [1, 1, 1]\nstiffness = [3, 0, 1]\n");
  const char* const held = "equilibria tie.toml --end-point 2.9,0 --certify";
  CHECK(contains(here.plumbline(held).out, "0 stands for an absolute value in [0, "));
  const auto digits = nlohmann::json::parse(here.plumbline(std::string(held) + " --json").out);
  for (const auto& one : digits["equilibria"]) {
    for (const std::string angle : one["q"]) CHECK((angle == "0" || std::abs(std::stod(angle)) > 1e-3));
  }
  here.write("passive.toml", "lengths = [1, 1]\nstiffness = [0, 1]\n");
  const Outcome sampled = here.plumbline("equilibria passive.toml --force 0.5,0 --json");
  CHECK(nlohmann::json::parse(sampled.out)["equilibria"].size() == 2);  // pulled out, and the other way round
  const Outcome continuum = here.plumbline("equilibria passive.toml --force 0,0 --json");
  CHECK(nlohmann::json::parse(continuum.out)["equilibria"].size() <= 1000);
}

TEST_CASE("a pair of values takes two of them, wherever the file stands") {
  const Workplace here;
  here.write("sprung.toml", "lengths = [1, 1, 1]\nstiffness = [1, 1, 1]\nrest = [-0.1, 0.3, -0.3]\n");
  for (const std::string pair :
       {"equilibria --at 0.05,0", "equilibria --force -0.1,0", "path --force -0.1,0"}) {
    CAPTURE(pair);
    const Outcome after = here.plumbline(pair + " sprung.toml");
    const std::string verb = pair.substr(0, pair.find(' '));
    CHECK(after.status == 0);
    CHECK(after.out == here.plumbline(verb + " sprung.toml" + pair.substr(verb.size())).out);
  }
}

TEST_CASE("loads that cannot be are refused in one line") {
  const Workplace here;
  here.write("zigzag.toml", zigzag);
  for (const char* arguments :
       {"path --to x", "path --to 0", "path --to -5", "path nowhere.toml",
        "path zigzag.toml --to 1 --force 1,0", "equilibria --at 1", "equilibria --at a,b",
        "equilibria --end-point 9,0", "equilibria --end-point 4,0 --certify",
        "equilibria --end-point 2,0 --certify", "figure 99", "figure 2 --out zigzag.toml"}) {
    CAPTURE(arguments);
    check_refused(here.plumbline(arguments));
  }
}

TEST_CASE("path: events to fifty digits begin with those of double precision") {
  const Workplace here;
  const Outcome outcome = here.plumbline("path --to 1 --digits 50 --json");
  REQUIRE(outcome.status == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  REQUIRE(json["events"].size() == 1);
  CHECK(json["events"][0]["kind"] == "quasi-buckling");
  const auto load = json["events"][0]["load"].get<std::string>();
  CHECK(load.size() > 50);
  CHECK(std::stod(load) == close_to(json["history"][0]["events"][0]["load"].get<double>()).epsilon(1e-9));
  CHECK(contains(here.plumbline("path --to 1 --digits 20").out, "Events to 20 digits"));
  CHECK(here.plumbline("path --digits 51").status == 2);
}

TEST_CASE("path: what is proved of it, and the exit status") {
  const Workplace here;
  const Outcome text = here.plumbline("path --to 1.5 --certify");
  CHECK(text.status == 0);
  CHECK(contains(text.out, "one smooth branch"));
  CHECK(contains(text.out, "load from 0 to 1.5: stable"));
  // by hand its critical force is 1/2, see tests/proofs/census/census.test.cpp
  here.write("straight.toml", "lengths = [1, 1]\nstiffness = [1.5, 1]\n");
  const Outcome all = here.plumbline("path straight.toml --force -1,0 --branches all --certify --json");
  CHECK(all.status == 0);
  const auto json = nlohmann::json::parse(all.out);
  REQUIRE(json["certificates"].size() == json["branches"].size());
  for (std::size_t i = 0; i < json["branches"].size(); ++i) {
    const auto &branch = json["branches"][i], &proved = json["certificates"][i];
    CHECK(proved["certified"] == true);
    CHECK(proved["failure"] == nullptr);
    CHECK(proved["gaps"].empty());
    REQUIRE(proved["pitchforks"].size() == 1);
    CHECK(proved["pitchforks"][0][0].get<double>() <= 0.5);
    CHECK(proved["pitchforks"][0][1].get<double>() >= 0.5);
    const auto& last = branch["points"].back();
    CHECK(proved["runs"].back()["to"] == last["load"]);
    CHECK(proved["runs"].back()["negative_directions"] == last["negative_directions"]);
  }
  here.write("nearly.toml", "lengths = [1, 1]\nstiffness = [1.5, 1]\nrest = [0, 1e-30]\n");
  const Outcome nearly = here.plumbline("path nearly.toml --force -0.6,0 --certify");
  CHECK(nearly.status == 0);
  CHECK(contains(nearly.out, "a bifurcation unfolded (it is proved that none is there)"));
  // less than a point's width: nothing is shown, and nothing proved
  const Outcome open = here.plumbline("path --to 1e-10 --certify");
  CHECK(open.status == 1);
  CHECK(contains(open.out, "NOT proved"));
  CHECK_FALSE(contains(here.plumbline("path --to 0.1 --json").out, "certificates"));
}

TEST_CASE("figure: two links are drawn, with a sentence") {
  const Workplace here;
  const Outcome outcome = here.plumbline("figure 2");
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "figure-02.svg"));
  CHECK(contains(outcome.out, "  confirmed: "));
  CHECK(contains(here.read("figure-02.svg"), "<svg"));
}
