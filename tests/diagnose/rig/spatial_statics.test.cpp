#include "diagnose/rig/spatial_statics.hpp"

#include <plumbline/arm/arm_equilibrium.hpp>

#include "tests/close_to.hpp"
#include "tests/diagnose/arms.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using Name = Channel::Name;

Vector3<double> place_of_tip(const Trace& trace, Eigen::Index reading) {
  const Eigen::Index first = trace.cols() - 6;  // of the only point
  return {trace(reading, first), trace(reading, first + 1), trace(reading, first + 2)};
}

/// Where fits of an effect start, in the middle of them.
std::vector<double> some_of(const Study& study, const EffectAt& at, double share) {
  std::vector<double> values;
  for (const ParameterRange& range : study.ranges(at))
    values.push_back(range.may_be_nothing() ? share * range.scale
                                            : range.low + 0.5 * (range.high - range.low));
  return values;
}

double largest_difference(const Study& study, const Prediction& a, const Prediction& b) {
  return (study.residual(a) - study.residual(b)).cwiseAbs().maxCoeff();
}

/// One joint about y with a bar of 2 kg: its weight pulls with 2 * 9.81 * 0.5 N m where it is horizontal.
NominalArm bar(double stiffness) {
  NominalArm arm;
  add_link(arm, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}, stiffness, 2, {0.5, 0, 0});
  arm.base = "wall", arm.tip = "end";
  arm.arm.tip.translation() = Vector3<double>(1, 0, 0);
  return arm;
}

/// One run with these commands.
Experiment commanded_bar(double stiffness, const std::vector<double>& commands) {
  Experiment experiment = arm_bench(bar(stiffness), 2, {.angles = true, .torques = true});
  experiment.runs.pop_back();
  Run& run = experiment.runs.front();
  const Reading one = run.readings.front();
  run.readings.clear();
  for (const double q : commands) {
    run.readings.push_back(one);
    run.readings.back().rest = {q};
    run.readings.back().t = static_cast<double>(run.readings.size());
  }
  run.rest = run.readings.front().rest;
  return experiment;
}

}  // namespace

TEST_CASE("the nominal prediction of an arm is its equilibrium under gravity and weights") {
  for (const NominalArm& arm : {industrial_arm(), collaborative_arm()}) {
    const Study study(arm_bench(arm, 8, {.turns = true}));
    const Prediction& nominal = study.nominal();
    REQUIRE(nominal.reached);
    const Run& run = study.experiment().runs[1];
    for (std::size_t r = 0; r < run.readings.size(); ++r) {
      const std::vector<double>& q = run.readings[r].rest;
      const OnLink<double> tip{arm.arm.size() - 1, arm.arm.tip};
      const Vector<double> command =
          Eigen::Map<const Vector<double>>(q.data(), static_cast<Eigen::Index>(q.size()));
      const Vector<double> rest = equilibrium<double>(arm.arm, command, {{tip, {0, 0, -3 * 9.81}}});
      const Vector3<double> place = ArmPosture<double>(arm.arm, rest).of(tip).translation();
      // both are solved to rounding
      CHECK((place_of_tip(nominal.runs[1], static_cast<Eigen::Index>(r)) - place).norm() < 1e-13);
    }
  }
}

TEST_CASE("a rigid arm stands where it is commanded") {
  const NominalArm arm = industrial_arm(0);
  const Study study(arm_bench(arm, 4));
  const Reading& reading = study.experiment().runs[0].readings[0];
  const Vector3<double> place =
      nominal_pose(arm.arm, {arm.arm.size() - 1, arm.arm.tip}, reading.rest).translation();
  CHECK((place_of_tip(study.nominal().runs[0], 0) - place).norm() < 1e-15);
}

