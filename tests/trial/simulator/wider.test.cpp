#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/trial/simulator/a_bench.hpp"
#include "trial/simulator/bench.hpp"
#include "trial/simulator/make_experiment.hpp"
#include "trial/simulator/nominal_error.hpp"

using namespace plumbline::simulator;

namespace {

Bench working(const Plan& plan = a_bench()) {
  const Physics physics = physics_of(plan);
  Bench bench{plan, simulate(plan, physics), {}, {}};
  for (std::size_t r = 0; r < plan.runs.size(); ++r)
    bench.shown.push_back(show(plan, physics, plan.runs[r], bench.states[r]));
  bench.scatter.sigma = {scene_of(bench).force / 900, 1e-4 * plan.reach(), 7e-4};
  return bench;
}

/// Whose nominal links weigh a tenth of a kilogram a metre.
Plan heavy_bench() {
  Plan plan = a_bench();
  plan.nominal.gravity = {9.81 * plan.down[0], 9.81 * plan.down[1]};
  for (const double length : plan.nominal.length) plan.nominal.mass.push_back(0.1 * length);
  return plan;
}

/// The nominal chain with what these effects change of it.
double against_nominal_statics(const Bench& bench, std::string_view id, const Values& values,
                               void (*change)(Plan&, const Values&)) {
  const Effect effect{&kind(id, false), 0, values};
  const auto states = simulate(bench.plan, physics_with(bench.plan, {effect}));
  Plan changed = bench.plan;
  change(changed, values);
  return nominal_error(changed, states, bench.scatter.sigma);
}

/// On benches drawn one after the other, until so many arms of one joint and chains of several elastic joints
/// were seen.
void check_equivalent_with_one_joint(std::string_view common, std::string_view single, std::size_t least) {
  CAPTURE(common);
  std::size_t alone = 0, several = 0;
  for (std::uint64_t stream = 0; alone < least || several < least; ++stream) {
    REQUIRE(stream < 100);
    Random random(7, stream);
    const Experiment made = make_experiment({{&kind(common, false)}, {20}, false, true}, "one", random);
    const auto& k = made.plan.nominal.stiffness;
    const bool arm = made.plan.size() == 1;
    const bool chain = std::count_if(k.begin(), k.end(), [](double one) { return one > 0; }) > 1;
    const auto& aliases = made.label.equivalent;
    const bool listed = std::find(aliases.begin(), aliases.end(),
                                  std::vector<std::string>{std::string(single)}) != aliases.end();
    if (arm) CHECK(listed);
    if (chain) CHECK_FALSE(listed);
    alone += arm;
    several += chain;
  }
}

}  // namespace

TEST_CASE("a changed nominal parameter gives the nominal statics of the changed chain") {
  const Bench bench = working();
  // a hundredth of the finest instruments' noise, as for the chain without an effect
  CHECK(against_nominal_statics(bench, "stiffness_scale", {0.1}, [](Plan& plan, const Values& v) {
          for (double& k : plan.nominal.stiffness) k *= 1 + v[0];
        }) < 0.01);
  CHECK(against_nominal_statics(bench, "length_scale", {0.01}, [](Plan& plan, const Values& v) {
          for (double& length : plan.nominal.length) length *= 1 + v[0];
        }) < 0.01);
  CHECK(
      against_nominal_statics(working(heavy_bench()), "mass_scale", {-0.2}, [](Plan& plan, const Values& v) {
        for (double& mass : plan.nominal.mass) mass *= 1 + v[0];
      }) < 0.01);
  CHECK(against_nominal_statics(bench, "rest_offset", {0.02}, [](Plan& plan, const Values& v) {
          for (PlannedRun& run : plan.runs)
            for (double& q : run.rest) q += v[0];
        }) < 0.01);
  CHECK(against_nominal_statics(bench, "stiffness_spread", {0.1, -0.05, 0.02, 0.08},
                                [](Plan& plan, const Values& v) {
                                  for (std::size_t j = 0; j < v.size(); ++j)
                                    plan.nominal.stiffness[j] *= 1 + v[j];
                                }) < 0.01);
  CHECK(against_nominal_statics(bench, "length_spread", {0.01, -0.005, 0.002, 0.008},
                                [](Plan& plan, const Values& v) {
                                  for (std::size_t j = 0; j < v.size(); ++j)
                                    plan.nominal.length[j] *= 1 + v[j];
                                }) < 0.01);
  CHECK(against_nominal_statics(bench, "rest_spread", {0.01, -0.02, 0.005, 0.01},
                                [](Plan& plan, const Values& v) {
                                  for (PlannedRun& run : plan.runs)
                                    for (std::size_t j = 0; j < v.size(); ++j) run.rest[j] += v[j];
                                }) < 0.01);
  CHECK(against_nominal_statics(bench, "run_rest", {0, 0, 0, 0, 0.01, -0.02, 0.005, 0.01},
                                [](Plan& plan, const Values& v) {
                                  for (std::size_t j = 0; j < 4; ++j) plan.runs[1].rest[j] += v[4 + j];
                                }) < 0.01);
  CHECK(against_nominal_statics(bench, "tendon_friction", {0.05}, [](Plan& plan, const Values& v) {
          for (PlannedRun& run : plan.runs)
            for (std::size_t j = 0; j < run.rest.size(); ++j)
              run.rest[j] *= std::exp(-v[0] * static_cast<double>(j));
        }) < 0.01);
}

