#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include "diagnose/inference/measurements.hpp"
#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Work of the environment on the end point, by the trapezoidal rule.
double work(const Trace& trace, Eigen::Index from, Eigen::Index to) {
  double sum = 0;
  for (Eigen::Index i = from; i < to; ++i) {
    for (const auto& [force, place] : {std::pair{column_Fx, column_x}, std::pair{column_Fy, column_y}})
      sum += (trace(i, force) + trace(i + 1, force)) / 2 * (trace(i + 1, place) - trace(i, place));
  }
  return sum;
}

double elastic_energy(const Experiment& experiment, const Trace& trace, Eigen::Index row) {
  double sum = 0;
  for (std::size_t i = 0; i < experiment.joint_stiffness.size(); ++i)
    sum += experiment.joint_stiffness[i] * std::pow(angle(trace, row, i) - experiment.runs[0].rest[i], 2) / 2;
  return sum;
}

/// Half a meter on a spring of 2 N m/rad, without weight.
Experiment one_link() {
  Experiment experiment = three_links();
  experiment.link_length = {0.5};
  experiment.joint_stiffness = {2.0};
  experiment.link_mass = {0};
  return experiment;
}

/// A press and back in steps so fine that the trapezoidal rule, which errs by the square of the step, is
/// right to four digits.
Experiment fine_cycle() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0.01}, 400, true, 0.1);
  return experiment;
}

}  // namespace

TEST_CASE("without friction the work of the load is stored") {
  const Experiment experiment = fine_cycle();
  const Trace trace = predict(Study(experiment), {}, {}).runs[0];
  const double stored = elastic_energy(experiment, trace, 400);
  CHECK(work(trace, 0, 400) == close_to(stored).epsilon(1e-4));
  CHECK(work(trace, 0, 800) == doctest::Approx(0).scale(stored).epsilon(1e-6));
}

TEST_CASE("dry friction dissipates tau_c times the path of every joint, and no contact carries more") {
  const Experiment experiment = fine_cycle();
  const double tau_c = 0.03;
  const Trace trace = predict(Study(experiment), only("joint_friction"), {tau_c}).runs[0];
  double way = 0, stuck = 0;
  for (Eigen::Index row = 1; row < trace.rows(); ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double turn = std::abs(angle(trace, row, i) - angle(trace, row - 1, i));
      way += turn;
      stuck += turn < 1e-6;
    }
  }
  const double dissipated = work(trace, 0, 800) - elastic_energy(experiment, trace, 800);
  CHECK(dissipated == close_to(tau_c * way).epsilon(1e-2));  // at the reversals the force jumps within a step
  CHECK(stuck > 0);
}

TEST_CASE("one joint under an imposed force sticks until tau_c and lags by it on the way back") {
  Experiment experiment = one_link();
  load(experiment, {0.0}, {0, 0}, {0, 0.4}, 40);
  for (int i = 39; i >= 0; --i) {
    Reading back = experiment.runs[0].readings[static_cast<std::size_t>(i)];
    back.t = 80 - i;
    experiment.runs[0].readings.push_back(back);
  }
  const double tau_c = 0.05;
  const Trace trace = predict(Study(experiment), only("joint_friction"), {tau_c}).runs[0];
  for (Eigen::Index row = 0; row < trace.rows(); ++row) {
    const double q = angle(trace, row, 0);
    const double moment = 0.5 * std::cos(q) * trace(row, column_Fy);
    CHECK(std::abs(moment - 2.0 * q) <= tau_c * (1 + 1e-9));
    if (moment < tau_c) {
      if (row <= 40) CHECK(std::abs(q) < 1e-6);
    } else if (row > 0 && row <= 40) {
      CHECK(moment - 2.0 * q == close_to(tau_c));
    }
  }
  // Unloaded, the joint is held where its spring carries tau_c.
  CHECK(2.0 * angle(trace, 80, 0) == close_to(tau_c).epsilon(1e-6));
}

TEST_CASE("a joint with play turns freely by b before it carries") {
  Experiment experiment = one_link();
  load(experiment, {0.0}, {0, 0.01}, {0, 0.4}, 40);
  const Trace trace = predict(Study(experiment), only("backlash", 1), {0.04}).runs[0];
  for (Eigen::Index row = 0; row < trace.rows(); ++row) {
    const double q = angle(trace, row, 0);
    CHECK(2.0 * (q - 0.04) == close_to(0.5 * std::cos(q) * trace(row, column_Fy)));
  }
}

