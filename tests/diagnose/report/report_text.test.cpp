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
    "  this cause leaves 12.5 % of the held-out residual; noise alone 11 %\n";

const std::string gap_in_words =
    "\nIs there a gap?  Yes (p = 1e-05): the nominal model misses Fx 0.25 N, q2 0.0031 rad rms, chi-square "
    "per "
    "value 12.5\n"
    "  noise over declared: Fx 2.00, q 0.50; autocorrelation of successive readings 0.12 (force), 0.03 "
    "(angle)\n"
    "  the noise of Fx is 2.0 times the declared one\n"
    "  the noise of q is 0.5 times the declared one\n"
    "  the noise of Fx grows with the reading, by 2.1 % of it\n"
    "  the noise of q2 is 3.2 times that of the other joint angles\n"
    "  the force noise of run load-2 is 2.7 times that of the other runs\n"
    "  the angle noise of readings 4-9 of press-1 is 3.2 times that of the others\n"
    "  periodic interference in q2 of press-1: period 7.5 readings, 1.2 declared sigmas rms; counted as "
    "noise\n"
    "  all forces of load-2 point straight down without noise: assumed to be weights\n"
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
    "\nWhat?  Identified: backlash(2) + gravity (probability 0.912, chi-square per degree of freedom 1.04)\n"
    "  backlash(2): play in joint 2\n"
    "    b = 0.0312 rad (95 %: 0.0301 to 0.0323)\n"
    "  gravity: the weight of the links\n"
    "    rho = 0.81 kg/m (95 %: 0.7 to 0.9)\n"
    "  a cause outside the catalogue: probability 0.008\n";

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
  made.cause.best = 1;
  made.estimates = {{{"a", "rad", 0.02, 0.019, 0.021, false}}};
  const std::string named = "\n\nIdentified: a wrong rest angle of joint 2\n",
                    value = "  a = 0.02 rad (95 %: 0.019 to 0.021)\n", left = "  this cause leaves 12.5 % of";
  CHECK(has_words(as_text(made), named + value + left));
  made.estimates.front().resize(5, made.estimates.front().front());
  CHECK(has_words(as_text(made), named + left));  // too many values for the headline
  made.cause.verdict = CauseVerdict::ambiguous;
  made.cause.equivalent = {0};
  CHECK(has_words(as_text(made), "joint 2, or one of 1 alternative below\n"));
  made.cause.reservation = Reservation::not_predicted;
  CHECK(has_words(as_text(made), "joint 2, or one of 2 alternatives below\n"));
  made.cause.verdict = CauseVerdict::unknown;
  CHECK(has_words(as_text(made), "\n\nUnknown: the catalogue has no explanation of the gap\n"));
  made.shrink->ratio = 1;
  CHECK_FALSE(has_words(as_text(made), "noise alone"));
}

TEST_CASE("readings that scatter far less than was declared are told with their digits") {
  Diagnosis made = made_up();
  made.noise.scale = {1, 1, 0.15, 1, 0.0333};
  const std::string text = as_text(made);
  CHECK(text.find("  noise over declared: Fx 0.15, q 0.033;") != std::string::npos);
  CHECK(text.find("  the noise of Fx is 0.15 times the declared one\n") != std::string::npos);
  CHECK(text.find("  the noise of q is 0.033 times the declared one\n") != std::string::npos);
  made.noise.scale = {1, 1, 1.96, 1, 1};
  CHECK(as_text(made).find("  the noise of Fx is 2.0 times the declared one\n") != std::string::npos);
}

