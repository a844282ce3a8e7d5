#include "diagnose/screening/physical.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include <cmath>
#include <plumbline/base/error.hpp>

#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Links of 0.20, 0.25 and 0.15 m, 0.6 m in all; folded they reach the base. One press from the straight
/// shape.
Experiment straight_bench() {
  Experiment experiment = three_links();
  press(experiment, {0, 0, 0}, {-0.01, 0}, 3, false);
  return experiment;
}

std::string refused(const Experiment& experiment) {
  try {
    require_physical(experiment);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string refused_bench(const Experiment& experiment) {
  try {
    require_bench(experiment);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a commanded end point lies within the reach, to a ten-thousandth of it") {
  Experiment experiment = straight_bench();
  for (Reading& r : experiment.runs[0].readings) r.value.resize(column_q);
  CHECK(refused(experiment) == "");
  Reading& third = experiment.runs[0].readings[2];
  third[column_x] = 0.36 + 0.48 / 2, third[column_y] = 0;
  third[column_x] = 0.60005;
  CHECK(refused(experiment) == "");
  third[column_x] = 0.6001;
  CHECK(refused(experiment) ==
        "run \"press-1\", reading 3: found an end point 0.6001 m from the base, expected at most the length "
        "of the chain, 0.6 m; x and y count from joint 1: where it lies elsewhere, columns.x.zero and "
        "columns.y.zero say where");
  third[column_x] = 0.48008, third[column_y] = -0.36006;
  CHECK(refused(experiment).find("reading 3: found an end point 0.6001 m") != std::string::npos);
  experiment.runs[0].control = Control::force;  // measured: up to a quarter beyond
  third[column_x] = 0.74, third[column_y] = 0;
  CHECK(refused(experiment) == "");
  third[column_x] = 0.76;
  CHECK(refused(experiment).find("reading 3: found an end point 0.76 m") != std::string::npos);
}

TEST_CASE("a rest angle of thousands of turns is refused") {
  Experiment experiment = full_bench();
  for (const std::size_t joint : {0U, 2U}) {
    const double before = std::exchange(experiment.runs[1].rest[joint], -9e3);
    CHECK_NOTHROW(require_bench(experiment));
    experiment.runs[1].rest[joint] = 1e9;
    const std::string said = "run \"press-2\": found rest of joint " + std::to_string(joint + 1) +
                             ": 1e+09 rad, expected an angle within 10000 rad";
    CHECK_THROWS_WITH_AS(require_bench(experiment), said.c_str(), Error);
    experiment.runs[1].rest[joint] = before;
  }
}

TEST_CASE("a folded chain cannot come nearer than its longest link exceeds the others") {
  Experiment experiment = straight_bench();
  experiment.link_length = {0.40, 0.15, 0.05};
  for (Reading& r : experiment.runs[0].readings) r.value.resize(column_q);
  Reading& first = experiment.runs[0].readings[0];
  first[column_x] = 0.12, first[column_y] = 0.16;
  CHECK(refused(experiment) == "");
  first[column_x] = 0.119, first[column_y] = 0.16;
  CHECK(refused(experiment) ==
        "run \"press-1\", reading 1: found an end point 0.199402 m from the base, expected at least 0.2 m, "
        "what the links reach when folded; x and y count from joint 1: where it lies elsewhere, "
        "columns.x.zero and columns.y.zero say where");
}

TEST_CASE("angles that put most end points more than a quarter of the chain away are refused") {
  Experiment experiment = straight_bench();
  CHECK(refused(experiment) == "");  // all angles are zero: 0.6 m
  std::vector<Reading>& readings = experiment.runs[0].readings;
  readings[0][column_q + 0] = readings[1][column_q + 0] = 2;  // of four the upper middle counts
  const std::string two = refused(experiment);
  CHECK(two.find("run \"press-1\": found joint angles that put the end point ") == 0);
  CHECK(two.find(" m from where x and y say it is, expected joint angles of this chain, relative and in "
                 "radians") != std::string::npos);
  readings[1][column_q + 0] = 0;
  CHECK(refused(experiment) == "");
  // 2 x 0.6 sin(q / 2) apart: a quarter of the chain from 0.2507 rad on, less 1 cm of press
  for (Reading& r : readings) r[column_x] = 0.6, r[column_q + 0] = 0.24;
  CHECK(refused(experiment) == "");
  for (Reading& r : readings) r[column_q + 0] = 0.26;
  CHECK(refused(experiment).find("joint angles that put the end point 0.155") != std::string::npos);
}

TEST_CASE("measured channels have a noise above their rounding") {
  Experiment experiment = straight_bench();
  experiment.noise[Channel::Name::q] = 0;
  CHECK(refused(experiment) ==
        "noise.q: found 0, or nothing, expected a positive figure: run \"press-1\" measures it");
  for (Reading& r : experiment.runs[0].readings) r.value.resize(column_q);
  CHECK(refused(experiment) == "");
  experiment.noise[Channel::Name::Fy] = 0;
  CHECK(refused(experiment) ==
        "noise.Fy: found 0, or nothing, expected a positive figure: run \"press-1\" measures it; where the "
        "rig imposes it: control = \"force\"");
  experiment.noise[Channel::Name::Fy] = 0.01;
  experiment.noise[Channel::Name::x] = 0;  // commanded
  CHECK(refused(experiment) == "");

  // Sizes: the reach 0.6 m, the force k / reach of the stiffest joint, 2 / 0.6 N, one radian.
  const double epsilon = std::numeric_limits<double>::epsilon();
  const auto least = [&](Channel::Name channel, double size, const char* name) {
    Experiment one = straight_bench();
    for (Reading& r : one.runs[0].readings) std::fill(r.value.begin() + column_q, r.value.end(), 0.0);
    CAPTURE(name);
    one.noise[channel] = 1.01 * size * epsilon;
    CHECK(refused(one) == "");
    one.noise[channel] = 0.99 * size * epsilon;
    const std::string said = refused(one);
    CHECK(said.find(std::string("noise.") + name + ": found ") == 0);
    CHECK(said.find("expected more than the rounding of what it is the noise of, ") != std::string::npos);
  };
  using Name = Channel::Name;
  least(Name::x, 0.6, "x"), least(Name::y, 0.6, "y"), least(Name::q, 1, "q");
  least(Name::Fx, 2 / 0.6, "Fx"), least(Name::Fy, 2 / 0.6, "Fy");
  Experiment large = straight_bench();
  large.runs[0].readings[1][column_Fx] = -8, large.runs[0].readings[1][column_Fy] = 9;
  large.noise[Channel::Name::Fx] = 7 * epsilon;
  CHECK(refused(large).find("noise.Fx: found ") == 0);
  CHECK(refused(large).ends_with(": a reading, or the force that turns a joint by a radian, is 8"));
  large.noise[Channel::Name::Fx] = 8.1 * epsilon, large.noise[Channel::Name::Fy] = 8.5 * epsilon;
  CHECK(refused(large).find("noise.Fy: found ") == 0);
  large.noise[Channel::Name::Fy] = 9.1 * epsilon;
  CHECK(refused(large) == "");
}

TEST_CASE("at least three measured values, at most two passive joints") {
  Experiment experiment = straight_bench();
  std::vector<Reading>& readings = experiment.runs[0].readings;
  for (Reading& r : readings) r.value.resize(column_q), r[column_Fx] = r[column_Fy] = nan_value();
  readings[0][column_Fx] = readings[2][column_Fy] = 1;
  CHECK(refused(experiment) ==
        "experiment \"three links\": found 2 measured values, expected at least 3, more than an effect has "
        "parameters");
  readings[1][column_Fx] = 1;
  CHECK(refused(experiment) == "");
  experiment.joint_stiffness = {0, 0, 1};
  CHECK(refused(experiment) == "");
  experiment.joint_stiffness = {0, 0, 0};
  CHECK(refused(experiment) ==
        "nominal.joint_stiffness: found 3 passive joints, expected at most two: with more the chain is a "
        "mechanism even with its end point held");
}

TEST_CASE("a plan declares the noise of some channel of every run") {
  Experiment experiment = straight_bench();
  const auto only_noise = [&](const Noise& noise) {
    experiment.noise = noise;
    return refused_bench(experiment);
  };
  const std::string nothing =
      "noise: found no figure for anything that run \"press-1\" measures, expected a positive one for ";
  CHECK(only_noise({0, 0, 1, 0, 0}) == "");
  CHECK(only_noise({0, 0, 0, 1, 0}) == "");
  CHECK(only_noise({0, 0, 0, 0, 1}) == "");
  CHECK(only_noise({1, 1, 0, 0, 0}) == nothing + "Fx, Fy, q, Fx_2, Fy_2 or tilt");
  experiment.runs[0].control = Control::force;
  CHECK(only_noise({1, 0, 0, 0, 0}) == "");
  CHECK(only_noise({0, 1, 0, 0, 0}) == "");
  CHECK(only_noise({0, 0, 0, 0, 1}) == "");
  CHECK(only_noise({0, 0, 1, 1, 0}) == nothing + "x, y, q, Fx_2, Fy_2 or tilt");
}
