#include <doctest/doctest.h>

#include "diagnose/report/sketch.hpp"
#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const std::string headline_in_words =
    "three links\n\n"
    "Identified: play in joint 2 and the weight of the links\n"
    "  backlash(2): b = 0.0312 rad (95 %: 0.0301 to 0.0323)\n"
    "  gravity: rho = 0.81 kg/m (95 %: 0.7 to 0.9)\n"
    "  this cause leaves 12.5 % of the held-out residual; noise alone 11 %\n"
    "  2 values have no weight: outliers, up to 310 standard deviations off, the largest x at reading 4 of "
    "load-2\n";

const std::string gap_in_words =
    "\nIs there a gap?  Yes (probability of a gap > 0.999): the nominal model misses Fx 0.25 N, q2 0.0031 "
    "rad "
    "rms, chi-square per value 12.5\n"
    "  noise over declared: Fx 2.00, Fy 1.00, q 0.50, x 1.00, y 1.04; autocorrelation of successive "
    "readings: "
    "Fx 0.12, Fy 0.12, q 0.03 to 0.05, x 0, y 0\n"
    "  the noise of Fx grows with the reading, by 2.1 % of it\n"
    "  the force noise of run load-2 is 2.7 times that of the other runs\n"
    "  the angle noise of readings 4-9 of press-1 is 3.2 times that of the others\n"
    "  a coarse display: equal readings in a row share one rounding error\n"
    "  periodic interference in q2 of press-1: period 7.5 readings, 1.2 declared sigmas rms; counted as "
    "noise\n"
    "  outlier: x at reading 4 of load-2, -310 standard deviations; at the end of its run, where an event "
    "would look the same\n"
    "  outlier: Fx at reading 5 of press-1, +12.3 standard deviations\n"
    "  all forces of load-2 point straight down without noise: assumed to be weights\n"
    "  press-1b goes on where press-1 ends, in time and command: read as one run\n"
    "  temperature has no value at 3 of 9 readings of load-2: interpolated in time\n"
    "  of the 9000 readings of load-2 800 are used\n"
    "  from reading 3 of press-1 on the chain is on the other post-critical branch, which imperfections "
    "choose; "
    "the model is started on the same one\n";

const std::string where_in_words =
    "\nWhere?  Shares of the squared residual above noise\n"
    "  channels: Fx 75 %, q2 25 %\n"
    "  runs:     press-1 90 %, load-2 10 %\n"
    "  path:     press-1 readings 3-6 (post-critical) 60 %, press-1 readings 7-12 (unloading) 39 %\n"
    "  joints:   2 80 %, 3 15 %, 1 5 % (of the measured torque residual)\n";

const std::string cause_in_words =
    "\nWhat?  Identified: backlash(2) + gravity (probability 0.912, chi-square per value 1.04)\n"
    "  backlash(2): play in joint 2\n"
    "    b = 0.0312 rad (95 %: 0.0301 to 0.0323)\n"
    "  gravity: the weight of the links\n"
    "    rho = 0.81 kg/m (95 %: 0.7 to 0.9)\n"
    "  a cause outside the catalogue has probability 0.008\n";

const std::string shrink_in_words =
    "\nHow far?  On held-out readings (2 blocks, in turn), this cause leaves 0.125 of the residual (95 %: "
    "0.101 "
    "to 0.152; noise floor 0.11)\n"
    "  rms before: Fx 0.24 N, q2 0.003 rad\n"
    "  rms after:  Fx 0.031 N, q2 0.0011 rad\n"
    "  3 outliers of the held-out values excluded; with them 0.172\n";

}  // namespace

TEST_CASE("a diagnosis in words, by hand") {
  CHECK(as_text(made_up()) ==
        headline_in_words + gap_in_words + where_in_words + cause_in_words + shrink_in_words);
}

