#include <doctest/doctest.h>

#include "diagnose/report/sketch.hpp"
#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const std::string gap_in_words =
    "three links\n\n"
    "Is there a gap?  Yes (p = 1e-05; chi-square per value 12.5; rms Fx 0.25 N, q2 0.0031 rad)\n"
    "  noise over declared: Fx 2.00, q 0.50; neighbours correlate by 0.12 (force), 0.03 (angle)\n"
    "  the readings of Fx scatter 2.0 times what was declared\n"
    "  the readings of q scatter 0.5 times what was declared\n"
    "  the readings of Fx scatter by a further 2.1 % of themselves\n"
    "  the readings of q2 scatter 3.2 times as much as those of the other joints\n"
    "  force readings of load-2 scatter 2.7 times as much as those of the other runs\n"
    "  angle readings 4-9 of press-1 scatter 3.2 times as much as elsewhere\n"
    "  the forces of load-2 point straight down and have no noise: taken for weights\n"
    "  from reading 3 of press-1 on the chain is where its imperfections sent it, half a degree of a rest "
    "angle "
    "deciding: so is the model\n"
    "  q2 of press-1 hums every 7.5 readings, 1.2 declared sigmas rms: taken for noise\n";

const std::string where_in_words =
    "\nWhere?  shares of the squared residual beyond noise\n"
    "  channels: Fx 75 %, q2 25 %\n"
    "  runs:     press-1 90 %, load-2 10 %\n"
    "  path:     press-1 readings 3-6 (post-critical) 60 %, press-1 readings 7-12 (unloading) 39 %\n"
    "  joints:   2 80 %, 3 15 %, 1 5 % of the measured missing torque\n";

const std::string cause_in_words =
    "\nWhat?  Identified: backlash(2) + gravity (probability 0.912, chi-square per degree of freedom 1.04)\n"
    "  backlash(2), play in joint 2\n"
    "    b = 0.0312 rad (95 %: 0.0301 to 0.0323)\n"
    "  gravity, the weight of the links\n"
    "    rho = 0.81 kg/m (95 %: 0.7 to 0.9)\n"
    "  outside the catalogue with probability 0.008\n";

const std::string shrink_in_words =
    "\nHow far?  On held-out readings (press-1[1:2], load-2), with this cause, the residual shrinks to 0.125 "
    "of itself (95 %: 0.101 to 0.152; noise floor 0.11)\n"
    "  rms before: Fx 0.24 N, q2 0.003 rad\n"
    "  rms after:  Fx 0.031 N, q2 0.0011 rad\n"
    "  without 3 of the values held out, which stand off their neighbours; with them: 0.172\n";

}  // namespace

TEST_CASE("a diagnosis in words, by hand") {
  CHECK(as_text(made_up()) == gap_in_words + where_in_words + cause_in_words + shrink_in_words);
}

TEST_CASE("readings that scatter far less than was declared are told with their digits") {
  Diagnosis made = made_up();
  made.noise.scale = {1, 1, 0.15, 1, 0.0333};
  const std::string text = as_text(made);
  CHECK(text.find("  noise over declared: Fx 0.15, q 0.033;") != std::string::npos);
  CHECK(text.find("  the readings of Fx scatter 0.15 times what was declared\n") != std::string::npos);
  CHECK(text.find("  the readings of q scatter 0.033 times what was declared\n") != std::string::npos);
  made.noise.scale = {1, 1, 1.96, 1, 1};
  CHECK(as_text(made).find("  the readings of Fx scatter 2.0 times what was declared\n") !=
        std::string::npos);
}

