#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/bench/read_samples.hpp"
#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

const std::string start = R"(format = "chain-experiment/1"
name = "two"
nominal = { link_length = [0.3, 0.2], joint_stiffness = [2.0, 1.5] }
noise = { x = 0.001, y = 0.001, Fx = 0.02, Fy = 0.02, q = 0.001 }
run = [{ id = "press", control = "displacement", rest = [0.4, -0.9], samples = "press.csv" }]
)";

Experiment read(const std::string& toml, const std::string& samples) {
  return read_experiment("E", [&](const std::string& name, const std::string&) {
    return name == "experiment.toml" ? toml : samples;
  });
}

std::vector<Reading> readings(const std::string& tables, const std::string& samples) {
  return read(start + tables, samples).runs.at(0).readings;
}

std::string fault(const std::string& tables, const std::string& samples) {
  try {
    readings(tables, samples);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void check_says(const std::string& message, const std::vector<std::string>& words) {
  INFO(message);
  CHECK(message.find('\n') == std::string::npos);
  for (const std::string& word : words) CHECK_MESSAGE(message.find(word) != std::string::npos, word);
}

double nearest(const Rational& value) {
  return from_rational<double>(value);
}

/// A decimal with so many places, as an exact number and as a text.
struct Decimal {
  std::int64_t digits;
  int places;
  [[nodiscard]] Rational value() const {
    return Rational(digits) / Rational(pow(Integer(10), static_cast<unsigned>(places)));
  }
  [[nodiscard]] std::string text(char point) const {
    std::string text = fmt::format("{:0{}}", std::abs(digits), places + 1);
    text.insert(text.size() - static_cast<std::size_t>(places), 1, point);
    return (digits < 0 ? "-" : "") + text;
  }
};

rc::Gen<Decimal> decimals() {
  return rc::gen::map(
      rc::gen::pair(rc::gen::inRange<std::int64_t>(-99999999, 100000000), rc::gen::inRange(1, 7)),
      [](const auto& pair) {
        return Decimal{pair.first, pair.second};
      });
}

double force_in(const std::string& unit, const std::string& text) {
  const std::string tables =
      "[columns]\nt = { constant = 0 }\nx = { constant = 0.45 }\ny = { constant = 0.02 }\n"
      "Fx = { column = \"F\", unit = \"" +
      unit + "\" }\n";
  SampleFormat format = standard_format(2);
  const toml::table table = toml::parse(tables);
  format = read_sample_format(Section(table, "f"), format);
  const SampleTable samples = parse_sample_table("F\n" + text + "\n", "s", format);
  return read_samples({{"s", samples, format}}, Control::end_point).readings.at(0)[column_Fx];
}

}  // namespace

TEST_CASE("a reading in a unit is the double next to its exact value") {
  // BIPM SI brochure and NIST SP 811: these factors are exact
  const std::vector<std::pair<std::string, Rational>> units{{"mN", Rational(1, 1000)},
                                                            {"kN", Rational(1000)},
                                                            {"kgf", Rational(980665, 100000)},
                                                            {"gf", Rational(980665, 100000000)},
                                                            {"lbf", Rational(44482216152605, 10000000000000)},
                                                            {"0.5 N", Rational(1, 2)}};
  for (const auto& [unit, factor] : units) {
    CAPTURE(unit);
    check_property("exact", [&, &name = unit, &times = factor] {
      const Decimal decimal = *decimals();
      RC_ASSERT(force_in(name, decimal.text('.')) == nearest(decimal.value() * times));
    });
  }
}

TEST_CASE("units of angle, stiffness and mass have the factors of their references") {
  const auto factor = [](const std::string& unit, const Quantity& of) {
    return parse_unit(unit, of, "p").in_si();
  };
  CHECK(factor("deg", quantity::angle) == 0.017453292519943295);  // pi / 180
  CHECK(factor("rev", quantity::angle) == 6.283185307179586);     // 2 pi
  CHECK(factor("N mm/rad", quantity::stiffness) == 1e-3);
  CHECK(factor("N·mm/deg", quantity::stiffness) == close_to(0.0572957795130823).epsilon(1e-14));
  CHECK(factor("Nm/rad", quantity::stiffness) == 1);
  CHECK(factor("kgf cm/rad", quantity::stiffness) == 0.0980665);
  CHECK(factor("lbf in/rad", quantity::stiffness) == close_to(0.1129848290276167).epsilon(1e-14));
  CHECK(factor("lb", quantity::mass) == 0.45359237);
  CHECK(factor("mm/s^2", quantity::acceleration) == 1e-3);
  CHECK(factor("ft/s²", quantity::acceleration) == 0.3048);
  CHECK(factor("0.25 deg", quantity::angle) == close_to(0.004363323129985824).epsilon(1e-15));
}

TEST_CASE("a unit of another quantity is refused with the list of valid ones") {
  for (const std::string wrong :
       {"N", "m m", "mm/", "/mm", "", "furlong", "mm^0", "mm^x", "-1 mm", "nan m", "mm**m"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH_AS(
        parse_unit(wrong, quantity::length, "p"),
        ("p: found \"" + wrong + "\", expected a unit of a length: m, mm, cm, um, in, ft").c_str(), Error);
  }
  CHECK_THROWS_AS(parse_unit("N m", quantity::stiffness, "p"), Error);  // by radian or by degree?
}

TEST_CASE("a logger's file is read like the same data in the native format") {
  const std::string own =
      "t,x,y,Fx,Fy,q1,q2\n0,0.4518,0.0209,0,-0.5,0.4,-0.9\n0.5,0.45,0.0209,-1.25,,0.41,\n";
  const std::vector<Reading> expected = readings("", own);
  const std::string tables = R"(
[csv]
delimiter = ";"
decimal = ","
skip_lines = 3
skip_after_header = 1
comment = "#"
missing = ["NaN", "---"]
[columns]
t = { column = "Zeit", unit = "ms", zero = 100 }
x = { column = "Weg", unit = "mm", sign = -1, zero = 500 }
y = { constant = 20.9, unit = "mm" }
Fx = { column = "Kraft [N]", sign = -1, zero = "first" }
Fy = 6
q = ["A1", "A2"]
)";
  const std::string lab =
      "\xEF\xBB\xBF\"Prüfstand\r\nan \"einem\" Tag\r\n\r\n# Kommentar\r\nKraft "
      "[N];Zeit;Weg;A2;A1;Quer;Bemerkung;\r\n"
      "N;ms;mm;;;N;\r\n"
      "+0,30;100;48,2;-0,9;0,4;-0,5;\"gut; ja\";\r\n\r\n # Pause\r\n1,55;600;50,0;NaN;0,41;---;x\r\n";
  const std::vector<Reading> found = readings(tables, lab);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    CHECK(found[i].t == expected[i].t);
    CHECK(found[i][column_x] == expected[i][column_x]);
    CHECK(found[i][column_y] == expected[i][column_y]);
    CHECK(found[i][column_Fx] == expected[i][column_Fx]);
    CHECK(same(found[i][column_Fy], expected[i][column_Fy]));
    for (std::size_t j = 0; j < 2; ++j) CHECK(same(found[i][column_q + j], expected[i][column_q + j]));
  }
}