TEST_CASE("what else the words may say: no gap, interference, discrepancy, alternatives, no excitation") {
  Diagnosis made = made_up();
  made.gap.hum = {{"press-1", of_Fx, 3.7, 1.6}};
  made.gap.present = false;
  made.noise.scale = {1, 1, 1.5, 1, 1 / 1.5};
  made.gap.proportional.clear(), made.gap.uneven.clear(), made.gap.taken_for_weights.clear();
  made.gap.rougher.clear(), made.gap.rougher_stretches.clear(), made.gap.other_branch.clear();
  const std::string interference = "  periodic interference in ",
                    counted = " declared sigmas rms; counted as noise\n";
  CHECK(as_text(made) ==
        "three links\n\nNo gap: the nominal model fits the readings to within their noise\n\n"
        "Is there a gap?  No (p = 1e-05): the nominal model misses Fx 0.25 N, q2 0.0031 rad rms, chi-square "
        "per "
        "value 12.5\n"
        "  noise over declared: Fx 1.50, q 0.67; autocorrelation of successive readings 0.12 (force), 0.03 "
        "(angle)\n" +
            interference + "Fx of press-1: period 3.7 readings, 1.6" + counted);
  CHECK_FALSE(has_words(as_text(made), "ripple"));
  made.gap.hum = {{"press-1", of_Fx, 3.7, 1.6}, {"press-1", of_q2, 3.6, 1.9}, {"load-2", of_Fx, 3.7, 1}};
  CHECK(has_words(as_text(made), interference + "Fx, q2 of press-1: period 3.7 readings, up to 1.9" +
                                     counted + interference + "Fx of load-2: period 3.7 readings, 1.0" +
                                     counted));
  made.noise.scale[2] = 6;  // of Fx, beyond five
  CHECK(
      has_words(as_text(made), "  noise this large may hide a ripple of the device finer than the readings"));

  made = made_up();
  made.cause.verdict = CauseVerdict::ambiguous;
  made.cause.remainder = 0.07;
  made.cause.equivalent = {1};
  made.cause.reservation = Reservation::not_predicted;
  made.not_excited = {{"tip_payload"}, {"joint_stop", 1}};
  made.estimates[0][0].low = made.estimates[0][0].high;
  made.estimates[1][0] = {"rho", "ratio", 0.81, 0.7, 0.9, true};
  CHECK(has_words(
      as_text(made),
      "What?  Ambiguous: backlash(2) + gravity (probability 0.912, chi-square per degree of freedom 1.04)\n"
      "  backlash(2): play in joint 2\n"
      "    b = 0.0312 rad (no bounds found)\n"
      "  gravity: the weight of the links\n"
      "    rho = 0.81 (95 %: 0.7 to 0.9; at its bound)\n"
      "  model discrepancy: 7 % of the gap remains on held-out readings\n"
      "  or rest_angle(2)\n"
      "  a cause outside the catalogue: probability 0.008\n"
      "  caveat: " +
          reservation_words(Reservation::not_predicted) +
          "\n  not excited by these runs, so neither found nor excluded: tip_payload, joint_stop(1)\n"));
  for (std::size_t joint = 2; joint < 7; ++joint) made.not_excited.push_back({"joint_stop", joint});
  CHECK(has_words(as_text(made), "neither found nor excluded: 7 effects (--json: cause.not_excited)\n"));
}

TEST_CASE("of many alternatives the most probable stand on lines of their own, the rest as a number") {
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::ambiguous;
  for (std::size_t joint = 1; joint <= 6; ++joint)
    made.cause.ranking.push_back(
        ranked({{{"joint_stop", joint}}}, {0.1, 2}, 0.001 * static_cast<double>(joint), 1.2));
  made.cause.equivalent = {2, 1, 3, 4, 5, 6, 7};
  CHECK(has_words(as_text(made), "  or rest_angle(2)\n  or force_gain\n  or joint_stop(5)\n"));
  CHECK(has_words(as_text(made), "  or joint_stop(1)\n"));
  made.cause.equivalent.push_back(8);
  CHECK(has_words(as_text(made), "  or joint_stop(6)\n"));
  CHECK(
      has_words(as_text(made),
                "  or joint_stop(3)\n  or one of 2 less probable explanations (--json: cause.equivalent)\n"));
}

TEST_CASE("how far, in words: not tested, no reduction, optimistic, nothing that predicts") {
  Diagnosis made = made_up();
  made.shrink->chosen_blind = false;
  made.shrink->ratio = 1;
  CHECK(has_words(as_text(made),
                  "this cause leaves 1 of the residual (95 %: 0.101 to 0.152; noise floor 0.11)\n"
                  "  optimistic: without these readings another explanation would be selected\n"));
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
  made.nothing_predicts = true;
  CHECK(has_words(as_text(made),
                  "How far?  No explanation predicts held-out readings better than the nominal model\n"));
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
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::unknown;
  made.cause.best = 1;
  made.missing = Missing{"torque at joint 2", "N m", "q2", "rad", {{0.1, 0.2, 0.3, true}}, 0.5, 0.6, 0.7};
  const std::string text = as_text(made);
  CHECK(has_words(
      text,
      "What?  Unknown: no one or two effects of the catalogue explain the gap\n"
      "  variance of torque at joint 2 explained by q2: 50 %; by its direction of motion too: 60 %; by time "
      "too: 70 %\n" +
          picture(*made.missing) +
          "  best partial explanation: rest_angle(2) (chi-square per degree of freedom 1.1)\n"));
  CHECK(has_words(text, "the best partial explanation leaves 0.125 of the residual"));
  CHECK(as_json(made)["shrink"]["of"] == "partial");
}

TEST_CASE("what is missing as a picture of letters, by hand") {
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
