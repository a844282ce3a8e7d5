/// \file
/// Tables as people have them: whatever the shape, the readings are those of the same runs in a file each.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

Experiment shaped(const std::string& shape) {
  return read_experiment(PLUMBLINE_SOURCE_DIR "/tests/tables/" + shape);
}

using Texts = std::map<std::string, std::string>;

Experiment read_texts(const Texts& texts) {
  return read_experiment("E", [&](const std::string& name, const std::string& place) {
    if (!texts.contains(name)) throw Error(place, name, "a file of the test");
    return texts.at(name);
  });
}

/// An experiment of two links with one run, pressed.
/// \param tables   further tables of experiment.toml
/// \param samples  the value of the key
Texts one_run(const std::string& tables, const std::string& samples, Texts files) {
  files["experiment.toml"] = R"(format = "chain-experiment/1"
name = "two"
nominal = { link_length = [0.3, 0.2], joint_stiffness = [2.0, 1.5] }
noise = { Fx = 0.02, Fy = 0.02 }
)" + tables + R"(
[[run]]
id = "press"
control = "displacement"
rest = [0.4, -0.9]
samples = )" + samples + "\n";
  return files;
}

std::string fault_of(const Texts& texts) {
  try {
    read_texts(texts);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void check_line(const std::string& message, const std::vector<std::string>& words) {
  INFO(message);
  CHECK(message.find('\n') == std::string::npos);
  for (const std::string& word : words) CHECK_MESSAGE(message.find(word) != std::string::npos, word);
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

void check_same(const Run& run, const Run& other) {
  REQUIRE(run.readings.size() == other.readings.size());
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const Reading &a = run.readings[i], &b = other.readings[i];
    CAPTURE(i);
    CHECK(same(a.t, b.t));
    // Each decimal is read to the double nearest to its value in SI, whatever its unit.
    CHECK((same(a[column_x], b[column_x]) && same(a[column_y], b[column_y]) &&
           same(a[column_Fx], b[column_Fx]) && same(a[column_Fy], b[column_Fy])));
  }
}

const std::string first_two = "t,x,y,Fx,Fy\n0,0.4518,0.0209,0,0\n1,0.4458,0.0209,-1.69,0.16\n",
                  next_two = "t,x,y,Fx,Fy\n2,0.4398,0.0209,-2.40,0.22\n3,0.4338,0.0209,-3.04,0.26\n";
const std::string places = "t,x,y\n0,0.4518,0.0209\n1,0.4458,0.0209\n",
                  forces = "t,Fx,Fy\n0,0,0\n1,-1.69,0.16\n";

}  // namespace

TEST_CASE("a table of any shape has the readings of the same runs in a file each") {
  const Experiment plain = shaped("plain");
  for (const char* shape :
       {"side-by-side", "lines", "one-after-the-other", "at-the-same-times", "temperature"}) {
    CAPTURE(shape);
    const Experiment experiment = shaped(shape);
    REQUIRE(experiment.runs.size() == plain.runs.size());
    for (std::size_t r = 0; r < plain.runs.size(); ++r) check_same(experiment.runs[r], plain.runs[r]);
  }
}

TEST_CASE("one run a column: each has its own readings under the common loads") {
  const Experiment experiment = shaped("one-run-a-column");
  REQUIRE(experiment.runs.size() == 3);
  for (const Run& run : experiment.runs) {
    CHECK(run.readings.size() == 10);
    CHECK(run.readings[1][column_Fy] == 0.5);
  }
  CHECK(experiment.runs[1].readings[1][column_y] == 0.0155);
  CHECK(std::isnan(experiment.runs[2].readings[9][column_y]));
}

TEST_CASE("a run cut into files anywhere is the same run") {
  const Run whole = shaped("plain").runs.front();
  CHECK(rc::check("any cut", [&] {
    const auto cut = *rc::gen::inRange<std::size_t>(1, whole.readings.size());
    Texts files{{"a.csv", "t,x,y,Fx,Fy\n"}, {"b.csv", "t,x,y,Fx,Fy\n"}};
    for (std::size_t i = 0; i < whole.readings.size(); ++i) {
      const Reading& r = whole.readings[i];
      files[i < cut ? "a.csv" : "b.csv"] +=
          fmt::format("{},{},{},{},{}\n", r.t, r[column_x], r[column_y], r[column_Fx], r[column_Fy]);
    }
    check_same(read_texts(one_run("", R"(["a.csv", "b.csv"])", files)).runs.front(), whole);
  }));
}

TEST_CASE("readings without a time are counted over all files of a run") {
  const Texts files{{"a.csv", "x,y,Fx,Fy\n0.4518,0.0209,0,0\n0.4458,0.0209,-1.7,0.2\n"},
                    {"b.csv", "x,y,Fx,Fy\n0.4398,0.0209,-2.4,0.2\n"}};
  CHECK(read_texts(one_run("", R"(["a.csv", "b.csv"])", files)).runs.front().readings.back().t == 2);
}

TEST_CASE("the first reading is that of the run, not of each file") {
  const std::string columns = "[columns]\nt = { zero = \"first\" }\nFx = { zero = \"first\" }\n";
  Texts files{{"a.csv", "t,x,y,Fx,Fy\n5,0.4518,0.0209,1,0\n6,0.4458,0.0209,-1,0.16\n"},
              {"b.csv", "t,x,y,Fx,Fy\n7,0.4398,0.0209,-2,0.22\n"}};
  const Reading last =
      read_texts(one_run(columns, R"(["a.csv", "b.csv"])", files)).runs.front().readings.back();
  CHECK(last.t == 2);
  CHECK(last[column_Fx] == -3);
}

TEST_CASE("files that do not fit together are refused in one line") {
  const auto fault = [](const std::string& a, const std::string& b) {
    return fault_of(one_run("", R"(["a.csv", "b.csv"])", {{"a.csv", a}, {"b.csv", b}}));
  };
  check_line(fault(places, "t,Fx,Fy\n0,0,0\n1.5,-1.69,0.16\n"),
             {"E/b.csv:3, t", "1.5", "1, the time of E/a.csv:3"});
  check_line(fault(places, "t,Fx,Fy\n0,0,0\n"), {"E/b.csv", "1 readings", "the time 1 of E/a.csv:3"});
  check_line(fault(places, forces + "2,0,0\n"), {"E/b.csv:4, t", "found 2", "2 readings, as in E/a.csv"});
  check_line(fault(places, "Fx,Fy\n0,0\n1,1\n"), {"E/b.csv", "no column of t"});
  check_line(fault(places, "t,x,Fx,Fy\n0,0.4518,0,0\n1,0.4458,0,0\n"), {"E/b.csv", "x as in E/a.csv"});
  check_line(fault(next_two, first_two), {"E/b.csv:2, t", "found 0", "the part before"});
  check_line(fault("t,x\n0,0.4518\n1,0.4458\n", forces),
             {"E/a.csv:1", "no column 'y', which the run imposes"});
  check_line(fault_of(one_run("", "[]", {})), {"samples", "names of sample files"});
  check_line(fault_of(one_run("", "[3]", {})), {"samples", "names of sample files"});
  check_line(fault_of(one_run("", R"([{ csv = { decimal = "," } }])", {})),
             {"samples[1].file", "no such key"});
  check_line(fault_of(one_run("", R"(["a.csv", "b.csv", "c.csv"])",
                              {{"a.csv", places}, {"b.csv", forces}, {"c.csv", forces}})),
             {"E/c.csv", "the channels of E/b.csv"});
}

TEST_CASE("sheets that are no tables are refused in one line") {
  const auto fault = [](const std::string& tables, const std::string& text) {
    return fault_of(one_run(tables, "\"sheet.csv\"", {{"sheet.csv", text}}));
  };
  check_line(fault("", ""), {"E/sheet.csv", "blank lines alone"});
  check_line(fault("[csv]\ntransposed = true\n", ""), {"E/sheet.csv", "blank lines alone"});
  check_line(fault("[csv]\ntransposed = true\n", "t,0,1\nx,0.45\n"),
             {"E/sheet.csv:2", "2 fields", "3, as in the first line"});
  check_line(fault("[csv]\ntransposed = true\n", "t\nx\ny\nFx\nFy\n"), {"E/sheet.csv", "a header alone"});
  check_line(fault("[csv]\ntransposed = true\n", "t,0,1\nx,0.4518,z\ny,0.0209,0.0209\nFx,0,0\nFy,0,0\n"),
             {"E/sheet.csv, field 3, x", "'z'"});
  check_line(fault("[columns]\nFx = \"F\"\n", "x,y,F,F,Fy\n0.45,0.02,1,2,3\n"),
             {"E/sheet.csv:1", "2 columns of one name", "a number says which one"});
  // A block that stops in the middle is no end.
  check_line(fault("[columns]\n", "x,y,Fx,Fy\n0.45,0.02,1,2\n,,,\n0.45,0.02,1,2\n"),
             {"E/sheet.csv:3", "an empty imposed channel"});
}

TEST_CASE("a covariate is interpolated in time where it was not noted") {
  const Experiment experiment = shaped("temperature");
  CHECK(experiment.covariates == std::vector<std::string>{"temperature"});
  const Run& run = experiment.runs.front();
  CHECK(run.interpolated == std::vector<std::size_t>{10});
  // 21.0 and 21.4 °C at 0 and 8 s, less 20; what is interpolated is rounded a few times
  CHECK(run.readings[0].covariates[0] == 1);
  CHECK(run.readings[4].covariates[0] == doctest::Approx(1.4).epsilon(1e-12));
  CHECK(run.readings[1].covariates[0] == doctest::Approx(1.1).epsilon(1e-12));
}

TEST_CASE("a covariate that is linear in time is found again wherever it was noted twice") {
  CHECK(rc::check("linear", [] {
    const auto noted = *rc::gen::container<std::vector<bool>>(12, rc::gen::arbitrary<bool>());
    std::string text = "t,x,y,Fx,Fy,T\n";
    for (std::size_t i = 0; i < noted.size(); ++i) {
      const bool here = noted[i] || i == 0 || i + 1 == noted.size();
      text += fmt::format("{},0.45,0.02,0,0,{}\n", i * i, here ? fmt::format("{}", 20 + 3 * i * i) : "");
    }
    const Run run =
        read_texts(one_run("[columns.covariate]\nT = \"T\"\n", "\"a.csv\"", {{"a.csv", text}})).runs[0];
    for (const Reading& one : run.readings)
      RC_ASSERT(std::abs(one.covariates[0] - (20 + 3 * one.t)) < 1e-11);  // of values up to 400
  }));
}

TEST_CASE("covariates that cannot be used are refused in one line") {
  const auto fault = [](const std::string& covariate, const std::string& text) {
    return fault_of(one_run("[columns.covariate]\n" + covariate + "\n", "\"a.csv\"", {{"a.csv", text}}));
  };
  const std::string header = "t,x,y,Fx,Fy,T\n";
  check_line(fault("T = \"T\"", header + "0,0.45,0.02,0,0,\n1,0.45,0.02,0,0,\n"),
             {"no value of T in run \"press\""});
  check_line(fault("T = \"T\"", first_two), {"E/a.csv:1", "columns.covariate.T names"});
  check_line(fault("q = \"T\"", header), {"columns.covariate.q", "a covariate of that name"});
  check_line(fault("\"room T\" = \"T\"", header), {"a covariate of that name"});
  check_line(fault("T = { column = \"T\", unit = \"K\" }", header),
             {"columns.covariate.T.unit", "an unknown key"});
  Texts texts = one_run("", "\"a.csv\"\ncolumns = { covariate = { T = \"T\" } }",
                        {{"a.csv", header + "0,0.45,0.02,0,0,1\n1,0.45,0.02,0,0,2\n"}, {"b.csv", first_two}});
  texts["experiment.toml"] +=
      "[[run]]\nid = \"b\"\ncontrol = \"displacement\"\nrest = [0.4, -0.9]\nsamples = \"b.csv\"\n";
  check_line(fault_of(texts), {"run \"b\" with no covariate", "the covariates T, as in the first run"});
}

TEST_CASE("runs that go on where the one before ends are one run, others are not") {
  const auto in_two = [&](const std::string& second) {
    std::string toml = one_run("", "\"a.csv\"", {}).at("experiment.toml");
    toml +=
        "[[run]]\nid = \"rest of it\"\ncontrol = \"displacement\"\nrest = [0.4, -0.9]\nsamples = \"b.csv\"\n";
    return read_texts({{"experiment.toml", toml}, {"a.csv", first_two}, {"b.csv", second}});
  };
  const Experiment joined = in_two(next_two);
  REQUIRE(joined.runs.size() == 1);
  CHECK(joined.runs[0].continued_by == std::vector<std::string>{"rest of it"});
  CHECK(joined.runs[0].readings.size() == 4);
  // later by more than two steps of a second; earlier; elsewhere; from the unloaded end point
  CHECK(in_two("t,x,y,Fx,Fy\n4,0.4398,0.0209,-2.40,0.22\n5,0.4338,0.0209,-3.04,0.26\n").runs.size() == 2);
  CHECK(in_two("t,x,y,Fx,Fy\n0,0.4398,0.0209,-2.40,0.22\n1,0.4338,0.0209,-3.04,0.26\n").runs.size() == 2);
  CHECK(in_two("t,x,y,Fx,Fy\n2,0.4298,0.0209,-2.40,0.22\n3,0.4338,0.0209,-3.04,0.26\n").runs.size() == 2);
  CHECK(in_two("t,x,y,Fx,Fy\n2,0.4518,0.0209,0,0\n3,0.4458,0.0209,-1.7,0.16\n").runs.size() == 2);
}