TEST_CASE("what else the words may say: no gap, tones, remainders, rivals, what was not exercised") {
  Diagnosis made = made_up();
  made.gap.hum = {{"press-1", of_Fx, 3.7, 1.6}};
  made.gap.present = false;
  made.noise.scale = {1, 1, 1.5, 1, 1 / 1.5};
  made.gap.proportional.clear(), made.gap.uneven.clear(), made.gap.taken_for_weights.clear();
  made.gap.rougher.clear(), made.gap.rougher_stretches.clear(), made.gap.other_branch.clear();
  CHECK(
      as_text(made) ==
      "three links\n\nIs there a gap?  No, the nominal model explains the readings to the noise (p = 1e-05; "
      "chi-square per value 12.5; rms Fx 0.25 N, q2 0.0031 rad)\n"
      "  noise over declared: Fx 1.50, q 0.67; neighbours correlate by 0.12 (force), 0.03 (angle)\n"
      "  Fx of press-1 hums every 3.7 readings, 1.6 declared sigmas rms: taken for noise\n");
  CHECK_FALSE(has_words(as_text(made), "ripple"));
  made.gap.hum = {{"press-1", of_Fx, 3.7, 1.6}, {"press-1", of_q2, 3.6, 1.9}, {"load-2", of_Fx, 3.7, 1}};
  CHECK(
      has_words(as_text(made),
                "  Fx, q2 of press-1 hum every 3.7 readings, up to 1.9 declared sigmas rms: taken for noise\n"
                "  Fx of load-2 hums every 3.7 readings, 1.0 declared sigmas rms: taken for noise\n"));
  made.noise.scale[2] = 6;  // of Fx, beyond five
  CHECK(has_words(as_text(made),
                  "  so much that a ripple of the device finer than the readings may hide in it"));

  made = made_up();
  made.cause.verdict = CauseVerdict::ambiguous;
  made.cause.remainder = 0.07;
  made.cause.equivalent = {1};
  made.cause.reservation = Reservation::not_predicted;
  made.not_excited = {{"tip_payload"}, {"joint_stop", 1}};
  made.estimates[0][0].low = made.estimates[0][0].high;
  made.estimates[1][0] = {"rho", "ratio", 0.81, 0.7, 0.9, true};
  std::string text = as_text(made);
  CHECK(has_words(
      text,
      "What?  Ambiguous: backlash(2) + gravity (probability 0.912, chi-square per degree of freedom "
      "1.04)\n"
      "  backlash(2), play in joint 2\n"
      "    b = 0.0312 rad (no bounds found)\n"
      "  gravity, the weight of the links\n"
      "    rho = 0.81 (95 %: 0.7 to 0.9; at its bound)\n"
      "  with a remainder: 7 % of the gap is left on the readings held out\n"
      "  outside the catalogue with probability 0.008\n"
      "  cannot be told apart from rest_angle(2)\n"
      "  or a cause outside the catalogue: " +
          reservation_words(Reservation::not_predicted) +
          "\n"
          "  neither excluded nor blamed, for the runs never exercise them: tip_payload, "
          "joint_stop(1)\n"));
}

TEST_CASE("of many alternatives the most probable stand on lines of their own, the rest on one") {
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::ambiguous;
  for (std::size_t joint = 1; joint <= 6; ++joint)
    made.cause.ranking.push_back(
        ranked({{{"joint_stop", joint}}}, {0.1, 2}, 0.001 * static_cast<double>(joint), 1.2));
  made.cause.equivalent = {2, 1, 3, 4, 5, 6, 7};
  CHECK(has_words(as_text(made),
                  "  cannot be told apart from rest_angle(2)\n"
                  "  cannot be told apart from force_gain\n"
                  "  cannot be told apart from joint_stop(5)\n"));
  CHECK(has_words(as_text(made), "  cannot be told apart from joint_stop(1)\n"));
  made.cause.equivalent.push_back(8);
  CHECK(has_words(as_text(made), "  cannot be told apart from joint_stop(6)\n"));
  CHECK(has_words(as_text(made),
                  "  cannot be told apart from joint_stop(3)\n"
                  "  nor from 2 less probable ones: joint_stop(2) | joint_stop(1)\n"));
}

TEST_CASE("how far, in words: not tested, not shrinking, not chosen blind, nothing that predicts") {
  Diagnosis made = made_up();
  made.shrink->chosen_blind = false;
  made.shrink->ratio = 1;
  CHECK(has_words(as_text(made),
                  "with this cause, which without them would not be chosen, the residual does not shrink, it "
                  "becomes 1 of itself (95 %: 0.101 to 0.152; noise floor 0.11)\n"));
  made.shrink->noise_floor_ratio = 0.71;
  CHECK(has_words(
      as_text(made),
      "How far?  Not tested: the readings held out (press-1[1:2], load-2) carry too little of the gap, "
      "noise alone is 71 % of them\n"));
  made.shrink.reset();
  CHECK(has_words(as_text(made),
                  "How far?  Not tested: without readings held out too few are left to fit it\n"));
  made.nothing_predicts = true;
  CHECK(has_words(
      as_text(made),
      "How far?  Nothing that was tried leaves less on readings held out than the nominal model\n"));
}

TEST_CASE("what to measure next, in words and as JSON") {
  Diagnosis made = made_up();
  made.proposals = {proposal("press farther", 5, 4), proposal("load", 14.1, 4), proposal("turn", 13.9, 4)};
  const std::string text = as_text(made), next = text.substr(text.find("\nWhat next?"));
  CHECK(next ==
        "\nWhat next?  Runs that would tell the candidates apart, best first; of the runs that there are the "
        "same forecast was 54.6 to one\n"
        "  press farther: expected odds 148 to one\n"
        "  load: expected odds over a million to one\n"
        "  turn: expected odds 1.09e+06 to one\n");
  made.proposals.front().log_odds_so_far = 2.9;
  CHECK(has_words(as_text(made), "best first\n  press farther"));
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
  CHECK(
      has_words(text,
                "What?  Unknown: no effect of the catalogue, alone or in twos, explains the gap\n"
                "  what is missing, as a function of q2: 50 %; of direction too: 60 %; of time too: 70 %\n" +
                    picture(*made.missing) +
                    "  best partial explanation: rest_angle(2) (chi-square per degree of freedom 1.1)\n"));
  CHECK(has_words(text, "with the best partial explanation, the residual shrinks to"));
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
