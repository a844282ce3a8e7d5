#include "trial/answer.hpp"

#include <doctest/doctest.h>

#include "tests/close_to.hpp"

using namespace plumbline::trial;
using plumbline::campaign::StatedReport;

namespace {

Label truth(std::vector<TrueEffect> effects, std::vector<std::vector<std::string>> equivalent = {}) {
  return {"one", std::move(effects), std::move(equivalent), 9, "declared", 1, "", ""};
}
const Label backlash = truth({{"backlash", 2, {{"b", 0.03}}, 9}});
const Label nothing = truth({});
const Label outside = truth({{"unknown", 3, {}, 9}});
const Label pair = truth({{"gravity", 0, {}, 9}, {"rest_angle", 1, {}, 9}});

StatedReport said(const std::string& verdict, std::vector<std::string> effects = {},
                  std::vector<std::vector<std::string>> equivalent = {}) {
  StatedReport report;
  report.verdict = verdict;
  report.effects = std::move(effects);
  report.equivalent = std::move(equivalent);
  return report;
}

Answer answer(const Label& label, const StatedReport& report) {
  return judge(label, report).answer;
}

}  // namespace

TEST_CASE("one effect") {
  CHECK(answer(backlash, said("identified", {"backlash(2)"})) == Answer::right);
  CHECK(answer(backlash, said("identified", {"backlash(3)"})) == Answer::wrong_sure);
  CHECK(answer(backlash, said("identified", {"backlash(2)", "gravity"})) == Answer::wrong_sure);
  CHECK(answer(backlash, said("ambiguous", {"gravity"}, {{"backlash(2)"}})) == Answer::in_class);
  CHECK(answer(backlash, said("ambiguous", {"gravity"}, {{"backlash(1)"}})) == Answer::wrong_ambiguous);
  CHECK(answer(backlash, said("unknown")) == Answer::unknown);
  CHECK(answer(backlash, said("none")) == Answer::missed_gap);
}

TEST_CASE("the best explanation without its joints") {
  CHECK(judge(backlash, said("identified", {"rest_angle(2)", "backlash(2)"})).best == "backlash+rest_angle");
  CHECK(judge(backlash, said("unknown")).best == "unknown");
}

TEST_CASE("no effect") {
  CHECK(answer(nothing, said("none")) == Answer::right);
  CHECK(answer(nothing, said("unknown")) == Answer::false_alarm);
  CHECK(answer(nothing, said("identified", {"gravity"})) == Answer::false_alarm);
}

TEST_CASE("an effect outside the catalogue is unknown, whether or not it sits at a joint") {
  CHECK(answer(outside, said("unknown")) == Answer::right);
  CHECK(answer(outside, said("identified", {"backlash(3)"})) == Answer::wrong_sure);
  CHECK(answer(outside, said("ambiguous", {"gravity"})) == Answer::wrong_ambiguous);
  CHECK(answer(outside, said("none")) == Answer::missed_gap);
  CHECK(answer(outside, said("ambiguous", {"unknown"}, {{"gravity"}})) == Answer::in_class);
  StatedReport report = said("unknown");
  CHECK(judge(outside, report).place_right == false);
  report.joint = 3;
  CHECK(judge(outside, report).place_right == true);
  report.joint = 1;
  CHECK(judge(outside, report).place_right == false);
  Label wave = truth({{"unknown", 0, {}, 9}});
  CHECK(!judge(wave, report).place_right);
  wave.channel = "Fx, Fy";
  report.channel = "Fy";
  CHECK(judge(wave, report).place_right == true);
  report.channel = "q1";
  CHECK(judge(wave, report).place_right == false);
}

TEST_CASE("two effects, in any order; one of them is a partial answer") {
  CHECK(answer(pair, said("identified", {"rest_angle(1)", "gravity"})) == Answer::right);
  CHECK(answer(pair, said("identified", {"gravity"})) == Answer::part);
  CHECK(answer(pair, said("identified", {"gravity", "rest_angle(2)"})) == Answer::part);
  CHECK(answer(pair, said("identified", {"backlash(1)"})) == Answer::wrong_sure);
  CHECK(answer(pair, said("ambiguous", {"backlash(1)"}, {{"gravity", "rest_angle(1)"}})) == Answer::in_class);
}