TEST_CASE("the headline names the cause with few values, the number of alternatives, or says unknown") {
  Diagnosis made = made_up();
  const std::string named = "\n\nIdentified: play in joint 2 and the weight of the links\n",
                    left = "  this cause leaves 12.5 % of";
  made.estimates.front().resize(4, made.estimates.front().front());
  CHECK(has_words(as_text(made), named + left));  // five values are too many for the headline
  made = made_up_ambiguous();
  CHECK(has_words(as_text(made),
                  "Ambiguous: play in joint 2 and the weight of the links, or one of 2 "
                  "alternatives below\n"));
  made.cause.unknown = 0.93;
  CHECK(has_words(as_text(made),
                  "2 alternatives below, a cause outside the catalogue the most probable of all\n"));
  made.cause.or_unknown = false;
  CHECK(has_words(as_text(made), "the links, or the alternative below\n"));
  made = made_up_unknown();
  CHECK(has_words(as_text(made),
                  "\n\nUnknown: the cause is outside the catalogue with probability 0.970\n"
                  "  the best partial explanation leaves 12.5 % of the held-out residual"));
  made.shrink->ratio = 1;
  CHECK_FALSE(has_words(as_text(made), "noise alone"));
}

TEST_CASE("the headline names the cause on top of the ranking, or says that it fails to predict") {
  Diagnosis made = made_up();
  std::swap(made.cause.ranking[0], made.cause.ranking[1]);
  made.estimates = {{{"a", "rad", 0.02, 0.019, 0.021, false}}};
  CHECK(has_words(as_text(made),
                  "\n\nIdentified: a wrong zero or rest angle of joint 2\n"
                  "  a = 0.02 rad (95 %: 0.019 to 0.021)\n"));
  made = made_up();
  made.fails_to_predict = true;
  made.cause.verdict = CauseVerdict::unknown;
  made.cause.named = 0;
  made.shrink->ratio = 1.3, made.shrink->ratio_low = 1.1, made.shrink->ratio_high = 1.6;
  const std::string text = as_text(made);
  CHECK(has_words(text,
                  "\n\nUnknown: the most probable cause, play in joint 2 and the weight of the links, fails "
                  "to predict held-out readings\n"));
  CHECK(has_words(text, "  fails to predict held-out readings: backlash(2) + gravity (probability 0.912, "));
  CHECK(has_words(text, "the most probable cause leaves 1.3 of the residual (95 %: 1.1 to 1.6; noise floor"));
  CHECK(as_json(made)["cause"]["fails_to_predict"] == true);
}

TEST_CASE("a cause in part is told with what it leaves, and too few readings are told") {
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::partial;
  made.cause.rest = Rest{0.28, 0.05, "the rest is outside the catalogue"};
  const std::string text = as_text(made);
  CHECK(has_words(
      text,
      "\n\nMostly: play in joint 2 and the weight of the links (part of it with 0.912); the rest is "
      "outside the catalogue\n"));
  CHECK(has_words(text,
                  "  it leaves 28 % of the residual, noise alone 5 %: the rest is outside the catalogue\n"));
  const auto cause = as_json(made)["cause"];
  CHECK(cause["verdict"] == "partial");
  CHECK(cause["rest"]["share"] == 0.28);
  Diagnosis few = made_up();
  few.cause.verdict = CauseVerdict::ambiguous;
  few.cause.too_few_readings = true;
  CHECK(has_words(as_text(few), "\n\nToo few readings to tell: play in joint 2 and the weight of the links"));
}

TEST_CASE("no gap is told with its probability, and with the noise in which there is none") {
  Diagnosis made = made_up_no_gap();
  const std::string gap =
      "Is there a gap?  No (probability of a gap 0.020): the nominal model misses Fx 0.25 N, q2 0.0031 rad "
      "rms, "
      "chi-square per value 1\n"
      "  noise over declared: Fx 2.00, Fy 1.00, q 0.50, x 1.00, y 1.04; autocorrelation of successive "
      "readings: "
      "Fx 0.12, Fy 0.12, q 0.03 to 0.05, x 0, y 0\n";
  CHECK(as_text(made) ==
        "three links\n\nNo gap: the nominal model fits the readings to within noise of Fx 2.00, Fy 1.00, q "
        "0.50, "
        "x 1.00, y 1.04 times the declared one\n\n" +
            gap);
  made.noise.channels[2].scale = 0.0333;
  made.noise.channels[4].scale = 6.6;
  CHECK(has_words(as_text(made), "to within noise of Fx 0.033, Fy 1.00, q 0.50 to 6.60, x"));
  made.gap.outliers = {{"press-1", 11, of_Fx, 301.2, true}};
  CHECK(has_words(as_text(made),
                  "times the declared one\n  1 value has no weight: an outlier, 301 standard "
                  "deviations off, Fx at reading 11 of press-1\n"));
}

