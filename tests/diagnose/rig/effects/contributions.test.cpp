#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "diagnose/rig/effect.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/rig/effects/by_hand.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("effects of one kind add up; the contribution of each to the rig, by hand") {
  const CharacteristicScales size = sizes_by_hand();
  const auto add = [&](const Effect& row, std::size_t joint, const std::vector<double>& value) {
    Rig rig;
    rig.length = {0.2, 0.5, 0.6}, rig.stiffness = {0, 3, 5};
    rig.rest_error = rig.backlash = rig.stop = rig.stop_stiffness = rig.hardening = rig.asymmetry = rig.knee =
        rig.give = rig.friction = {1, 2, 3};
    rig.travel.assign(3, {0.1, 0.3});
    rig.slip = {1, 2, 3};
    rig.weight.assign(3, Vector2(0.1, 0.2));
    rig.centre.assign(3, Vector2::Zero());
    rig.sliders.resize(3);
    rig.drive.drift.assign(3, 0);
    for (int twice = 0; twice < 2; ++twice)
      row.add({rig, joint > 0 ? joint - 1 : 0, size, Vector2(0.6, -0.8), value.data()});
    return rig;
  };
  const auto with = [&](const char* id, std::size_t joint, const std::vector<double>& value) {
    return add(effect(id, joint), joint, value);
  };
  check_values(with("joint_stiffness", 2, {0.5}).stiffness, {0, 3 * 1.5 * 1.5, 5});
  check_values(with("stiffness_scale", 0, {0.5}).stiffness, {0, 3 * 2.25, 5 * 2.25});
  check_values(with("stiffness_spread", 0, {0.5, 1}).stiffness, {0, 3 * 2.25, 5 * 4});
  check_values(with("link_length", 3, {0.5}).length, {0.2, 0.5, 0.6 * 2.25});
  check_values(with("length_scale", 0, {0.5}).length, {0.45, 1.125, 1.35});
  check_values(with("length_spread", 0, {0.5, 1, 0}).length, {0.45, 2, 0.6});
  check_values(with("rest_angle", 2, {0.25}).rest_error, {1, 2.5, 3});
  check_values(with("rest_offset", 0, {0.25}).rest_error, {1.5, 2.5, 3.5});
  check_values(with("rest_spread", 0, {0.25, 0.5}).rest_error, {1, 2.5, 4});
  check_values(with("backlash", 3, {0.25}).backlash, {1, 2, 3.5});
  check_values(with("play", 0, {0.25, 0.5}).backlash, {1, 2.5, 4});
  check_values(with("joint_friction", 0, {0.25}).friction, {1.5, 2.5, 3.5});
  check_values(with("joint_friction", 2, {0.25}).friction, {1, 2.5, 3});
  check_values(with("friction_spread", 0, {0.25, 0.5}).friction, {1, 2.5, 4});
  const Rig giving = add(other_form("joint_friction"), 0, {0.25, 0.01});
  check_values(giving.friction, {1.5, 2.5, 3.5});
  CHECK(giving.presliding == 0.01);
  check_values(with("nonlinear_spring", 0, {0.25}).hardening, {1.5, 2.5, 3.5});
  check_values(with("hardening_spread", 0, {0.25, 0.5}).hardening, {1, 2.5, 4});
  check_values(with("joint_stop", 2, {0.1, 7}).stop, {1, 0.1, 3});
  check_values(with("joint_stop", 2, {0.1, 7}).stop_stiffness, {1, 7, 3});
  // Of two ends, and of two places where a spring slips, the first to be met acts.
  CHECK(with("upper_limit", 2, {0.2}).travel[1] == Travel{0.1, 0.2});
  CHECK(with("upper_limit", 2, {0.4}).travel[1] == Travel{0.1, 0.3});
  CHECK(with("lower_limit", 2, {0.2}).travel[1] == Travel{0.2, 0.3});
  CHECK(with("lower_limit", 2, {0.0}).travel[1] == Travel{0.1, 0.3});
  check_values(with("series_friction", 2, {0.5}).slip, {1, 0.5, 3});
  check_values(with("series_friction", 2, {4}).slip, {1, 2, 3});
  check_values(with("joint_stops", 0, {0.1, 7}).stop, {0.1, 0.1, 0.1});
  check_values(with("joint_stops", 0, {0.1, 7}).stop_stiffness, {7, 7, 7});
  check_values(with("piecewise_spring", 0, {0.1, 0.5}).knee, {0.1, 0.1, 0.1});
  check_values(with("piecewise_spring", 0, {0.1, 0.5}).give, {0.5, 0.5, 0.5});
  check_values(with("piecewise_spring", 2, {0.1, 0.5}).knee, {1, 0.1, 3});
  check_values(with("piecewise_spring", 2, {0.1, 0.5}).give, {1, 0.5, 3});
  CHECK(with("joint_coupling", 0, {0.25}).coupling == 0.5);
  CHECK(with("link_centre", 2, {0.25, -1}).centre[1] == Vector2(0.5, -2));
  CHECK(with("gravity_compensation", 0, {0.25}).compensated == 0.5);
  CHECK(with("viscoelasticity", 0, {0.25, 9}).arms == std::vector<Arm>{{0.25, 9}, {0.25, 9}});
  CHECK(with("relaxation_spectrum", 0, {1, 2, 3, 4}).arms ==
        std::vector<Arm>{{1, 2}, {3, 4}, {1, 2}, {3, 4}});
  CHECK(with("axial_compliance", 0, {0.25}).axial == 0.5);
  CHECK(with("link_bending", 0, {4}).flexibility == 0.5);
  check_values(with("asymmetric_spring", 0, {0.25}).asymmetry, {1.5, 2.5, 3.5});
  check_values(add(other_form("asymmetric_spring"), 0, {0.25, -0.5}).asymmetry, {1, 2.5, 2});
  const Rig stopped = add(other_form("joint_stops"), 0, {7, 0.1, 0.2, 0.3});
  check_values(stopped.stop, {0.1, 0.2, 0.3});
  check_values(stopped.stop_stiffness, {7, 7, 7});
  CHECK(with("tendon_friction", 0, {0.25}).capstan == 0.5);
  CHECK(with("plastic_set", 0, {0.25, 3}).yield == 0.25);
  CHECK(with("plastic_set", 0, {0.25, 3}).flow == 3);
  const Rig load = with("load_friction", 0, {0.25, 3}), way = with("direction_friction", 0, {0.25, 0.5}),
            fast = with("speed_friction", 0, {0.25, 0.5, 6});
  for (const Rig& one : {load, way, fast}) check_values(one.friction, {1.5, 2.5, 3.5});
  CHECK(load.friction_law == FrictionLaw{1.5, 0, 0, 1});
  CHECK(way.friction_law == FrictionLaw{0, 1, 0, 1});
  CHECK(fast.friction_law == FrictionLaw{0, 0, 1, 6});
  const Rig all = with("hysteresis", 0, {0.5, 0.1, 1, 0.2, 2, 0.4}),
            one = with("hysteresis", 3, {0.5, 0.1, 1, 0.2, 2, 0.4});
  for (const auto& sliders : all.sliders) {
    REQUIRE(sliders.size() == 6);
    CHECK(sliders[2].ratio == 2);
    CHECK(sliders[2].yield == close_to(2 * 4 * 0.4));
  }
  CHECK(one.sliders[0].empty());
  REQUIRE(one.sliders[2].size() == 6);
  CHECK(one.sliders[2][1].yield == close_to(1 * 5 * 0.2));
  // rho L_j g along the weights' direction, twice
  const Rig heavy = with("gravity", 0, {0.25});
  CHECK((heavy.weight[1] - Vector2(0.1 + 0.5 * 0.5 * 9.81 * 0.6, 0.2 - 0.5 * 0.5 * 9.81 * 0.8)).norm() <
        1e-14);
  CHECK((with("link_mass", 2, {0.5}).weight[1] - Vector2(0.1 + 9.81 * 0.6, 0.2 - 9.81 * 0.8)).norm() < 1e-14);
  CHECK((with("mass_scale", 0, {0.5}).weight[1] - 2.25 * Vector2(0.1, 0.2)).norm() < 1e-14);
  CHECK((with("tip_payload", 0, {0.25}).payload - Vector2(0.3, -0.4)).norm() < 1e-15);
  CHECK(with("base_compliance", 0, {1, 2}).base_compliance == Vector2(2, 4));
  CHECK(with("train_compliance", 0, {1}).train_compliance == 2);
  CHECK(with("rail_misalignment", 0, {1}).misalignment == 2);
  CHECK(with("eccentric_load", 0, {1}).eccentricity == 2);
  CHECK(with("tip_stiffness", 0, {1}).tip_stiffness == 2);
  CHECK(with("guide_friction", 0, {1}).guide_friction == 2);
  CHECK(with("pulley_friction", 0, {1}).pulley_friction == 2);
  CHECK(with("moment_arm", 0, {1}).moment_arm_error == 2);
  CHECK(with("capstan_friction", 0, {1}).capstan_friction == 2);
  CHECK(with("camera_scale", 0, {1}).place_scale == 2);
  CHECK(with("camera_turn", 0, {1}).place_turn == Vector3<double>(0, 0, 2));
  CHECK(with("position_offset", 0, {1, 2}).position_offset == Vector3<double>(2, 4, 0));
  CHECK(with("force_bias", 0, {1, 2}).force_bias == Vector3<double>(2, 4, 0));
  CHECK(with("force_gain", 0, {1}).force_gain == 2);
  CHECK(with("second_zero", 0, {1, 2}).sensors.error(Channel::Name::Fy_2).zero == 4);
  CHECK(with("second_gain", 0, {1}).sensors.error(Channel::Name::Fx_2).gain == 2);
  CHECK(with("angle_drift", 2, {1}).sensors.error(Channel::Name::q, 1).drift == 2);
  CHECK(with("command_delay", 0, {1}).drive.response.delay == 2);
  CHECK(with("command_drift", 2, {1}).drive.drift[1] == 2);
  CHECK(with("command_scale", 0, {1}).drive.gain == 2);
  // Of loads along the chain in shares of the largest, 10, and of the 90 s.
  CHECK(with("applied_bias", 0, {0.25}).drive.covariates.at(1).zero == 5);
  CHECK(with("applied_scale", 0, {0.25}).drive.covariates.at(1).gain == 0.5);
  CHECK(with("applied_drift", 0, {0.9}).drive.covariates.at(1).drift == close_to(0.2));
  CHECK(with("applied_lag", 0, {1}).drive.covariates.at(1).response.lag == 2);
  CHECK(with("covariate_lag", 0, {1}).drive.covariates.at(0).response.lag == 2);
  CHECK(with("pixel_bias", 0, {1, 2}).sensors.error(Channel::Name::pixel, 1).zero == 4);
  CHECK(with("height_scale", 0, {1}).sensors.error(Channel::Name::height).gain == 2);
  CHECK(with("place_drift", 0, {1, 2}).place_drift == Vector3<double>(2, 4, 0));
  CHECK(with("camera_skew", 0, {1}).place_skew == Vector3<double>(2, 0, 0));
  CHECK(with("sensor_drift", 0, {1, 2}).force_drift == Vector3<double>(2, 4, 0));
  CHECK(with("cross_talk", 0, {1, 2}).cross_talk == Vector2(2, 4));
  CHECK(with("cell_curvature", 0, {1, 2}).cell_curvature == Vector2(2, 4));
  CHECK(with("saturation", 0, {8}).sensors.response(Channel::Name::Fx).limit == 8);
  CHECK(with("sensor_lag", 0, {1}).sensors.response(Channel::Name::Fx).lag == 2);
  CHECK(with("sensor_creep", 0, {1, 7}).sensors.response(Channel::Name::Fx).creep == 2);
  CHECK(with("sensor_creep", 0, {1, 7}).sensors.response(Channel::Name::Fx).creep_time == 7);
  const Rig tared = with("run_tare", 0, {1, 2, 3, 4, 5, 6}), turned = with("run_rest", 0, {1, 2, 3, 4, 5, 6});
  CHECK(tared.run_tare == std::vector<Vector2>{{2, 4}, {6, 8}, {10, 12}});
  CHECK(turned.run_rest == std::vector<std::vector<double>>{{0, 2, 4}, {0, 6, 8}, {0, 10, 12}});
}
