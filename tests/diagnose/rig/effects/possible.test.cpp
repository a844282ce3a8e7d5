#include <doctest/doctest.h>

#include <functional>
#include <map>
#include <set>

#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/rig/effects/by_hand.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("an effect is possible where the bench meets each of its conditions") {
  struct Asked {
    const char* id;
    std::function<void(CharacteristicScales&)> without;
  };
  CharacteristicScales all = sizes_by_hand();
  all.measures_force = all.load_cell = all.pivot = all.clock = all.measures_both_forces = true;
  all.turns_back = all.bent_at_rest = all.nominal_weight = all.imposes_force = true;
  all.turned_by_loads = all.long_tendon = all.end_is_loaded = all.drives = all.warms = true;
  all.tool_is_measured = true;
  all.applied.push_back({2, 10});
  all.measured.fill(true);
  all.at_largest = 4;
  const auto one_spring = [](CharacteristicScales& s) { s.joint_stiffness = {0, 3, 0}; };
  const auto one_link = [](CharacteristicScales& s) {
    s.joint_stiffness = {3}, s.link_length = {0.2}, s.rigid = {false};
  };
  const auto no_force = [](CharacteristicScales& s) { s.measures_force = false; };
  const auto no_place = [](CharacteristicScales& s) { s.measured.fill(false); };
  // That of a drive's delay shows in the same readings.
  const auto one_kind = [](CharacteristicScales& s) {
    s.measured.fill(false);
    s.measured[static_cast<std::size_t>(Channel::Name::q)] = true;
  };
  const auto no_cell = [](CharacteristicScales& s) { s.load_cell = false; };
  const auto no_clock = [](CharacteristicScales& s) { s.clock = false; };
  const auto no_loads = [](CharacteristicScales& s) { s.applied.clear(); };
  const auto no_links = [](CharacteristicScales& s) { s.axes = 1; };
  const auto no_end = [](CharacteristicScales& s) { s.end_is_loaded = false; };
  const auto no_turn = [](CharacteristicScales& s) { s.turns_back = false; };
  const auto weightless = [](CharacteristicScales& s) { s.weighs = false; };
  const auto no_masses = [](CharacteristicScales& s) { s.nominal_weight = false; };
  const auto one_run = [](CharacteristicScales& s) { s.runs = 1; };
  const std::vector<Asked> asked{
      {"stiffness_scale", one_spring},
      {"mass_scale", no_masses},
      {"rest_offset", one_spring},
      {"stiffness_spread", one_spring},
      {"rest_spread", one_spring},
      {"play", one_spring},
      {"friction_spread", one_spring},
      {"hardening_spread", one_spring},
      {"piecewise_spring", one_spring},
      {"hysteresis", one_spring},
      {"hysteresis", no_turn},
      {"length_scale", one_link},
      {"length_spread", one_link},
      {"joint_stops", one_link},
      {"joint_coupling", one_link},
      {"viscoelasticity", no_clock},
      {"relaxation_spectrum", no_clock},
      {"relaxation_spectrum", [](CharacteristicScales& s) { s.duration = 20 * s.sampling_interval; }},
      {"plastic_set", no_turn},
      {"tendon_friction", [](CharacteristicScales& s) { s.bent_at_rest = false; }},
      {"tendon_friction", [](CharacteristicScales& s) { s.led_together = false; }},
      {"gravity_compensation",
       [](CharacteristicScales& s) {
         s.moves = {false, false, false};
       }},
      {"load_friction", no_turn},
      {"direction_friction", no_turn},
      {"speed_friction", no_turn},
      {"speed_friction", no_clock},
      {"gravity", weightless},
      {"tip_payload", weightless},
      {"tip_stiffness", [](CharacteristicScales& s) { s.pivot = false; }},
      {"guide_friction", no_force},
      {"train_compliance", no_force},
      {"pulley_friction", [](CharacteristicScales& s) { s.imposes_force = false; }},
      {"pulley_friction", no_turn},
      {"applied_bias", no_loads},
      {"applied_scale", no_loads},
      {"applied_drift", no_clock},
      {"applied_lag", no_clock},
      {"covariate_lag", no_clock},
      {"covariate_lag", [](CharacteristicScales& s) { s.covariates.clear(); }},
      {"command_scale", no_force},
      {"distance_bias", no_place},
      {"pixel_cross_talk", no_place},
      {"height_lag", no_clock},
      {"moment_arm", [](CharacteristicScales& s) { s.turned_by_loads = false; }},
      {"capstan_friction", [](CharacteristicScales& s) { s.long_tendon = false; }},
      {"camera_scale", no_place},
      {"camera_turn", no_place},
      {"force_bias", no_cell},
      {"force_gain", no_cell},
      {"sensor_drift", no_cell},
      {"sensor_drift", no_clock},
      {"axial_compliance", no_links},
      {"link_bending", no_links},
      {"base_compliance", no_end},
      {"rail_misalignment", no_end},
      {"eccentric_load", no_end},
      {"command_delay", no_clock},
      {"command_delay", [](CharacteristicScales& s) { s.drives = false; }},
      {"second_zero", no_place},
      {"second_gain", no_place},
      {"cross_talk", [](CharacteristicScales& s) { s.measures_both_forces = false; }},
      {"cell_curvature", no_cell},
      {"saturation", [](CharacteristicScales& s) { s.at_largest = 3; }},
      {"sensor_lag", no_force},
      {"sensor_lag", no_clock},
      {"second_drift", no_clock},
      {"second_cross_talk", no_place},
      {"second_lag", no_clock},
      {"place_drift", no_clock},
      {"place_lag", no_clock},
      {"camera_skew", no_place},
      {"angle_lag", no_clock},
      {"angle_lag", one_kind},
      {"tilt_lag", no_clock},
      {"torque_lag", one_kind},
      {"sensor_creep", no_force},
      {"sensor_creep", no_clock},
      {"run_rest", one_run},
      {"run_rest", [](CharacteristicScales& s) { s.runs = 11; }},  // 33 values
      {"run_tare", one_run},
      {"run_tare", no_force},
      {"run_tare", [](CharacteristicScales& s) { s.runs = 16; }}};  // 32 values
  CharacteristicScales in_space = all;
  in_space.axes = 3;
  in_space.reads_encoders = true;
  in_space.rigid = {true, false, false};
  in_space.slides = {false, false, true};
  in_space.link_mass = {1, 1, 1};
  CharacteristicScales still = all;  // no servo leads its joints
  still.moves = std::vector<bool>(3, false);
  for (const Effect& row : catalogue()) {
    CAPTURE(row.id);
    CHECK((row.possible({all, row.at_joint ? std::size_t{1} : 0}) || row.possible({in_space, 0}) ||
           row.possible({in_space, 1}) || row.possible({still, 1})));
    for (const Asked& one : asked) {
      if (row.at_joint || row.id != one.id || row.form == "turns") continue;  // that one needs no loaded end
      CharacteristicScales less = all;
      one.without(less);
      CHECK_FALSE(row.possible({less, 0}));
    }
  }
  CharacteristicScales most = all;
  most.runs = 10;
  CHECK(effect("run_rest").possible({most, 0}));
  most.runs = 15;
  CHECK(effect("run_tare").possible({most, 0}));
  for (const char* id : {"joint_stiffness", "rest_angle", "backlash", "piecewise_spring", "hysteresis",
                         "upper_limit", "lower_limit", "series_friction"}) {
    CAPTURE(id);
    CHECK_FALSE(effect(id, 1).possible({all, 0}));
  }
  CharacteristicScales straight = all;
  straight.turns_back = false;
  CHECK_FALSE(effect("hysteresis", 2).possible({straight, 1}));
  CHECK_FALSE(other_form("joint_friction").possible({straight, 0}));
  CHECK(effect("joint_friction").possible({straight, 0}));
}
