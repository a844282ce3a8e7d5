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
        "What can it never see?  Of what a lab calls sizeable, by all runs that it could make, 5\n"
        "  cannot act on this bench, or nothing shows it: gravity, tip_payload\n"
        "  below the noise: backlash(2)\n\n"
        "What can it never tell apart?\n"
        "  force_gain | stiffness_scale (exactly alike)\n"
        "  rest_angle(1): mistaken for joint_stiffness(1)\n"
        "  play | backlash(1), each mistaken for gravity\n\n"
        "Which runs separate the rest?  There is nothing to separate\n");
  plan.candidates = 6;
  plan.fewest = {"press", "load"};
  plan.planned = Unidentifiable{};
  CHECK(has_words(as_text(plan), "by any 5 of 6 runs\n"));
  CHECK(has_words(
      as_text(plan),
      "What do the runs leave open as they are planned?\n  below the noise: none\n  not told apart:\n"
      "    none\n\nWhich runs separate the rest?  2 of 6; fewer may do\n  press\n  load\n"));
  plan.proved_minimal = true;
  CHECK(has_words(as_text(plan), "2 of 6; no fewer do\n"));
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
