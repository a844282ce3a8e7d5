#include "diagnose/bench/conversion.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/bench/unit.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Three links and one reading in which every number is another.
Experiment one_reading() {
  Experiment experiment = three_links();
  experiment.link_mass = {0.1, 0.2, 0.3};
  experiment.runs = {
      {"press", Control::end_point, {0.3, -0.5, 0.4}, {{0, chain_values(2, 3, 5, 7, {0.1, 0.25, 0.45})}}}};
  return experiment;
}

const Conversion& conversion(const std::vector<Conversion>& all, const std::string& what,
                             const std::string& looks_like) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Conversion& one) {
    return one.what == what && one.looks_like == looks_like;
  });
  CAPTURE(what);
  CAPTURE(looks_like);
  REQUIRE(found != all.end());
  return *found;
}

void check_close(const std::vector<double>& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == close_to(expected[i]).epsilon(1e-12));
}

}  // namespace

TEST_CASE("every symbol of a unit has the factor of its source, with its powers") {
  // BIPM's brochure and NIST SP 811, appendix B
  const std::map<std::string, double> lengths{
      {"m", 1},       {"km", 1e3},      {"dm", 0.1},        {"cm", 0.01},   {"mm", 1e-3},
      {"um", 1e-6},   {"µm", 1e-6},     {"μm", 1e-6},       {"in", 0.0254}, {"inch", 0.0254},
      {"ft", 0.3048}, {"m^3/cm²", 1e4}, {"2.5 mm", 2.5e-3}, {"m*s/s", 1}};
  const std::map<std::string, double> forces{{"N", 1},
                                             {"kN", 1e3},
                                             {"cN", 0.01},
                                             {"mN", 1e-3},
                                             {"uN", 1e-6},
                                             {"µN", 1e-6},
                                             {"μN", 1e-6},
                                             {"dyn", 1e-5},
                                             {"kgf", 9.80665},
                                             {"kp", 9.80665},
                                             {"gf", 9.80665e-3},
                                             {"lbf", 4.4482216152605},
                                             {"ozf", 0.27801385095378125},
                                             {"kg m/s^2", 1},
                                             {"kg·m/s²", 1},
                                             {"Nm/m", 1},
                                             {"N mm³/m^3", 1e-9}};
  const std::map<std::string, double> times{{"s", 1},     {"ms", 1e-3}, {"us", 1e-6}, {"µs", 1e-6},
                                            {"μs", 1e-6}, {"min", 60},  {"h", 3600}};
  const std::map<std::string, double> masses{
      {"kg", 1}, {"g", 1e-3}, {"lb", 0.45359237}, {"oz", 0.028349523125}};
  const double degree = std::acos(-1.0) / 180;
  const std::map<std::string, double> angles{{"rad", 1},           {"mrad", 1e-3},     {"deg", degree},
                                             {"°", degree},        {"degree", degree}, {"degrees", degree},
                                             {"rev", 360 * degree}};
  const std::map<std::string, double> stiffnesses{{"Nm/rad", 1},
                                                  {"Ncm/rad", 0.01},
                                                  {"Nmm/rad", 1e-3},
                                                  {"mNm/rad", 1e-3},
                                                  {"N m/rev", 1 / (360 * degree)}};
  const auto check = [](const std::map<std::string, double>& units, const Quantity& of) {
    for (const auto& [name, factor] : units) {
      CAPTURE(name);
      CHECK(parse_unit(name, of, "p").in_si() == close_to(factor).epsilon(1e-15));
    }
  };
  check(lengths, quantity::length), check(forces, quantity::force), check(times, quantity::time);
  check(masses, quantity::mass), check(angles, quantity::angle), check(stiffnesses, quantity::stiffness);
  check({{"km/h^2", 1e3 / 3600 / 3600}, {"m/s/s", 1}}, quantity::acceleration);
  CHECK(in_si(250.0, parse_unit("mm", quantity::length, "p")) == 0.25);
  CHECK(in_si(0.1, si_unit(quantity::length)) == 0.1);
  CHECK(si_unit(quantity::stiffness).name == "N m/rad");
}

