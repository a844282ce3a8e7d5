#include "diagnose/inference/study.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <set>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using InPlane = std::array<double, 2>;

double cross(const InPlane& a, const InPlane& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// One predicted reading, read in relative joint angles: what the statics of the effect catalogue is written
/// in.
struct Drawn {
  std::vector<double> q;
  std::vector<InPlane> joint;  ///< positions of joints 1 … n and of the end point
  InPlane force;

  Drawn(const Trace& trace, Eigen::Index row, const std::vector<double>& length)
      : joint{{0, 0}}, force{trace(row, column_Fx), trace(row, column_Fy)} {
    double theta = 0;
    for (std::size_t j = 0; j < length.size(); ++j) {
      q.push_back(trace(row, column_q + static_cast<Eigen::Index>(j)));
      theta += q.back();
      joint.push_back(
          {joint.back()[0] + length[j] * std::cos(theta), joint.back()[1] + length[j] * std::sin(theta)});
    }
  }

  /// [J^T F]_i: moment of a force at a point about joint i.
  [[nodiscard]] double moment(std::size_t i, const InPlane& at, const InPlane& f) const {
    return cross({at[0] - joint[i][0], at[1] - joint[i][1]}, f);
  }
  [[nodiscard]] double moment(std::size_t i) const { return moment(i, joint.back(), force); }
  [[nodiscard]] InPlane middle(std::size_t j) const {
    return {(joint[j][0] + joint[j + 1][0]) / 2, (joint[j][1] + joint[j + 1][1]) / 2};
  }
  [[nodiscard]] double orientation(std::size_t j) const {
    double theta = 0;
    for (std::size_t i = 0; i <= j; ++i) theta += q[i];
    return theta;
  }
};

/// Calls `check(shape, rest, run, reading)` on every predicted reading.
template <class Check>
void each_reading(const Experiment& experiment, const Prediction& predicted, Check check) {
  REQUIRE(predicted.reached);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    for (Eigen::Index i = 0; i < predicted.runs[r].rows(); ++i) {
      check(Drawn(predicted.runs[r], i, experiment.link_length), experiment.runs[r].rest, r,
            static_cast<std::size_t>(i));
    }
  }
}

// Newton stops with steps below 1e-7 rad, which leaves errors of their square: what is left is rounding.
constexpr double up_to_rounding = 1e-9;

/// A value of each parameter that is clearly felt on the full bench.
std::vector<double> sizeable(const Experiment& experiment, const EffectAt& at) {
  if (const auto known = chosen(at); known && !known->sizeable.empty()) return known->sizeable;
  std::vector<double> values;
  for (const ParameterRange& range : Study(experiment).ranges(at)) values.push_back(0.5 * range.scale);
  return values;
}

/// The same effect with amount zero.
std::vector<double> nothing(const EffectAt& at) {
  if (const auto known = chosen(at)) return known->nothing;
  return std::vector<double>(Study(full_bench()).ranges(at).size(), 0.0);
}

double largest_difference(const Prediction& a, const Prediction& b) {
  double largest = 0;
  for (std::size_t r = 0; r < a.runs.size(); ++r)
    largest = std::max(largest, (a.runs[r] - b.runs[r]).abs().maxCoeff());
  return largest;
}

}  // namespace

TEST_CASE("the nominal model satisfies k_i (q_i - rest_i) = [J^T F]_i at the imposed end point") {
  const Experiment experiment = full_bench();
  const Prediction predicted = predict(Study(experiment), {}, {});
  each_reading(experiment, predicted, [&](const Drawn& shape, const auto& rest, auto run, auto reading) {
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(experiment.joint_stiffness[i] * (shape.q[i] - rest[i]) ==
            doctest::Approx(shape.moment(i)).epsilon(up_to_rounding).scale(1));
    }
    if (experiment.runs[run].control == Control::end_point) {
      CHECK(shape.joint.back()[0] ==
            close_to(experiment.runs[run].readings[reading][column_x]).epsilon(up_to_rounding));
      CHECK(
          shape.joint.back()[1] ==
          doctest::Approx(experiment.runs[run].readings[reading][column_y]).epsilon(up_to_rounding).scale(1));
    }
  });
}

