#include "trial/simulator/instruments.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/trial/simulator/a_bench.hpp"
#include "trial/simulator/draw_scatter.hpp"

using namespace plumbline::simulator;

namespace {

/// The cell's readings of a force that grows steadily from (1, 2) by (0.5, -0.25) a reading of 2 s.
Readings shown(const Physics& physics, const Plan& plan) {
  std::vector<State> states;
  for (const Command& command : plan.runs[0].commands) {
    const double i = command.t / 2;
    states.push_back({command.t, command.value, {1 + 0.5 * i, 2 - 0.25 * i}, {0, 0, 0, 0}});
  }
  return show(plan, physics, plan.runs[0], states);
}

/// Standard deviation and correlation of neighbours of what is added to readings of nothing.
struct Noise {
  double deviation = 0, neighbours = 0;
};
Noise noise_of(const Scatter& scatter, double value) {
  const Plan plan = a_bench();
  constexpr int count = 20000;
  Readings readings;
  for (int i = 0; i < count; ++i) readings.push_back({0.7 * i, {0, 0}, {value, value}, {}});
  Random random(4, 4);
  readings = scattered(plan.runs[0], std::move(readings), scatter, random);
  double square = 0, product = 0, last = 0;
  for (const Reading& one : readings) {
    const double d = one.force[0] - value;
    square += d * d, product += d * last, last = d;
  }
  return {std::sqrt(square / count), product / square};
}

Scatter scatter_of(double sigma) {
  Scatter scatter;
  scatter.sigma = scatter.declared = {sigma, sigma, sigma};
  return scatter;
}

}  // namespace

TEST_CASE("cross-talk, curvature, the tare of another day, warming up, saturation") {
  const Plan plan = a_bench();
  Physics is = physics_of(plan);
  is.cross_talk = {0.1, -0.2};
  is.other_day[plan.runs[0].id].tare = {0.3, 0};
  const Readings mixed = shown(is, plan);
  CHECK(mixed[2].force[0] == close_to(2 + 0.1 * 1.5 + 0.3));
  CHECK(mixed[2].force[1] == close_to(1.5 - 0.2 * 2));
  is = physics_of(plan);
  is.other_day[plan.runs[1].id].tare = {0.3, 0};
  CHECK(shown(is, plan)[2].force[0] == close_to(2));
  is.curvature = {0.05, 0}, is.warming = {1, 0}, is.warming_time = 4;
  CHECK(shown(is, plan)[2].force[0] == close_to(2 * 1.1 + 1 - std::exp(-1)));
  is = physics_of(plan);
  is.saturation = 1.75;
  CHECK(shown(is, plan)[1].force[0] == 1.5);
  CHECK(shown(is, plan)[2].force[0] == 1.75);
  CHECK(shown(is, plan)[20].force[1] == -1.75);
}

TEST_CASE("a cell with hysteresis reads more while unloading, nothing at either end of its loop") {
  const Plan plan = a_bench();
  Physics is = physics_of(plan);
  const Readings plain = shown(is, plan);
  is.cell_loop = 0.05;
  const Readings loop = shown(is, plan);
  CHECK(loop.front().force[1] == 2);
  CHECK(loop[4].force[1] == close_to(1 + 0.05 * 2));  // half of the largest: 0.05 of it more
  CHECK(loop[8].force[1] == 0);
  CHECK(loop[20].force[1] == plain[20].force[1]);  // -3 is larger than all before
  CHECK(loop[10].force[0] == plain[10].force[0]);
}

TEST_CASE("a cell with a lag trails a steady rise by its time constant") {
  const Plan plan = a_bench();
  Physics is = physics_of(plan);
  is.lag = 1.5;
  const Readings late = shown(is, plan);
  CHECK(late[0].force[0] == 1);
  // y' = (F - y) / tau with F = 1 + t / 4: y = F - tau / 4 (1 - exp(-t / tau))
  for (const std::size_t i : {1U, 2U, 20U}) {
    const double t = 2 * static_cast<double>(i);
    CHECK(late[i].force[0] == close_to(1 + t / 4 - 1.5 / 4 * (1 - std::exp(-t / 1.5))));
  }
}

