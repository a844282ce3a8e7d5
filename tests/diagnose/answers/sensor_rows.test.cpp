/// Errors of the sensors and drives of a servo arm that is written as a user writes it: joint angles are
/// read, and a camera sees the end. A planar chain and an arm in space name the same one.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "tests/folder.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

constexpr double angle_noise = 2e-4, place_noise = 5e-5;

const char* const chain = R"(format = "chain-experiment/1"
name = "chain"
[nominal]
link_length = [0.3, 0.25]
joint_stiffness = [60, 25]
link_mass = [1.2, 0.8]
gravity = [0, -9.81]
[bench]
gravity_plane = "vertical"
[noise]
q = 2e-4
x = 5e-5
y = 5e-5
[[run]]
id = "sweep"
control = "command"
samples = "t.csv"
)";

const char* const arm = R"(format = "chain-experiment/1"
name = "arm"
[arm]
gravity = [0, -9.81, 0]
tip_xyz = [0.25, 0, 0]
[[arm.joint]]
name = "shoulder"
link = "upper"
kind = "revolute"
axis = [0, 0, 1]
stiffness = 60
mass = 1.2
centre = [0.15, 0, 0]
[[arm.joint]]
name = "elbow"
link = "fore"
kind = "revolute"
xyz = [0.3, 0, 0]
axis = [0, 0, 1]
stiffness = 25
mass = 0.8
centre = [0.125, 0, 0]
[noise]
q = 2e-4
place = 5e-5
[[run]]
id = "sweep"
samples = "t.csv"
)";

struct Row {
  double t;
  std::array<double, 2> command, angle, place;
};

/// Joints that are swept at changing speeds, read every 0.4 s.
std::vector<Row> swept() {
  std::vector<Row> rows;
  for (int i = 0; i < 40; ++i) {
    const double t = 0.4 * i + 0.05 * (i % 3);
    const double first = 0.8 * std::sin(0.35 * t), second = 0.5 + 0.6 * std::sin(0.61 * t + 1);
    rows.push_back({t,
                    {first, second},
                    {first, second},
                    {0.3 * std::cos(first) + 0.25 * std::cos(first + second),
                     0.3 * std::sin(first) + 0.25 * std::sin(first + second)}});
  }
  return rows;
}

std::string table(const std::vector<Row>& rows, bool in_space) {
  std::string text =
      std::string("t,q_command1,q_command2,q1,q2,") + (in_space ? "tip_x,tip_y,tip_z\n" : "x,y\n");
  for (const Row& one : rows)
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}{}\n", one.t, one.command[0],
                        one.command[1], one.angle[0], one.angle[1], one.place[0], one.place[1],
                        in_space ? ",0" : "");
  return text;
}

Study study_of(const char* settings, const std::string& samples) {
  const Folder folder;
  folder.write("experiment.toml", settings);
  folder.write("t.csv", samples);
  return Study(read_experiment(folder.path()));
}

/// The table of a chain with this cause in it.
std::vector<Row> planted(const EffectAt& cause, const std::vector<double>& values) {
  std::vector<Row> rows = swept();
  const Prediction truth = predict(study_of(chain, table(rows, false)), {{cause}}, values);
  REQUIRE(truth.reached);
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto read = truth.runs[0].row(static_cast<Eigen::Index>(r));
    for (std::size_t i = 0; i < 2; ++i) {
      const auto at = static_cast<std::ptrdiff_t>(i);
      rows[r].angle[i] = read(column_q + at) + angle_noise * normal(engine);
      rows[r].place[i] = read(column_x + at) + place_noise * normal(engine);
    }
  }
  return rows;
}

const char* const joint_alone = R"(format = "chain-experiment/1"
name = "a joint, loaded by a servo with a cell, beside a second cell"
[nominal]
joint = "{}"
joint_stiffness = [40]
[noise]
{} = 2e-4
{}_2 = 0.01
[[run]]
id = "load"
control = "{}"
samples = "t.csv"
)";