TEST_CASE("an effect of amount zero is the nominal model, any other is not") {
  const Experiment experiment = full_bench();
  const Prediction nominal = predict(Study(experiment), {}, {});
  const auto possible = possible_effects(Study(experiment));
  // Nothing saturates where no force was read, nominal links weigh nothing, no servo moves a joint, and there
  // are no loads along the chain, no second sensor, no torques of drives, no axes and points in space.
  std::set<std::string> without;
  for (const Effect& row : catalogue()) without.insert(row.id);
  for (const EffectAt& at : possible) without.erase(at.effect->id);
  for (const char* one : {"distance", "pixel", "inclination", "height", "applied"})
    CHECK(std::erase_if(without, [&](const std::string& id) { return id.starts_with(one); }) >= 4);
  CHECK(without == std::set<std::string>{
                       "saturation",       "mass_scale",        "joint_scale",          "encoder_ripple",
                       "joint_compliance", "joint_balance",     "gravity_compensation", "moment_arm",
                       "capstan_friction", "second_zero",       "second_gain",          "torque_bias",
                       "torque_drift",     "torque_cross_talk", "torque_lag",           "tilt_bias",
                       "tilt_scale",       "tilt_drift",        "tilt_cross_talk",      "tilt_lag",
                       "second_drift",     "second_cross_talk", "second_lag",           "command_drift",
                       "torque_scale",     "axis_tilt",         "axis_shift",           "link_centre",
                       "mount_tilt",       "thermal_expansion", "tool_compliance",      "tool_play",
                       "tool_offset",      "tool_turn",         "slide_bending",        "upper_limit",
                       "lower_limit",      "gear_coupling",     "covariate_lag"});
  for (const EffectAt& at : possible) {
    CAPTURE(at.name());
    const Prediction none = predict(Study(experiment), {{at}}, nothing(at));
    REQUIRE(none.reached);
    CHECK(largest_difference(none, nominal) < (at.effect == &effect("link_bending") ? 1e-4 : 1e-7));
    const Prediction some = predict(Study(experiment), {{at}}, sizeable(experiment, at));
    REQUIRE(some.reached);
    CHECK(largest_difference(some, nominal) > 1e-4);
  }
}

TEST_CASE("sensitivities are the derivatives of the prediction, history included") {
  const Experiment experiment = full_bench();
  for (const EffectAt& at : possible_effects(Study(experiment))) {
    CAPTURE(at.name());
    const std::vector<double> value = sizeable(experiment, at);
    const std::vector<ParameterRange> ranges = Study(experiment).ranges(at);
    const Prediction predicted = predict(Study(experiment), {{at}}, value, true);
    REQUIRE(predicted.reached);
    for (std::size_t p = 0; p < value.size(); ++p) {
      const double step = 1e-4 * ranges[p].scale;
      std::vector<double> up = value, down = value;
      up[p] += step;
      down[p] -= step;
      const Prediction above = predict(Study(experiment), {{at}}, up),
                       below = predict(Study(experiment), {{at}}, down);
      for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        const Trace quotient = (above.runs[r] - below.runs[r]) / (2 * step);
        // The forward step of the sensitivities errs by 1e-6 of the curvature over a scale; a kink (a joint
        // that reaches its play or stop, or sticks, between the two probes) spoils the quotient of single
        // readings.
        const double size = quotient.abs().maxCoeff();
        const auto wrong = ((predicted.sensitivity[p][r] - quotient).abs() > 1e-3 * size + 1e-7).count();
        CHECK(wrong <= quotient.size() / 50);
      }
    }
  }
}

TEST_CASE("joint effects balance as their definitions say") {
  const Experiment experiment = full_bench();
  const std::vector<double>& k = experiment.joint_stiffness;
  const auto torque = [](double value) { return doctest::Approx(value).epsilon(1e-8).scale(1); };

  each_reading(experiment, predict(Study(experiment), only("joint_stiffness", 2), {std::log1p(0.3)}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 CHECK(k[1] * 1.3 * (shape.q[1] - rest[1]) == torque(shape.moment(1)));
                 CHECK(k[2] * (shape.q[2] - rest[2]) == torque(shape.moment(2)));
               });
  each_reading(experiment, predict(Study(experiment), only("rest_angle", 3), {0.07}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 CHECK(k[2] * (shape.q[2] - rest[2] - 0.07) == torque(shape.moment(2)));
               });
  each_reading(experiment, predict(Study(experiment), only("nonlinear_spring"), {1.7}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 for (std::size_t i = 0; i < 3; ++i) {
                   const double d = shape.q[i] - rest[i];
                   CHECK(k[i] * d * (1 + 1.7 * d * d) == torque(shape.moment(i)));
                 }
               });
  each_reading(experiment, predict(Study(experiment), only("backlash", 1), {0.05}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 const double d = shape.q[0] - rest[0];
                 const double engaged = std::max(0.0, std::abs(d) - 0.05);
                 CHECK(std::copysign(k[0] * engaged, d) == torque(shape.moment(0)));
               });
  each_reading(experiment, predict(Study(experiment), only("joint_stop", 2), {0.1, 4.0}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 const double d = shape.q[1] - rest[1];
                 const double excess = std::max(0.0, std::abs(d) - 0.1);
                 CHECK(k[1] * d + std::copysign(4.0 * excess, d) == torque(shape.moment(1)));
               });
  each_reading(experiment, predict(Study(experiment), only("joint_coupling"), {0.4}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 const auto d = [&](std::size_t i) { return shape.q[i] - rest[i]; };
                 CHECK(k[0] * d(0) - 0.4 * d(1) == torque(shape.moment(0)));
                 CHECK(k[1] * d(1) - 0.4 * (d(0) + d(2)) == torque(shape.moment(1)));
                 CHECK(k[2] * d(2) - 0.4 * d(1) == torque(shape.moment(2)));
               });
}

