#include <doctest/doctest.h>

#include "tests/diagnose/report/made_up.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("the JSON has every number of a diagnosis, by hand") {
  const ReportJson json = as_json(made_up());
  CHECK(json["format"] == "gap-diagnosis/2");
  CHECK(json["experiment"] == "three links");
  CHECK(json["gap"] == ReportJson::parse(R"json({"present": true, "probability": 0.9995, "chi2_per_dof": 12.5,
    "rms": {"Fx": 0.25, "q2": 0.0031},
    "noise": {"scale": {"x": 1.0, "y": 1.04, "Fx": 2.0, "Fy": 1.0, "q1": 0.5, "q2": 0.5, "q3": 0.5},
      "correlation": {"x": 0.0, "y": 0.0, "Fx": 0.12, "Fy": 0.12, "q1": 0.03, "q2": 0.03, "q3": 0.05}},
    "periodic_interference": [{"run": "press-1", "channel": "q2", "period": 7.5, "rms": 1.25}],
    "proportional_noise": {"Fx": 0.021},
    "noisier_runs": [{"run": "load-2", "sensor": "force", "factor": 2.7}],
    "noisier_segments": [{"run": "press-1", "sensor": "angle", "from": 4, "to": 9, "factor": 3.25}],
    "quantised": true,
    "outliers": [{"run": "load-2", "reading": 4, "channel": "x", "deviation": -310.4, "at_end": true},
      {"run": "press-1", "reading": 5, "channel": "Fx", "deviation": 12.3, "at_end": false}],
    "assumed_weights": ["load-2"],
    "continued_runs": [{"run": "press-1", "by": ["press-1b"]}],
    "interpolated": [{"run": "load-2", "covariate": "temperature", "readings": 3, "of": 9}],
    "thinned": [{"run": "load-2", "readings": 800, "of": 9000}],
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
    "tolerances": false, "equivalent": [], "fails_to_predict": false, "discrepancy": 0.0, "discrepancy_torque": 0.0, "ranking": [
      {"effects": ["backlash(2)", "gravity"], "probability": 0.912, "chi2_per_dof": 1.04},
      {"effects": ["rest_angle(2)"], "probability": 0.05, "chi2_per_dof": 1.1},
      {"effects": ["force_gain"], "probability": 0.03, "chi2_per_dof": 1.7},
      {"effects": ["unknown"], "probability": 0.008, "chi2_per_dof": 12.5}],
    "effect_probabilities": [{"effect": "backlash(2)", "probability": 0.96},
      {"effect": "gravity", "probability": 0.913}, {"effect": "tip_payload", "probability": 0.012}],
    "rest": null, "too_few_readings": false, "not_excited": []})json"));
  CHECK(json["shrink"] == ReportJson::parse(R"json({"of": "cause", "tested": true,
    "heldout": ["press-1[1:2]", "load-2"], "rms_before": {"Fx": 0.24, "q2": 0.003},
    "rms_after": {"Fx": 0.031, "q2": 0.0011}, "ratio": 0.125, "ratio_low": 0.101, "ratio_high": 0.152,
    "noise_floor_ratio": 0.11, "chi2_per_dof_after": 1.21, "channels": {
      "Fx": {"ratio": 0.13, "ratio_low": 0.12, "ratio_high": 0.14, "noise_floor_ratio": 0.09},
      "q2": {"ratio": 0.36, "ratio_low": 0.34, "ratio_high": 0.38, "noise_floor_ratio": 0.3}},
    "outliers": {"count": 3, "ratio_with": 0.172}})json"));
  CHECK(json["next"] == ReportJson::array());
  CHECK_FALSE(json.contains("law"));
}

