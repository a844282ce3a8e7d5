#include "diagnose/report/law.hpp"

#include <doctest/doctest.h>

#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("a torque law in words and as JSON, by hand") {
  OfferedLaw offered;
  offered.law.base = {{{{"gravity"}, {"force_gain"}}}, {0.1, 0.2}};
  offered.law.cross_validated = 0.34;
  offered.pictures = {{{1, 3},
                       {{-0.1, -0.2}, {0.1, 0.3}},
                       {{0.02, 0.5, 0}, {0.03, 0, 0, {{-0.1, 0.4}, {0.1, -0.6}}}},
                       {{9, 0.7}},
                       "it hardens",
                       {{"nonlinear_spring", "joint_stop"}, {"hysteresis"}}}};
  ReportJson json = law_as_json(offered);
  CHECK(json ==
        ReportJson::parse(R"json({"id": "torque_law", "with_effects": ["gravity", "force_gain"], "laws": [
    {"joints": [1, 3], "knots": [[-0.1, -0.2], [0.1, 0.3]],
     "sliders": [{"slips_at": 0.02, "torque": 0.5, "growth": 0.0, "profile": []},
                 {"slips_at": 0.03, "torque": 0.0, "growth": 0.0, "profile": [[-0.1, 0.4], [0.1, -0.6]]}],
     "relaxation": [{"time_constant": 9.0, "stiffness": 0.7}], "description": "it hardens",
     "similar_effects": [["nonlinear_spring", "joint_stop"], ["hysteresis"]]}],
    "cross_validated": 0.34})json"));
  CHECK(law_as_text(offered) ==
        "  a torque law fitted to the gap (a description, not a cause), together with gravity + force_gain:\n"
        "    joints 1, 3: it hardens\n"
        "      similar to nonlinear_spring or joint_stop, with hysteresis\n"
        "    not tested: the other readings never bend the joints as far as the held-out ones; in "
        "cross-validation over the readings used, 0.34 of the residual remains\n");
  CHECK(what_it_does(offered) == "fitted to");
  offered.shrink = Shrink{};
  offered.shrink->heldout = {"press-1"};
  offered.shrink->ratio = 0.25, offered.shrink->ratio_low = 0.2, offered.shrink->ratio_high = 0.3;
  offered.shrink->noise_floor_ratio = 0.1;
  offered.law.base = {};
  offered.pictures[0].joints = {2};
  offered.pictures[0].resembles = {};
  CHECK(what_it_does(offered) == "that closes");
  CHECK(law_as_text(offered) ==
        "  a torque law that closes the gap (a description, not a cause):\n"
        "    joint 2: it hardens\n"
        "    leaves 0.25 of the residual on the held-out readings (95 %: 0.2 to 0.3; noise floor 0.1)\n");
  json = law_as_json(offered);
  CHECK(json["with_effects"] == ReportJson::array());
  CHECK(json["heldout"] == ReportJson::parse(R"json(["press-1"])json"));
  CHECK(json["ratio"] == 0.25);
  CHECK(json["ratio_low"] == 0.2);
  CHECK(json["ratio_high"] == 0.3);
  CHECK(json["noise_floor_ratio"] == 0.1);
  offered.shrink->ratio = 0.26;
  CHECK(what_it_does(offered) == "that narrows");
  offered.shrink->noise_floor_ratio = 0.14;
  CHECK(what_it_does(offered) == "that closes");
  offered.shrink->ratio = 1;
  CHECK(what_it_does(offered) == "fitted to");

  Diagnosis made = made_up();
  made.law = offered;
  CHECK(has_words(as_text(made), law_as_text(offered)));
  CHECK(as_json(made)["law"] == law_as_json(offered));
  CHECK(as_json(made)["shrink"]["of"] == "cause");
  made.cause.verdict = CauseVerdict::unknown;
  CHECK(has_words(as_text(made), law_as_text(offered)));
  CHECK(has_words(as_text(made), "the torque law leaves "));
  CHECK(as_json(made)["shrink"]["of"] == "law");
}