TEST_CASE("tabs, bars, blanks and files without a header are read") {
  const std::vector<Reading> expected =
      readings("", "t,x,y,Fx,Fy\n0,0.45,0.02,-1,0.5\n2,0.44,0.02,-2,0.25\n");
  const auto same = [&](const std::string& tables, const std::string& samples) {
    const std::vector<Reading> found = readings(tables, samples);
    REQUIRE(found.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(found[i].t == expected[i].t);
      CHECK(found[i][column_x] == expected[i][column_x]);
      CHECK(found[i][column_Fx] == expected[i][column_Fx]);
      CHECK(found[i][column_Fy] == expected[i][column_Fy]);
    }
  };
  same("csv = { delimiter = \"tab\" }", "t\tx\ty\tFx\tFy\n0\t0.45\t0.02\t-1\t0.5\n2\t0.44\t0.02\t-2\t0.25\n");
  same("csv = { delimiter = \"|\" }", "t | x | y | Fx | Fy\n0|0.45|0.02|-1|0.5\n2|0.44|0.02|-2|0.25");
  same("csv = { delimiter = \"blanks\" }",
       "  t x y  Fx Fy\n 0  0.45\t0.02 -1 0.5 \n 2 0.44 0.02 -2   0.25\n");
  same("csv = { header = false }", "0,0.45,0.02,-1,0.5\n2,0.44,0.02,-2,0.25\n");
  same("[csv]\nheader = false\n[columns]\nt = 2\nx = 1\ny = 3\nFx = 5\nFy = 6\n",
       "0.45,0,0.02,9,-1,0.5\n0.44,2,0.02,9,-2,0.25\n");
}