/// A joint alone, turning or sliding, whose second sensor has this error.
void check_named_alone(bool slides, const EffectAt& cause, const std::vector<double>& values) {
  const std::string place = slides ? "x" : "angle", load = slides ? "Fx" : "torque";
  const std::string settings = fmt::format(fmt::runtime(joint_alone), slides ? "prismatic" : "revolute",
                                           place, load, slides ? "force" : "torque");
  const auto table = [&](const Trace* read) {
    std::mt19937 engine(9);
    std::normal_distribution<double> normal;
    std::string text = fmt::format("t,{0},{1},{1}_2\n", place, load);
    for (int i = 0; i < 40; ++i) {
      const double t = 0.4 * i + 0.05 * (i % 3), imposed = 4 * std::sin(0.5 * t) * (1 + 0.02 * t);
      double at = imposed / 40, second = imposed;
      if (read != nullptr) {
        at = (*read)(i, column_x) + 2e-4 * normal(engine);
        second = (*read)(i, column_Fx_2) + 0.01 * normal(engine);
      }
      text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", t, at, imposed, second);
    }
    return text;
  };
  const Prediction truth = predict(study_of(settings.c_str(), table(nullptr)), {{cause}}, values);
  REQUIRE(truth.reached);
  const Diagnosis found = diagnose::diagnose(study_of(settings.c_str(), table(&truth.runs[0])));
  CAPTURE(cause.name());
  CAPTURE(slides);
  REQUIRE(!found.cause.ranking.empty());
  CHECK(found.cause.named == 1);
  CHECK(found.cause.ranking[0].cause.label() == cause.label());
}

/// The form of a row that is not the first of its id.
const Effect& second_form(std::string_view id) {
  for (const Effect& row : catalogue())
    if (row.id == id && !row.form.empty()) return row;
  FAIL("one form");
  return catalogue().front();
}

void check_named(const EffectAt& cause, const std::vector<double>& values) {
  const std::vector<Row> rows = planted(cause, values);
  for (const bool in_space : {false, true}) {
    CAPTURE(cause.name());
    CAPTURE(in_space);
    const Diagnosis found = diagnose::diagnose(study_of(in_space ? arm : chain, table(rows, in_space)));
    REQUIRE(!found.cause.ranking.empty());
    CHECK(found.cause.named == 1);
    CHECK(found.cause.ranking[0].cause.label() == cause.label());
    const Estimate& amount = found.estimates.at(0).at(0);
    // 95 % bounds, of which one in twenty misses: half as wide again
    CHECK(std::abs(amount.value - values[0]) < 0.75 * (amount.high - amount.low));
  }
}

}  // namespace

TEST_CASE("a camera that is late is late, by a delay and by a time constant" * doctest::test_suite("long")) {
  check_named({second_form("place_lag"), 0}, {0.12});
  check_named({"place_lag"}, {0.12});
}

TEST_CASE("angles that are read late are late, beside a camera") {
  check_named({second_form("angle_lag"), 0}, {0.1});
}

TEST_CASE("a second cell of a joint alone, turning or sliding, has a zero, drifts or is late" *
          doctest::test_suite("long")) {
  for (const bool slides : {false, true}) {
    check_named_alone(slides, {"second_zero"}, {0.1});
    check_named_alone(slides, {"second_drift"}, {0.01});
    check_named_alone(slides, {second_form("second_lag"), 0}, {0.1});
  }
}

TEST_CASE("angles drift, and talk into each other" * doctest::test_suite("long")) {
  check_named({"angle_drift", 2}, {4e-4});
  check_named({"angle_cross_talk", 1}, {0.03});
}

TEST_CASE("a frame of places drifts, and a camera's axes are not square" * doctest::test_suite("long")) {
  check_named({"place_drift"}, {1e-4, -5e-5});
  check_named({"camera_skew"}, {0.01});
}

TEST_CASE("a drive follows with a time constant, and the zero of a command drifts" *
          doctest::test_suite("long")) {
  check_named({second_form("command_delay"), 0}, {0.12});
  check_named({"command_drift", 1}, {6e-4});
}