TEST_CASE("an effect of amount zero is the nominal arm, another is not, and sensitivities are differences") {
  for (const NominalArm& arm : {industrial_arm(), collaborative_arm()}) {
    Experiment experiment = arm_bench(arm, 16, {true, true, true});
    for (Run& run : experiment.runs) {
      run.by_weights = false;
      // a weight alone does not load an upright axis
      for (Reading& reading : run.readings) reading.wrench = {12, -7, -30, 0.4, 0.3, -0.5};
    }
    const Study study(experiment);
    const std::vector<EffectAt> possible = possible_effects(study);
    for (const EffectAt& at : possible) {
      const std::vector<ParameterRange> own = study.ranges(at);
      const bool only_grows = std::all_of(own.begin(), own.end(),
                                          [](const ParameterRange& range) { return range.may_be_nothing(); });
      if (at.effect->orders || !only_grows) continue;  // thresholds and times: history.test
      CAPTURE(at.label());
      const Candidate candidate{{at}};
      const Prediction none = predict(study, candidate, some_of(study, at, 0));
      REQUIRE(none.reached);
      CHECK(largest_difference(study, none, study.nominal()) < 1e-6);
      const std::vector<double> values = some_of(study, at, 1);
      const Prediction some = predict(study, candidate, values, true);
      REQUIRE(some.reached);
      // what turns about an upright first axis weighs alike everywhere, and a length of nothing has no scale
      const bool of_first_link =
          at.joint == 1 && (at.effect->id == "link_mass" || at.effect->id == "link_centre");
      const bool of_no_length =
          at.effect->id == "link_length" && arm.arm.links[at.joint].frame.translation().norm() == 0;
      if (of_first_link || of_no_length) continue;
      CHECK(largest_difference(study, some, study.nominal()) > 1e-3);
      if (at.effect->dissipates || at.effect->id == "backlash" || at.effect->id == "play") continue;  // kinks
      for (std::size_t p = 0; p < values.size(); ++p) {
        std::vector<double> ahead = values, behind = values;
        const double h = 1e-3 * study.ranges(at)[p].scale;
        ahead[p] += h, behind[p] -= h;
        const VectorXd quotient = (study.residual(predict(study, candidate, behind)) -
                                   study.residual(predict(study, candidate, ahead))) /
                                  (2 * h);
        const VectorXd slope = study.measurements().in_sigmas(some.sensitivity[p]);
        // third derivatives over a thousandth of a scale; one millionth of it beside the rounding of places
        CHECK((quotient - slope).cwiseAbs().maxCoeff() < 1e-4 * (1 + slope.cwiseAbs().maxCoeff()));
      }
    }
  }
}

// One step beside the nominal arm leads to all of them, to links that it does not have bending among them.
TEST_CASE("sensitivities from nothing on are the quotients of arms that come to rest by themselves") {
  for (const NominalArm& arm : {industrial_arm(), collaborative_arm()}) {
    const Study study(arm_bench(arm, 4, {true, true, true}));
    for (const EffectAt& at : possible_effects(study)) {
      const std::vector<ParameterRange> ranges = study.ranges(at);
      const bool grows = std::all_of(ranges.begin(), ranges.end(),
                                     [](const ParameterRange& range) { return range.may_be_nothing(); });
      if (at.effect->id == "play" || at.effect->orders || !grows || at.effect->perturbation.large_step ||
          at.effect->dissipates ||  // kinks
          !at.effect->perturbation.growing.empty())
        continue;
      CAPTURE(at.label());
      const Candidate candidate{{at}};
      const std::vector<double> nothing(ranges.size(), 0.0);
      const Prediction here = predict(study, candidate, nothing, true);
      REQUIRE(here.reached);
      for (std::size_t p = 0; p < ranges.size(); ++p) {
        const double h = 1e-3 * ranges[p].scale;
        const auto ahead = [&](double step) {
          std::vector<double> values = nothing;
          values[p] = step;
          return study.residual(predict(study, candidate, values));
        };
        const VectorXd quotient = (3 * ahead(0) - 4 * ahead(h / 2) + ahead(h)) / h,
                       slope = study.measurements().in_sigmas(here.sensitivity[p]);
        // third derivatives over a thousandth of a scale, as above; the step of a sensitivity is shorter
        CHECK((quotient - slope).cwiseAbs().maxCoeff() < 1e-4 * (1 + slope.cwiseAbs().maxCoeff()));
      }
    }
  }
}

TEST_CASE("dry friction of a joint leaves it off its rest by its slip torque, on the side it came from") {
  const Study study(commanded_bar(1e4, {-0.5, 0.0, 0.5, 0.0}));
  const Prediction predicted = predict(study, only("joint_friction", 1), {0.7});
  REQUIRE(predicted.reached);
  const Trace& trace = predicted.runs[0];
  const double up = trace(1, column_q), down = trace(3, column_q);
  // both near the horizontal, where the weight hardly changes with the angle
  CHECK(down - up == close_to(2 * 0.7 / 1e4).epsilon(1e-4));
  const double held = trace(1, Channel(Name::drive, 0, 1).column),
               let = trace(3, Channel(Name::drive, 0, 1).column);
  CHECK(held - let == close_to(2 * 0.7).epsilon(1e-3));
  CHECK((held + let) / 2 == close_to(-2 * 9.81 * 0.5).epsilon(1e-3));
}