TEST_CASE("weights, an eccentric load and a held tip balance as their definitions say") {
  const Experiment experiment = full_bench();
  const std::vector<double>&k = experiment.joint_stiffness, &length = experiment.link_length;
  const auto torque = [](double value) { return doctest::Approx(value).epsilon(1e-8).scale(1); };

  each_reading(experiment, predict(Study(experiment), only("gravity"), {0.8}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 for (std::size_t i = 0; i < 3; ++i) {
                   double moment = shape.moment(i);
                   for (std::size_t j = i; j < 3; ++j)
                     moment += shape.moment(i, shape.middle(j), {0, -0.8 * length[j] * standard_gravity});
                   CHECK(k[i] * (shape.q[i] - rest[i]) == torque(moment));
                 }
               });
  each_reading(experiment, predict(Study(experiment), only("tip_payload"), {0.6}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 for (std::size_t i = 0; i < 3; ++i) {
                   const double moment = shape.moment(i) + shape.moment(i, shape.joint.back(), {0, -0.6});
                   CHECK(k[i] * (shape.q[i] - rest[i]) == torque(moment));
                 }
               });
  each_reading(experiment, predict(Study(experiment), only("eccentric_load"), {0.02}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 const double theta = shape.orientation(2);
                 const double extra = 0.02 * cross({-std::sin(theta), std::cos(theta)}, shape.force);
                 for (std::size_t i = 0; i < 3; ++i)
                   CHECK(k[i] * (shape.q[i] - rest[i]) == torque(shape.moment(i) + extra));
               });
  each_reading(experiment, predict(Study(experiment), only("tip_stiffness"), {0.5}),
               [&](const Drawn& shape, const auto& rest, auto, auto) {
                 const double turned = shape.orientation(2) - (rest[0] + rest[1] + rest[2]);
                 for (std::size_t i = 0; i < 3; ++i)
                   CHECK(k[i] * (shape.q[i] - rest[i]) == torque(shape.moment(i) - 0.5 * turned));
               });
}

TEST_CASE("compliances move the end point as their definitions say") {
  const Experiment experiment = full_bench();
  const auto place = [](double value) { return doctest::Approx(value).epsilon(1e-8).scale(0.1); };
  const auto imposed = [&](std::size_t run) { return experiment.runs[run].control == Control::end_point; };

  each_reading(experiment, predict(Study(experiment), only("link_length", 2), {0.02}),
               [&](const Drawn& shape, const auto&, auto run, auto reading) {
                 if (!imposed(run)) return;
                 const double extra = 0.02 * experiment.link_length[1];
                 const double theta = shape.orientation(1);
                 CHECK(shape.joint.back()[0] + extra * std::cos(theta) ==
                       place(experiment.runs[run].readings[reading][column_x]));
               });
  const Prediction base = predict(Study(experiment), only("base_compliance"), {1e-3, 2e-3});
  each_reading(experiment, base, [&](const Drawn& shape, const auto&, auto run, auto reading) {
    const double x = base.runs[run](static_cast<Eigen::Index>(reading), column_x);
    const double y = base.runs[run](static_cast<Eigen::Index>(reading), column_y);
    CHECK(shape.joint.back()[0] + 1e-3 * shape.force[0] == place(x));
    CHECK(shape.joint.back()[1] + 2e-3 * shape.force[1] == place(y));
  });
  each_reading(experiment, predict(Study(experiment), only("train_compliance"), {1e-3}),
               [&](const Drawn& shape, const auto&, auto run, auto reading) {
                 if (!imposed(run)) return;
                 CHECK(shape.joint.back()[0] ==
                       place(experiment.runs[run].readings[reading][column_x] - 1e-3 * shape.force[0]));
               });
  const Prediction axial = predict(Study(experiment), only("axial_compliance"), {2e-3});
  each_reading(experiment, axial, [&](const Drawn& shape, const auto&, auto run, auto reading) {
    InPlane end{0, 0};
    for (std::size_t j = 0; j < 3; ++j) {
      const InPlane u{std::cos(shape.orientation(j)), std::sin(shape.orientation(j))};
      const double tension = u[0] * shape.force[0] + u[1] * shape.force[1];
      for (std::size_t a : {0U, 1U}) end[a] += experiment.link_length[j] * (1 + 2e-3 * tension) * u[a];
    }
    CHECK(end[0] == place(axial.runs[run](static_cast<Eigen::Index>(reading), column_x)));
    CHECK(end[1] == place(axial.runs[run](static_cast<Eigen::Index>(reading), column_y)));
  });
}

