/// \file
/// Covariates of an experiment as variables of a user's expressions.

#include <doctest/doctest.h>

#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/decimate.hpp"
#include "diagnose/rig/user_effects/read_effects.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// An effect of one parameter c.
std::string with_one(const std::string& acts) {
  return "format = \"user-effects/1\"\n[[effect]]\nid = \"warm\"\nwords = \"heat\"\n" + acts +
         "[effect.parameters.c]\nunit = \"ratio\"\nscale = 0.01\nlow = -1\nhigh = 1\n";
}

/// Pressed there and back, while a covariate goes with the time.
Experiment warmed() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true, 2.5);
  experiment.covariates = {"warmth"};
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.covariates = {reading.t};
  return experiment;
}

std::vector<Reading> readings_with(const std::string& text) {
  const auto stated = std::make_shared<StatedEffect>(parse_effects(text, "U", {"warmth"}).at(0));
  const Effect row = row_of(stated);
  return measured(warmed(), {{EffectAt(row)}}, {0.01}, 3).runs.front().readings;
}

std::string covariate_fault(const std::string& text, const std::vector<std::string>& covariates) {
  try {
    parse_effects(text, "U", covariates);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a covariate that goes with the time acts as the time does") {
  const auto torque = [](const std::string& expression) {
    return with_one("where = \"every joint\"\ntorque = \"" + expression + "\"\n");
  };
  const auto reading = [](const std::string& expression) {
    return with_one("[effect.reading]\nFx = \"" + expression + "\"\n");
  };
  for (const auto& [covariate, time] :
       {std::pair(torque("c * warmth * k * d"), torque("c * t * k * d")),
        std::pair(torque("c * warmth * s"), torque("c * t * s")),
        std::pair(reading("c * warmth"), reading("c * t")),
        std::pair(reading("c * warmth * Fx * s"), reading("c * t * Fx * s"))}) {
    CAPTURE(covariate);
    const std::vector<Reading> by_covariate = readings_with(covariate), by_time = readings_with(time);
    REQUIRE(by_covariate.size() == by_time.size());
    // the same expression of the same numbers
    for (std::size_t i = 0; i < by_time.size(); ++i)
      CHECK(by_covariate[i][column_Fx] == by_time[i][column_Fx]);
  }
}

TEST_CASE("names of covariates are known to expressions, and no parameter has one") {
  const std::string text = with_one("[effect.reading]\nFx = \"c * warmth\"\n");
  CHECK(covariate_fault(text, {"warmth"}).empty());
  CHECK(covariate_fault(text, {"humidity"}).find("the unknown name \"warmth\"") != std::string::npos);
  CHECK(covariate_fault(text, {"humidity"}).find("humidity") != std::string::npos);
  CHECK(covariate_fault(with_one("[effect.reading]\nFx = \"c * t\"\n"), {"c"}).find("parameters.c") !=
        std::string::npos);
  CHECK(covariate_fault(text, {"warmth", "sin"}) ==
        "columns.covariate.sin: found the name of a function of expressions, expected another name");
}

TEST_CASE("decimated readings have the mean of a covariate, as of the time") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 2000, false);
  experiment.covariates = {"warmth"};
  for (Reading& reading : experiment.runs.front().readings) reading.covariates = {3 * reading.t};
  const Experiment fewer = decimated(experiment);
  for (const Reading& reading : fewer.runs.front().readings)
    CHECK(reading.covariates.at(0) == close_to(3 * reading.t));
}
