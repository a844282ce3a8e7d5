#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "diagnose/discrepancy/law_terms.hpp"
#include "diagnose/discrepancy/torque_balance.hpp"
#include "diagnose/discrepancy/torque_law.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Three presses of three links whose joints have this law, read with noise.
Experiment pressed_with(const std::function<TorqueLaw(const Study&)>& truth, unsigned seed) {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 40, true);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 40, true);
  press(experiment, {0.5, -0.3, 0.4}, {-0.05, -0.02}, 40, false);
  const Study bare(experiment);
  const Prediction given = predict_with_law(bare, truth(bare));
  REQUIRE((given.reached && !given.snapped));
  experiment = as_measured(experiment, given);
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) {
      reading[column_Fx] += experiment.noise[Channel::Name::Fx] * normal(engine);
      reading[column_Fy] += experiment.noise[Channel::Name::Fy] * normal(engine);
      for (std::size_t c = column_q; c < reading.value.size(); ++c)
        reading.value[c] += experiment.noise[Channel::Name::q] * normal(engine);
    }
  return experiment;
}

/// A law over a radian to either side, without what dissipates.
JointTorqueLaw law_of(const std::vector<std::size_t>& joints, double stiffness,
                      const std::function<double(double)>& torque) {
  JointTorqueLaw law{joints, {-1, 1, 160}, Eigen::VectorXd::Zero(law_terms_count), stiffness};
  for (Eigen::Index k = 0; k < finest_knots; ++k) law.coefficients(k) = torque(knot_place(law.span, k));
  return law;
}

/// Five standard deviations of the torque that one reading of a joint tells: of its angle and of the force at
/// the whole chain's length. A law that many readings tell is nearer.
double torque_of_one_reading(const Experiment& experiment, std::size_t joint) {
  const double reach = experiment.link_length[0] + experiment.link_length[1] + experiment.link_length[2];
  return 5 * std::hypot(experiment.joint_stiffness[joint - 1] * experiment.noise[Channel::Name::q],
                        reach * experiment.noise[Channel::Name::Fx]);
}

/// What joints carry along the runs with what was found, beside what they carried.
void check_carried(const Study& study, const TorqueLaw& found, const TorqueLaw& truth) {
  const std::vector<LawTrace> expected = law_traces(study, truth);
  for (const LawTrace& one : law_traces(study, found)) {
    const auto same = std::find_if(expected.begin(), expected.end(), [&](const LawTrace& other) {
      return other.joint == one.joint && other.run == one.run;
    });
    REQUIRE(same != expected.end());
    const double tolerance = torque_of_one_reading(study.experiment(), one.joint);
    CAPTURE(one.joint);
    CHECK((one.torque - same->torque).cwiseAbs().maxCoeff() < tolerance);
  }
}

}  // namespace

TEST_CASE("what a joint carries along a run has what the nominal model knows of its spring") {
  Experiment experiment = full_bench();
  experiment.effects = {{"nonlinear_spring", 0, {{"c", 5}}}, {"joint_stiffness", 2, {{"a", 0.4}}}};
  const Study study(experiment);
  JointTorqueLaw none;
  none.joints = {2};
  none.stiffness = experiment.joint_stiffness[1];
  none.span = {-1, 1, 100};
  none.coefficients = Eigen::VectorXd::Zero(law_terms_count);
  const std::vector<LawTrace> traces = law_traces(study, TorqueLaw{{none}, {3}, 1});
  REQUIRE(traces.size() == experiment.runs.size());
  // The same joint by statics: the moment of the end point's force about it.
  const std::vector<double>& length = experiment.link_length;
  for (const LawTrace& trace : traces) {
    const Trace& run = study.nominal().runs[trace.run];
    for (Eigen::Index r = 0; r < run.rows(); ++r) {
      const double second = angle(run, r, 0) + angle(run, r, 1), third = second + angle(run, r, 2);
      const double x = length[1] * std::cos(second) + length[2] * std::cos(third),
                   y = length[1] * std::sin(second) + length[2] * std::sin(third);
      CHECK(trace.torque(r) ==
            close_to(x * run(r, column_Fy) - y * run(r, column_Fx)).epsilon(1e-6).scale(none.stiffness));
    }
  }
}

