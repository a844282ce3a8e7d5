/// \file
/// Chains under tendons, pressures and forces on links.

#include "diagnose/rig/chain_loads.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "diagnose/rig/characteristic_scales.hpp"
#include "diagnose/rig/history.hpp"
#include "diagnose/rig/nominal.hpp"
#include "diagnose/rig/regime.hpp"
#include "diagnose/rig/substeps.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/finger.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Equilibria are solved to ten digits of angles of about one.
constexpr double rounding_of_equilibria = 1e-9;

Trace trace_of(const Experiment& experiment, const Rig& rig) {
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  CHECK_FALSE(predicted.snapped);
  return predicted.runs.front();
}

Trace trace_of(const Experiment& experiment) {
  return trace_of(experiment, nominal_rig(experiment));
}

/// Three links under a growing force at a share of a link.
Experiment pulled_at(std::size_t link, double at, const Vector2& force) {
  Experiment experiment = three_links();
  load(experiment, {0.3, -0.5, 0.4}, {0, 0}, {0, 0}, 6);
  for (std::size_t i = 0; i < experiment.runs[0].readings.size(); ++i) {
    const double share = static_cast<double>(i) / 6;
    experiment.runs[0].readings[i].covariates = {share * force.x(), share * force.y()};
  }
  set_loads(experiment, {{Load::Kind::force, 0, {}, link, at}}, {"Gx", "Gy"});
  return experiment;
}

/// Every part of a rig that bends, stretches or couples.
Rig yielding(const Experiment& experiment) {
  Rig rig = nominal_rig(experiment);
  rig.flexibility = 0.6, rig.axial = 0.011, rig.coupling = 0.2;
  return rig;
}

}  // namespace

TEST_CASE("a tendon turns each joint by its radius times the tension over the stiffness") {
  check_property("of any tensions and radii", [] {
    const double largest = random_hundredths(1, 40);
    Experiment experiment = finger(there_and_back(largest, 5));
    std::vector<double>& radius = experiment.loads[0].moment_arm;
    for (double& one : radius) one = random_hundredths(-2, 2) / 100;
    for (const Load::Kind kind : {Load::Kind::tendon, Load::Kind::pressure}) {
      experiment.loads[0].kind = kind;
      const Trace trace = trace_of(experiment);
      for (std::size_t i = 0; i < experiment.runs[0].readings.size(); ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const double tension = experiment.runs[0].readings[i].covariates[0];
          const double turned = radius[j] * tension / experiment.joint_stiffness[j];
          RC_ASSERT(std::abs(angle(trace, static_cast<Eigen::Index>(i), j) - finger_rest[j] - turned) <
                    rounding_of_equilibria);
        }
    }
  });
}

TEST_CASE("a first tension that turns joints by more than a radian is no snap") {
  const Trace trace = trace_of(finger({40, 50}));
  CHECK(angle(trace, 0, 0) == close_to(0.1 + 0.012 * 40 / 0.4).epsilon(rounding_of_equilibria));
}

TEST_CASE("a force at the end of the last link is that on the end point") {
  const Vector2 force(-1.2, 0.7);
  Experiment at_end = three_links();
  load(at_end, {0.3, -0.5, 0.4}, {0, 0}, {force.x(), force.y()}, 6);
  at_end.runs[0].by_weights = true;
  const Experiment along = pulled_at(2, 1, force);
  for (const bool yields : {false, true}) {
    const auto rig = [&](const Experiment& one) { return yields ? yielding(one) : nominal_rig(one); };
    const Trace of_end = trace_of(at_end, rig(at_end)), of_link = trace_of(along, rig(along));
    CHECK(difference(of_end.leftCols(2), of_link.leftCols(2)) < rounding_of_equilibria);
    CHECK(difference(of_end.rightCols(3), of_link.rightCols(3)) < rounding_of_equilibria);
  }
}

TEST_CASE("a force at the beginning of a link is one at the end of the link before") {
  const Experiment after = pulled_at(2, 0, {0.6, -1.1}), before = pulled_at(1, 1, {0.6, -1.1});
  CHECK(difference(trace_of(after, yielding(after)), trace_of(before, yielding(before))) <
        rounding_of_equilibria);
}

TEST_CASE("beyond a force on a link the chain stays at rest; to it, it is a chain that ends there") {
  for (const double at : {0.4, 1.0}) {
    const Vector2 force(0.6, -1.1);
    const Trace whole = trace_of(pulled_at(1, at, force));
    Experiment cut = three_links();
    cut.link_length = {0.20, at * 0.25}, cut.joint_stiffness = {2.0, 1.5}, cut.link_mass = {0, 0};
    load(cut, {0.3, -0.5}, {0, 0}, {force.x(), force.y()}, 6);
    cut.runs[0].by_weights = true;
    const Trace ends_there = trace_of(cut);
    for (Eigen::Index i = 0; i < whole.rows(); ++i) {
      CHECK(angle(whole, i, 0) == close_to(angle(ends_there, i, 0)).epsilon(rounding_of_equilibria));
      CHECK(angle(whole, i, 1) == close_to(angle(ends_there, i, 1)).epsilon(rounding_of_equilibria));
      CHECK(angle(whole, i, 2) == close_to(0.4).epsilon(rounding_of_equilibria));
    }
  }
}