TEST_CASE("of many outliers the largest stand on lines of their own, the rest as a number") {
  Diagnosis made = made_up_no_gap();
  for (std::size_t i = 0; i < 6; ++i)
    made.gap.outliers.push_back({"press-1", i, of_Fx, 20 - static_cast<double>(i), false});
  CHECK(has_words(as_text(made), "Fx at reading 5 of press-1, +15 standard deviations\n"));
  CHECK_FALSE(has_words(as_text(made), "smaller outlier"));
  made.gap.outliers.push_back({"press-1", 9, of_Fx, 9, false});
  made.gap.outliers.push_back({"press-1", 7, of_Fx, 8, false});
  CHECK(has_words(as_text(made), "  2 smaller outliers (--json: gap.outliers)\n"));
  CHECK(has_words(as_text(made),
                  "  8 values have no weight: outliers, up to 20 standard deviations off, the "
                  "largest Fx at reading 0 of press-1\n"));
  CHECK(as_json(made)["gap"]["outliers"].size() == 8);
}

TEST_CASE("channels of a run that share an interference stand on one line") {
  Diagnosis made = made_up_no_gap();
  made.gap.interference = {
      {"press-1", of_Fx, 3.7, 1.6}, {"press-1", of_q2, 3.7, 1.9}, {"load-2", of_Fx, 3.7, 1}};
  const std::string interference = "  periodic interference in ",
                    counted = " declared sigmas rms; counted as noise\n";
  CHECK(has_words(as_text(made), interference + "Fx, q2 of press-1: period 3.7 readings, up to 1.9" +
                                     counted + interference + "Fx of load-2: period 3.7 readings, 1.0" +
                                     counted));
}

TEST_CASE("an ambiguous cause in words: discrepancy, alternatives, single effects, no excitation") {
  Diagnosis made = made_up_ambiguous();
  made.not_excited = {{"tip_payload"}, {"joint_stop", 1}};
  made.estimates[0][0].low = made.estimates[0][0].high;
  made.estimates[1][0] = {"rho", "ratio", 0.81, 0.7, 0.9, true};
  CHECK(
      has_words(as_text(made),
                "What?  Ambiguous: backlash(2) + gravity (probability 0.912, chi-square per value 1.04)\n"
                "  backlash(2): play in joint 2\n"
                "    b = 0.0312 rad (no bounds found)\n"
                "  gravity: the weight of the links\n"
                "    rho = 0.81 (95 %: 0.7 to 0.9; at its bound)\n"
                "  model discrepancy: 0.012 N m at the joints, 7 % of the nominal residual beside the noise\n"
                "  or rest_angle(2) (probability 0.050)\n"
                "  or a cause outside the catalogue (probability 0.008)\n"
                "  play in joint 2 is part of it with probability 0.960\n"
                "  the weight of the links is part of it with probability 0.913\n"
                "  not excited by these runs, so neither found nor excluded: tip_payload, joint_stop(1)\n"));
  for (std::size_t joint = 2; joint < 7; ++joint) made.not_excited.push_back({"joint_stop", joint});
  CHECK(has_words(as_text(made), "neither found nor excluded: 7 effects (--json: cause.not_excited)\n"));
}

TEST_CASE("manufacturing tolerances beside a cause are said, and their values are not listed") {
  Diagnosis made = made_up();
  Hypothesis& lead = made.cause.ranking.front().hypothesis;
  for (const Effect& row : catalogue())
    if (row.is_tolerance) {
      lead.candidate.effects.emplace_back(row);
      made.estimates.push_back({{"a_1", "ratio", 0.01, 0, 0.02, false}});
    }
  const std::string text = as_text(made);
  CHECK(has_words(text, "  manufacturing tolerances show beside it\n"));
  CHECK_FALSE(has_words(text, "a_1"));
}

TEST_CASE("how far, in words: no reduction, not tested") {
  Diagnosis made = made_up();
  made.shrink->ratio = 1;
  CHECK(has_words(
      as_text(made),
      "this cause leaves 1 of the residual (95 %: 0.101 to 0.152; noise floor 0.11)\n  rms before"));
  made.shrink->heldout = {"press-1"};
  CHECK(has_words(as_text(made), "On held-out readings (1 run), this cause"));
  made.shrink->heldout = {"press-1", "load-2"};
  CHECK(has_words(as_text(made), "On held-out readings (2 runs, in turn), this cause"));
  made.shrink->noise_floor_ratio = 0.71;
  CHECK(has_words(
      as_text(made),
      "How far?  Not tested: noise is 71 % of the residual in the held-out readings (2 runs, in turn)"));
  made.shrink.reset();
  CHECK(has_words(as_text(made), "How far?  Not tested: too few readings to hold some out of the fit\n"));
}

