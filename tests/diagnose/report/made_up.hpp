#pragma once
/// \file
/// A diagnosis by hand, for what reports say of it.

#include "diagnose/report/report.hpp"
#include "tests/diagnose/bench.hpp"

namespace plumbline::diagnose::test {

using ReportJson = nlohmann::ordered_json;

inline constexpr Channel of_Fx{Channel::Name::Fx}, of_q2{Channel::Name::q, 1};

/// A press there and back, and a load.
inline Experiment small_bench() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 6, true);
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {-0.2, 0.1}, 4);
  return experiment;
}

inline RankedCause ranked(const Candidate& candidate, const std::vector<double>& parameters,
                          double probability, double chi2) {
  RankedCause one;
  one.hypothesis.candidate = one.cause = candidate;
  one.hypothesis.parameters = parameters;
  one.probability = probability;
  one.chi2_per_value = chi2;
  return one;
}

/// Of all channels of the small bench.
inline NoiseEstimate made_up_noise() {
  NoiseEstimate noise{{}, NoiseShape(Measurements(small_bench()))};
  using Name = Channel::Name;
  noise.channels = {
      {Channel(Name::x), 1, 0, 1},        {Channel(Name::y), 1.04, 0, 1},      {of_Fx, 2, 0.12, 1},
      {Channel(Name::Fy), 1, 0.12, 1},    {Channel(Name::q, 0), 0.5, 0.03, 1}, {of_q2, 0.5, 0.03, 1},
      {Channel(Name::q, 2), 0.5, 0.05, 1}};
  return noise;
}

inline Shrink made_up_shrink() {
  Shrink shrink;
  shrink.heldout = {"press-1[1:2]", "load-2"};
  shrink.rms_before = {{of_Fx, 0.24}, {of_q2, 0.003}};
  shrink.rms_after = {{of_Fx, 0.031}, {of_q2, 0.0011}};
  shrink.ratio = 0.125, shrink.ratio_low = 0.101, shrink.ratio_high = 0.152;
  shrink.noise_floor_ratio = 0.11;
  shrink.chi2_per_value_after = 1.21;
  shrink.outliers = 3, shrink.ratio_with_outliers = 0.172;
  shrink.channels = {{of_Fx, {0.13, 0.12, 0.14, 0.09}}, {of_q2, {0.36, 0.34, 0.38, 0.3}}};
  return shrink;
}

/// A diagnosis of the small bench in which every number is another.
inline Diagnosis made_up() {
  Diagnosis made{"three links", {}, {}, {}, made_up_noise(), {}, {}, {}, false, {}, {}, {}};
  made.gap = {true,
              0.9995,
              7.6,
              0.9995,
              12.5,
              {{of_Fx, 0.25}, {of_q2, 0.0031}},
              {{"load-2", 4, Channel(Channel::Name::x), -310.4, true}, {"press-1", 5, of_Fx, 12.3, false}},
              {"load-2"},
              {{"press-1", 3}},
              {{"press-1", {"press-1b"}}},
              {{"load-2", "temperature", 3, 9}},
              {{"load-2", 800, 9000}},
              {{"load-2", Sensor::force, 0, 4, true, 2.7}, {"press-1", Sensor::angle, 4, 9, false, 3.25}},
              {{"press-1", of_q2, 7.5, 1.25}}};
  made.noise.shape.proportional = {{Channel::Name::Fx, 0.021}};
  made.noise.shape.quantised = true;
  made.where.channels = {{of_Fx, 0.75}, {of_q2, 0.25}};
  made.where.runs = {{"press-1", 0.9}, {"load-2", 0.1}};
  made.where.load_path = {{"load-2", 0, 4, 0.004, Regime::pre_critical},
                          {"press-1", 3, 6, 0.6, Regime::post_critical},
                          {"press-1", 0, 2, 0.006, Regime::near_critical},
                          {"press-1", 7, 12, 0.39, Regime::unloading}};
  made.where.joints = {{2, 0.8}, {3, 0.15}, {1, 0.05}};
  made.where.joint_evidence = JointEvidence::measured;
  made.cause.verdict = CauseVerdict::identified;
  made.cause.ranking = {ranked({{{"backlash", 2}, {"gravity"}}}, {0.0312, 0.02}, 0.912, 1.04),
                        ranked({{{"rest_angle", 2}}}, {0.02}, 0.05, 1.1),
                        ranked({{{"force_gain"}}}, {0.01}, 0.03, 1.7)};
  made.cause.named = 1;
  made.cause.unknown = 0.008;
  made.cause.effects = {{"backlash(2)", 0.96}, {"gravity", 0.913}, {"tip_payload", 0.012}};
  made.estimates = {{{"b", "rad", 0.0312, 0.0301, 0.0323, false}}, {{"rho", "kg/m", 0.81, 0.7, 0.9, false}}};
  made.shrink = made_up_shrink();
  return made;
}

/// Two causes, or one outside the catalogue.
inline Diagnosis made_up_ambiguous() {
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::ambiguous;
  made.cause.named = 2;
  made.cause.or_unknown = true;
  made.cause.discrepancy = 0.07, made.cause.discrepancy_torque = 0.0123;
  return made;
}

inline Diagnosis made_up_unknown() {
  Diagnosis made = made_up();
  made.cause.verdict = CauseVerdict::unknown;
  made.cause.named = 0;
  made.cause.unknown = 0.97;
  made.cause.ranking.front().probability = 0.02;
  made.cause.ranking[1].probability = made.cause.ranking[2].probability = 0.001;
  made.cause.effects = {{"backlash(2)", 0.021}};
  made.estimates.clear();
  made.missing = Missing{"torque at joint 2", "N m", "q2", "rad", {{0.1, 0.2, 0.3, true}}, 0.5, 0.6, 0.7};
  return made;
}

inline Diagnosis made_up_no_gap() {
  Diagnosis made{"three links", {}, {}, {}, made_up_noise(), {}, {}, {}, false, {}, {}, {}};
  made.gap.probability = 0.02;
  made.gap.rms = {{of_Fx, 0.25}, {of_q2, 0.0031}};
  made.where = made_up().where;
  made.cause.ranking = {ranked({{{"rest_angle", 2}}}, {0.02}, 0.01, 0.99)};
  made.cause.unknown = 0.005;
  return made;
}

inline Proposal proposal(const std::string& what, double log_odds, double so_far) {
  Proposal one{};
  one.description = what;
  one.log_odds = log_odds;
  one.log_odds_so_far = so_far;
  return one;
}

inline bool has_words(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace plumbline::diagnose::test
