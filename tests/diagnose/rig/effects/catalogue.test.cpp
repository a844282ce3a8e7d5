#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "diagnose/inference/start.hpp"
#include "diagnose/priors.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/rig/effects/by_hand.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

std::vector<double> sizeable_values(const char* id, std::size_t joint) {
  const CharacteristicScales size = sizes_by_hand();
  std::vector<double> all;
  for (const ParameterRange& one : effect(id, joint).parameters({size, joint > 0 ? joint - 1 : 0}))
    all.push_back(one.scale);
  return all;
}

InitialGuesses guesses_of(const char* id, std::size_t joint) {
  const CharacteristicScales size = sizes_by_hand();
  return effect(id, joint).initial_guesses({size, joint > 0 ? joint - 1 : 0}, excitation_by_hand());
}

void check_guesses(const char* id, std::size_t joint, const std::vector<std::vector<double>>& expected,
                   std::size_t refined) {
  CAPTURE(id);
  const InitialGuesses known = guesses_of(id, joint);
  CHECK(known.refined == refined);
  REQUIRE(known.points.size() == expected.size());
  for (std::size_t s = 0; s < expected.size(); ++s) check_values(known.points[s], expected[s]);
}

}  // namespace

TEST_CASE("a sizeable amount of each effect, by hand") {
  // k = 4, L = 1.3, l = 1.3 / 3, f = 7, phi = 0.3, tau = 1.2, m = 2; L^2 / k is 0.4225
  const double c = 0.01 * 1.3 * 1.3 / 4, density = 4 / (9.81 * 1.3 * 1.3);
  std::map<std::string, std::vector<double>> of_chain{{"nonlinear_spring", {0.05 / 0.09}},
                                                      {"joint_friction", {0.06}},
                                                      {"joint_coupling", {0.4}},
                                                      {"viscoelasticity", {0.2, 1}},
                                                      {"gravity", {0.1 * density}},
                                                      {"mass_scale", {0.1}},
                                                      {"axial_compliance", {0.01 / 7}},
                                                      {"link_bending", {0.3 / (4 * 1.3)}},
                                                      {"slide_bending", {0.3 / (4 * 1.3)}},
                                                      {"tip_payload", {0.7}},
                                                      {"base_compliance", {c, c}},
                                                      {"rail_misalignment", {0.05}},
                                                      {"eccentric_load", {0.013}},
                                                      {"tip_stiffness", {0.4}},
                                                      {"guide_friction", {0.35}},
                                                      {"position_offset", {0.0065, 0.0065}},
                                                      {"train_compliance", {c}},
                                                      {"pulley_friction", {0.03}},
                                                      {"moment_arm", {0.05}},
                                                      {"capstan_friction", {0.03}},
                                                      {"camera_scale", {0.01}},
                                                      {"camera_turn", {0.01}},
                                                      {"command_delay", {0.75}},
                                                      {"gravity_compensation", {0.2}},
                                                      {"mount_tilt", {0.01, 0.01}},
                                                      {"thermal_expansion", {1.2e-5}},
                                                      {"tool_compliance", {1e-3 / 1.2}},
                                                      {"tool_play", {0.003}},
                                                      {"tool_offset", {0.0065, 0.0065, 0.0065}},
                                                      {"tool_turn", {0.01, 0.01, 0.01}},
                                                      {"force_bias", {0.35, 0.35}},
                                                      {"force_gain", {0.05}},
                                                      {"sensor_drift", {0.35 / 90, 0.35 / 90}},
                                                      {"second_zero", {0.35, 0.35}},
                                                      {"second_gain", {0.05}},
                                                      {"second_drift", {0.35 / 90, 0.35 / 90}},
                                                      {"second_cross_talk", {0.03, 0.03}},
                                                      {"place_drift", {0.0026 / 90, 0.0026 / 90}},
                                                      {"camera_skew", {0.01}},
                                                      {"stiffness_scale", {0.2}},
                                                      {"length_scale", {0.02}},
                                                      {"rest_offset", {0.05}},
                                                      {"asymmetric_spring", {0.05}},
                                                      {"piecewise_spring", {0.3, 0.2}},
                                                      {"joint_stops", {0.3, 40}},
                                                      {"hysteresis", {0.2, 0.03, 0.2, 0.03, 0.2, 0.03}},
                                                      {"relaxation_spectrum", {0.2, 1, 0.2, 1}},
                                                      {"plastic_set", {0.36, 0.1}},
                                                      {"tendon_friction", {0.03}},
                                                      {"load_friction", {0.06, 2 / 0.3}},
                                                      {"direction_friction", {0.06, 0.3}},
                                                      {"speed_friction", {0.06, 0.5, 1}},
                                                      {"run_tare", {0.35, 0.35, 0.35, 0.35, 0.35, 0.35}},
                                                      {"cross_talk", {0.03, 0.03}},
                                                      {"cell_curvature", {0.03 / 7, 0.03 / 7}},
                                                      {"saturation", {0.3 / 7}},
                                                      {"sensor_lag", {0.75}},
                                                      {"sensor_creep", {0.05, 1}}};
  std::map<std::string, std::vector<double>> of_a_joint{{"joint_stiffness", {0.2}},
                                                        {"rest_angle", {0.05}},
                                                        {"backlash", {0.05}},
                                                        {"joint_stop", {0.3, 50}},
                                                        {"upper_limit", {0.05 * 0.5}},
                                                        {"lower_limit", {0.05 * 0.5}},
                                                        {"series_friction", {0.3 / 1.2}},
                                                        {"link_length", {0.02}},
                                                        {"joint_friction", {0.06}},
                                                        {"joint_scale", {0.01}},
                                                        {"encoder_ripple", {0.003, 0.003}},
                                                        {"joint_compliance", {1e-3 / 1.2}},
                                                        {"joint_balance", {0.12, 0.12}},
                                                        {"link_mass", {0.2}},
                                                        {"link_bending", {0.3 / (4 * 1.3)}},
                                                        {"axis_tilt", {0.003, 0.003}},
                                                        {"axis_shift", {0.0026, 0.0026, 0.0026}},
                                                        {"link_centre", {0.026, 0.026}},
                                                        {"torque_drift", {0.06 / 90}},
                                                        {"torque_bias", {0.06}},
                                                        {"torque_scale", {0.05}},
                                                        {"hysteresis", {0.2, 0.03, 0.2, 0.03, 0.2, 0.03}},
                                                        {"piecewise_spring", {0.3, 0.2}}};
  for (const char* one : {"second", "place", "angle", "tilt", "torque", "distance", "pixel", "inclination",
                          "height", "applied", "covariate"})
    of_chain[one + std::string("_lag")] = {0.75};
  for (const char* one : {"applied_bias", "applied_scale", "applied_drift"}) of_chain[one] = {0.05};
  for (const char* one : {"command_scale", "distance_scale", "height_scale"}) of_chain[one] = {0.01};
  for (const char* one : {"pixel_scale", "pixel_cross_talk", "inclination_scale", "inclination_cross_talk"})
    of_chain[one] = {0.01, 0.01};
  for (const char* one : {"distance", "height"}) {
    of_chain[one + std::string("_bias")] = {0.0065};
    of_chain[one + std::string("_drift")] = {0.0026 / 90};
  }
  of_chain["pixel_bias"] = {5, 5}, of_chain["pixel_drift"] = {2.0 / 90, 2.0 / 90};
  of_chain["inclination_bias"] = {0.05, 0.05}, of_chain["inclination_drift"] = {0.01 / 90, 0.01 / 90};
  for (const char* one : {"command", "angle", "tilt"}) of_a_joint[one + std::string("_drift")] = {0.01 / 90};
  for (const char* one : {"angle_bias", "tilt_bias", "torque_cross_talk"}) of_a_joint[one] = {0.05};
  for (const char* one : {"angle_scale", "tilt_scale", "angle_cross_talk", "tilt_cross_talk"})
    of_a_joint[one] = of_a_joint["gear_coupling"] = {0.01};
  std::size_t known = 0;
  for (const Effect& row : catalogue()) {
    CAPTURE(row.id);
    const auto& all = row.at_joint ? of_a_joint : of_chain;
    const auto place = all.find(row.id);
    const bool is_named = &effect(row.id, row.at_joint ? 1 : 0) == &row;
    if (row.id == "joint_stops" && !is_named) {  // of no tolerance: a joint may be free
      const CharacteristicScales size = sizes_by_hand();
      for (const ParameterRange& one : row.parameters({size, 0})) {
        CHECK(one.tolerance == 0);
        CHECK(one.scale == doctest::Approx(one.name == "k_s" ? 40 : 0.3));
      }
      continue;
    }
    if (row.id == "joint_friction" && !is_named) {  // gives before it slips
      const CharacteristicScales size = sizes_by_hand();
      const std::vector<ParameterRange> ranges = row.parameters({size, 0});
      REQUIRE(ranges.size() == 2);
      check_values({ranges[0].scale, ranges[1].scale}, {0.06, 1});
      continue;
    }
    static const std::set<std::string_view> as_first{"tool_play", "rest_angle", "joint_scale",
                                                     "base_compliance"};
    if (!is_named && (as_first.contains(row.id) || row.form.starts_with("by a "))) continue;
    if (place == all.end() || !is_named) {  // of values within a tolerance, of which half is sizeable
      const CharacteristicScales size = sizes_by_hand();
      for (const ParameterRange& one : row.parameters({size, 0})) {
        CHECK(one.tolerance > 0);
        CHECK(one.scale == one.tolerance / 2);
      }
      continue;
    }
    ++known;
    check_values(sizeable_values(row.id.c_str(), row.at_joint ? 3 : 0), place->second);
  }
  CHECK(known == of_chain.size() + of_a_joint.size());
  check_values(sizeable_values("joint_stop", 1), {0.3, 40});  // at a passive joint the mean spring's
}

