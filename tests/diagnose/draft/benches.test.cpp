#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/draft/draft.hpp"
#include "diagnose/draft/told_columns.hpp"
#include "support/files/text_file.hpp"

// The tables of the examples, and those that the door once turned away (tests/tables/door): each becomes the
// experiment that is meant, or a question that names what is missing.
namespace plumbline::diagnose {
namespace {

const std::string source_folder = PLUMBLINE_SOURCE_DIR;

DraftFile of_example(const std::string& name) {
  return {name.substr(name.find('/') + 1), files::read_text(source_folder + "/docs/examples/" + name)};
}

DraftFile at_the_door(const std::string& name) {
  return {name, files::read_text(source_folder + "/tests/tables/door/" + name)};
}

DraftModel nominal_model(const std::string& nominal) {
  return {parse_nominal("[nominal]\n" + nominal, "model.toml"), {}, {0, 0}, true};
}

const char* const torsion = "joint = \"revolute\"\njoint_stiffness = [200.0]\n";
const char* const spring = "joint = \"prismatic\"\njoint_stiffness = [1220.0]\n";

Experiment read_bench(const Draft& draft) {
  return read_experiment("", [&](const std::string& name, const std::string& place) {
    if (name == "experiment.toml") return draft.settings;
    for (const DraftFile& one : draft.tables)
      if (one.name == name) return one.text;
    throw Error(place, name, "a table");
  });
}

std::size_t doubts(const Draft& draft) {
  return static_cast<std::size_t>(std::count_if(draft.guesses.begin(), draft.guesses.end(),
                                                [](const Guess& one) { return one.doubtful; }));
}

/// Drafted without a question, and with so many doubts at most.
Experiment drafted(const DraftModel& of, const std::vector<DraftFile>& files,
                   const std::vector<ToldColumn>& told = {}, std::size_t most = 0) {
  const Draft draft = draft_experiment("bench", of, files, {}, told);
  CAPTURE(draft.settings);
  for (const Guess& guess : draft.guesses)
    if (guess.doubtful) MESSAGE(guess.what, ": ", guess.value, " (", guess.reason, ")");
  CHECK(draft.question == "");
  CHECK(doubts(draft) <= most);
  return read_bench(draft);
}

constexpr double degree = 0.017453292519943295;

}  // namespace

TEST_CASE("a torque over an angle is a joint that is turned") {
  const Experiment experiment = drafted(nominal_model(torsion), {of_example("joint-loop/loop.csv")});
  REQUIRE(experiment.runs.size() == 1);
  CHECK(experiment.device == Device::turning_joint);
  CHECK(experiment.runs[0].control == Control::end_point);  // the angle
  const Reading& third = experiment.runs[0].readings[2];
  CHECK(std::abs(third[column_x] - 0.5 * degree) < 1e-9);
  CHECK(third[column_Fx] == 2.92);
}

TEST_CASE("an encoder at the motor is the command of the one at the link") {
  const Experiment experiment = drafted(nominal_model("joint = \"revolute\"\njoint_stiffness = [4000.0]\n"),
                                        {{"hold.csv",
                                          "motor_deg,link_deg,load_Nm\n0,0.0052,0\n0,0.5667,30\n"
                                          "0,1.1385,60\n0,0.5801,30\n0,-0.0014,0\n0,-0.5837,-30\n"}});
  REQUIRE(experiment.runs[0].commands_joints());
  CHECK(experiment.runs[0].readings[2][column_Fx] == 60);
  CHECK(std::abs(experiment.runs[0].readings[2][column_x] - 1.1385 * degree) < 1e-9);
}

TEST_CASE("a force over a travel is a joint that slides") {
  const Experiment experiment = drafted(nominal_model("joint = \"prismatic\"\njoint_stiffness = [4000.0]\n"),
                                        {at_the_door("buffer.csv")});
  CHECK(experiment.device == Device::sliding_joint);
  CHECK(experiment.runs[0].readings[2][column_x] == 0.001);
  CHECK(experiment.runs[0].readings[2][column_Fx] == 4.06);
}

TEST_CASE("a unit that a title says is asked about, not replaced, where the model has another size") {
  const DraftFile press = at_the_door("buffer.csv");  // stroke_mm, force_N
  const Draft draft =
      draft_experiment("buffer", nominal_model("joint = \"prismatic\"\njoint_stiffness = [4]\n"), {press});
  CHECK(draft.settings.find("\"stroke_mm\", unit = \"mm\"") != std::string::npos);
  CHECK(draft.question.find("looks like") != std::string::npos);
}

TEST_CASE("weights on a lever: the lever is asked for, and may be told") {
  const DraftModel flexure = nominal_model("joint = \"revolute\"\njoint_stiffness = [2.2]\n");
  const DraftFile weights = of_example("flexure/weights.csv");
  const Draft asked = draft_experiment("flexure", flexure, {weights});
  CHECK(asked.question.find("lever") != std::string::npos);
  CHECK(asked.question.find("--columns") != std::string::npos);
  const Experiment told = drafted(flexure, {weights}, told_columns("torque=weight_g:50 gf mm"));
  // 0.4 g of weight at 50 mm
  CHECK(std::abs(told.runs[0].readings[2][column_Fx] - 0.4e-3 * 9.80665 * 0.05) < 1e-12);
  CHECK(std::abs(told.runs[0].readings[2][column_x] - 102.1e-6) < 1e-12);
}

TEST_CASE("commands of servos and what was reached are a run of poses, a line each") {
  const Experiment poses = drafted(nominal_model("link_length = [0.30, 0.25]\njoint_stiffness = [60, 25]\n"),
                                   {of_example("poses/poses.csv")});
  REQUIRE(poses.runs.size() == 1);
  REQUIRE(poses.runs[0].commands_joints());
  CHECK(poses.runs[0].readings.size() == 8);
  CHECK(std::abs(poses.runs[0].readings[3].rest[1] - 30 * degree) < 1e-9);
  CHECK(std::abs(poses.runs[0].readings[3][column_q] - 41.25 * degree) < 1e-9);
  const Experiment sweep = drafted(nominal_model("link_length = [0.45]\njoint_stiffness = [30]\n"),
                                   {of_example("servo-arm/sweep.csv")});
  CHECK(sweep.runs[0].commands_joints());
}

TEST_CASE("a tendon: its moment arms are asked for") {
  const Draft draft = draft_experiment("finger",
                                       nominal_model("link_length = [0.045, 0.03, 0.025]\njoint_stiffness = "
                                                     "[0.16, 0.12, 0.1]\nrest = [0.17, 0.26, 0.17]\n"),
                                       {of_example("finger/bend.csv")});
  CHECK(draft.question.find("radius of tension") != std::string::npos);
}

TEST_CASE("grams on a spring are a force, by the words of the heading") {
  const Experiment experiment =
      drafted(nominal_model(spring), {at_the_door("spring-table.csv")}, {}, 1);  // which of the two is put
  const Reading& third = experiment.runs[0].readings[2];
  CHECK(third[column_x] == 0.010);
  CHECK(std::abs(third[column_Fx] - 1.310 * 9.80665) < 1e-9);
}

TEST_CASE("of raw counts and newtons the newtons are one specimen's force") {
  const Experiment experiment = drafted(nominal_model("joint = \"prismatic\"\njoint_stiffness = [250000]\n"),
                                        {at_the_door("raw-and-newtons.csv")});
  REQUIRE(experiment.runs.size() == 1);
  CHECK(experiment.runs[0].readings[2][column_Fx] == 7.5);
}

TEST_CASE("clocks of ISO 8601 and units in the cells") {
  const Experiment iso = drafted(nominal_model("joint = \"revolute\"\njoint_stiffness = [103]\n"),
                                 {at_the_door("iso-time.csv")});
  CHECK(std::abs(iso.runs[0].readings[3].t - iso.runs[0].readings[0].t - 0.3) < 1e-6);
  const Experiment cells = drafted(nominal_model(torsion), {at_the_door("degrees-in-the-cells.csv")});
  REQUIRE(cells.runs[0].commands_joints());
  CHECK(std::abs(cells.runs[0].readings[1].rest[0] + 45 * degree) < 1e-9);
  CHECK(std::abs(cells.runs[0].readings[1][column_x] + 44.7 * degree) < 1e-9);
}

TEST_CASE("two loggers on one clock are one run, at the times of the first") {
  const Experiment experiment =
      drafted(nominal_model("joint = \"prismatic\"\njoint_stiffness = [2000]\n"),
              {at_the_door("two-clocks-position.txt"), at_the_door("two-clocks-force.txt")},
              told_columns("x=displacement:in"), 1);
  REQUIRE(experiment.runs.size() == 1);
  CHECK(experiment.runs[0].readings.size() > 3);
}

TEST_CASE("columns without a header are told by their numbers") {
  const DraftModel bench = nominal_model("joint = \"prismatic\"\njoint_stiffness = [2700]\n");
  const DraftFile logger = at_the_door("logger-by-time-of-day.csv");
  CHECK_THROWS_WITH_AS(draft_experiment("bench", bench, {logger}), doctest::Contains("--columns"), Error);
  const Experiment experiment = drafted(bench, {logger}, told_columns("t=1:s,x=2:mm,Fx=3:N"));
  CHECK(experiment.runs[0].readings[4][column_x] == 0.0028);
  CHECK(experiment.runs[0].readings[4][column_Fx] == 46.7);
  CHECK(experiment.runs[0].readings[2].t - experiment.runs[0].readings[0].t == 1);
  CHECK_THROWS_WITH_AS(draft_experiment("bench", bench, {logger}, {}, told_columns("x=9:mm")),
                       doctest::Contains("the title of a column"), Error);
}

TEST_CASE("a recording of motion capture without joint angles is a question") {
  CHECK_THROWS_WITH_AS(
      draft_experiment("capture", nominal_model(torsion), {at_the_door("motion-capture.csv")}),
      doctest::Contains("--columns"), Error);
}

TEST_CASE("motor encoders beside commands and joint encoders are neither a force nor runs of their own") {
  const DraftModel arm = nominal_model("link_length = [0.3, 0.25]\njoint_stiffness = [60, 25]\n");
  const DraftFile sweep{"sweep.csv",
                        "Zeit;Soll 1;Soll 2;Motor 1;Motor 2;Gelenk 1;Gelenk 2;Bemerkung\n"
                        "hh:mm:ss;°;°;°;°;°;°;\n"
                        "14:02:11;-60,00;30,00;-60,03;30,01;-56,90;30,88;\n"
                        "14:02:15;-55,00;27,50;-55,01;27,52;-52,11;28,42;\n"
                        "14:02:19;-50,00;25,00;-50,00;25,01;-47,31;25,93;nachgestellt\n"
                        "14:02:23;-45,00;22,50;-45,02;22,50;-42,50;23,41;\n"};
  const Experiment experiment = drafted(arm, {sweep});
  REQUIRE(experiment.runs.size() == 1);
  CHECK(experiment.runs[0].commands_joints());
  CHECK(std::abs(experiment.runs[0].readings[1].rest[0] + 55 * degree) < 1e-9);
  CHECK(std::abs(experiment.runs[0].readings[1][column_q] + 52.11 * degree) < 1e-9);
}

TEST_CASE("what is written of columns is what is read") {
  for (const ChannelChoice& choice : channel_choices()) {
    CAPTURE(choice.word);
    const std::string said = choice.word + (choice.numbered ? "2" : "") + "=-a::b,,c" +
                             (choice.units.empty() ? "" : ":" + choice.units.front());
    const std::string option = columns_option(told_columns(said));
    CHECK(option == "--columns \"" + said + "\"");
  }
}

TEST_CASE("what a person says of columns") {
  const std::vector<ToldColumn> told = told_columns("Fx=-Kraft:g,q_command2=5:deg,ignore=a::b,,c");
  REQUIRE(told.size() == 3);
  CHECK(told[0].column == "Kraft");
  CHECK(told[0].words.sign == -1);
  CHECK(told[0].words.unit == "gf");
  CHECK(told[1].words.joint == 2);
  CHECK(told[1].words.commanded);
  CHECK(told[2].column == "a:b,c");
  for (const char* wrong : {"x", "x=", "force=1", "x=1:N", "=1"}) CHECK_THROWS_AS(told_columns(wrong), Error);
}

}  // namespace plumbline::diagnose
