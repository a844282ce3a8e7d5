/// \file
/// Tables of tendons and pressures: which columns become loads along the chain, and what stays open.

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/draft/column_words.hpp"
#include "diagnose/draft/draft.hpp"
#include "tests/close_to.hpp"

namespace plumbline::diagnose {
namespace {

using Table = std::vector<std::vector<std::string>>;

/// Two joints of a finger; its first reading is without load.
DraftModel finger() {
  return {{{0.04, 0.03}, {0.2, 0.1}, {}, {0, 0}, {0.1, 0.2}, {}}, {}, {0, 0}, false};
}

/// A column each: the title, then the values. A load up to `most` turns the joints by 0.3 and 0.4 rad.
Table bent(const std::string& title, double most) {
  Table columns{{"t"}, {title}, {"q1"}, {"q2"}};
  for (int i = 0; i <= 24; ++i) {
    const double share = (i <= 12 ? i : 24 - i) / 12.0, scatter = 0.0005 * std::sin(7.1 * i * i);
    const std::array values{2.0 * i, most * share, 0.1 + 0.3 * share + scatter, 0.2 + 0.4 * share - scatter};
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(fmt::format("{:.5g}", values[c]));
  }
  return columns;
}

std::string as_csv(const Table& columns) {
  std::string text;
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    std::vector<std::string> fields;
    for (const std::vector<std::string>& column : columns) fields.push_back(column[row]);
    text += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return text;
}

Draft drafted(const Table& columns, const Ask& ask = {}) {
  return draft_experiment("finger", finger(), {{"bend.csv", as_csv(columns)}}, ask);
}

Experiment read_drafted(const Draft& draft) {
  CAPTURE(draft.settings);
  return read_experiment("", [&](const std::string& name, const std::string& place) {
    if (name == "experiment.toml") return draft.settings;
    for (const DraftFile& table : draft.tables)
      if (table.name == name) return table.text;
    throw Error(place, name, "a table");
  });
}

/// As it is read after a person has filled in the empty lists.
Experiment filled_in(Draft draft, const std::string& list = "[0.008, 0.006]") {
  for (std::size_t at; (at = draft.settings.find(" = []")) != std::string::npos;)
    draft.settings.replace(at, 5, " = " + list);
  return read_drafted(draft);
}

bool tells(const Draft& draft, const std::string& what, const std::string& words) {
  return std::any_of(draft.guesses.begin(), draft.guesses.end(), [&](const Guess& one) {
    return one.what.find(what) != std::string::npos &&
           (one.value + " " + one.reason).find(words) != std::string::npos;
  });
}

/// The end point and the force on it that hold the finger of a bent table by its springs alone.
std::array<double, 4> held(double share) {
  const double q1 = 0.1 + 0.3 * share, q12 = q1 + 0.2 + 0.4 * share, torque1 = 0.06 * share,
               torque2 = 0.04 * share;
  const double x2 = 0.03 * std::cos(q12), y2 = 0.03 * std::sin(q12), x = 0.04 * std::cos(q1) + x2,
               y = 0.04 * std::sin(q1) + y2, moment = x * y2 - y * x2;
  return {x, y, (torque1 * x2 - torque2 * x) / moment, (torque1 * y2 - torque2 * y) / moment};
}

/// With columns of the end point and of forces on it.
Table with_forces(Table columns) {
  const std::size_t first = columns.size();
  for (const char* title : {"x", "y", "Fx", "Fy"}) columns.push_back({title});
  for (int i = 0; i <= 24; ++i) {
    const std::array<double, 4> values = held((i <= 12 ? i : 24 - i) / 12.0);
    for (std::size_t c = 0; c < values.size(); ++c)
      columns[first + c].push_back(fmt::format("{:.6g}", values[c]));
  }
  return columns;
}

}  // namespace

TEST_CASE("a tension beside joint angles is a load along the chain, its radii left to a person") {
  const Draft draft = drafted(bent("tension_N", 10));
  CAPTURE(draft.settings);
  CHECK(draft.settings.find("[[load]]\ntendon = \"tension\"\nradius = []  # fill in 2 numbers, m: ") !=
        std::string::npos);
  CHECK(draft.settings.find("covariate = { tension = { column = \"tension_N\", unit = \"N\" } }") !=
        std::string::npos);
  CHECK(draft.question.find("radius of tension") == 0);
  CHECK(draft.question.find('\n') == std::string::npos);
  CHECK(tells(draft, "load", "tendon = \"tension\""));
  CHECK(tells(draft, "control of bend.csv", "force"));

  const Experiment experiment = filled_in(draft);
  REQUIRE(experiment.loads.size() == 1);
  CHECK(experiment.loads[0].kind == Load::Kind::tendon);
  CHECK(experiment.loads[0].moment_arm == std::vector{0.008, 0.006});
  REQUIRE(experiment.runs.size() == 1);
  CHECK_FALSE(experiment.runs[0].holds_end_point());
  CHECK(experiment.runs[0].by_weights);
  CHECK(experiment.runs[0].readings[6].covariates == std::vector{5.0});
  CHECK(experiment.runs[0].readings[6][column_Fx] == 0);
  CHECK(experiment.noise[Channel::Name::q] > 0);
}

TEST_CASE("moment arms that nobody has filled in are one line of error, which names the key") {
  for (const auto& [title, key] : {std::pair("tension_N", "radius"), std::pair("pressure_kPa", "volume")}) {
    std::string message;
    try {
      read_drafted(drafted(bent(title, 10)));
    } catch (const Error& error) {
      message = error.what();
    }
    INFO(message);
    CHECK(message.find(fmt::format("load[1].{}: found 0 values", key)) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("moment arms are asked where somebody can be, in any unit") {
  const auto answer = [](const std::string& words) {
    return [words](const Guess& guess) {
      return guess.what.starts_with("radius of") || guess.what.starts_with("volume of")
                 ? std::optional<std::string>(words)
                 : std::nullopt;
    };
  };
  const Draft tendon = drafted(bent("tension_N", 10), answer("6, 4 mm"));
  CHECK(tendon.settings.find("radius = [0.006, 0.004]\n") != std::string::npos);
  CHECK(tendon.question == "");
  CHECK(tells(tendon, "radius of tension", "as you said"));
  const Draft pressure = drafted(bent("pressure_kPa", 50), answer("[1.2e-6 0]"));
  CHECK(filled_in(pressure).loads[0].moment_arm == std::vector{1.2e-6, 0.0});
  CHECK(filled_in(drafted(bent("pressure_kPa", 50), answer("1200 800 mm^3"))).loads[0].moment_arm[1] ==
        close_to(8e-7));
  for (const char* words : {"8 mm", "eight, six", "8, 6 N", ""})
    CHECK_THROWS_WITH_AS(drafted(bent("tension_N", 10), answer(words)),
                         doctest::Contains("radius of tension"), Error);
}

TEST_CASE("a pressure in its unit") {
  const Draft draft = drafted(bent("pressure_kPa", 60));
  CHECK(draft.settings.find("[[load]]\npressure = \"pressure\"\nvolume = []  # fill in 2 numbers, m^3: ") !=
        std::string::npos);
  const Experiment experiment = filled_in(draft, "[2e-6, 0]");
  CHECK(experiment.loads.at(0).kind == Load::Kind::pressure);
  CHECK(experiment.runs[0].readings[6].covariates[0] == close_to(30e3));
  CHECK(filled_in(drafted(bent("p [bar]", 2))).runs[0].readings[6].covariates[0] == close_to(1e5));
}

TEST_CASE("titles of tensions and pressures, in several tongues, with their units") {
  struct Said {
    const char* title;
    Kind kind;
    const char *unit, *variable;
  };
  for (const Said& said : std::vector<Said>{{"tension_N", Kind::tension, "N", "tension"},
                                            {"tension_kN", Kind::tension, "kN", "tension"},
                                            {"tendon force [N]", Kind::tension, "N", "tendon_force"},
                                            {"cable tension", Kind::tension, "", "cable_tension"},
                                            {"flexor_mN", Kind::tension, "mN", "flexor"},
                                            {"Seilkraft", Kind::tension, "", "seilkraft"},
                                            {"Zugkraft (kN)", Kind::tension, "kN", "zugkraft"},
                                            {"Kraft Sehne 2 [N]", Kind::tension, "N", "kraft_sehne_2"},
                                            {"pressure_kPa", Kind::pressure, "kPa", "pressure"},
                                            {"p1kPa", Kind::pressure, "kPa", "p_1"},
                                            {"p [bar]", Kind::pressure, "bar", "p"},
                                            {"chamber 2 (psi)", Kind::pressure, "lbf/in^2", "chamber_2"},
                                            {"Druck", Kind::pressure, "", "druck"},
                                            {"Kammerdruck/mbar", Kind::pressure, "mbar", "kammerdruck"}}) {
    CAPTURE(said.title);
    const ColumnWords words = words_of(said.title, "", {});
    CHECK(words.kind == said.kind);
    CHECK(words.unit == said.unit);
    CHECK(words.variable == said.variable);
  }
  CHECK(words_of("Seilkraft", "kN", {}).unit == "kN");  // of a line of units
  CHECK(words_of("Fx_kN", "", {}).unit == "kN");
}

// "ambient pressure [mbar]" is taken for a pressure by its unit.
TEST_CASE("titles with some of these words that are neither a tension nor a pressure" *
          doctest::should_fail()) {
  for (const std::string title : {"cable length [mm]", "tension [V]", "tendon velocity", "p", "chamber 1",
                                  "wire", "ambient pressure [mbar]", "muscle temperature"}) {
    CAPTURE(title);
    CHECK_FALSE(is_actuation(words_of(title, "", {}).kind));
  }
  CHECK(words_of("cable force x", "", {}).kind == Kind::force_x);
  CHECK(words_of("shoulder torque", "", {"shoulder"}).kind == Kind::torque);
}

TEST_CASE("tables in German are drafted to loads") {
  for (const auto& [title, value] : {std::pair("Seilkraft [N]", 5.0), std::pair("Zugkraft in cN", 0.05),
                                     std::pair("Druck [bar]", 5e5), std::pair("Schlauchdruck_kPa", 5e3)}) {
    CAPTURE(title);
    const Experiment experiment = filled_in(drafted(bent(title, 10)));
    REQUIRE(experiment.loads.size() == 1);
    CHECK(experiment.runs[0].readings[6].covariates[0] == close_to(value));
  }
}

TEST_CASE("a load without a unit is asked about") {
  std::vector<std::string> asked;
  const Draft draft = drafted(bent("Druck", 60), [&](const Guess& guess) -> std::optional<std::string> {
    asked.push_back(guess.what);
    return guess.what.starts_with("unit of") ? std::optional<std::string>("kPa") : std::nullopt;
  });
  CHECK(std::count(asked.begin(), asked.end(), "unit of pressure of bend.csv") == 1);
  CHECK(filled_in(draft, "[2e-6, 0]").runs[0].readings[6].covariates[0] == close_to(30e3));
  CHECK(tells(drafted(bent("Druck", 60)), "unit of pressure", "Pa"));
}

TEST_CASE("beside a force on the end point a pressure is a covariate, and the draft says so") {
  const Draft draft =
      draft_experiment("finger", finger(), {{"press.csv", as_csv(with_forces(bent("pressure_kPa", 60)))}});
  CAPTURE(draft.settings);
  CHECK(draft.settings.find("[[load]]") == std::string::npos);
  CHECK(tells(draft, "pressure of press.csv", "pressure_kPa"));
  CHECK(tells(draft, "pressure", "a covariate, as it is written, and no load along the chain"));
  const Experiment experiment = filled_in(draft);
  CHECK(experiment.loads.empty());
  CHECK(experiment.covariates == std::vector<std::string>{"pressure"});
  CHECK(experiment.runs[0].readings[6].covariates[0] == close_to(30));
  CHECK(experiment.runs[0].readings[12][column_Fx] == close_to(held(1)[2]));
}

TEST_CASE("beside a torque, or commands of the joints, a tension is a covariate") {
  Table geared = bent("tension_N", 10), servo = bent("tension_N", 10);
  geared.push_back(geared[1]);
  geared.back()[0] = "torque 1 [Nm]";
  for (const std::size_t c : {2, 3}) {
    servo.push_back(servo[c]);
    servo.back()[0] = servo[c][0] + "_cmd";
  }
  for (const Table& table : {geared, servo}) {
    const Draft draft = drafted(table);
    CAPTURE(draft.settings);
    CHECK(draft.settings.find("[[load]]") == std::string::npos);
    CHECK(tells(draft, "tension", "no load along the chain"));
    CHECK(filled_in(draft).covariates == std::vector<std::string>{"tension"});
  }
}

TEST_CASE("a temperature stays a covariate beside a load") {
  Table columns = bent("tension_N", 10);
  columns.push_back(columns[0]);
  columns.back()[0] = "T [C]";
  const Draft draft = drafted(columns);
  CHECK(tells(draft, "covariate temperature of bend.csv", "T [C]"));
  const Experiment experiment = filled_in(draft);
  CHECK(experiment.loads.size() == 1);
  CHECK(experiment.covariates == std::vector<std::string>{"tension", "temperature"});
}

TEST_CASE("the order of columns does not matter") {
  Table columns = bent("flexor tension [N]", 10);
  columns.push_back(columns[1]);
  columns.back()[0] = "extensor tension [N]";
  const std::string settings = drafted(columns).settings;
  CHECK(settings.find("tendon = \"flexor_tension\"") != std::string::npos);
  std::sort(columns.begin(), columns.end());
  int orders = 0;
  do {
    CHECK(drafted(columns).settings == settings);
    ++orders;
  } while (std::next_permutation(columns.begin(), columns.end()));
  CHECK(orders == 120);
}

TEST_CASE("several tendons are a load each") {
  Table columns = bent("tension 1 [N]", 10);
  columns.push_back(columns[1]);
  columns.back()[0] = "tension 2 [N]";
  const Draft draft = drafted(columns);
  CHECK(draft.question.find("radius of tension_1, radius of tension_2: ") == 0);
  const Experiment experiment = filled_in(draft);
  CHECK(experiment.loads.size() == 2);
  CHECK(experiment.covariates == std::vector<std::string>{"tension_1", "tension_2"});
}

TEST_CASE("of a commanded and a reached tension the reached one is the load") {
  Table columns = bent("tension_cmd_N", 10);
  columns.push_back(columns[1]);
  columns.back()[0] = "tension_N";
  const Draft draft = drafted(columns);
  CHECK(tells(draft, "tension_cmd_N of bend.csv", "left out"));
  CHECK(draft.settings.find("{ column = \"tension_N\", unit = \"N\" }") != std::string::npos);
  CHECK(filled_in(drafted(bent("tension_cmd_N", 10))).loads.size() == 1);
}

TEST_CASE("a run without the load of the others has none, which is asked about") {
  Table pressed = with_forces(bent("note", 0));
  pressed.erase(pressed.begin() + 1, pressed.begin() + 4);  // t, x, y, Fx, Fy
  const Draft draft = draft_experiment(
      "finger", finger(), {{"bend.csv", as_csv(bent("Seilkraft [N]", 10))}, {"press.csv", as_csv(pressed)}});
  CAPTURE(draft.settings);
  CHECK(tells(draft, "tension of press.csv", "0 throughout"));
  const Experiment experiment = filled_in(draft);
  CHECK(experiment.runs.at(0).readings[6].covariates == std::vector{5.0});
  CHECK(experiment.runs.at(1).readings[6].covariates == std::vector{0.0});
}

TEST_CASE("a load that one file calls so and another so is one load") {
  const Draft draft = draft_experiment(
      "finger", finger(),
      {{"bend.csv", as_csv(bent("Seilkraft [cN]", 1000))}, {"again.csv", as_csv(bent("tension_N", 10))}});
  const Experiment experiment = filled_in(draft);
  REQUIRE(experiment.loads.size() == 1);
  REQUIRE(experiment.runs.size() == 2);
  for (const Run& run : experiment.runs) CHECK(run.readings[6].covariates[0] == close_to(5));
}

TEST_CASE("a load in one file and joint angles in another are joined at the same times") {
  const Table all = bent("tension_N", 10);
  const Draft draft = draft_experiment(
      "finger", finger(),
      {{"cell.csv", as_csv({all[0], all[1]})}, {"encoders.csv", as_csv({all[0], all[2], all[3]})}});
  CHECK(tells(draft, "files of cell", "at the same times"));
  const Experiment experiment = filled_in(draft);
  REQUIRE(experiment.runs.size() == 1);
  CHECK(experiment.runs[0].readings[6].covariates == std::vector{5.0});
}

TEST_CASE("where the first reading is under load the model's rest counts") {
  Table columns = bent("tension_N", 10);
  for (std::vector<std::string>& column : columns) column.erase(column.begin() + 1, column.begin() + 7);
  const Draft draft = drafted(columns);
  CHECK(tells(draft, "rest of bend.csv", "the model's"));
  CHECK(filled_in(draft).runs[0].rest == std::vector{0.1, 0.2});
}

}  // namespace plumbline::diagnose
