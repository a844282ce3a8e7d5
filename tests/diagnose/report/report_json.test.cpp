#include <doctest/doctest.h>

#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("every number of a diagnosis stands in its JSON, by hand") {
  const ReportJson json = as_json(made_up());
  CHECK(json["format"] == "gap-diagnosis/2");
  CHECK(json["experiment"] == "three links");
  CHECK(json["gap"] == ReportJson::parse(R"json({"present": true, "p_value": 1e-5, "chi2_per_dof": 12.5,
    "rms": {"Fx": 0.25, "q2": 0.0031}, "noise": {"Fx": 2.0, "q": 0.5, "correlation": 0.12,
      "correlations": {"force": 0.12, "angle": 0.03}},
    "periodic_interference": [{"run": "press-1", "channel": "q2", "period": 7.5, "rms": 1.25}],
    "proportional_noise": {"Fx": 0.021}, "noisier_joints": {"q2": 3.2},
    "noisier_runs": [{"run": "load-2", "sensor": "force", "factor": 2.7}],
    "noisier_segments": [{"run": "press-1", "sensor": "angle", "from": 4, "to": 9, "factor": 3.25}], "assumed_weights": ["load-2"],
    "other_branch": [{"run": "press-1", "from": 3}]})json"));
  CHECK(json["where"] == ReportJson::parse(R"json({
    "channels": [{"channel": "Fx", "share": 0.75}, {"channel": "q2", "share": 0.25}],
    "runs": [{"run": "press-1", "share": 0.9}, {"run": "load-2", "share": 0.1}],
    "load_path": [{"run": "load-2", "from": 0, "to": 4, "share": 0.004, "regime": "pre-critical"},
      {"run": "press-1", "from": 3, "to": 6, "share": 0.6, "regime": "post-critical"},
      {"run": "press-1", "from": 0, "to": 2, "share": 0.006, "regime": "near-critical"},
      {"run": "press-1", "from": 7, "to": 12, "share": 0.39, "regime": "unloading"}],
    "joints": [{"joint": 2, "share": 0.8}, {"joint": 3, "share": 0.15}, {"joint": 1, "share": 0.05}],
    "joint_evidence": "of the measured torque residual"})json"));
  CHECK(json["cause"] == ReportJson::parse(R"json({"verdict": "identified", "effects": [
      {"id": "backlash", "joint": 2, "parameters":
        {"b": {"value": 0.0312, "low": 0.0301, "high": 0.0323, "at_bound": false, "unit": "rad"}}},
      {"id": "gravity", "joint": null, "parameters":
        {"rho": {"value": 0.81, "low": 0.7, "high": 0.9, "at_bound": false, "unit": "kg/m"}}}],
    "equivalent": [], "ranking": [
      {"effects": ["backlash(2)", "gravity"], "probability": 0.912, "chi2_per_dof": 1.04
},
      {"effects": ["rest_angle(2)"], "probability": 0.05, "chi2_per_dof": 1.1},
      {"effects": ["force_gain"], "probability": 0.03, "chi2_per_dof": 1.7},
      {"effects": ["unknown"], "probability": 0.008, "chi2_per_dof": 12.5}],
    "not_excited": []
})json"));
  CHECK(json["shrink"] ==
        ReportJson::parse(R"json({"of": "cause", "tested": true, "selected_without_heldout": true,
    "heldout": ["press-1[1:2]", "load-2"], "rms_before": {"Fx": 0.24, "q2": 0.003},
    "rms_after": {"Fx": 0.031, "q2": 0.0011}, "ratio": 0.125, "ratio_low": 0.101, "ratio_high": 0.152,
    "noise_floor_ratio": 0.11, "chi2_per_dof_after": 1.21, "channels": {
      "Fx": {"ratio": 0.13, "ratio_low": 0.12, "ratio_high": 0.14, "noise_floor_ratio": 0.09},
      "q2": {"ratio": 0.36, "ratio_low": 0.34, "ratio_high": 0.38, "noise_floor_ratio": 0.3}},
    "outliers": {"count": 3, "ratio_with": 0.172}})json"));
  CHECK(json["next"] == ReportJson::array());
  CHECK_FALSE(json.contains("law"));
}

TEST_CASE("what is named is listed however far down the ranking it stands, and once") {
  Diagnosis made = made_up();
  for (int i = 0; i < 20; ++i) made.cause.ranking.push_back(ranked(only("gravity"), {0.1}, 1e-3, 2));
  made.cause.verdict = CauseVerdict::ambiguous;
  made.cause.best = 14;
  made.cause.equivalent = {12, 2};
  CHECK(listed_places(made.cause) == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 14});
  CHECK(as_json(made)["cause"]["ranking"].size() == 13);
  made.cause.verdict = CauseVerdict::unknown;
  made.cause.equivalent = {};
  CHECK(listed_places(made.cause).size() == 10);
}

TEST_CASE(
    "what else the JSON may hold: alternatives, a discrepancy, the unexplained residual, ten of a ranking") {
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::ambiguous;
  made.cause.remainder = 0.07;
  made.cause.equivalent = {2};
  made.cause.reservation = Reservation::many_values;
  made.not_excited = {{"joint_stop", 1}};
  made.cause.best = 1;
  made.estimates = {{{"a", "rad", 0.02, 0.01, 0.03, true}}};
  made.missing = Missing{"torque at joint 2", "N m", "q2", "rad", {{0.1, 0.2, 0.3, true}}, 0.5, 0.6, 0.7};
  for (int i = 0; i < 9; ++i) made.cause.ranking.push_back(ranked(only("gravity"), {0.1}, 1e-3, 2));
  made.shrink->noise_floor_ratio = 0.71;
  ReportJson json = as_json(made);
  CHECK(json["cause"]["discrepancy"] == 0.07);
  CHECK(json["cause"]["equivalent"] == ReportJson::parse(R"json([["force_gain"], ["unknown"]])json"));
  CHECK(json["cause"]["not_excited"] == ReportJson::parse(R"json(["joint_stop(1)"])json"));
  CHECK(json["cause"]["effects"][0]["id"] == "rest_angle");
  CHECK(json["cause"]["effects"][0]["parameters"]["a"]["at_bound"] == true);
  CHECK(json["cause"]["ranking"].size() == 11);
  CHECK(json["cause"]["ranking"][10]["effects"][0] == "unknown");
  CHECK(json["where"]["unexplained"] ==
        ReportJson::parse(R"json({"quantity": "torque at joint 2", "unit": "N m",
    "abscissa": "q2", "variance_explained": {"position": 0.5, "direction": 0.6, "time": 0.7},
    "points": [[0.1, 0.2, 0.3, true]]})json"));
  CHECK(json["shrink"]["tested"] == false);
  made.cause.verdict = CauseVerdict::unknown;
  made.shrink.reset();
  made.gap.present = false;
  json = as_json(made);
  CHECK(json["cause"]["effects"] == ReportJson::array());
  CHECK(json["cause"]["ranking"].size() == 10);
  CHECK(json["shrink"] == nullptr);
}
