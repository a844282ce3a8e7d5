#include "diagnose/rig/sizes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <regex>
#include <sstream>

#include "diagnose/rig/effect.hpp"
#include "support/files/text_file.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/rig/effects/by_hand.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

struct Documented {
  std::string words, unit, size, typical, low, high;
};

std::vector<Documented> documented_sizes() {
  static const std::regex row(R"(\| ([^|]*) \| ([^|]*) \| ([^|]*) \| ?([^|]*) \| ([^|]*) \| ([^|]*) \|)");
  std::vector<Documented> rows;
  std::istringstream lines(files::read_text(PLUMBLINE_SOURCE_DIR "/diagnose/rig/effects/README.md"));
  std::smatch found;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) inside = line == "## Typical sizes";
    if (inside && std::regex_match(line, found, row) && found[1] != "quantity")
      rows.push_back({found[1], found[2], found[3], found[4], found[5], found[6]});
  }
  return rows;
}

}  // namespace

TEST_CASE("the table of typical sizes has a row for each kind, in their order") {
  const std::vector<TypicalSize>& all = typical_sizes();
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i].kind == static_cast<ParameterKind>(i));
  CHECK(all.back().kind == ParameterKind::expansion);  // the last one
}

TEST_CASE("the document shows the table of typical sizes") {
  const std::vector<Documented> rows = documented_sizes();
  REQUIRE(rows.size() == typical_sizes().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TypicalSize& own = typical_sizes()[i];
    INFO(rows[i].words);
    CHECK(rows[i].words == own.words);
    CHECK(rows[i].unit == own.unit);
    CHECK(rows[i].size == own.size);
    const bool even = own.coordinate == Coordinate::logarithm;
    CHECK(rows[i].typical.empty() == even);
    if (!even) CHECK(std::stod(rows[i].typical) == close_to(own.typical));
    CHECK(std::stod(rows[i].low) == close_to(own.low));
    CHECK(std::stod(rows[i].high) == close_to(own.high));
  }
}

TEST_CASE("a parameter is its kind's size times the device's own") {
  const CharacteristicScales sizes = characteristic_scales(full_bench());
  const Place at{sizes, 1};
  const ParameterRange zero = of(ParameterKind::force_zero, "b", at);
  CHECK(zero.scale == close_to(0.05 * sizes.force));
  CHECK(zero.low == close_to(-3 * sizes.force));
  CHECK(zero.positive().low == 0);
  const ParameterRange decay = of(ParameterKind::decay_time, "tau", at);
  CHECK(decay.low == close_to(std::log(0.1 * sizes.sampling_interval)));
  CHECK(decay.high == close_to(std::log(20 * sizes.duration)));
}

TEST_CASE("ranges and initial guesses scale with the units of force, length and time") {
  // Forces in units 5 times as small, lengths 3 times, times 7 times.
  constexpr double N = 5, m = 3, s = 7;
  const CharacteristicScales size = sizes_by_hand();
  CharacteristicScales other = size;
  for (double& k : other.joint_stiffness) k *= N * m;
  for (double& length : other.link_length) length *= m;
  other.stiffness *= N * m, other.length *= m, other.link *= m;
  for (double& length : other.reach) length *= m;
  other.force *= N, other.largest_reading *= N, other.torque *= N * m;
  other.mass *= N;  // gravity is the same
  other.duration *= s, other.sampling_interval *= s;
  const Excitation nominal = excitation_by_hand();
  Excitation scaled = nominal;
  scaled.torque *= N * m;
  const std::map<std::string, double> factors{{"ratio", 1},
                                              {"rad", 1},
                                              {"1/rad", 1},
                                              {"1/rad²", 1},
                                              {"N", N},
                                              {"N m", N * m},
                                              {"N m/rad", N * m},
                                              {"m", m},
                                              {"s", s},
                                              {"m/N", m / N},
                                              {"1/N", 1 / N},
                                              {"N/s", N / s},
                                              {"N m/s", N * m / s},
                                              {"m/s", m / s},
                                              {"rad/s", 1 / s},
                                              {"N m²", N * m * m},
                                              {"kg/m", N / m},
                                              {"kg", N},
                                              {"1/K", 1},
                                              {"px", 1},
                                              {"px/s", 1 / s},
                                              {"rad/(N m)", 1 / (N * m)}};
  for (const Effect& row : catalogue()) {
    const std::size_t joint = row.at_joint ? 1 : 0;
    const auto before = row.parameters({size, joint}), after = row.parameters({other, joint});
    std::vector<double> factor, shift;
    REQUIRE(before.size() == after.size());
    for (std::size_t p = 0; p < before.size(); ++p) {
      CAPTURE(row.id);
      CAPTURE(p);
      const auto unit = factors.find(std::string(before[p].unit));
      REQUIRE(unit != factors.end());
      const Coordinate how = before[p].coordinate;
      factor.push_back(how == Coordinate::plain        ? unit->second
                       : how == Coordinate::reciprocal ? 1 / unit->second
                                                       : 1);
      shift.push_back(how == Coordinate::logarithm ? std::log(unit->second) : 0);
      const auto moved = [&](double value) {
        return doctest::Approx(value * factor[p] + shift[p]).epsilon(1e-12).scale(1e-9);
      };
      CHECK(after[p].low == moved(before[p].low));
      CHECK(after[p].high == moved(before[p].high));
      CHECK(after[p].scale == doctest::Approx(before[p].scale * factor[p]).epsilon(1e-12).scale(1e-9));
      CHECK(after[p].tolerance ==
            doctest::Approx(before[p].tolerance * factor[p]).epsilon(1e-12).scale(1e-9));
    }
    if (row.initial_guesses == nullptr) continue;
    const InitialGuesses from = row.initial_guesses({size, joint}, nominal),
                         to = row.initial_guesses({other, joint}, scaled);
    CHECK(from.refined == to.refined);
    REQUIRE(from.points.size() == to.points.size());
    // Guesses for stops and hardening depend on angles alone.
    for (std::size_t i = 0; i < from.points.size(); ++i)
      for (std::size_t p = 0; p < factor.size(); ++p) {
        CAPTURE(row.id);
        CHECK(to.points[i][p] ==
              doctest::Approx(from.points[i][p] * factor[p] + shift[p]).epsilon(1e-12).scale(1e-9));
      }
  }
}