TEST_CASE("a weight hung at the middle of a link is that of the link") {
  const Experiment hung = pulled_at(1, 0.5, {0, -1.4});
  Experiment heavy = three_links();
  load(heavy, {0.3, -0.5, 0.4}, {0, 0}, {0, 0}, 1);
  Rig rig = nominal_rig(heavy);
  rig.weight[1] = {0, -1.4};
  for (const double flexibility : {0.0, 0.3}) {
    rig.flexibility = flexibility;
    Rig with_load = nominal_rig(hung);
    with_load.flexibility = flexibility;
    const Trace by_load = trace_of(hung, with_load), by_weight = trace_of(heavy, rig);
    const double apart = difference(by_load.row(6), by_weight.row(1));
    // A beam under its weight bends otherwise than under that weight in the middle.
    CHECK(apart < (flexibility > 0 ? 0.02 : rounding_of_equilibria));
  }
}

TEST_CASE("friction: the tension falls from joint to joint while it grows, and rises while it is let out") {
  const double mu = 0.1;
  const std::vector<Load> loads{{Load::Kind::tendon, 0, {0.01, 0, 0.02}}};
  LoadHistory passing(loads, 3, 0.5, mu);
  const std::vector<double> up{10}, little_less{9.5}, less{4};
  const ChainLoads pulled = passing.next(up);
  CHECK(pulled.moment[0] == close_to(1.5 * 0.1));
  CHECK(pulled.moment[1] == 0);
  CHECK(pulled.moment[2] == close_to(1.5 * 0.2 * std::exp(-mu)));  // the joint between does not count
  CHECK(passing.next(little_less).moment[2] == pulled.moment[2]);  // sticks
  CHECK(passing.next(less).moment[2] == close_to(1.5 * 0.08 * std::exp(mu)));
}

TEST_CASE("a tendon that rubs dissipates: what it did on the joints is less than what was put in") {
  check_property("around any loop of tensions", [] {
    Experiment experiment = finger(there_and_back(10, 8));
    const double mu = random_hundredths(0, 1), low = random_hundredths(0, 9);
    std::vector<Reading>& readings = experiment.runs[0].readings;
    for (int i = 0; i <= 16; ++i) {
      readings.push_back(readings.back());
      readings.back().t += 2;
      readings.back().covariates = {low + (10 - low) * (1 - std::abs(1 - i / 8.0))};
    }
    Rig rig = nominal_rig(experiment);
    rig.capstan_friction = mu;
    const Trace trace = trace_of(experiment, rig);
    double put_in = 0;  // by the tension over the way of the tendon, around the last loop
    for (std::size_t i = readings.size() - 16; i < readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      double way = 0;
      for (std::size_t j = 0; j < 3; ++j)
        way += finger_radius[j] * (angle(trace, row, j) - angle(trace, row - 1, j));
      put_in += (readings[i].covariates[0] + readings[i - 1].covariates[0]) / 2 * way;
    }
    RC_ASSERT(put_in > -1e-9);
  });
}

TEST_CASE("loads at part of the way are between those at its ends, from nothing too") {
  const ChainLoads to{{2, 4}, {{1, 0.5, {6, 8}}}};
  const ChainLoads half = between({}, to, 0.5), most = between(half, to, 0.5);
  CHECK(half.moment == std::vector<double>{1, 2});
  CHECK(half.forces[0].value == Vector2(3, 4));
  CHECK(half.forces[0].link == 1);
  CHECK(most.moment == std::vector<double>{1.5, 3});
  CHECK(most.forces[0].value == Vector2(4.5, 6));
}

TEST_CASE("a run whose tendon is pulled and let out turns back, and slips are followed on the way") {
  const Experiment experiment = finger(there_and_back(10, 4));
  const Run& run = experiment.runs[0];
  CHECK(run.turning_points() == std::vector{false, false, false, false, true, false, false, false, false});
  const CharacteristicScales size = characteristic_scales(experiment);
  CHECK(size.turns_back);
  CHECK(size.turned_by_loads);
  CHECK(size.long_tendon);
  CHECK_FALSE(size.load_cell);
  // The largest moment, 0.12 N m, over 0.3 of a chain of 0.6 m.
  CHECK(size.force == close_to(0.12 / (0.3 * 0.6)));
  CHECK(size.deflection == close_to(0.12 / 0.3));
  const Rig rig = nominal_rig(experiment);
  // A quarter of 48, and one more where rounding makes it a little more.
  const std::vector<std::size_t> parts = substeps(run, 1, rig);
  CHECK(parts[0] == 1);
  for (std::size_t i = 1; i < parts.size(); ++i) CHECK((parts[i] == 12 || parts[i] == 13));
  CHECK(regimes(run, trace_of(experiment))[6] == Regime::unloading);
}

TEST_CASE("dry friction in the joints of a finger leaves it bent when the tendon is slack") {
  const Experiment experiment = finger(there_and_back(10, 6));
  Rig rig = nominal_rig(experiment);
  rig.friction = {0.01, 0.01, 0.01};
  const Trace trace = trace_of(experiment, rig);
  for (std::size_t j = 0; j < 3; ++j) {
    const double k = experiment.joint_stiffness[j], sticks = 1e-4;
    CHECK(std::abs(angle(trace, 6, j) - finger_rest[j] - (finger_radius[j] * 10 - 0.01) / k) < sticks);
    CHECK(std::abs(angle(trace, 12, j) - finger_rest[j] - 0.01 / k) < sticks);
  }
}