TEST_CASE("manufacturing tolerances belong to elastic joints or to every link") {
  const CharacteristicScales size = sizes_by_hand();
  const auto tolerances = [&](const char* id) {
    std::vector<double> all;
    for (const ParameterRange& one : effect(id).parameters({size, 0})) all.push_back(one.tolerance);
    return all;
  };
  using namespace priors;
  check_values(tolerances("stiffness_spread"), {stiffness_tolerance, stiffness_tolerance});
  check_values(tolerances("length_spread"), {length_tolerance, length_tolerance, length_tolerance});
  check_values(tolerances("rest_spread"), {angle_tolerance, angle_tolerance});
  check_values(tolerances("play"), {angle_tolerance, angle_tolerance});
  check_values(tolerances("friction_spread"), {1.2 * friction_tolerance, 1.2 * friction_tolerance});
  check_values(tolerances("hardening_spread"), {hardening_tolerance / 0.09, hardening_tolerance / 0.09});
  check_values(tolerances("run_rest"), std::vector<double>(6, angle_tolerance));
}

TEST_CASE("initial guesses are fractions of the excitation of the joints, by hand") {
  check_guesses("backlash", 2, {{0.02 * 0.23}, {0.1 * 0.23}, {0.4 * 0.23}}, 2);
  check_guesses("joint_friction", 0, {{0.0034}, {0.017}, {0.085}}, 1);
  const InitialGuesses giving =
      other_form("joint_friction").initial_guesses({sizes_by_hand(), 0}, excitation_by_hand());
  CHECK(giving.refined == 1);
  REQUIRE(giving.points.size() == 6);
  for (std::size_t s = 0; s < 6; ++s)  // d_s in decades below the typical deflection of 0.3 rad
    check_values(giving.points[s],
                 {s < 3 ? 0.0051 : 0.0255, std::log(0.3 * std::vector{1e-3, 1e-2, 1e-1}[s % 3])});
  const auto stops = [](double reach, double k) {
    std::vector<std::vector<double>> all;
    for (const double share : {0.2, 0.4, 0.6, 0.8, 0.92, 0.98})
      for (const double stiff : {1.0, 30.0}) all.push_back({share * reach, stiff * k});
    return all;
  };
  check_guesses("joint_stop", 2, stops(0.23, 3), 2);
  check_guesses("joint_stop", 1, stops(0.11, 4), 2);
  check_guesses("joint_stops", 0, stops(0.31, 4), 2);
  for (const char* end : {"upper_limit", "lower_limit"})  // of commands from -0.2 to 0.8
    check_guesses(end, 2, {{-0.1}, {0.1}, {0.3}, {0.5}, {0.7}}, 2);
  check_guesses("series_friction", 2, {{1 / 0.207}, {1 / 0.414}, {1 / 0.621}}, 2);  // of 3 times 0.23
  check_guesses("sensor_creep", 0, {{0.05, std::log(2.7)}, {0.05, std::log(9.0)}, {0.05, std::log(27.0)}}, 2);
  const InitialGuesses own =
      other_form("joint_stops").initial_guesses({sizes_by_hand(), 0}, excitation_by_hand());
  CHECK(own.refined == 2);
  REQUIRE(own.points.size() == 12);
  check_values(own.points[3], {30.0 * 4, 0.4 * 0.11, 0.4 * 0.23, 0.4 * 0.31});
  const auto knees = [](double reach) {
    std::vector<std::vector<double>> all;
    for (const double share : {0.2, 0.4, 0.6, 0.8, 0.92, 0.98})
      for (const double give : {0.2, 0.6}) all.push_back({share * reach, give});
    return all;
  };
  check_guesses("piecewise_spring", 0, knees(0.31), 2);
  check_guesses("piecewise_spring", 2, knees(0.23), 2);
  const double low = std::log(0.25), wide = std::log(1800.0) - low;
  check_guesses("viscoelasticity", 0,
                {{0.1, low + 0.1 * wide},
                 {0.1, low + 0.3 * wide},
                 {0.1, low + 0.5 * wide},
                 {0.1, low + 0.7 * wide},
                 {0.1, low + 0.9 * wide}},
                2);
  const double soft = 0.3 / (4 * 1.3);
  check_guesses("link_bending", 0, {{0.01 * soft}, {0.3 * soft}, {2 * soft}}, 1);
  check_guesses("play", 0, {{0.05 * 0.23, 0.05 * 0.31}, {0.2 * 0.23, 0.2 * 0.31}}, 2);
  check_guesses("friction_spread", 0, {{0.0085, 0.0085}, {0.051, 0.051}}, 1);
  check_guesses("hardening_spread", 0, {{0, 0}, {0.3 / 0.09, 0.3 / 0.09}, {-0.1 / 0.09, -0.1 / 0.09}}, 1);
  const auto elements = [](double d) {
    return std::vector<std::vector<double>>{{0.1, 0.02 * d, 0.1, 0.1 * d, 0.1, 0.5 * d},
                                            {0.1, 0.05 * d, 0.1, std::sqrt(0.05) * d, 0.1, d}};
  };
  check_guesses("hysteresis", 0, elements(0.31), 2);
  check_guesses("hysteresis", 2, elements(0.23), 2);
  check_guesses("relaxation_spectrum", 0, {{0.1, std::log(5.0), 0.1, std::log(36.0)}}, 1);
  check_guesses("plastic_set", 0, {{0.34, 0.1}, {0.68, 0.1}, {1.02, 0.1}, {1.36, 0.1}}, 1);
  check_guesses("load_friction", 0, {{0.0051, 3 / 0.31}, {0.0255, 3 / 0.31}}, 1);
  check_guesses("direction_friction", 0, {{0.0051, 0.5}, {0.0051, -0.5}, {0.0255, 0.5}, {0.0255, -0.5}}, 1);
  const double slow = std::log(0.3 * 2 * 0.3 / 90), fast = std::log(3.0 * 2 * 0.3 / 90);
  check_guesses("speed_friction", 0,
                {{0.0051, 1, slow},
                 {0.0051, 1, fast},
                 {0.0051, -0.5, slow},
                 {0.0051, -0.5, fast},
                 {0.0255, 1, slow},
                 {0.0255, 1, fast},
                 {0.0255, -0.5, slow},
                 {0.0255, -0.5, fast}},
                1);
  check_guesses("saturation", 0, {{1 / (0.98 * 11)}}, 1);
}