TEST_CASE("every kind is visible at realistic sizes, and absent at size zero" * doctest::test_suite("long")) {
  const Bench light = working(), heavy = working(heavy_bench());
  std::vector<const Kind*> all;
  for (const Kind& one : catalogue()) all.push_back(&one);
  for (const Kind& one : outside()) all.push_back(&one);
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i]->id);
    CAPTURE(all[i]->description);
    Random random(9, i);
    const Bench& bench = all[i]->id == "mass_scale" ? heavy : light;
    const Effect effect = draw_effect(*all[i], scene_of(bench), random);
    REQUIRE(effect.kind != nullptr);
    CHECK(rms(outcome_of(bench, {effect}).gap) > 0.3);
    // what is left is the way in which the carriage is moved, and contacts that hardly rub
    CHECK(rms(outcome_of(bench, {effect.scaled(1e-6)}).gap) < 0.02);
  }
}

TEST_CASE("values are drawn for each of several joints; for one joint it is that joint's error") {
  Plan plan = a_bench();
  plan.nominal.length = {0.2};
  plan.nominal.stiffness = {2};
  const std::vector<std::vector<State>> states;
  const Scene scene{plan, states, {0.5}, 10, 60, 2};
  for (const Kind& one : catalogue())
    if (one.family == one_at_each_joint) {
      CAPTURE(one.id);
      CHECK_FALSE(one.possible(scene, 0));
    }
}

TEST_CASE("parameters of a group are numbered by joint, those of elements by element") {
  const Plan plan = a_bench();
  const Kind& spread = kind("stiffness_spread", false);
  CHECK(spread.name(plan, 0) == "a_1");
  CHECK(spread.name(plan, 3) == "a_4");
  const Kind& hysteresis = kind("hysteresis", true);
  CHECK(hysteresis.name(plan, 0) == "r_1");
  CHECK(hysteresis.name(plan, 3) == "d_2");
  const Kind& day = kind("run_rest", false);
  CHECK(day.name(plan, 0) == "a_1_1");
  CHECK(day.name(plan, 5) == "a_2_2");
  const Kind& tare = kind("run_tare", false);
  CHECK(tare.name(plan, 3) == "b_y_2");
  const Kind& spectrum = kind("relaxation_spectrum", false);
  CHECK(spectrum.name(plan, 3) == "tau_2");
  CHECK(spectrum.scales(2));
  CHECK_FALSE(spectrum.scales(3));
  CHECK_THROWS_WITH(kind("stiffness_spread", true), doctest::Contains("no such effect at a joint"));
}

TEST_CASE(
    "the second trial: a third outside the catalogue, a third with groups or tolerances, all with realistic "
    "noise") {
  Random random(2, 2);
  std::size_t from_outside = 0, groups = 0, none = 0;
  std::set<std::string_view> seen;
  constexpr std::size_t count = 3000;
  for (std::size_t i = 0; i < count; ++i) {
    const Wish wish = draw_second_wish(random);
    CHECK(wish.rough);
    CHECK(wish.kinds.size() == wish.strengths.size());
    const bool one = wish.kinds.size() == 1;
    if (one && wish.kinds[0]->id == "unknown") ++from_outside, seen.insert(wish.kinds[0]->description);
    if (wish.tolerances || (one && wish.kinds[0]->family == "common to all joints") ||
        (one && wish.kinds[0]->family == "a value of its own at each joint"))
      ++groups;
    none += wish.kinds.empty() && !wish.tolerances;
  }
  const auto near = [&](std::size_t found, double share) {  // four standard deviations of a binomial
    return std::abs(static_cast<double>(found) - share * count) < 4 * std::sqrt(share * (1 - share) * count);
  };
  CHECK(near(from_outside, 1.0 / 3));
  CHECK(groups > count * 0.3);
  CHECK(near(none, 0.3 / 3));
  CHECK(seen.size() == outside().size());
}

TEST_CASE("piecewise springs are equivalent to a single one where only that one reaches its threshold") {
  const Bench bench = working();
  std::vector<double> reach = scene_of(bench).deflection;
  const auto most = std::max_element(reach.begin(), reach.end());
  const std::string alone = "piecewise_spring(" + std::to_string(most - reach.begin() + 1) + ")";
  const auto passes_for = [&](bool at_joint, double s) {
    const Place joint = at_joint ? static_cast<Place>(most - reach.begin()) : 0;
    return aliases(bench, outcome_of(bench, {{&kind("piecewise_spring", at_joint), joint, {s, 0.3}}}));
  };
  const double least = *std::min_element(reach.begin(), reach.end());
  CHECK(passes_for(false, 0.97 * *most) == std::vector<std::vector<std::string>>{{alone}});
  CHECK(passes_for(false, 0.5 * least).empty());
  CHECK(passes_for(true, 0.5 * least).empty());
}

TEST_CASE("with one elastic joint an effect of all joints is equivalent to that of the joint") {
  check_equivalent_with_one_joint("stiffness_scale", "joint_stiffness(1)", 1);
}

TEST_CASE("with one elastic joint every effect of all joints is equivalent to that of the joint" *
          doctest::test_suite("long")) {
  check_equivalent_with_one_joint("stiffness_scale", "joint_stiffness(1)", 2);
  check_equivalent_with_one_joint("length_scale", "link_length(1)", 2);
  check_equivalent_with_one_joint("rest_offset", "rest_angle(1)", 2);
}