TEST_CASE("the end of a run does not depend on its number of readings") {
  // Chains of two to five links of random lengths, springs and rest angles, pressed by up to half of their
  // length: where 400 readings show no snap, one or three lead to the same angles.
  std::mt19937 random(11);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::size_t compared = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t links = 2 + static_cast<std::size_t>(trial % 4);
    Experiment often = three_links();
    often.link_mass.assign(links, 0);
    often.link_length.clear();
    often.joint_stiffness.clear();
    std::vector<double> rest;
    double length = 0;
    for (std::size_t i = 0; i < links; ++i) {
      often.link_length.push_back(between(0.1, 0.3));
      often.joint_stiffness.push_back(between(0.5, 3));
      rest.push_back(between(-0.6, 0.6));
      length += often.link_length.back();
    }
    Experiment seldom = often;
    const std::array<double, 2> by{-between(0.02, 0.5) * length, between(-0.2, 0.2) * length};
    const int steps = trial % 2 == 0 ? 1 : 3;
    press(often, rest, by, 400, false);
    press(seldom, rest, by, steps, false);
    const Prediction fine = predict(Study(often), {}, {}), coarse = predict(Study(seldom), {}, {});
    if (!fine.reached || fine.snapped) continue;
    ++compared;
    REQUIRE(coarse.reached);
    for (std::size_t i = 0; i < links; ++i)
      CHECK(std::abs(angle(fine.runs[0], 400, i) - angle(coarse.runs[0], steps, i)) < 1e-7);
  }
  CHECK(compared > 150);
}

TEST_CASE("a joint pushed out of its play comes to rest at lower energy") {
  // Inside its play a joint has no stiffness, and a chain that is nearly straight none under a pressing force
  // either: it falls to a side of the play. Along the way of a stable chain, and where it snaps, its energy
  // under the load that it comes to, Phi - F . p, does not rise; 1e-9 of it is what Newton's method leaves.
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t links = 2 + static_cast<std::size_t>(trial % 5);
    Experiment experiment = three_links();
    experiment.link_mass.assign(links, 0);
    experiment.link_length.clear();
    experiment.joint_stiffness.assign(links, between(1, 4));
    std::vector<double> rest;
    for (std::size_t i = 0; i < links; ++i) {
      experiment.link_length.push_back(between(0.06, 0.12));
      rest.push_back(between(-0.08, 0.08));
    }
    const std::size_t joint = 1 + static_cast<std::size_t>(between(0, 0.999) * static_cast<double>(links));
    const double play = between(0.02, 0.2), force = -between(0.05, 2);
    load(experiment, rest, {0, 0}, {force, 0}, 1);
    const Prediction predicted = predict(Study(experiment), only("backlash", joint), {play});
    if (!predicted.reached) continue;
    const auto energy = [&](Eigen::Index row) {
      double sum = -force * predicted.runs[0](row, column_x);
      for (std::size_t i = 0; i < links; ++i) {
        const double turned = std::abs(angle(predicted.runs[0], row, i) - rest[i]);
        const double spring = i + 1 == joint ? std::max(0.0, turned - play) : turned;
        sum += experiment.joint_stiffness[i] * spring * spring / 2;
      }
      return sum;
    };
    CAPTURE(trial);
    CHECK(energy(1) <= energy(0) + 1e-9 * std::abs(force));
  }
}

TEST_CASE("Maxwell arms stiffen fast loading by 1 + m, and slow loading not at all") {
  const double m = 0.4, tau = 10;
  const auto first_force = [&](double interval, double share) {
    Experiment experiment = three_links();
    press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 1, false, interval);
    return predict(Study(experiment), only("viscoelasticity"), {m * share, std::log(tau)})
        .runs[0](1, column_Fx);
  };
  const double nominal = first_force(1, 0);
  CHECK(first_force(1e-6, 1) == close_to((1 + m) * nominal).epsilon(1e-6));
  // Steady rate over dt >> tau: the arm carries m k tau/dt of the turn.
  CHECK(first_force(1e4, 1) == close_to((1 + m * tau / 1e4) * nominal).epsilon(1e-6));
}

TEST_CASE("a held chain relaxes exponentially from 1 + m to the nominal force") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 1, false, 1e-6);
  Run& run = experiment.runs[0];
  for (int i = 1; i <= 30; ++i) {
    run.readings.push_back(run.readings[1]);
    run.readings.back().t = 1e-6 + 5.0 * i;
  }
  const double m = 0.4, tau = 10;
  const Trace trace = predict(Study(experiment), only("viscoelasticity"), {m, std::log(tau)}).runs[0];
  const double nominal = predict(Study(experiment), {}, {}).runs[0](1, column_Fx);
  // All arms relax at one rate, so the force scales and the posture stays.
  for (Eigen::Index row = 1; row < trace.rows(); ++row) {
    const double held = 5.0 * static_cast<double>(row - 1);
    CHECK(trace(row, column_Fx) == close_to((1 + m * std::exp(-held / tau)) * nominal).epsilon(1e-5));
  }
}

