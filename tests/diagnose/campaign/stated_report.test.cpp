#include "diagnose/campaign/stated_report.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "tests/close_to.hpp"

using namespace plumbline::campaign;

TEST_CASE("a report is read from its JSON; anything else is refused") {
  const auto json = nlohmann::json::parse(R"json({
    "where": {"channels": [{"channel": "Fx", "share": 0.8}, {"channel": "Fy", "share": 0.2}],
              "joints": [{"joint": 1, "share": 0.2}, {"joint": 2, "share": 0.8}]},
    "cause": {"verdict": "ambiguous",
              "effects": [{"id": "backlash", "joint": 2, "parameters": {"b": {"value": 1, "low": 2, "high": 0.5}}}],
              "equivalent": [["gravity"]],
              "ranking": [{"effects": ["backlash(2)"], "probability": 0.6}]},
    "shrink": {"ratio": 0.2, "noise_floor_ratio": 0.1}})json");
  const StatedReport report = report_from(json, "report.json");
  CHECK(report.effects == std::vector<std::string>{"backlash(2)"});
  CHECK(report.bounds.at("backlash(2)/b").low == 0.5);
  CHECK(report.joint == 2);
  CHECK(report.channel == "Fx");
  CHECK(*report.shrunk == close_to(2));
  CHECK(report.equivalent == std::vector<std::vector<std::string>>{{"gravity"}});
  CHECK_THROWS_WITH_AS(report_from(nlohmann::json::object(), "report.json"), doctest::Contains("report.json"),
                       plumbline::Error);
}