TEST_CASE("base compliance along x and train compliance are equivalent where only x moves") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  const Prediction base = predict(Study(experiment), only("base_compliance"), {1e-3, 0});
  const Prediction train = predict(Study(experiment), only("train_compliance"), {1e-3});
  CHECK(largest_difference(base, train) < 1e-9);
}

TEST_CASE("a servo that loads shares the load cell's errors, weights do not") {
  Experiment experiment = three_links();
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {-1.0, 0.5}, 10);
  const auto end = [&](const char* id, const std::vector<double>& parameters) {
    const Trace trace = predict(Study(experiment), id ? only(id) : Candidate{}, parameters).runs[0];
    return InPlane{trace(10, column_x), trace(10, column_y)};
  };
  const InPlane nominal = end(nullptr, {});
  const std::vector<std::pair<const char*, std::vector<double>>> errors{{"force_gain", {0.1}},
                                                                        {"force_bias", {0.1, 0.1}},
                                                                        {"sensor_drift", {0.02, 0.01}},
                                                                        {"cross_talk", {0.1, 0.1}}};
  for (const auto& [id, parameters] : errors) {
    CAPTURE(id);
    experiment.runs[0].by_weights = false;
    CHECK(std::abs(end(id, parameters)[0] - nominal[0]) > 1e-4);
    experiment.runs[0].by_weights = true;
    CHECK(end(id, parameters) == nominal);
  }
  // A wrong stiffness shows under either.
  CHECK(std::abs(end("stiffness_scale", {0.1})[0] - nominal[0]) > 1e-4);
}

TEST_CASE("effects of rig and load cell act on commands and on readings") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0.01}, 10, true);
  const Trace nominal = predict(Study(experiment), {}, {}).runs[0];
  const auto force = [&](const char* id, std::vector<double> parameters, Eigen::Index row) {
    const Trace trace = predict(Study(experiment), only(id), parameters).runs[0];
    return InPlane{trace(row, column_Fx), trace(row, column_Fy)};
  };
  const Eigen::Index loading = 4, unloading = 14;
  const auto fx = [&](Eigen::Index row) { return nominal(row, column_Fx); };
  const auto fy = [&](Eigen::Index row) { return nominal(row, column_Fy); };
  CHECK(force("force_bias", {0.3, -0.2}, 4)[0] == close_to(fx(4) + 0.3));
  CHECK(force("force_bias", {0.3, -0.2}, 4)[1] == close_to(fy(4) - 0.2));
  CHECK(force("force_gain", {0.1}, 7)[0] == close_to(1.1 * fx(7)));
  CHECK(force("sensor_drift", {0.01, 0.02}, 7)[1] == close_to(fy(7) + 0.02 * 14));
  CHECK(force("guide_friction", {0.5}, 0)[0] == doctest::Approx(fx(0)).scale(1));
  CHECK(force("guide_friction", {0.5}, loading)[0] == close_to(fx(loading) - 0.5));
  CHECK(force("guide_friction", {0.5}, unloading)[0] == close_to(fx(unloading) + 0.5));

  // A rail that is turned: the same chain, pressed along the turned line, its force read in turned axes.
  const double eps = 0.1;
  Experiment turned = experiment;
  for (Reading& reading : turned.runs[0].readings) {
    const Reading& start = experiment.runs[0].readings.front();
    const double dx = reading[column_x] - start[column_x], dy = reading[column_y] - start[column_y];
    reading[column_x] = start[column_x] + std::cos(eps) * dx - std::sin(eps) * dy;
    reading[column_y] = start[column_y] + std::sin(eps) * dx + std::cos(eps) * dy;
  }
  const Trace along = predict(Study(turned), {}, {}).runs[0];
  const InPlane read = force("rail_misalignment", {eps}, 6);
  CHECK(read[0] == close_to(std::cos(eps) * along(6, column_Fx) + std::sin(eps) * along(6, column_Fy)));
  CHECK(read[1] == close_to(-std::sin(eps) * along(6, column_Fx) + std::cos(eps) * along(6, column_Fy)));

  Experiment shifted = experiment;
  for (Reading& reading : shifted.runs[0].readings) {
    reading[column_x] += 0.002;
    reading[column_y] -= 0.001;
  }
  const InPlane offset = force("position_offset", {0.002, -0.001}, 6);
  CHECK(offset[0] == close_to(predict(Study(shifted), {}, {}).runs[0](6, column_Fx)));
}