TEST_CASE("a bending link is a cantilever: F L^3 / 3 EI beside the joint's F L^2 / k") {
  Experiment experiment = one_link();
  load(experiment, {0.0}, {0, 0}, {0, 1e-4}, 1);
  const double rigidity = 0.8;
  const Trace trace = predict(Study(experiment), only("link_bending"), {1 / rigidity}).runs[0];
  const double expected = 1e-4 * (std::pow(0.5, 3) / (3 * rigidity) + 0.5 * 0.5 / 2.0);
  CHECK(trace(1, column_y) / expected == close_to(1).epsilon(1e-6));
  CHECK(angle(trace, 1, 0) / (1e-4 * 0.5 / 2.0) == close_to(1).epsilon(1e-6));
}

TEST_CASE("a bending link sags under its own weight: W L^3 / 8 EI beside the joint's W L^2 / 2 k") {
  Experiment experiment = one_link();
  load(experiment, {0.0}, {0, 0}, {0, 0}, 1);
  const double rigidity = 0.8, density = 1e-5, weight = density * 0.5 * standard_gravity;
  const Trace trace =
      predict(Study(experiment), {{{"gravity"}, {"link_bending"}}}, {density, 1 / rigidity}).runs[0];
  const double expected = -weight * (std::pow(0.5, 3) / (8 * rigidity) + 0.5 * 0.5 / (2 * 2.0));
  // the bent shape is a quadratic in the model, whose end is then exact; large turns are left out: 1e-9
  CHECK(trace(1, column_y) / expected == close_to(1).epsilon(1e-6));
  CHECK(angle(trace, 1, 0) / (-weight * 0.5 / (2 * 2.0)) == close_to(1).epsilon(1e-6));
}

TEST_CASE("a chain pushed over snaps to the other branch and stays in equilibrium") {
  Experiment experiment = three_links();
  experiment.link_length = {0.5};
  experiment.joint_stiffness = {1.0};
  experiment.link_mass = {0};
  // Compressed beyond its critical force k/L = 2 it rests on one side; the transverse force turns over.
  load(experiment, {0.02}, {-3, 0.5}, {-3, -1.5}, 20);
  load(experiment, {0.02}, {0, 0}, {-0.5, 0.1}, 4);  // this one does not snap
  const Prediction predicted = predict(Study(experiment), {}, {});
  REQUIRE(predicted.reached);
  CHECK(predicted.snapped);
  const Trace& trace = predicted.runs[0];
  CHECK(angle(trace, 0, 0) > 0.5);
  CHECK(angle(trace, 20, 0) < -0.5);
  for (Eigen::Index row = 0; row < trace.rows(); ++row) {
    const double q = angle(trace, row, 0);
    const double moment = 0.5 * (std::cos(q) * trace(row, column_Fy) - std::sin(q) * trace(row, column_Fx));
    CHECK(q - 0.02 == close_to(moment).epsilon(1e-8));
    CHECK(1 - 0.5 * (-std::sin(q) * trace(row, column_Fy) - std::cos(q) * trace(row, column_Fx)) > 0);
  }
}

TEST_CASE("a coarse step ends on the branch of the fine ones") {
  // Nearly straight, so the first millimetres of a press turn the joints most. Each shape has a mirror image
  // that is as stable and that one long Newton step may fall on.
  for (const std::vector<double>& rest :
       {std::vector<double>{0.02, -0.03, 0.02}, {-0.03, 0.01, 0.04}, {0.01, 0.03, -0.05}}) {
    const auto pressed = [&](int steps) {
      Experiment experiment = three_links();
      press(experiment, rest, {-0.02, 0.002}, steps, false);
      const Prediction predicted = predict(Study(experiment), {}, {});
      REQUIRE(predicted.reached);
      CHECK_FALSE(predicted.snapped);
      return Trace(predicted.runs[0].bottomRows(1));
    };
    // Newton stops within 1e-7 rad.
    CHECK((pressed(1) - pressed(400)).abs().maxCoeff() < 1e-6);
  }
}

