#include "diagnose/screening/stuck_channel.hpp"

#include <doctest/doctest.h>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/screening/question.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// The convention asked about; empty where none is. Whether the readings are physical at all is asked before,
/// elsewhere.
std::string asked(const Experiment& experiment) {
  try {
    require_conventions(Study(experiment));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Two presses of three centimetres of the nominal model, with noise of the declared size.
Experiment still_bench(int steps = 10) {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.03, 0}, steps, false);
  press(experiment, {0.3, -0.5, 0.4}, {-0.03, 0.01}, steps, false);
  return measured(experiment, {}, {}, 3);
}

void hold(Run& run, const Channel& channel, double value) {
  for (Reading& reading : run.readings) channel.in(reading) = value;
}

const Channel Fy{Channel::Name::Fy};

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a column of zeros raises a question, in all runs or in those that have it") {
  Experiment experiment = still_bench();
  CHECK_FALSE(stuck_channel(Study(experiment)));
  hold(experiment.runs[1], Fy, 0);
  const auto one = stuck_channel(Study(experiment));
  REQUIRE(one);
  CHECK(one->channel == Fy);
  CHECK(one->runs == std::vector<std::string>{"press-2"});
  CHECK(one->values == std::set<double>{0});
  CHECK(one->readings == 11);
  const Trace& nominal = Study(experiment).nominal().runs[1];
  CHECK(one->predicted_range ==
        close_to(nominal.col(Fy.column).maxCoeff() - nominal.col(Fy.column).minCoeff()));
  CHECK(says(asked(experiment), "three links, run press-2, Fy: found 0 N in all 11 readings"));
  CHECK(says(asked(experiment), "leave its fields empty there"));
  hold(experiment.runs[0], Fy, 0);
  const auto both = stuck_channel(Study(experiment));
  REQUIRE(both);
  CHECK(both->runs.empty());
  CHECK(both->readings == 22);
  CHECK(says(asked(experiment), "three links, Fy: found 0 N in all 22 readings"));
  CHECK(says(asked(experiment), "leave its column out"));
  hold(experiment.runs[0], Fy, 0.3);
  CHECK(says(asked(experiment), "Fy: found one value a run in all 22 readings"));
}

TEST_CASE("a constant angle raises a question with its name") {
  Experiment experiment = still_bench();
  const Channel q2{Channel::Name::q, 1};
  hold(experiment.runs[0], q2, 0);
  hold(experiment.runs[1], q2, 0);
  CHECK(says(asked(experiment), "three links, q2: found 0 rad in all 22 readings"));
}

TEST_CASE("seven readings, missing ones, and a moving channel raise no question") {
  const auto held = [](int steps) {
    Experiment experiment = still_bench(steps);
    for (Run& run : experiment.runs) hold(run, Fy, 0.01);
    return experiment;
  };
  CHECK_FALSE(stuck_channel(Study(held(6))));
  CHECK(stuck_channel(Study(held(7))));
  Experiment experiment = held(7);
  for (Run& run : experiment.runs) run.readings[3][column_Fy] = nan_value();
  CHECK_FALSE(stuck_channel(Study(experiment)));
  experiment = held(10);
  for (Run& run : experiment.runs) run.readings[3][column_Fy] = nan_value();
  CHECK(stuck_channel(Study(experiment)));
  for (Run& run : experiment.runs) run.readings[5][column_Fy] = 0.02;
  CHECK_FALSE(stuck_channel(Study(experiment)));
  for (Run& run : experiment.runs) hold(run, Fy, nan_value());
  CHECK_FALSE(stuck_channel(Study(experiment)));
}

TEST_CASE("a channel may be constant where the nominal model spans at most twenty times its noise") {
  Experiment experiment = still_bench();
  for (Run& run : experiment.runs) hold(run, Fy, 0);
  const auto found = stuck_channel(Study(experiment));
  REQUIRE(found);
  experiment.noise[Channel::Name::Fy] = found->predicted_range / 19;
  CHECK_FALSE(stuck_channel(Study(experiment)));
  experiment.noise[Channel::Name::Fy] = found->predicted_range / 21;
  CHECK(stuck_channel(Study(experiment)));
}

TEST_CASE("a channel may be constant where it is small beside the other of its sensor") {
  // The share of the force along y grows with the angle of the press; small noise alone decides nothing.
  const auto held = [](double by) {
    Experiment experiment = three_links();
    press(experiment, {0.3, -0.5, 0.4}, {-0.03, by}, 10, false);
    const Trace nominal = Study(experiment).nominal().runs[0];
    const auto range = [&](Channel::Name name) {
      const auto column = nominal.col(Channel(name).column);
      return column.maxCoeff() - column.minCoeff();
    };
    const double share = range(Channel::Name::Fy) / range(Channel::Name::Fx);
    experiment = measured(experiment, {}, {}, 3);
    experiment.noise[Channel::Name::Fy] = 1e-3;
    hold(experiment.runs[0], Fy, 0);
    return std::pair(share, stuck_channel(Study(experiment)).has_value());
  };
  const auto [little, asked_of_little] = held(-0.024);
  CHECK(little < 0.02);
  CHECK_FALSE(asked_of_little);
  const auto [enough, asked_of_enough] = held(-0.014);
  CHECK(enough > 0.02);
  CHECK(asked_of_enough);
}

TEST_CASE(
    "a run without joint angles beside one that has them raises no question, and a stuck one there is "
    "found") {
  Experiment experiment = still_bench();
  const std::vector<double> angles = experiment.runs[0].readings[0].angles(3);
  REQUIRE_FALSE(angles.empty());
  for (Reading& reading : experiment.runs[1].readings) reading.value.resize(column_q);
  CHECK_FALSE(stuck_channel(Study(experiment)));
  hold(experiment.runs[0], Channel(Channel::Name::q, 1), 0.25);
  const auto found = stuck_channel(Study(experiment));
  REQUIRE(found);
  CHECK(found->channel == Channel(Channel::Name::q, 1));
  CHECK(found->readings == experiment.runs[0].readings.size());
}