TEST_CASE("absolute angles, settings of single runs, and files without time") {
  const std::vector<Reading> angles = readings(
      "[columns]\nq = { column = [\"a\", \"b\"], unit = \"deg\", sign = [1, -1], absolute = true }\n",
      "x,y,a,b\n0.45,0.02,20,40\n0.44,0.02,21,\n");
  const double degree = 0.017453292519943295;
  CHECK(angles[0].t == 0);
  CHECK(angles[1].t == 1);
  CHECK(std::isnan(angles[0][column_Fx]));
  CHECK(angles[0][column_q + 0] == 20 * degree);
  CHECK(angles[0][column_q + 1] == close_to(-60 * degree).epsilon(1e-15));
  CHECK(std::isnan(angles[1][column_q + 1]));
  const std::string toml = R"(format = "chain-experiment/1"
name = "two"
nominal = { link_length = [300, 200], joint_stiffness = [2e3, 1500], link_mass = [10, 20], gravity = [0, -9810] }
units = { link_length = "mm", joint_stiffness = "N mm/rad", rest = "deg", link_mass = "g", gravity = "mm/s^2" }
noise = { Fx = 20, Fy = 20 }
columns = { Fx = { unit = "mN" }, Fy = { unit = "mN" } }
[[run]]
id = "one"
control = "displacement"
rest = [20, -40]
samples = "a.csv"
[[run]]
id = "two"
control = "displacement"
rest = [20, -40]
samples = "b.csv"
columns = { Fx = "Load" }
csv = { delimiter = ";" }
)";
  const Experiment both = read_experiment("E", [&](const std::string& name, const std::string&) {
    return name == "experiment.toml" ? toml
           : name == "a.csv"         ? std::string("t,x,y,Fx,Fy\n0,0.45,0.02,500,250\n1,0.44,0.02,500,250\n")
                                     : std::string("t;x;y;Load;Fy\n0;0.45;0.02;0.5;250\n");
  });
  CHECK(both.runs[0].readings[0][column_Fx] == 0.5);
  CHECK(both.runs[1].readings[0][column_Fx] == 0.5);
  CHECK(both.runs[1].readings[0][column_Fy] == 0.25);
  CHECK(both.noise[Channel::Name::Fx] == 0.02);
  CHECK(both.link_length == std::vector{0.3, 0.2});
  CHECK(both.joint_stiffness == std::vector{2.0, 1.5});
  CHECK(both.link_mass == std::vector{0.01, 0.02});
  CHECK(both.gravity[1] == -9.81);
  CHECK(both.runs[0].rest[1] == -40 * degree);
}