TEST_CASE("an equivalent cause is right too; a larger class is oversized") {
  const Label payload = truth({{"tip_payload", 0, {}, 9}}, {{"force_bias"}});
  CHECK(answer(payload, said("identified", {"force_bias"})) == Answer::right);
  CHECK(!judge(payload, said("ambiguous", {"tip_payload"}, {{"force_bias"}})).oversized_class);
  CHECK(judge(payload, said("ambiguous", {"tip_payload"}, {{"force_bias"}, {"gravity"}})).oversized_class);
}

TEST_CASE("parameters count where the cause is right") {
  StatedReport report = said("identified", {"backlash(2)"});
  report.bounds["backlash(2)/b"] = {0.028, 0.031};
  CHECK(judge(backlash, report).covered ==
        std::vector<std::pair<std::string, bool>>{{"backlash(2)/b", true}});
  report.bounds["backlash(2)/b"] = {0.031, 0.033};
  CHECK(!judge(backlash, report).covered.front().second);
}

TEST_CASE("parameters of a law with more elements than the answer has are not compared") {
  StatedReport report = said("identified", {"hysteresis(1)"});
  report.bounds["hysteresis(1)/d_1"] = {0.1, 0.2};
  const auto judged = [&](TrueEffect law) { return judge(truth({std::move(law)}), report).covered; };
  CHECK(judged({"hysteresis", 1, {{"d_1", 0.3}}, 9}).size() == 1);
  CHECK(judged({"hysteresis", 1, {{"d_1", 0.05}, {"d_2", 0.3}}, 9}).empty());
}

TEST_CASE("the Brier score: 0 for a certain right answer, 2 for a certain wrong one") {
  StatedReport report = said("identified", {"backlash(2)"});
  report.ranking = {{{"backlash(2)"}, 1.0}};
  CHECK(judge(backlash, report).brier == 0);
  report.ranking = {{{"gravity"}, 1.0}, {{"backlash(2)"}, 0.0}};
  CHECK(judge(backlash, report).brier == 2);
  report.ranking = {{{"gravity"}, 1.0}};
  CHECK(judge(backlash, report).brier == 2);
  report.ranking = {{{"backlash(2)"}, 0.5}, {{"gravity"}, 0.5}};
  CHECK(judge(backlash, report).brier == 0.5);
  CHECK(judge(backlash, report).stated->first == 0.5);
  report = said("unknown");
  report.ranking = {{{"gravity"}, 0.25}, {{"unknown"}, 0.75}};
  CHECK(judge(outside, report).stated == std::pair(0.75, true));
  CHECK(judge(outside, report).brier == 0.125);
  CHECK(judge(nothing, report).stated == std::pair(0.75, false));
}

TEST_CASE("the Brier score expects all probability on one of two right explanations") {
  const Label either = truth({{"backlash", 2, {}, 9}}, {{"rest_angle(2)"}});
  StatedReport report = said("ambiguous", {"backlash(2)"}, {{"rest_angle(2)"}});
  report.ranking = {{{"backlash(2)"}, 0.6}, {{"rest_angle(2)"}, 0.3}, {{"gravity"}, 0.1}};
  // (0.6 - 1)^2 + 0.3^2 + 0.1^2
  CHECK(judge(either, report).brier == close_to(0.26));
  report.ranking = {{{"gravity"}, 1.0}};  // the truth is not ranked: 1^2, and 1^2 for what it lacks
  CHECK(judge(either, report).brier == close_to(2));
}

TEST_CASE("a residual reduction counts only where the cause is right") {
  StatedReport report = said("identified", {"gravity"});
  report.shrunk = 1.2;
  CHECK(!judge(backlash, report).shrunk);
  report.effects = {"backlash(2)"};
  CHECK(judge(backlash, report).shrunk == 1.2);
}