TEST_CASE(
    "joints that have each a law of its own are each given one, fitted to the chain that has all of them") {
  const auto truth = [](const Study& study) {
    const std::vector<double>& k = study.experiment().joint_stiffness;
    return TorqueLaw{{law_of({1}, k[0], [&](double d) { return k[0] * d * d * d; }),
                      law_of({2}, k[1], [&](double d) { return -0.2 * k[1] * d; }),
                      law_of({3}, k[2], [&](double d) { return 0.15 * k[2] * std::abs(d); })},
                     {finest_knots},
                     1};
  };
  const Study study(pressed_with(truth, 4));
  const auto found = fit_torque_law(study, declared_noise(study));
  REQUIRE(found);
  REQUIRE(found->laws.size() == 3);
  for (std::size_t j = 0; j < 3; ++j) {
    const JointTorqueLaw& law = found->laws[j];
    CHECK(law.joints == std::vector{j + 1});
    CHECK(law.stiffness == study.experiment().joint_stiffness[j]);
    CHECK(law.span.duration == 160);  // 80 steps of two seconds
    // as far as the nominal model bends the joint
    double low = 0, high = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      const auto bent = study.nominal().runs[r].col(column_q + static_cast<Eigen::Index>(j)) -
                        study.experiment().runs[r].rest[j];
      low = std::min(low, bent.minCoeff()), high = std::max(high, bent.maxCoeff());
    }
    CHECK(law.span.low == close_to(low).epsilon(1e-9));
    CHECK(law.span.high == close_to(high).epsilon(1e-9));
    CHECK(law.coefficients.size() == plain_terms);
  }
  check_carried(study, *found, truth(study));
  const auto values = static_cast<double>(study.measurements().size());
  CHECK(left_with(study, declared_noise(study), *found) < values + 5 * std::sqrt(2 * values));
}

TEST_CASE(
    "joints that share a law have it in proportion to their stiffness, and one joint alone has it as it is") {
  const auto values_of = [](const Study& study) { return static_cast<double>(study.measurements().size()); };
  for (const std::vector<std::size_t>& joints : {std::vector<std::size_t>{1, 2, 3}, {2}}) {
    const double stiffness = joints.size() == 3 ? (2 + 1.5 + 1) / 3 : 1.5;
    const auto truth = [&](const Study&) {
      return TorqueLaw{
          {law_of(joints, stiffness, [&](double d) { return stiffness * d * d * d; })}, {finest_knots}, 1};
    };
    const Study study(pressed_with(truth, 5));
    const auto found = fit_torque_law(study, declared_noise(study));
    REQUIRE(found);
    REQUIRE(found->laws.size() == 1);
    CHECK(found->laws[0].joints == joints);
    CHECK(found->laws[0].stiffness == close_to(stiffness).epsilon(1e-12));
    check_carried(study, *found, truth(study));
    const double values = values_of(study);
    CHECK(left_with(study, declared_noise(study), *found) < values + 5 * std::sqrt(2 * values));
  }
}

TEST_CASE(
    "joints that share a loop over a part of the way share its profile, which laws of their own have not") {
  const auto truth = [](const Study&) {
    TorqueLaw law{{law_of({1, 2, 3}, 1.5, [](double) { return 0.0; })}, {finest_knots}, 1};
    for (Eigen::Index k = 0; k < profile_knots; ++k)
      law.laws[0].coefficients(plain_terms + k) =
          0.15 * std::exp(-std::pow((knot_place(law.laws[0].span, 2 * k) - 0.3) / 0.2, 2));
    return law;
  };
  const Study study(pressed_with(truth, 6));
  const auto found = fit_torque_law(study, declared_noise(study));
  REQUIRE(found);
  REQUIRE(found->laws.size() == 1);
  CHECK(found->laws[0].joints == std::vector<std::size_t>{1, 2, 3});
  REQUIRE(found->laws[0].coefficients.size() == law_terms_count);
  CHECK_FALSE(found->laws[0].coefficients.tail(law_terms_count - plain_terms).isZero(0));
  CHECK(found->cross_validated < 0.5);
}