TEST_CASE("a fault of a lab file is named with line and key") {
  const std::string good = "t,x,y,Fx,Fy\n0,0.45,0.02,-1,0.5\n1,0.44,0.02,-1,0.5\n";
  check_says(fault("csv = { delimiter = \"/\" }", good), {"experiment.toml:6: csv.delimiter", "\"tab\""});
  check_says(fault("csv = { decimal = \"x\" }", good), {"csv.decimal", "x"});
  check_says(fault("csv = { header = 1 }", good), {"csv.header", "true or false"});
  check_says(fault("csv = { skip_lines = -1 }", good), {"csv.skip_lines", "-1"});
  check_says(fault("csv = { zz = -1 }", good), {"csv.zz", "unknown key", "skip_after_header"});
  check_says(fault("[columns]\nFx = \"Kraft\"", good),
             {"press.csv:1", "'t,x,y,Fx,Fy'", "'Kraft'", "experiment.toml:7: columns.Fx"});
  check_says(fault("[columns]\nFx = 9", good), {"press.csv:1", "5 columns", "column 9", "columns.Fx"});
  check_says(fault("[columns]\nFx = 0", good), {"columns.Fx", "0", "number from 1"});
  check_says(fault("[columns]\nFx = { unit = \"mm\" }", good), {"columns.Fx.unit", "mm", "kgf"});
  check_says(fault("[columns]\nFx = { sign = 2 }", good), {"columns.Fx.sign", "1 or -1"});
  check_says(fault("[columns]\nFx = { zero = \"last\" }", good), {"columns.Fx.zero", "first"});
  check_says(fault("[columns]\nFx = { absolute = true }", good), {"columns.Fx.absolute", "unknown key"});
  check_says(fault("[columns]\nFx = { constant = 1, column = \"Fx\" }", good), {"columns.Fx.column"});
  check_says(fault("[columns]\nq = [\"a\"]", good), {"columns.q", "a list of 2"});
  check_says(fault("[columns]\nx = \"y\"\n[units]\nrest = \"mm\"", good), {"units.rest", "deg"});
  check_says(fault("[columns]\nt = \"t\"", "t,y,Fx,Fy\n0,0.02,1,1\n"),
             {"press.csv:1", "no column 'x'", "columns.x"});
  check_says(fault("", "t;x;y;Fx;Fy\n0;0.45;0.02;-1;0.5\n"), {"press.csv:1", "csv.delimiter = \";\""});
  check_says(fault("", "Time,Pos,y,Fx,Fy\n0,0.45,0.02,-1,0.5\n"), {"press.csv:1", "[columns]"});
  // Decimal commas cut the lines of a file that semicolons cut, and titles stand above the header.
  check_says(fault("", "t;x;y;Fx;Fy\n0;0,45;0,02;-1;0,5\n"),
             {"press.csv:2", "4 fields", "1, as in the header", "csv.delimiter = \";\""});
  check_says(fault("", "bench 3\nt,x,y,Fx,Fy\n0,0.45,0.02,-1,0.5\n"),
             {"press.csv:2", "5 fields", "if the header is line 2: csv.skip_lines = 1"});
  check_says(fault("csv = { delimiter = \";\" }", "t;x;y;Fx;Fy\n0;0,45;0,02;-1;0,5\n"),
             {"press.csv:2, x", "'0,45'", "csv.decimal"});
  check_says(fault("csv = { decimal = \",\", delimiter = \";\" }", "t;x;y;Fx;Fy\n0;0,45;0,02;-1.000,5;0,5\n"),
             {"press.csv:2, Fx", "'-1.000,5'"});
  check_says(fault("[columns]\nt = \"t\"", "t,t,x,y,Fx,Fy\n0,0,0.45,0.02,1,1\n"), {"2 columns of one name"});
  check_says(fault("csv = { skip_lines = 2 }", "a\nb\nt,x,y,Fx,Fy\n0,0.45,0.02,1,1\n1,0.45,0.02,1\n"),
             {"press.csv:5", "4 fields"});
}