TEST_CASE("sticking joints are found where all slip at once") {
  Experiment experiment = three_links();
  experiment.link_length = {0.2313, 0.2632, 0.2143, 0.2747};
  experiment.joint_stiffness = {0.44, 0.339, 0.262, 0.202};
  experiment.link_mass = {0, 0, 0, 0};
  for (const double tau_c : {0.001, 0.003, 0.01, 0.03}) {
    experiment.runs.clear();
    press(experiment, {0.3865, -0.7614, -0.0433, 0.7876}, {0, 0.06}, 24, true);
    const Prediction predicted = predict(Study(experiment), only("joint_friction"), {tau_c});
    REQUIRE(predicted.reached);
    const Trace& trace = predicted.runs[0];
    for (Eigen::Index row = 1; row < trace.rows(); ++row) {
      double x = trace(row, column_x), y = trace(row, column_y), theta = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const double moment = x * trace(row, column_Fy) - y * trace(row, column_Fx);
        const double spring =
            experiment.joint_stiffness[i] * (angle(trace, row, i) - experiment.runs[0].rest[i]);
        CHECK(std::abs(moment - spring) <= tau_c * (1 + 1e-6));
        theta += angle(trace, row, i);
        x -= experiment.link_length[i] * std::cos(theta);
        y -= experiment.link_length[i] * std::sin(theta);
      }
    }
  }
}

TEST_CASE("an end point out of reach is reported, not predicted") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {0.2, 0}, 4, false);
  press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 4, false);
  const Prediction predicted = predict(Study(experiment), {}, {}, true);
  CHECK_FALSE(predicted.reached);
  REQUIRE(predicted.runs.size() == 2);
  CHECK(predicted.runs[0].row(4).isNaN().all());
  CHECK(predicted.runs[1].isNaN().all());
  const Measurements measurements(experiment);
  CHECK(static_cast<std::size_t>(measurements.residual(predicted).size()) == measurements.size());
}

TEST_CASE("effects act together: friction, play, weight, compliance and a load cell in one balance") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0.01}, 20, true);
  const Candidate all{
      {{"joint_friction"}, {"backlash", 2}, {"tip_payload"}, {"axial_compliance"}, {"force_bias"}}};
  const std::vector<double> value{0.02, 0.03, 0.2, 1e-3, 0.1, -0.1};
  const Prediction predicted = predict(Study(experiment), all, value);
  REQUIRE(predicted.reached);
  const Trace& trace = predicted.runs[0];
  for (Eigen::Index row = 1; row < trace.rows(); ++row) {
    const double fx = trace(row, column_Fx) - 0.1, fy = trace(row, column_Fy) + 0.1;
    std::array<double, 4> x{}, y{};
    double theta = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      theta += angle(trace, row, j);
      // The payload pulls on the links as the measured force does.
      const double tension = std::cos(theta) * fx + std::sin(theta) * (fy - 0.2);
      const double length = experiment.link_length[j] * (1 + 1e-3 * tension);
      x[j + 1] = x[j] + length * std::cos(theta);
      y[j + 1] = y[j] + length * std::sin(theta);
    }
    CHECK(x[3] == close_to(trace(row, column_x)).epsilon(1e-8));
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = angle(trace, row, i) - experiment.runs[0].rest[i];
      const double spring = i == 1 ? std::copysign(std::max(0.0, std::abs(d) - 0.03), d) : d;
      const double moment = (x[3] - x[i]) * (fy - 0.2) - (y[3] - y[i]) * fx;
      CHECK(std::abs(moment - experiment.joint_stiffness[i] * spring) <= 0.02 * (1 + 1e-6));
    }
  }
}

TEST_CASE("slipping joints are followed between readings: few readings predict what many do") {
  // Joints that slip one after the other: in one step a reading some would slip too far.
  Experiment many = three_links();
  press(many, {0.9, -1.3, 1.1}, {-0.12, 0.05}, 480, true, 0.05);
  Experiment few = many;
  std::vector<Reading>& kept = few.runs[0].readings;
  kept.clear();
  for (std::size_t i = 0; i < many.runs[0].readings.size(); i += 80) kept.push_back(many.runs[0].readings[i]);
  const std::array<std::pair<Candidate, std::vector<double>>, 4> slipping{
      {{only("friction_spread"), {0.12, 0.03, 0.008}},
       {only("hysteresis"), {0.4, 0.02, 0.3, 0.06, 0.2, 0.2}},
       {only("plastic_set"), {0.1, 0.5}},
       {only("series_friction", 2), {1 / 0.1}}}};
  for (const auto& [candidate, values] : slipping) {
    CAPTURE(candidate.label());
    const Trace fine = predict(Study(many), candidate, values).runs[0],
                coarse = predict(Study(few), candidate, values).runs[0];
    const double largest = fine.col(column_Fx).abs().maxCoeff();
    for (Eigen::Index r = 0; r < coarse.rows(); ++r) {
      CAPTURE(r);
      // Ten times as many parts: what is left of the error is of their first order, a tenth of 1/48 at most.
      CHECK(std::abs(coarse(r, column_Fx) - fine(80 * r, column_Fx)) < largest / 480);
      CHECK(std::abs(coarse(r, column_Fy) - fine(80 * r, column_Fy)) < largest / 480);
    }
  }
}