TEST_CASE("readings converted to other units, by hand") {
  const Experiment experiment = one_reading();
  const std::vector<Conversion> all = conversions(experiment);
  const std::map<std::string, double> forces{
      {"kgf", 9.80665},   {"kN", 1e3},
      {"mN", 1e-3},       {"lbf", 4.4482216152605},
      {"gf", 9.80665e-3}, {"N that were multiplied by 9.80665 once too often", 1 / 9.80665}};
  for (const auto& [name, factor] : forces) {
    const Conversion& one = conversion(all, "Fx, Fy", name);
    const Reading read = converted(experiment, one).runs[0].readings[0];
    check_close({read[column_Fx], read[column_Fy], read[column_x], read[column_y]},
                {5 * factor, 7 * factor, 2, 3});
    CHECK(one.factor == close_to(factor));
    CHECK(one.expected == "N");
    CHECK_FALSE(one.mirror);
    CHECK(one.remedy ==
          "columns.Fx.unit and columns.Fy.unit = \"" + (name.size() > 4 ? "0.101972 N" : name) + "\"");
  }
  for (const auto& [name, factor] : {std::pair("mm", 1e-3), std::pair("cm", 1e-2), std::pair("in", 0.0254)}) {
    const Reading read = converted(experiment, conversion(all, "x, y", name)).runs[0].readings[0];
    check_close({read[column_x], read[column_y], read[column_Fx], read[column_Fy]},
                {2 * factor, 3 * factor, 5, 7});
    CHECK(conversion(all, "x, y", name).remedy ==
          std::string("columns.x.unit and columns.y.unit = \"") + name + "\"");
    const Experiment links = converted(experiment, conversion(all, "link_length", name)),
                     both = converted(experiment, conversion(all, "link_length, x, y", name));
    check_close(links.link_length, {0.2 * factor, 0.25 * factor, 0.15 * factor});
    check_close(both.link_length, links.link_length);
    CHECK(links.runs[0].readings[0][column_x] == 2);
    check_close({both.runs[0].readings[0][column_x], both.runs[0].readings[0][column_y]},
                {2 * factor, 3 * factor});
    CHECK(conversion(all, "link_length", name).factor == close_to(factor));
  }
  const double degree = std::acos(-1.0) / 180;
  const std::map<std::string, double> stiffnesses{{"N mm/rad", 1e-3},
                                                  {"N cm/rad", 1e-2},
                                                  {"N m/deg", 1 / degree},
                                                  {"N mm/deg", 1e-3 / degree},
                                                  {"kgf cm/rad", 0.0980665},
                                                  {"kgf m/rad", 9.80665},
                                                  {"lbf in/rad", 4.4482216152605 * 0.0254}};
  for (const auto& [name, k] : stiffnesses) {
    const Conversion& one = conversion(all, "joint_stiffness", name);
    check_close(converted(experiment, one).joint_stiffness, {2 * k, 1.5 * k, k});
    CHECK(one.factor == close_to(k));
    CHECK(one.remedy == "units.joint_stiffness = \"" + name + "\"");
    CHECK(one.expected == "N m/rad");
  }
  // SI units raise no question about SI, and none twice.
  for (const Conversion& one : all) {
    CHECK(one.looks_like != "m");
    CHECK(one.looks_like != "N");
    CHECK(one.looks_like != "N m/rad");
    CHECK(std::count_if(all.begin(), all.end(), [&](const Conversion& other) {
            return one.what == other.what && one.looks_like == other.looks_like;
          }) == 1);
  }
}