TEST_CASE("the JSON of an ambiguous cause: alternatives, a discrepancy, what was not excited") {
  Diagnosis made = made_up_ambiguous();
  made.not_excited = {{"joint_stop", 1}};
  made.estimates[0][0].at_bound = true;
  made.shrink->noise_floor_ratio = 0.71;
  const ReportJson json = as_json(made);
  CHECK(json["cause"]["verdict"] == "ambiguous");
  CHECK(json["cause"]["discrepancy"] == 0.07);
  CHECK(json["cause"]["discrepancy_torque"] == 0.0123);
  CHECK(json["cause"]["equivalent"] == ReportJson::parse(R"json([["rest_angle(2)"], ["unknown"]])json"));
  CHECK(json["cause"]["not_excited"] == ReportJson::parse(R"json(["joint_stop(1)"])json"));
  CHECK(json["cause"]["effects"][0]["id"] == "backlash");
  CHECK(json["cause"]["effects"][0]["parameters"]["b"]["at_bound"] == true);
  CHECK(json["shrink"]["tested"] == false);
}

TEST_CASE("the JSON of an unknown cause: no effects, what is missing, the unknown first by its probability") {
  const ReportJson json = as_json(made_up_unknown());
  CHECK(json["cause"]["effects"] == ReportJson::array());
  CHECK(json["cause"]["equivalent"] == ReportJson::array());
  REQUIRE(json["cause"]["ranking"].size() == 4);
  CHECK(json["cause"]["ranking"][0]["effects"] == ReportJson::array({"unknown"}));
  CHECK(json["cause"]["ranking"][0]["probability"] == 0.97);
  CHECK(json["cause"]["ranking"][1]["effects"][0] == "backlash(2)");
  CHECK(json["where"]["unexplained"] ==
        ReportJson::parse(R"json({"quantity": "torque at joint 2", "unit": "N m",
    "abscissa": "q2", "variance_explained": {"position": 0.5, "direction": 0.6, "time": 0.7},
    "points": [[0.1, 0.2, 0.3, true]]})json"));
  CHECK(json["shrink"]["of"] == "partial");
}

TEST_CASE("the ranking stands in the order of its probabilities, whatever the verdict") {
  for (Diagnosis made : {made_up(), made_up_ambiguous(), made_up_unknown(), made_up_no_gap()})
    for (const double outside : {0.0, 0.02, 0.04, 0.5, 1.0}) {
      made.cause.unknown = outside;
      const ReportJson ranking = as_json(made)["cause"]["ranking"];
      CHECK(ranking.size() == made.cause.ranking.size() + 1);
      for (std::size_t i = 1; i < ranking.size(); ++i)
        CHECK(ranking[i - 1]["probability"].get<double>() >= ranking[i]["probability"].get<double>());
    }
}

TEST_CASE("manufacturing tolerances beside a cause are a flag, not effects; alone they are the cause") {
  Diagnosis made = made_up();
  Hypothesis& lead = made.cause.ranking.front().hypothesis;
  Candidate tolerances;
  for (const Effect& row : catalogue())
    if (row.is_tolerance) tolerances.effects.emplace_back(row);
  const std::vector<Estimate> spread{{"a_1", "ratio", 0.01, 0, 0.02, false}};
  lead.candidate.effects.insert(lead.candidate.effects.begin(), tolerances.effects.begin(),
                                tolerances.effects.end());
  made.estimates.insert(made.estimates.begin(), tolerances.effects.size(), spread);
  const ReportJson json = as_json(made)["cause"];
  CHECK(json["effects"] == as_json(made_up())["cause"]["effects"]);
  CHECK(json["ranking"] == as_json(made_up())["cause"]["ranking"]);
  CHECK(json["tolerances"] == true);
  lead.candidate = made.cause.ranking.front().cause = tolerances;
  made.estimates.resize(tolerances.effects.size());
  const ReportJson alone = as_json(made)["cause"];
  CHECK(alone["effects"].size() == tolerances.effects.size());
  CHECK(alone["tolerances"] == true);
}

TEST_CASE("the JSON of no gap names no cause, and says how probable one would be") {
  const ReportJson json = as_json(made_up_no_gap());
  CHECK(json["gap"]["present"] == false);
  CHECK(json["gap"]["probability"] == 0.02);
  CHECK(json["gap"]["outliers"] == ReportJson::array());
  CHECK(json["cause"]["verdict"] == "none");
  CHECK(json["cause"]["effects"] == ReportJson::array());
  CHECK(json["shrink"] == nullptr);
}
