/// \file
/// Drafts of tables as people have them: each run is found, whatever the shape (tests/tables).

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/draft/draft.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

const std::string shapes_folder = PLUMBLINE_SOURCE_DIR "/tests/tables/";

DraftFile table_in(const std::string& shape, const std::string& name) {
  return {name, files::read_text(shapes_folder + shape + "/" + name)};
}

DraftModel pressed_arm() {
  return {{{0.3, 0.2}, {2.0, 1.5}, {}, {0, 0}, {0.4, -0.9}, {}}, {"shoulder", "elbow"}, {0, 0}, true};
}

Experiment as_read(const Draft& draft) {
  return read_experiment("", [&](const std::string& name, const std::string& place) {
    if (name == "experiment.toml") return draft.settings;
    for (const DraftFile& table : draft.tables)
      if (table.name == name) return table.text;
    throw Error(place, name, "a table");
  });
}

bool guesses(const Draft& draft, const std::string& what, const std::string& words) {
  return std::any_of(draft.guesses.begin(), draft.guesses.end(), [&](const Guess& one) {
    return one.what.find(what) != std::string::npos &&
           (one.value + " " + one.reason).find(words) != std::string::npos;
  });
}

/// The readings of the runs in a file each, to the rounding of a unit that was converted.
void check_as_plain(const Draft& draft) {
  CAPTURE(draft.settings);
  const Experiment plain = read_experiment(shapes_folder + "plain"), drafted = as_read(draft);
  REQUIRE(drafted.runs.size() == plain.runs.size());
  for (std::size_t r = 0; r < plain.runs.size(); ++r) {
    CHECK(drafted.runs[r].holds_end_point());
    REQUIRE(drafted.runs[r].readings.size() == plain.runs[r].readings.size());
    for (std::size_t i = 0; i < plain.runs[r].readings.size(); ++i) {
      const Reading &a = drafted.runs[r].readings[i], &b = plain.runs[r].readings[i];
      CHECK(std::abs(a[column_x] - b[column_x]) + std::abs(a[column_y] - b[column_y]) < 1e-12);
      CHECK(std::abs(a[column_Fx] - b[column_Fx]) + std::abs(a[column_Fy] - b[column_Fy]) < 1e-12);
    }
  }
}

}  // namespace

TEST_CASE("blocks of columns side by side are a run each") {
  const Draft draft = draft_experiment("press", pressed_arm(), {table_in("side-by-side", "sheet.csv")});
  CHECK(guesses(draft, "runs in sheet.csv", "2 side by side"));
  check_as_plain(draft);
}

TEST_CASE("lines that are columns, side by side: a run each") {
  // The draft takes no field between a name and its numbers for units.
  std::string text = table_in("lines", "lines.csv").text;
  for (const char* unit : {",s,", ",m,", ",N,"})
    for (std::size_t at; (at = text.find(unit)) != std::string::npos;) text.replace(at, 3, ",");
  const Draft draft = draft_experiment("press", pressed_arm(), {{"lines.csv", text}});
  CHECK(guesses(draft, "transposed", "each line is a column"));
  check_as_plain(draft);
}

TEST_CASE("a file that goes on where another ends is a part of its run") {
  const Draft draft = draft_experiment(
      "press", pressed_arm(),
      {table_in("one-after-the-other", "a-1.csv"), table_in("one-after-the-other", "a-2.csv"),
       table_in("one-after-the-other", "b.csv")});
  CHECK(guesses(draft, "files of a-1", "goes on where the first ends"));
  check_as_plain(draft);
}

