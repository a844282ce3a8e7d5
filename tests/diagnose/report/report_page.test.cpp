#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "diagnose/report/charts.hpp"
#include "tests/diagnose/chain_values.hpp"
#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// The number as the page must show it.
std::string marked(const ReportJson& report, const std::string& key) {
  return "<data value=\"" + ReportJson(report.at(ReportJson::json_pointer(key)).get<double>()).dump() +
         "\" data-key=\"" + key + "\">";
}

}  // namespace

TEST_CASE("a page has the numbers of the JSON at its keys, and the verdict") {
  const Study study(measured(small_bench(), {{{"backlash", 2}, {"gravity"}}}, {0.0312, 0.02}, 4));
  const Diagnosis made = made_up();
  const ReportJson report = as_json(made);
  const std::string page = as_html(study, made);
  static const std::regex number(R"re(<data value="([^"]*)" data-key="([^"]*)">)re");
  int found = 0;
  for (std::sregex_iterator one(page.begin(), page.end(), number), end; one != end; ++one, ++found) {
    CAPTURE((*one)[2].str());
    CHECK(report.at(ReportJson::json_pointer((*one)[2].str())).get<double>() == std::stod((*one)[1].str()));
  }
  CHECK(found > 60);
  for (const char* key : {"/gap/probability",
                          "/gap/chi2_per_dof",
                          "/gap/noise/scale/Fx",
                          "/gap/noise/scale/q2",
                          "/gap/noise/correlation/Fy",
                          "/gap/noise/correlation/q3",
                          "/gap/proportional_noise/Fx",
                          "/gap/outliers/0/reading",
                          "/gap/outliers/0/deviation",
                          "/gap/outliers/1/reading",
                          "/gap/outliers/1/deviation",
                          "/gap/noisier_runs/0/factor",
                          "/gap/noisier_segments/0/from",
                          "/gap/noisier_segments/0/to",
                          "/gap/noisier_segments/0/factor",
                          "/gap/periodic_interference/0/period",
                          "/gap/periodic_interference/0/rms",
                          "/where/joints/2/share",
                          "/where/runs/1/share",
                          "/where/channels/1/share",
                          "/where/load_path/3/share",
                          "/where/load_path/3/from",
                          "/where/load_path/3/to",
                          "/shrink/ratio",
                          "/shrink/ratio_low",
                          "/shrink/ratio_high",
                          "/shrink/noise_floor_ratio",
                          "/shrink/chi2_per_dof_after",
                          "/shrink/outliers/count",
                          "/shrink/outliers/ratio_with",
                          "/cause/ranking/3/probability",
                          "/cause/ranking/2/chi2_per_dof",
                          "/shrink/channels/q2/ratio",
                          "/shrink/channels/q2/ratio_high",
                          "/shrink/channels/q2/ratio_low",
                          "/shrink/channels/q2/noise_floor_ratio"}) {
    CAPTURE(key);
    CHECK(has_words(page, marked(report, key)));
  }
  CHECK(has_words(page, "<h1>Diagnosis of three links</h1>"));
  CHECK(has_words(page, "the gap is caused by <strong>play in joint 2 and the weight of the links</strong>"));
  CHECK(has_words(page, "nominal model: Fx " + marked(report, "/gap/rms/Fx") + "0.25</data> N, q2 " +
                            marked(report, "/gap/rms/q2") + "0.0031</data> rad."));
  CHECK(has_words(page, "All forces of load-2 point straight down"));
  CHECK(has_words(page, "Yes: the probability of a gap is " + marked(report, "/gap/probability")));
  CHECK(has_words(page, "2 values have no weight in this verdict: outliers, the largest " +
                            marked(report, "/gap/outliers/0/deviation") +
                            "−310</data> standard deviations off, x at "
                            "reading " +
                            marked(report, "/gap/outliers/0/reading") + "4</data> of load-2."));
  CHECK(has_words(page, "equal readings in a row share one rounding error"));
  const std::string effect = "/cause/effects/0/parameters/b/";
  CHECK(has_words(page, "<tr><td><span class=\"id\">backlash</span></td><td>" +
                            marked(report, "/cause/effects/0/joint") +
                            "2</data></td><td>b</td><td class=\"number\">" +
                            marked(report, effect + "value") + "0.0312</data></td><td class=\"number\">" +
                            marked(report, effect + "low") + "0.0301</data></td><td class=\"number\">" +
                            marked(report, effect + "high") + "0.0323</data></td><td>rad</td></tr>"));
  CHECK(has_words(page, "<tr><td><span class=\"id\">gravity</span></td><td>–</td><td>rho</td>"));
  CHECK(
      has_words(page, "<tr><td>q2, rad</td><td class=\"number\">" + marked(report, "/shrink/rms_before/q2") +
                          "0.003</data></td><td class=\"number\">" + marked(report, "/shrink/rms_after/q2")));
  CHECK(has_words(page, "<span style=\"width:75.0%\"></span></span>" +
                            marked(report, "/where/channels/0/share") + "75 %</data>"));
  CHECK(has_words(page, "<span style=\"width:91.2%\"></span></span>" +
                            marked(report, "/cause/ranking/0/probability") + "91.2 %</data>"));
  CHECK(has_words(page, "On held-out readings (press-1[1:2], load-2, in turn) this cause leaves "));
  CHECK(has_words(page, "12.5 % of the residual") == false);  // the number stands in its mark
  CHECK(has_words(page, "On held-out readings this cause leaves " + marked(report, "/shrink/ratio") +
                            "12.5 %</data> of the residual (95 %: "));
  // Alternatives with a hundredth and more, and what this bench cannot show.
  CHECK(has_words(page, "<span class=\"id\">rest_angle(2)</span>: less probable, with " +
                            marked(report, "/cause/ranking/1/probability")));
  CHECK(has_words(page, "<span class=\"id\">force_gain</span>: less probable, with "));
  CHECK_FALSE(has_words(page, "a cause outside the catalogue, with probability"));
  CHECK(has_words(page, ", saturation, "));
  CHECK(has_words(page, "</span>: not considered: on this bench"));
  CHECK(has_words(page, "The area of a ring is the joint’s share."));
  CHECK(has_words(page, "corrected model: backlash(2) + gravity"));
  CHECK_FALSE(has_words(page, "model discrepancy"));
  CHECK_FALSE(has_words(page, "is part of the cause"));
  CHECK_FALSE(has_words(page, "<section id=\"next\">"));
}

