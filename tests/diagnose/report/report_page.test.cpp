#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "diagnose/report/charts.hpp"
#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// What the page would have to hold so that a program finds the number again.
std::string marked(const ReportJson& report, const std::string& key) {
  return "<data value=\"" + ReportJson(report.at(ReportJson::json_pointer(key)).get<double>()).dump() +
         "\" data-key=\"" + key + "\">";
}

}  // namespace

TEST_CASE("a page holds the numbers of the JSON at its keys, and says what was found") {
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
  for (const char* key : {"/gap/p_value",
                          "/gap/chi2_per_dof",
                          "/gap/noise/Fx",
                          "/gap/noise/q",
                          "/gap/noise/correlations/force",
                          "/gap/noise/correlations/angle",
                          "/gap/proportional_noise/Fx",
                          "/gap/noisier_joints/q2",
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
                          "/shrink/left_out/values",
                          "/shrink/left_out/ratio_with",
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
  CHECK(has_words(page, "The forces of load-2 point straight down"));
  CHECK(has_words(page, "below 0.01 there is a gap"));
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
  CHECK(has_words(page,
                  marked(report, "/shrink/ratio") + "12.5 %</data> of the residual is left with this cause"));
  // Alternatives with a hundredth and more, and what this bench cannot show.
  CHECK(has_words(page, "<span class=\"id\">rest_angle(2)</span>: less probable, with " +
                            marked(report, "/cause/ranking/1/probability")));
  CHECK(has_words(page, "<span class=\"id\">force_gain</span>: less probable, with "));
  CHECK_FALSE(has_words(page, "a cause outside the catalogue, with probability"));
  CHECK(has_words(page, "saturation</span>: not considered: on this bench"));
  CHECK(has_words(page, "The area of a ring is the joint’s share."));
  CHECK(has_words(page, "corrected model: backlash(2) + gravity"));
  CHECK_FALSE(has_words(page, "Model discrepancy"));
  CHECK_FALSE(has_words(page, "<section id=\"next\">"));
}

TEST_CASE("a page of an ambiguous cause, of an unknown one, and of none") {
  const Study study(measured(small_bench(), only("backlash", 2), {0.0312}, 4));
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::ambiguous;
  made.cause.equivalent = {1, 2};
  made.cause.remainder = 0.07;
  made.cause.reservation = Reservation::many_values;
  made.not_excited = {{"tip_payload"}, {"joint_stop", 1}};
  made.proposals = {proposal("press farther", 5, 4)};
  std::string page = as_html(study, made);
  CHECK(has_words(page,
                  "cannot tell it from a wrong rest angle of joint 2, a scale error of the load cell or a "
                  "cause outside the catalogue."));
  CHECK(has_words(page,
                  "<span class=\"id\">rest_angle(2)</span>: these readings do not tell it from the best<"));
  CHECK_FALSE(has_words(page, "less probable, with"));
  CHECK(has_words(page, "<span class=\"id\">unknown</span>: " + reservation_words(Reservation::many_values)));
  CHECK(has_words(page, "<span class=\"id\">tip_payload, joint_stop(1)</span>: not excited"));
  CHECK(has_words(page, "Model discrepancy: "));
  CHECK(has_words(page, "<section id=\"next\">"));
  CHECK(has_words(page, "<li>press farther: "));

  made = made_up();
  made.cause.verdict = CauseVerdict::unknown;
  made.cause.unknown = 0.97;
  made.missing = Missing{"torque at joint 2", "N m", "q2", "rad", {{0.1, 0.2, 0.3, true}}, 0.5, 0.6, 0.7};
  page = as_html(study, made);
  CHECK(has_words(
      page, "there is a gap, most of it in Fx of run press-1 and at joint 2, and no one or two effects"));
  CHECK(has_words(page, "The best partial explanation is play in joint 2 and the weight of the links."));
  CHECK(has_words(page, "On held-out readings the best partial explanation leaves "));
  CHECK(has_words(page, "Unexplained torque at joint 2 over q2: dots where q2 rises, rings where it falls"));
  // the unknown leads the candidates
  const std::size_t candidates = page.find("<h3>Candidates</h3>");
  CHECK(page.find("<span class=\"id\">unknown</span>", candidates) <
        page.find("<span class=\"id\">backlash(2) + gravity</span>", candidates));
  made.where.joints[0].share = 0.5;
  CHECK(has_words(as_html(study, made), "most of it in Fx of run press-1, and no one or two effects"));

  made.gap.present = false;
  made.cause = {};
  made.shrink.reset();
  made.missing.reset();
  page = as_html(study, made);
  CHECK(has_words(page, "<strong>No gap.</strong>"));
  CHECK_FALSE(has_words(page, "<section id=\"where\">"));
  CHECK_FALSE(has_words(page, "</svg>after: "));
  CHECK_FALSE(has_words(page, "ripple"));
  made.noise.scale[2] = 6;  // of Fx, beyond five
  CHECK(has_words(as_html(study, made), "may hide a ripple of the device finer than the readings"));
}

TEST_CASE("the command of a run: how far it has gone, along where it goes farthest") {
  Run run{"press", Control::end_point, {0}, {}};
  for (const auto& [x, y] :
       {std::pair(1.0, 1.0), std::pair(0.7, 0.6), std::pair(0.4, 0.2), std::pair(1.3, 0.6)})
    run.readings.push_back({0, x, y, 0, 2 * y, {0}});
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
  for (Reading& r : run.readings) std::swap(r.Fx, r.Fy);
  CHECK(command_of(run).label == "force added along +x, N");
  for (Reading& r : run.readings) r.Fx = -r.Fx;
  CHECK(command_of(run).label == "force added along −x, N");
  run.readings.resize(1);
  CHECK(command_of(run).along == std::vector<double>{0});
}