TEST_CASE("play of a joint lets it hang by its half, and servos that hold the weight keep it") {
  const Study study(commanded_bar(1e4, {0.0, 0.2}));
  const double sag = study.nominal().runs[0](0, column_q);
  CHECK(sag == close_to(2 * 9.81 * 0.5 / 1e4).epsilon(1e-6));  // about y, downwards is positive
  const Prediction play = predict(study, only("backlash", 1), {0.004});
  REQUIRE(play.reached);
  CHECK(play.runs[0](0, column_q) - sag == close_to(0.004).epsilon(1e-4));
  const Prediction held = predict(study, only("gravity_compensation"), {1});
  CHECK(std::abs(held.runs[0](0, column_q)) < 1e-5 * sag);
}

TEST_CASE("encoders are off by zero, scale and ripple without showing it") {
  const Study study(commanded_bar(0, {0.3, -0.8}));
  const auto of_encoder = [](std::string_view id) {
    return EffectAt(
        *std::find_if(catalogue().begin(), catalogue().end(),
                      [&](const Effect& row) { return row.id == id && row.form == "of the encoder"; }),
        1);
  };
  const Prediction off =
      predict(study, {{of_encoder("rest_angle"), of_encoder("joint_scale"), {"encoder_ripple", 1}}},
              {0.02, 0.01, 0.003, -0.004});
  for (const Eigen::Index r : {0, 1}) {
    const double q = r == 0 ? 0.3 : -0.8,
                 stands = 1.01 * q + 0.02 + 0.003 * std::cos(q) - 0.004 * std::sin(q);
    CHECK(off.runs[0](r, column_q) == close_to(q));
    CHECK((place_of_tip(off.runs[0], r) - Vector3<double>(std::cos(stands), 0, -std::sin(stands))).norm() <
          1e-14);
  }
}

TEST_CASE("a gear that turns with the joint before stands off by a share of the command of that one") {
  const Study study(arm_bench(industrial_arm(0), 6));
  const Prediction coupled = predict(study, {{EffectAt("gear_coupling", 5)}}, {0.01});
  for (Eigen::Index r = 0; r < 3; ++r) {
    const double before = study.experiment().runs[0].readings[static_cast<std::size_t>(r)].rest[3];
    const Prediction off = predict(study, {{EffectAt("rest_angle", 5)}}, {0.01 * before});
    CHECK((place_of_tip(coupled.runs[0], r) - place_of_tip(off.runs[0], r)).norm() < 1e-14);
  }
}

TEST_CASE("a tilted mount turns the arm and not gravity; a tracker that is turned shows it turned") {
  const NominalArm arm = industrial_arm();
  const Study study(arm_bench(arm, 4));
  const Prediction tilted = predict(study, only("mount_tilt"), {0.01, 0}),
                   turned = predict(study, only("tracker_turn"), {-0.01, 0, 0});
  const Vector3<double> one = place_of_tip(tilted.runs[0], 0), other = place_of_tip(turned.runs[0], 0);
  CHECK((one - other).norm() < 1e-5);  // the weight bends a tilted arm otherwise
  CHECK((one - other).norm() > 1e-9);
}

TEST_CASE("an arm that grows reaches out by its length, the rate and the warmth since the first reading") {
  const auto with_temperatures = [](double last) {
    Experiment experiment = commanded_bar(0, {0, 0, 0});
    experiment.covariates = {"temperature"};
    for (const std::size_t r : {0, 1, 2})
      experiment.runs.front().readings[r].covariates = {20 + (last - 20) * static_cast<double>(r) / 2};
    return experiment;
  };
  const auto is_possible = [](const Study& study) {
    const std::vector<EffectAt> all = possible_effects(study);
    return std::find(all.begin(), all.end(), EffectAt("thermal_expansion")) != all.end();
  };
  const Study study(with_temperatures(40));
  const Prediction warm = predict(study, only("thermal_expansion"), {2e-5});
  REQUIRE(warm.reached);
  for (Eigen::Index r = 0; r < 3; ++r)
    CHECK(place_of_tip(warm.runs[0], r).x() ==
          doctest::Approx(1 + 2e-4 * static_cast<double>(r)).epsilon(1e-12));
  CHECK(is_possible(study));
  CHECK_FALSE(is_possible(Study(with_temperatures(20))));
}