TEST_CASE("readings converted to other axes, by hand") {
  const Experiment experiment = one_reading();
  const std::vector<Conversion> all = conversions(experiment);
  struct Laid {
    const char* name;
    double x, y, Fx, Fy;
    const char *of_position, *of_force;
    bool mirror;
  };
  const Laid laid[] = {
      {"of the opposite sign", -2, -3, -5, -7, "columns.x and columns.y with sign = -1",
       "columns.Fx and columns.Fy with sign = -1", false},
      {"with y mirrored", 2, -3, 5, -7, "columns.y with sign = -1", "columns.Fy with sign = -1", true},
      {"with x mirrored", -2, 3, -5, 7, "columns.x with sign = -1", "columns.Fx with sign = -1", false},
      {"with x and y swapped", 3, 2, 7, 5, "columns.x with the column of y, columns.y with the column of x",
       "columns.Fx with the column of Fy, columns.Fy with the column of Fx", false},
      {"turned by 90 degrees", 3, -2, 7, -5,
       "columns.x with the column of y, columns.y with the column of x and sign = -1",
       "columns.Fx with the column of Fy, columns.Fy with the column of Fx and sign = -1", false},
      {"turned by -90 degrees", -3, 2, -7, 5,
       "columns.x with the column of y and sign = -1, columns.y with the column of x",
       "columns.Fx with the column of Fy and sign = -1, columns.Fy with the column of Fx", false},
      {"with x and y swapped and of the opposite sign", -3, -2, -7, -5,
       "columns.x with the column of y and sign = -1, columns.y with the column of x and sign = -1",
       "columns.Fx with the column of Fy and sign = -1, columns.Fy with the column of Fx and sign = -1",
       false}};
  const auto read = [&](const Conversion& one) {
    const Reading r = converted(experiment, one).runs[0].readings[0];
    return std::vector<double>{r[column_x], r[column_y], r[column_Fx], r[column_Fy]};
  };
  for (const Laid& one : laid) {
    const Conversion &force = conversion(all, "Fx, Fy", std::string("forces ") + one.name),
                     &place = conversion(all, "x, y", std::string("an end point ") + one.name),
                     &both = conversion(all, "x, y, Fx, Fy", std::string("axes ") + one.name);
    CHECK(read(force) == std::vector<double>{2, 3, one.Fx, one.Fy});
    CHECK(read(place) == std::vector<double>{one.x, one.y, 5, 7});
    CHECK(read(both) == std::vector<double>{one.x, one.y, one.Fx, one.Fy});
    CHECK(force.remedy == one.of_force);
    CHECK(place.remedy == one.of_position);
    CHECK(both.remedy == std::string(one.of_position) + ", " + one.of_force);
    for (const Conversion* each : {&force, &place, &both}) {
      CHECK(each->mirror == one.mirror);
      CHECK(each->factor == 0);
    }
  }
  // A component that is missing takes no other with it.
  Experiment half = experiment;
  half.runs[0].readings[0][column_Fy] = nan_value();
  CHECK(converted(half, conversion(all, "Fx, Fy", "forces with x mirrored")).runs[0].readings[0][column_Fx] ==
        -5);
  CHECK(converted(half, conversion(all, "Fx, Fy", "forces turned by 90 degrees"))
            .runs[0]
            .readings[0][column_Fy] == -5);
}