TEST_CASE("noise is as large and as correlated as stated") {
  // 20000 readings: a deviation is known to 0.5 %, a correlation of 0.9 to 0.3 %; tolerances are four of
  // these
  CHECK(noise_of(scatter_of(0.02), 5).deviation == close_to(0.02).epsilon(0.02));
  Scatter scatter = scatter_of(0.02);
  scatter.correlation.force = 0.9;
  CHECK(noise_of(scatter, 5).neighbours == close_to(0.9).epsilon(0.013));
  scatter = scatter_of(0.02);
  scatter.proportional.force = 0.01;
  CHECK(noise_of(scatter, 5).deviation == close_to(std::hypot(0.02, 0.05)).epsilon(0.02));
  scatter = scatter_of(0.02);
  scatter.interference = 3, scatter.interference_period = 7.3;
  CHECK(noise_of(scatter, 5).deviation == close_to(0.02 * std::sqrt(1 + 4.5)).epsilon(0.02));
  scatter = scatter_of(0.02);
  scatter.bad_channel = "Fx", scatter.bad_factor = 3;
  CHECK(noise_of(scatter, 5).deviation == close_to(0.06).epsilon(0.02));
  scatter.bad_channel = "Fy";
  CHECK(noise_of(scatter, 5).deviation == close_to(0.02).epsilon(0.02));
}

TEST_CASE("proportional noise is two to eight sigmas at the largest reading of every sensor") {
  const Plan plan = a_bench();
  Random random(8, 1);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const Scatter scatter = draw_rough_scatter(plan, 10, random);
    if (scatter.kind != "proportional") continue;
    ++seen;
    const double of_force = scatter.proportional.force * 10 / scatter.sigma.force,
                 of_position = scatter.proportional.position * plan.reach() / scatter.sigma.position,
                 of_angle = scatter.proportional.angle / scatter.sigma.angle;
    for (const double sigmas : {of_force, of_position, of_angle}) {
      CHECK(sigmas > 1.99);
      CHECK(sigmas < 8.01);
    }
  }
  CHECK(seen > 0);
}

TEST_CASE("rough noise goes to three times the declared, 8 % of outliers and a correlation of 0.9") {
  const Plan plan = a_bench();
  Random random(6, 1);
  double loudest = 0, wildest = 0, smoothest = 0;
  for (int i = 0; i < 1000; ++i) {
    const Scatter scatter = draw_rough_scatter(plan, 10, random);
    loudest = std::max(loudest, scatter.sigma.force / scatter.declared.force);
    wildest = std::max(wildest, scatter.outliers);
    smoothest = std::max(smoothest, scatter.correlation.force);
  }
  // 100 to 150 draws of each: the largest is within the last tenth of the range but for a chance of 3e-5
  CHECK((loudest > 2.5 && loudest <= 3));
  CHECK((wildest > 0.074 && wildest <= 0.08));
  CHECK((smoothest > 0.88 && smoothest <= 0.9));
}

TEST_CASE("half of the correlated noise is of one kind of sensor, one that the bench has") {
  Plan plan = a_bench();
  plan.angles_measured = true;
  Random random(9, 1);
  int of_all = 0, of_one = 0;
  std::size_t force = 0, angle = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scatter scatter = draw_rough_scatter(plan, 10, random);
    const Sigma& r = scatter.correlation;
    of_all += scatter.kind == "ar1";
    if (scatter.kind == "ar1") CHECK((r.force >= 0.7 && r.force == r.angle && r.force == r.position));
    if (scatter.kind != "ar1 of one sensor") continue;
    ++of_one;
    force += r.force > 0, angle += r.angle > 0;
    CHECK((r.force > 0) + (r.angle > 0) == 1);
    CHECK(r.position == 0);  // every run of this bench imposes the end point
    CHECK(r.force + r.angle >= 0.7);
  }
  // 12 of 100 in all: 240 of 2000, give or take 15; half of these, give or take 8: three times that
  CHECK(std::abs(of_all + of_one - 240) < 45);
  CHECK(std::abs(of_all - of_one) < 48);
  CHECK((force > 0 && angle > 0));
}