TEST_CASE("what to measure next, in words and as JSON") {
  Diagnosis made = made_up();
  made.proposals = {proposal("press farther", 5, 4), proposal("load", 14.1, 4), proposal("turn", 13.9, 4)};
  const std::string text = as_text(made), next = text.substr(text.find("\nWhat next?"));
  CHECK(next ==
        "\nWhat next?  The runs that best distinguish the explanations, with the expected odds for the true "
        "one\n"
        "  press farther: 148 to one\n"
        "  load: over a million to one\n"
        "  turn: 1.09e+06 to one\n"
        "  (for the runs so far the same forecast gives 54.6 to one)\n");
  made.proposals.front().log_odds_so_far = 2.9;
  CHECK_FALSE(has_words(as_text(made), "for the runs so far"));
  const ReportJson list = as_json(made)["next"];
  REQUIRE(list.size() == 3);
  CHECK(list[1] == ReportJson{{"run", "load"}, {"expected_log_odds", 14.1}});
}

TEST_CASE("an unknown cause in words: what is missing, and the best partial explanation") {
  Diagnosis made = made_up_unknown();
  std::string text = as_text(made);
  CHECK(has_words(
      text,
      "What?  Unknown: a cause outside the catalogue has probability 0.970\n"
      "  variance of torque at joint 2 explained by q2: 50 %; by its direction of motion too: 60 %; by time "
      "too: 70 %\n" +
          picture(*made.missing) +
          "  best partial explanation: backlash(2) + gravity (probability 0.020, chi-square per value "
          "1.04)\n"));
  CHECK(has_words(text, "the best partial explanation leaves 0.125 of the residual"));
  CHECK_FALSE(has_words(text, "is part of it"));  // with less than 0.1
  made.cause.effects = {
      {"joint_friction(1)", 0.41}, {"backlash(2)", 0.12}, {"gravity", 0.11}, {"hysteresis", 0.1}};
  text = as_text(made);
  CHECK(has_words(text,
                  "  joint_friction(1) is part of it with probability 0.410\n"  // not in the ranking
                  "  play in joint 2 is part of it with probability 0.120\n"
                  "  the weight of the links is part of it with probability 0.110\n"));
  CHECK_FALSE(has_words(text, "hysteresis is part of it"));
}

TEST_CASE("the missing torque drawn in text, by hand") {
  Missing missing{"Fx", "N", "x", "m", {}, 0, 0, 0};
  CHECK(picture(missing) == "");
  missing.against_unit = "m", missing.unit = "N";
  missing.points = {{0, 0, 0, false},     {1, 10, 1, false},    {0.5, 5, 2, false},  {0.5, 5, 3, true},
                    {0.25, 2.5, 4, true}, {0.25, 2.5, 5, true}, {0.75, -1, 6, false}};
  // From -1 to 10 in eleven rows of one each, from 0 to 1 in 58 columns.
  std::vector<std::string> rows(11, std::string(58, ' '));
  rows[9] = std::string(58, '.');
  rows[9][0] = '>', rows[0][57] = '>', rows[4][29] = '8', rows[7][14] = '<', rows[10][43] = '>';
  std::string expected = "  Fx (N) over x (m); > rising, < falling, 8 both\n";
  for (std::size_t r = 0; r < 11; ++r)
    expected += std::string(r == 0 || r == 10 ? "        " : "          ") +
                (r == 0    ? "10"
                 : r == 10 ? "-1"
                           : "") +
                " |" + rows[r] + "\n";
  expected += "           +" + std::string(58, '-') + "\n            0" + std::string(56, ' ') + "1\n";
  CHECK(picture(missing) == expected);
  missing.points = {{0.5, 3, 0, false}};  // one place: in the middle
  CHECK(has_words(picture(missing), " |" + std::string(29, ' ') + ">" + std::string(28, ' ') + "\n"));
}