// A weight W that hangs a metre beside the top of a column of height h turns that by W h / EI, and moves it
// by W h^2 / 2 EI to its side (a cantilever under a moment). The turn's square, 1e-6, and what W gains by the
// way, 1e-3 of the moment, are left.
TEST_CASE("a column that slides out bends by its height, and more than so to its side") {
  constexpr double W = 30, EI = 1e5;
  NominalArm column;
  add_link(column, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0, 0, {0, 0, 0});
  column.arm.links[0].kind = JointKind::prismatic;
  column.base = "floor", column.tip = "hook";
  column.arm.tip.translation() = Vector3<double>(1, 0, 0);
  Experiment experiment = arm_bench(column, 4);
  for (Run& run : experiment.runs)
    for (std::size_t r = 0; r < run.readings.size(); ++r) {
      run.readings[r].rest = {r == 0 ? 1.0 : 2.0};
      run.readings[r].wrench = {0, 0, -W, 0, 0, 0};
    }
  const Study study(experiment);
  const Prediction bent = predict(study, only("slide_bending"), {1 / EI});
  REQUIRE(bent.reached);
  for (const Eigen::Index r : {0, 1}) {
    const double h = r == 0 ? 1 : 2;
    const Vector3<double> moved = place_of_tip(bent.runs[0], r) - Vector3<double>(1, 0, h);
    CHECK(moved.x() == doctest::Approx(W * h * h / (2 * EI)).epsilon(3e-3));
    CHECK(moved.z() == doctest::Approx(-W * h / EI).epsilon(3e-3));
    CHECK(std::abs(moved.y()) < 1e-12);
  }
}

TEST_CASE("a tool yields to its weight and load, and a loose one drops to whichever side hangs down") {
  constexpr double b = 0.01, c = 1e-4;
  const double away = std::acos(-1.0);
  Experiment experiment = commanded_bar(0, {0.0, away, 0.0});
  experiment.runs.front().readings[2].wrench = {0, 0, 60, 0, 0, 0};  // lifts more than the 2 kg of the bar
  const Study study(experiment);
  const double weight = 2 * 9.81;
  const auto drop = [&](const Candidate& what, const std::vector<double>& values, Eigen::Index reading) {
    const Prediction prediction = predict(study, what, values);
    REQUIRE(prediction.reached);
    return -place_of_tip(prediction.runs[0], reading).z();
  };
  const Candidate yielding = only("tool_compliance"), loose{{EffectAt("tool_play")}};
  const double moment[3] = {weight, weight, weight - 60};  // on a lever of 1 m
  for (const Eigen::Index r : {0, 1, 2}) {
    // sin(pi) is not zero to rounding
    CHECK(drop(yielding, {c}, r) == doctest::Approx(std::sin(c * moment[r])).epsilon(1e-12));
    CHECK(drop(loose, {b}, r) == doctest::Approx(std::copysign(std::sin(b), moment[r])).epsilon(1e-12));
  }
  const Effect* hinged = nullptr;
  for (const Effect& row : catalogue())
    if (row.form == "about one axis") hinged = &row;
  REQUIRE(hinged != nullptr);
  const Candidate about_one_axis{{EffectAt(*hinged)}};
  for (const Eigen::Index r : {0, 1, 2})
    for (const double side : {1.0, -1.0}) {
      CHECK(drop(about_one_axis, {0, side * b, 0}, r) ==
            doctest::Approx(std::copysign(std::sin(b), moment[r])).epsilon(1e-12));
      CHECK(std::abs(drop(about_one_axis, {side * b, 0, 0}, r)) < 1e-12);  // no moment about it
    }
}

TEST_CASE("play shows in a joint that nothing loads, on an arm that carries weight") {
  const Study study(arm_bench(industrial_arm(), 8, {.angles = true}));  // its first axis is vertical
  const Prediction played = predict(study, {{EffectAt("backlash", 1)}}, {1e-3}, true);
  REQUIRE(played.reached);
  CHECK(study.in_sigmas(played.sensitivity[0]).norm() > 1);
}