TEST_CASE("guide friction acts at the first reading of a run that was brought there along x") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 10, false);
  experiment.runs[0].readings.erase(experiment.runs[0].readings.begin());
  const double with = predict(Study(experiment), only("guide_friction"), {0.5}).runs[0](0, column_Fx);
  CHECK(with == close_to(predict(Study(experiment), {}, {}).runs[0](0, column_Fx) - 0.5));
}

namespace {

/// The bench's run of imposed force alone, from one force to another in 15 s.
Experiment pushed(const InPlane& from, const InPlane& to) {
  Experiment experiment = three_links();
  load(experiment, {0.2, 0.3, -0.3}, from, to, 15);
  return experiment;
}

/// End point and angles of the one run, as predicted.
Trace response(const Experiment& experiment, const Candidate& candidate,
               const std::vector<double>& parameters) {
  const Prediction predicted = predict(Study(experiment), candidate, parameters);
  REQUIRE(predicted.reached);
  Trace trace = predicted.runs[0];
  trace.col(column_Fx) = 0;  // what was commanded
  trace.col(column_Fy) = 0;
  return trace;
}

}  // namespace

TEST_CASE("an imposed force is the load cell's reading: the true force lacks its bias, drift and gain") {
  const InPlane from{-0.2, 0.1}, to{-2.0, 1.0};
  const Experiment experiment = pushed(from, to);
  const auto close = [](const Trace& a, const Trace& b) { return (a - b).abs().maxCoeff() < up_to_rounding; };
  CHECK(close(response(experiment, only("force_bias"), {0.3, -0.2}),
              response(pushed({from[0] - 0.3, from[1] + 0.2}, {to[0] - 0.3, to[1] + 0.2}), {}, {})));
  CHECK(close(response(experiment, only("sensor_drift"), {0.02, -0.03}),
              response(pushed(from, {to[0] - 15 * 0.02, to[1] + 15 * 0.03}), {}, {})));
  CHECK(close(response(experiment, only("force_gain"), {0.25}),
              response(pushed({from[0] / 1.25, from[1] / 1.25}, {to[0] / 1.25, to[1] / 1.25}), {}, {})));
}

TEST_CASE("under an imposed force the end point is read less its offset") {
  const Experiment experiment = pushed({-0.2, 0.1}, {-2.0, 1.0});
  const Trace nominal = predict(Study(experiment), {}, {}).runs[0];
  const Trace offset = predict(Study(experiment), only("position_offset"), {0.01, -0.02}).runs[0];
  CHECK((offset.col(column_x) - (nominal.col(column_x) - 0.01)).abs().maxCoeff() < up_to_rounding);
  CHECK((offset.col(column_y) - (nominal.col(column_y) + 0.02)).abs().maxCoeff() < up_to_rounding);
  const Trace yielding = predict(Study(experiment), only("train_compliance"), {0.003}).runs[0];
  CHECK((yielding.col(column_x) - (nominal.col(column_x) + 0.003 * nominal.col(column_Fx))).abs().maxCoeff() <
        up_to_rounding);
  CHECK((yielding.col(column_y) - nominal.col(column_y)).abs().maxCoeff() < up_to_rounding);
}

TEST_CASE("a link stands at the sum of the joint angles up to it, as an inclinometer on it reads") {
  const Experiment experiment = full_bench();
  const Prediction predicted = Study(experiment).nominal();
  REQUIRE(predicted.reached);
  for (const Trace& trace : predicted.runs)
    for (Eigen::Index r = 0; r < trace.rows(); ++r) {
      double sum = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        sum += trace(r, Channel(Channel::Name::q, j).column);
        CHECK(trace(r, Channel(Channel::Name::tilt, j, 3).column) == doctest::Approx(sum).epsilon(1e-14));
      }
    }
}