TEST_CASE("every effect: perturbed parameters, step, dissipation and excitation") {
  struct Kind {
    std::vector<std::size_t> growing;
    bool large_step, dissipates;
    std::size_t guesses;
    bool tolerance;
  };
  const Kind plain{{}, false, false, 100, false};
  const std::map<std::string, Kind> others{{"backlash", {{}, true, false, 100, false}},
                                           {"joint_friction", {{}, true, true, 100, false}},
                                           {"joint_stop", {{1}, false, false, 100, false}},
                                           {"joint_stops", {{1}, false, false, 100, false}},
                                           {"upper_limit", {{}, true, false, 100, false}},
                                           {"lower_limit", {{}, true, false, 100, false}},
                                           {"series_friction", {{}, true, true, 100, false}},
                                           {"sensor_creep", {{0}, false, true, 100, false}},
                                           {"piecewise_spring", {{1}, false, false, 100, false}},
                                           {"viscoelasticity", {{0}, false, true, 100, false}},
                                           {"link_bending", {{}, true, false, 1, false}},
                                           {"guide_friction", {{}, false, true, 100, false}},
                                           {"pulley_friction", {{}, false, true, 100, false}},
                                           {"capstan_friction", {{}, false, true, 100, false}},
                                           {"stiffness_spread", {{}, false, false, 100, true}},
                                           {"length_spread", {{}, false, false, 100, true}},
                                           {"rest_spread", {{}, false, false, 100, true}},
                                           {"play", {{}, false, false, 100, false}},
                                           {"friction_spread", {{}, true, true, 100, false}},
                                           {"hysteresis", {{0, 2, 4}, true, true, 100, false}},
                                           {"relaxation_spectrum", {{0, 2}, false, true, 100, false}},
                                           {"plastic_set", {{1}, false, true, 100, false}},
                                           {"load_friction", {{0}, true, true, 100, false}},
                                           {"direction_friction", {{0}, true, true, 100, false}},
                                           {"speed_friction", {{0}, true, true, 100, false}},
                                           {"saturation", {{}, true, false, 100, false}},
                                           {"command_delay", {{}, false, true, 100, false}},
                                           {"sensor_lag", {{}, false, true, 100, false}}};
  const Kind own_stops{{0}, false, false, 100, false};  // their stiffness comes first
  const Kind giving{{0}, true, true, 100, false}, hinged{{}, true, false, 100, false};
  for (const Effect& row : catalogue()) {
    CAPTURE(row.id);
    const auto place = others.find(row.id);
    const bool is_own_stops = row.id == "joint_stops" && &row != &effect("joint_stops");
    const bool gives = row.id == "joint_friction" && !row.at_joint && &row != &effect("joint_friction");
    const bool of_one_link = row.id == "link_bending" && row.at_joint;
    const Kind& expected = is_own_stops                   ? own_stops
                           : of_one_link                  ? plain
                           : row.form == "about one axis" ? hinged
                           : gives                        ? giving
                           : row.id.ends_with("_lag")     ? others.at("sensor_lag")
                           : place == others.end()        ? plain
                                                          : place->second;
    CHECK(row.perturbation.growing == expected.growing);
    CHECK(row.perturbation.large_step == expected.large_step);
    CHECK(row.perturbation.guesses == expected.guesses);
    CHECK(row.dissipates == expected.dissipates);
    CHECK(row.is_tolerance == expected.tolerance);
  }
}