TEST_CASE("a page of an ambiguous cause, of an unknown one, and of none") {
  const Study study(measured(small_bench(), only("backlash", 2), {0.0312}, 4));
  Diagnosis made = made_up_ambiguous();
  made.not_excited = {{"tip_payload"}, {"joint_stop", 1}};
  made.proposals = {proposal("press farther", 5, 4)};
  std::string page = as_html(study, made);
  ReportJson report = as_json(made);
  CHECK(has_words(
      page,
      "cannot distinguish it from a wrong zero or rest angle of joint 2 or a cause outside the catalogue."));
  CHECK(has_words(page,
                  "<span class=\"id\">rest_angle(2)</span>: these readings do not distinguish it from the "
                  "best; probability " +
                      marked(report, "/cause/ranking/1/probability")));
  CHECK(has_words(page, "<span class=\"id\">force_gain</span>: less probable, with "));
  CHECK(
      has_words(page, "<span class=\"id\">unknown</span>: a cause outside the catalogue, with probability " +
                          marked(report, "/cause/ranking/3/probability")));
  CHECK(has_words(page, "<span class=\"id\">tip_payload, joint_stop(1)</span>: not excited"));
  CHECK(has_words(page, "A model discrepancy of " + marked(report, "/cause/discrepancy_torque") +
                            "0.0123</data> N m at the joints remains, " +
                            marked(report, "/cause/discrepancy")));
  CHECK(has_words(page, "<li>the weight of the links is part of the cause with probability " +
                            marked(report, "/cause/effect_probabilities/1/probability")));
  CHECK(has_words(page, "<section id=\"next\">"));
  CHECK(has_words(page, "<li>press farther: "));

  made.cause.unknown = 0.93;
  CHECK(has_words(as_html(study, made), "or a cause outside the catalogue, which is more probable."));

  made = made_up_unknown();
  report = as_json(made);
  page = as_html(study, made);
  CHECK(has_words(page, "the cause is outside the catalogue with probability " +
                            marked(report, "/cause/ranking/0/probability") +
                            "97 %</data>. Most of the gap is in Fx of run press-1 and at joint 2."));
  CHECK(has_words(page,
                  "The best partial explanation is <span class=\"id\">backlash(2) + gravity</span>, play in "
                  "joint 2 and the weight of the links."));
  CHECK(has_words(page, "On held-out readings the best partial explanation leaves "));
  CHECK(has_words(page, "Unexplained torque at joint 2 over q2: dots where q2 rises, rings where it falls"));
  made.where.joints[0].share = 0.5;
  CHECK(has_words(as_html(study, made), "Most of the gap is in Fx of run press-1."));

  made = made_up();
  made.cause.verdict = CauseVerdict::unknown;
  made.cause.named = 0;
  made.fails_to_predict = true;
  page = as_html(study, made);
  CHECK(has_words(page,
                  "the most probable cause, play in joint 2 and the weight of the links, fails to predict "
                  "held-out readings. Most of"));
  CHECK(has_words(page, "On held-out readings the most probable cause leaves "));

  made = made_up_no_gap();
  page = as_html(study, made);
  CHECK(
      has_words(page, "<strong>No gap.</strong> The nominal model fits the readings to within noise of x "));
  CHECK(has_words(page, marked(as_json(made), "/gap/noise/scale/q3") + "0.5</data> times the declared one."));
  CHECK_FALSE(has_words(page, "<section id=\"where\">"));
  CHECK_FALSE(has_words(page, "</svg>after: "));
  CHECK_FALSE(has_words(page, "no weight in this verdict"));
}

TEST_CASE("the command of a run: how far it has gone, along where it goes farthest") {
  Run run{"press", Control::end_point, {0}, {}};
  for (const auto& [x, y] :
       {std::pair(1.0, 1.0), std::pair(0.7, 0.6), std::pair(0.4, 0.2), std::pair(1.3, 0.6)})
    run.readings.push_back({0, chain_values(x, y, 0, 2 * y, {0})});
  const Command command = command_of(run);
  CHECK(command.farthest == 2);
  CHECK(command.label == "end point moved along (−0.60, −0.80), m");
  // (x - 1, y - 1) . (-0.6, -0.8)
  const double along[] = {0, 0.5, 1, 0.14};
  for (std::size_t i = 0; i < 4; ++i) CHECK(command.along[i] == doctest::Approx(along[i]).epsilon(1e-12));
  run.control = Control::force;
  CHECK(command_of(run).label == "force added along −y, N");
  std::reverse(run.readings.begin(), run.readings.end());
  run.readings.erase(run.readings.begin());
  CHECK(command_of(run).label == "force added along +y, N");
  for (Reading& r : run.readings) std::swap(r[column_Fx], r[column_Fy]);
  CHECK(command_of(run).label == "force added along +x, N");
  for (Reading& r : run.readings) r[column_Fx] = -r[column_Fx];
  CHECK(command_of(run).label == "force added along −x, N");
  run.readings.resize(1);
  CHECK(command_of(run).along == std::vector<double>{0});
}
