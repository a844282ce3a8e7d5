#include "diagnose/report/plan.hpp"

#include <doctest/doctest.h>

#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("a plan in words and as JSON, by hand") {
  Plan plan;
  plan.experiment = "bench";
  plan.impossible = {{"gravity"}, {"tip_payload"}};
  plan.candidates = 5;
  plan.unidentifiable.undetectable = {{"backlash", 2}};
  plan.unidentifiable.indistinguishable = {{{{"force_gain"}, {"stiffness_scale"}}, {}, true},
                                           {{{"rest_angle", 1}}, {{"joint_stiffness", 1}}, false},
                                           {{{"play"}, {"backlash", 1}}, {{"gravity"}}, false}};
  plan.separated = 31;
  CHECK(as_text(plan) ==
        "bench, before any data\n\n"
        "Which effects can it not detect?  At their typical size, with all 5 feasible runs\n"
        "  without effect on any channel of this bench: gravity, tip_payload\n"
        "  below the noise: backlash(2)\n\n"
        "Which effects can it not distinguish?\n"
        "  force_gain | stiffness_scale (identical readings)\n"
        "  rest_angle(1): confused with joint_stiffness(1)\n"
        "  play | backlash(1), each confused with gravity\n\n"
        "Which runs distinguish the rest?  There is nothing to distinguish\n");
  plan.candidates = 6;
  plan.fewest = {"press", "load"};
  plan.planned = Unidentifiable{};
  CHECK(has_words(as_text(plan), "with any 5 of 6 feasible runs\n"));
  CHECK(has_words(
      as_text(plan),
      "What do the planned runs leave open?\n  below the noise: none\n  not distinguished:\n"
      "    none\n\nWhich runs distinguish the rest?  2 of 6; fewer may suffice\n  press\n  load\n"));
  plan.proved_minimal = true;
  CHECK(has_words(as_text(plan), "2 of 6; no fewer suffice\n"));
  CHECK(as_json(plan) ==
        ReportJson::parse(R"json({"format": "experiment-plan/2", "experiment": "bench", "candidates": 6,
    "impossible": ["gravity", "tip_payload"], "unidentifiable": {"undetectable": ["backlash(2)"], "indistinguishable": [
      {"effects": ["force_gain", "stiffness_scale"], "exactly": true, "others": []},
      {"effects": ["rest_angle(1)"], "exactly": false, "others": ["joint_stiffness(1)"]},
      {"effects": ["play", "backlash(1)"], "exactly": false, "others": ["gravity"]}]
}
, "runs" : [ "press", "load" ], "proved_minimal" : true, "separated" : 31, "planned" : {
  "undetectable" : [], "indistinguishable" : []
}
})json"));
}
