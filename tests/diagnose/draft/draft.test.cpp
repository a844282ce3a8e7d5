#include "diagnose/draft/draft.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/rig/nominal.hpp"
#include "diagnose/rig/run_rig.hpp"
#include "diagnose/screening/conventions.hpp"
#include "tests/close_to.hpp"

// An arm that is pressed, written down as labs do it: whatever the writing, the experiment that is drafted
// has the readings that were taken.
namespace plumbline::diagnose {
namespace {

/// Two links, pressed from their rest towards the base and back; forces by their springs, a friction beside.
struct Lab {
  NominalChain chain{{0.3, 0.2}, {2.0, 1.5}, {}, {0, 0}, {0.4, -0.9}, {}};
  std::vector<Reading> readings;

  Lab() {
    Experiment experiment;
    static_cast<NominalChain&>(experiment) = chain;
    experiment.name = "press";
    experiment.bench.plane = Bench::Plane::horizontal;
    experiment.noise = {0, 0, 0.02, 0.02, 0};
    Run run{"press", Control::end_point, chain.rest, {}};
    for (int i = 0; i <= 32; ++i) {
      const double way = 0.0015 * (i <= 16 ? i : 32 - i);
      const double x = 0.3 * std::cos(0.4) + 0.2 * std::cos(-0.5) - way,
                   y = 0.3 * std::sin(0.4) + 0.2 * std::sin(-0.5);
      run.readings.push_back({static_cast<double>(i), {x, y, 0, 0}});
    }
    experiment.runs = {run};
    const Trace pressed = simulate(experiment, nominal_rig(experiment), {}).runs.front();
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      Reading& r = run.readings[i];
      const auto row = static_cast<Eigen::Index>(i);
      // a load cell that scatters, the same at every call
      r[column_Fx] =
          pressed(row, Channel(Channel::Name::Fx).column) + 0.02 * std::sin(7.1 * static_cast<double>(i * i));
      r[column_Fy] = pressed(row, Channel(Channel::Name::Fy).column) +
                     0.02 * std::sin(5.3 * static_cast<double>(i * i + 1));
    }
    readings = run.readings;
  }
};

/// How a lab writes.
struct Writing {
  std::string header, between;
  char decimal = '.';
  double place = 1, force = 1;  ///< so many of the lab's units are one of SI
  double x0 = 0, y0 = 0;        ///< m, where the lab counts from
};

std::string number(double value, char decimal) {
  std::string text = fmt::format("{:.7g}", value);
  if (decimal == ',') std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::string written(const Lab& lab, const Writing& w) {
  std::string text = w.header;
  for (const Reading& r : lab.readings) {
    text += number(r.t, w.decimal);
    for (const double value : {(r[column_x] + w.x0) * w.place, (r[column_y] + w.y0) * w.place,
                               r[column_Fx] * w.force, r[column_Fy] * w.force})
      text += w.between + number(value, w.decimal);
    text += "\n";
  }
  return text;
}

Experiment read(const Draft& draft) {
  return read_experiment("", [&](const std::string& name, const std::string& place) {
    if (name == "experiment.toml") return draft.settings;
    for (const DraftFile& table : draft.tables)
      if (table.name == name) return table.text;
    throw Error(place, name, "a table");
  });
}

void check_read(const Lab& lab, const Draft& draft) {
  CAPTURE(draft.settings);
  CHECK(draft.question == "");
  const Experiment experiment = read(draft);
  REQUIRE(experiment.runs.size() == 1);
  const Run& run = experiment.runs.front();
  CHECK(run.holds_end_point());
  REQUIRE(run.readings.size() == lab.readings.size());
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    // seven digits were written
    CHECK(std::abs(run.readings[i][column_x] - lab.readings[i][column_x]) < 1e-6);
    CHECK(std::abs(run.readings[i][column_y] - lab.readings[i][column_y]) < 1e-6);
    CHECK(std::abs(run.readings[i][column_Fx] - lab.readings[i][column_Fx]) < 1e-5);
    CHECK(std::abs(run.readings[i][column_Fy] - lab.readings[i][column_Fy]) < 1e-5);
  }
}

DraftModel model_of(const Lab& lab, std::array<double, 2> base = {0, 0}) {
  return {lab.chain, {"shoulder", "elbow"}, base, true};
}

bool says(const Draft& draft, const std::string& what, const std::string& value) {
  return std::any_of(draft.guesses.begin(), draft.guesses.end(), [&](const Guess& guess) {
    return guess.what.find(what) != std::string::npos && guess.value.find(value) != std::string::npos &&
           !guess.reason.empty();
  });
}

}  // namespace

TEST_CASE("a table in any lab's writing is drafted to the readings that were taken") {
  const Lab lab;
  for (const Writing& writing :
       {Writing{"t,x,y,Fx,Fy\n", ","}, Writing{"Time;x_mm;y_mm;Kraft_x;Kraft_y\n", ";", ',', 1000},
        Writing{"Bench 3\n\nt\tX [mm]\tY [mm]\tFx [kgf]\tFy [kgf]\n", "\t", '.', 1000, 1 / 9.80665},
        Writing{"zeit;x;y;Fx;Fy\ns;mm;mm;N;N\n", ";", ',', 1000}, Writing{"# t x y Fx Fy\n", "  "},
        Writing{"t,x,y,Fx,Fy\n", ",", '.', 1000},
        Writing{"time (s) | tip x (cm) | tip y (cm) | force x (N) | force y (N)\n", " | ", '.', 100},
        Writing{"t,x,y,Fx,Fy\n", ",", '.', 1, -1}, Writing{"t,x,y,Fx,Fy\n", ",", '.', 1, 1 / 9.80665},
        Writing{"t,x,y,Fx,Fy\n", ",", '.', 1000, -1}}) {
    CAPTURE(writing.header);
    CAPTURE(writing.place);
    CAPTURE(writing.force);
    check_read(lab, draft_experiment("press", model_of(lab), {{"press.csv", written(lab, writing)}}));
  }
}