TEST_CASE("forces and places in files of their own are joined at the same times") {
  std::vector<DraftFile> files;
  for (const char* name : {"cell-a.csv", "camera-a.csv", "cell-b.csv", "camera-b.csv"})
    files.push_back(table_in("at-the-same-times", name));
  // Both loggers count in seconds: the draft compares times as they are written.
  for (DraftFile& file : files)
    for (std::size_t at; (at = file.text.find("000;")) != std::string::npos;) file.text.erase(at, 3);
  for (DraftFile& file : files)
    if (const std::size_t at = file.text.find("ms;"); at != std::string::npos) file.text.erase(at, 1);
  const Draft draft = draft_experiment("press", pressed_arm(), files);
  CHECK(guesses(draft, "files of cell-a", "at the same times"));
  check_as_plain(draft);
}

TEST_CASE("loggers at other times of one clock are joined at the times of the first") {
  const Draft draft =
      draft_experiment("press", pressed_arm(),
                       {{"cell.csv", "t,Fx,Fy\n0,0,0\n1,-1.7,0.2\n2,-2.4,0.2\n"},
                        {"camera.csv", "t,x,y\n0,0.4518,0.0209\n1.5,0.4428,0.0209\n2.5,0.4368,0.0209\n"}});
  CHECK(guesses(draft, "files of cell.csv", "joined with camera.csv"));
  const Experiment experiment = as_read(draft);
  REQUIRE(experiment.runs.size() == 1);
  // between 0 and 1.5 s the place goes straight
  CHECK(std::abs(experiment.runs[0].readings[1][column_x] - (0.4518 - 0.009 / 1.5)) < 1e-9);
}

TEST_CASE("a column for each specimen under common loads is a run each, which is asked about") {
  const DraftModel lever{{{0.25}, {2.0}, {}, {0, 0}, {0}, {}}, {"hinge"}, {0, 0}, true};
  std::string text = table_in("one-run-a-column", "levers.csv").text;
  text.replace(0, 4, "Fy");  // "load" alone would be along x
  std::vector<std::string> asked;
  const Draft draft = draft_experiment("levers", lever, {{"levers.csv", text}},
                                       [&](const Guess& guess) -> std::optional<std::string> {
                                         asked.push_back(guess.what);
                                         return {};
                                       });
  CAPTURE(draft.settings);
  CHECK(guesses(draft, "runs in levers.csv", "3 side by side"));
  CHECK(draft.settings.find("\"specimen 3\"") != std::string::npos);
}

// Known defect: a table whose last column is mostly empty loses its header.
TEST_CASE("a temperature is a covariate where every run has it, though it has few values") {
  const Draft both = draft_experiment("press", pressed_arm(),
                                      {table_in("temperature", "a.csv"), table_in("temperature", "b.csv")});
  CHECK(as_read(both).covariates == std::vector<std::string>{"temperature"});
  check_as_plain(both);
  const Draft one = draft_experiment("press", pressed_arm(),
                                     {table_in("temperature", "a.csv"), table_in("plain", "b.csv")});
  CHECK(as_read(one).covariates.empty());
  check_as_plain(one);
}

TEST_CASE("a command to every joint along a time is imposed") {
  std::string text = "t,shoulder_cmd,elbow_cmd,shoulder,elbow\n";
  for (int i = 0; i < 12; ++i)
    text += std::to_string(i) + ",0." + std::to_string(10 + i) + ",-0." + std::to_string(20 + i) + ",0." +
            std::to_string(10 + i) + "1,-0." + std::to_string(20 + i) + "1\n";
  const Experiment experiment = as_read(draft_experiment("sweep", pressed_arm(), {{"sweep.csv", text}}));
  REQUIRE(experiment.runs.size() == 1);
  CHECK(experiment.runs[0].commands_joints());
  CHECK(experiment.runs[0].readings[3].rest == std::vector<double>{0.13, -0.23});
}

TEST_CASE("a damaged workbook is one line of error") {
  CHECK_THROWS_WITH_AS(draft_experiment("press", pressed_arm(), {{"press.xlsx", "PK\x03\x04..."}}),
                       doctest::Contains("press.xlsx: found no list of its files"), Error);
}

}  // namespace plumbline::diagnose
