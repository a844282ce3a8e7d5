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
