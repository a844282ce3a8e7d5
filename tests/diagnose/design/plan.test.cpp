#include "diagnose/design/plan.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/unmeasured.hpp"
#include "diagnose/design/design_space.hpp"
#include "diagnose/report/plan.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Two links in a horizontal plane, whose end point is held and whose force is read.
Experiment two_links() {
  Experiment bench;
  bench.name = "two links";
  bench.link_length = {0.3, 0.2};
  bench.joint_stiffness = {2.0, 1.5};
  bench.link_mass = {0, 0};
  bench.gravity = {0, 0};
  bench.bench = {Bench::Plane::horizontal, {0, 0}, false};
  bench.noise = {2e-4, 2e-4, 0.02, 0.02, 0};
  bench.runs = {{"press", Control::end_point, {0.4, -0.9}, {}}};
  return bench;
}

bool has(const std::vector<EffectAt>& effects, const EffectAt& one) {
  return std::find(effects.begin(), effects.end(), one) != effects.end();
}

/// The class in which an effect stands; nothing where it is told apart from all others.
const Indistinguishable* class_of(const Unidentifiable& left, const EffectAt& one) {
  for (const Indistinguishable& alike : left.indistinguishable)
    if (has(alike.effects, one)) return &alike;
  return nullptr;
}

}  // namespace

TEST_CASE("gravity is detectable only in a vertical plane") {
  Experiment bench = two_links();
  const std::vector<EffectAt> flat = design_space(bench).impossible;
  CHECK(has(flat, "gravity"));
  CHECK(has(flat, "tip_payload"));
  bench.bench = {Bench::Plane::vertical, {0, -1}, true};
  const std::vector<EffectAt> upright = design_space(bench).impossible;
  CHECK_FALSE(has(upright, "gravity"));
  CHECK_FALSE(has(upright, "tip_payload"));
}

TEST_CASE(
    "a load cell's gain and the scale of all springs are equivalent until known weights set the scale of "
    "force" *
    doctest::test_suite("long")) {
  Experiment bench = two_links();
  const Plan held = plan(bench);
  const Indistinguishable* gain = class_of(held.unidentifiable, "force_gain");
  REQUIRE(gain != nullptr);
  CHECK(gain->exactly);
  CHECK(has(gain->effects, "stiffness_scale"));
  CHECK_FALSE(held.planned);
  CHECK_FALSE(held.fewest.empty());

  bench.bench = {Bench::Plane::vertical, {0, -1}, true};
  bench.link_mass = {0.3, 0.2};
  bench.gravity = {0, -9.81};
  const Plan weighed = plan(bench);
  const Indistinguishable* now = class_of(weighed.unidentifiable, "force_gain");
  CHECK((now == nullptr || (!has(now->effects, "stiffness_scale") && !has(now->others, "stiffness_scale"))));
}

TEST_CASE("planned runs leave at least as much undetermined as the best runs" * doctest::test_suite("long")) {
  Experiment bench = two_links();
  press(bench, {0.4, -0.9}, {-0.03, 0}, 10, false);
  bench.runs.erase(bench.runs.begin());
  const Plan made = plan(unmeasured(bench));
  REQUIRE(made.planned);
  for (const EffectAt& at : made.unidentifiable.undetectable) CHECK(has(made.planned->undetectable, at));
  // Without a way back nothing tells friction from a stiffer spring.
  CHECK(class_of(made.unidentifiable, "joint_friction") == nullptr);
  CHECK((has(made.planned->undetectable, "joint_friction") ||
         class_of(*made.planned, "joint_friction") != nullptr));
}

TEST_CASE("noise as large as the forces hides every effect, and no run is proposed") {
  Experiment bench = two_links();
  bench.noise[Channel::Name::Fx] = bench.noise[Channel::Name::Fy] = 1e3;
  const Plan made = plan(bench);
  CHECK(made.unidentifiable.undetectable.size() == design_space(bench).effects.size());
  CHECK(made.unidentifiable.indistinguishable.empty());
  CHECK(made.fewest.empty());
}

TEST_CASE("indistinguishable effects are in one class, each once") {
  Experiment bench = two_links();
  bench.noise[Channel::Name::Fx] = bench.noise[Channel::Name::Fy] =
      8;  // so much that a few effects alone are seen
  const Unidentifiable never = plan(bench).unidentifiable;
  std::vector<EffectAt> classed;
  for (const Indistinguishable& one : never.indistinguishable) {
    CHECK(one.effects.size() + one.others.size() > 1);
    for (const EffectAt& at : one.effects) {
      CAPTURE(at.label());
      CHECK_FALSE(has(classed, at));
      CHECK_FALSE(has(one.others, at));
      CHECK_FALSE(has(never.undetectable, at));
      classed.push_back(at);
    }
  }
  CHECK(std::any_of(never.indistinguishable.begin(), never.indistinguishable.end(),
                    [](const Indistinguishable& one) { return one.effects.size() > 1; }));
}

TEST_CASE("the nominal chain and every effect can follow every run of a design space") {
  Experiment bench = three_links();
  press(bench, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  const DesignSpace space = design_space(unmeasured(bench));
  CHECK(space.planned == 1);
  CHECK(space.bench.runs.size() == space.descriptions.size());
  CHECK(space.bench.runs.size() > 5);
  const Study study(space.bench);
  for (const Instance& effect : space.effects) {
    CAPTURE(effect.candidate.label());
    CHECK(predict(study, effect.candidate, effect.parameters).reached);
  }
}

TEST_CASE("a plan that the chain cannot follow is refused") {
  Experiment bench = two_links();
  press(bench, {0.4, -0.9}, {0.2, 0}, 10, false);  // beyond the reach of both links
  CHECK_THROWS_AS(plan(unmeasured(bench)), Error);
}