TEST_CASE("what is guessed is said with its reason") {
  const Lab lab;
  const Draft draft = draft_experiment(
      "press", model_of(lab), {{"press.csv", written(lab, {"Zeit;x;y;Fx;Fy\n", ";", ',', 1000, -1})}});
  CHECK(says(draft, "delimiter", ";"));
  CHECK(says(draft, "decimal", ","));
  CHECK(says(draft, "unit of x, y", "mm"));
  CHECK(says(draft, "control", "displacement"));
  CHECK(says(draft, "Fx, Fy", "opposite sign"));
  CHECK(draft.settings.starts_with("#:schema experiment.schema.json\n"));
  CHECK(draft.settings.find("gravity_plane = \"horizontal\"") != std::string::npos);
}

TEST_CASE("samples that count from the model's origin are counted from its first joint") {
  const Lab lab;
  const Draft draft =
      draft_experiment("press", model_of(lab, {0.6, 0.1}),
                       {{"press.csv", written(lab, {"t,x,y,Fx,Fy\n", ",", '.', 1000, 1, 0.6, 0.1})}});
  CHECK(says(draft, "zero of x, y", "0.6, 0.1"));
  check_read(lab, draft);
}

TEST_CASE("runs in one table are cut apart by the column that names them") {
  const Lab lab;
  std::string text = "trial,t,x,y,Fx,Fy\n";
  for (const char* trial : {"a", "b"})
    for (const Reading& r : lab.readings)
      text += fmt::format("{},{},{:.7g},{:.7g},{:.7g},{:.7g}\n", trial, r.t, r[column_x], r[column_y],
                          r[column_Fx], r[column_Fy]);
  const Draft draft = draft_experiment("press", model_of(lab), {{"all.csv", text}});
  CHECK(draft.tables.size() == 2);
  CHECK(read(draft).runs.size() == 2);
  CHECK(says(draft, "runs in all.csv", "2"));
}

TEST_CASE("an arm that is held by its servos: a run of commands, a line each") {
  DraftModel model{
      {{0.3, 0.2}, {50, 40}, {0.3, 0.2}, {0, -9.81}, {0, 0}, {}}, {"shoulder", "elbow"}, {0, 0}, true};
  const Draft draft = draft_experiment(
      "poses", model,
      {{"poses.csv",
        "shoulder_cmd,elbow_cmd,shoulder,elbow\n30,40,28.9,39.6\n50,10,48.8,9.6\n70,-20,68.9,-20.1\n"}});
  const Experiment experiment = read(draft);
  REQUIRE(experiment.runs.size() == 1);
  CHECK(experiment.runs[0].commands_joints());
  CHECK(experiment.runs[0].readings[1].rest[0] == close_to(50 * std::numbers::pi / 180));
  CHECK(experiment.runs[0].readings[1][column_q + 1] == close_to(9.6 * std::numbers::pi / 180));
}

TEST_CASE("a person who is asked is heard") {
  const Lab lab;
  DraftModel model = model_of(lab);
  model.chain.link_length = {0.2, 0.15, 0.15}, model.chain.joint_stiffness = {2, 1, 1},
  model.chain.rest = {0, 0, 0};
  std::vector<std::string> asked;
  const Draft draft = draft_experiment(
      "press", model, {{"press.csv", written(lab, {"t,x,y,Fx,Fy\n", ","})}},
      [&](const Guess& guess) -> std::optional<std::string> {
        asked.push_back(guess.what);
        return guess.what.starts_with("rest") ? std::optional<std::string>("0.2, -0.3, 0.4") : std::nullopt;
      });
  CHECK(std::find(asked.begin(), asked.end(), "rest of press.csv") != asked.end());
  CHECK(draft.settings.find("rest = [0.2, -0.3, 0.4]") != std::string::npos);
}

TEST_CASE("a rest that no table says is asked for, though nothing else is odd") {
  const Lab lab;
  DraftModel model = model_of(lab);
  model.chain.link_length = {0.2, 0.15, 0.15}, model.chain.joint_stiffness = {2, 1, 1},
  model.chain.rest = {0, 0, 0};
  const Draft draft = draft_experiment("press", model, {{"press.csv", written(lab, {"t,x,y,Fx,Fy\n", ","})}});
  CHECK(draft.question != "");
}

TEST_CASE("what is no table is refused in one line") {
  const Lab lab;
  for (const auto& [text, words] :
       {std::pair("a\nb\n", "no rows of numbers"), std::pair("name,colour\nx,red\n", "no rows of numbers"),
        std::pair("p1,p2\n1,2\n3,4\n", "a name that says x, y")})
    CHECK_THROWS_WITH_AS(draft_experiment("press", model_of(lab), {{"bad.csv", text}}),
                         doctest::Contains(words), Error);
  const std::string good = written(lab, {"t,x,y,Fx,Fy\n", ","});
  CHECK_THROWS_WITH_AS(draft_experiment("press", model_of(lab), {{"a.csv", good}, {"a.csv", good}}),
                       doctest::Contains("a table of this name already"), Error);
  CHECK_THROWS_WITH_AS(draft_experiment("press", model_of(lab), {}), doctest::Contains("none"), Error);
}

}  // namespace plumbline::diagnose