TEST_CASE("joint angles in other conventions, by hand: readings, rest shape, both") {
  const Experiment experiment = one_reading();
  const std::vector<Conversion> all = conversions(experiment);
  const double degree = std::acos(-1.0) / 180;
  struct Written {
    const char* name;
    std::vector<double> rest, q;
    const char *of_rest, *of_q;
    double factor;
    bool mirror;
  };
  const std::vector<Written> written{{"degrees",
                                      {0.3 * degree, -0.5 * degree, 0.4 * degree},
                                      {0.1 * degree, 0.25 * degree, 0.45 * degree},
                                      "units.rest = \"deg\"",
                                      "columns.q.unit = \"deg\"",
                                      degree,
                                      false},
                                     {"angles of the opposite sign",
                                      {-0.3, 0.5, -0.4},
                                      {-0.1, -0.25, -0.45},
                                      "the signs of rest turned",
                                      "columns.q.sign = -1",
                                      0,
                                      true},
                                     {"absolute angles",
                                      {0.3, -0.8, 0.9},
                                      {0.1, 0.15, 0.2},
                                      "in rest the differences of neighbours",
                                      "columns.q.absolute = true",
                                      0,
                                      false},
                                     {"angles in the reverse order",
                                      {0.4, -0.5, 0.3},
                                      {0.45, 0.25, 0.1},
                                      "rest in reverse",
                                      "the columns of columns.q in reverse",
                                      0,
                                      false}};
  for (const Written& one : written) {
    const Conversion &q = conversion(all, "q", one.name), &rest = conversion(all, "rest", one.name),
                     &both = conversion(all, "rest, q", one.name);
    check_close(converted(experiment, q).runs[0].readings[0].angles(3), one.q);
    check_close(converted(experiment, q).runs[0].rest, {0.3, -0.5, 0.4});
    check_close(converted(experiment, rest).runs[0].rest, one.rest);
    check_close(converted(experiment, rest).runs[0].readings[0].angles(3), {0.1, 0.25, 0.45});
    check_close(converted(experiment, both).runs[0].readings[0].angles(3), one.q);
    check_close(converted(experiment, both).runs[0].rest, one.rest);
    CHECK(q.remedy == one.of_q);
    CHECK(rest.remedy == one.of_rest);
    CHECK(both.remedy == std::string(one.of_rest) + ", " + one.of_q);
    for (const Conversion* each : {&q, &rest, &both}) {
      CHECK(each->factor == doctest::Approx(one.factor));
      CHECK(each->mirror == one.mirror);
      CHECK(each->expected == "relative joint angles, counter-clockwise, from joint 1, in rad");
    }
  }
}

TEST_CASE("chain lists reversed, and readings in units other than SI") {
  Experiment experiment = one_reading();
  std::vector<Conversion> all = conversions(experiment);
  const Experiment springs =
      converted(experiment, conversion(all, "joint_stiffness", "a list from the end point on"));
  CHECK(springs.joint_stiffness == std::vector<double>{1, 1.5, 2});
  CHECK(springs.link_length == experiment.link_length);
  const Experiment lists =
      converted(experiment, conversion(all, "link_length, joint_stiffness", "lists from the end point on"));
  CHECK(lists.joint_stiffness == std::vector<double>{1, 1.5, 2});
  CHECK(lists.link_length == std::vector<double>{0.15, 0.25, 0.2});
  CHECK(lists.link_mass == std::vector<double>{0.3, 0.2, 0.1});

  experiment.origins = {{"link_length", "", "mm", 1e-3}, {"rest", "", "deg", std::acos(-1.0) / 180}};
  experiment.runs[0].origins = {{"Fx", "F", "kgf", 9.80665}, {"x", "X", "cm", 1e-2}};
  all = conversions(experiment);
  check_close(converted(experiment, conversion(all, "link_length", "m")).link_length, {200, 250, 150});
  CHECK(conversion(all, "link_length", "m").expected == "mm");
  check_close(converted(experiment, conversion(all, "rest", "radians")).runs[0].rest,
              {0.3 * 180 / std::acos(-1.0), -0.5 * 180 / std::acos(-1.0), 0.4 * 180 / std::acos(-1.0)});
  const Reading read = converted(experiment, conversion(all, "x, y", "mm")).runs[0].readings[0];
  check_close({read[column_x], read[column_y]}, {0.2, 0.3});
  CHECK(conversion(all, "Fx, Fy", "N").factor == close_to(1 / 9.80665));
  // Newtons that were multiplied once too often are what is said to be kgf already.
  for (const Conversion& one : all) CHECK(one.looks_like.find("once too often") == std::string::npos);
}
