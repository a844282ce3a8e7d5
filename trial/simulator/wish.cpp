#include "trial/simulator/wish.hpp"

#include <algorithm>
#include <array>

namespace plumbline::simulator {
namespace {

constexpr double weakest = 2.2, strongest = 50;

using Kinds = std::span<const Kind>;

bool is_group(const Kind& kind) {
  return kind.family == "common to all joints" || kind.family == "a value of its own at each joint";
}

Wish one_of(Kinds kinds, Random& random) {
  return {{&random.one_of(kinds)}, {random.log_uniform(weakest, strongest)}};
}
/// A cause outside the catalogue is requested only where it is visible.
Wish one_outside(Kinds kinds, Random& random) {
  return {{&random.one_of(kinds)}, {random.log_uniform(6, strongest)}};
}
Wish one_with_groups(bool group, Random& random) {
  const Kind* kind = &random.one_of(Kinds(catalogue()));
  while (is_group(*kind) != group) kind = &random.one_of(Kinds(catalogue()));
  return {{kind}, {random.log_uniform(weakest, strongest)}};
}

/// Dry friction with one slip torque for all joints.
bool rubs(const Kind& one) {
  constexpr std::array<std::string_view, 4> frictions{"joint_friction", "load_friction", "direction_friction",
                                                      "speed_friction"};
  return std::find(frictions.begin(), frictions.end(), one.id) != frictions.end();
}

/// With play and dry friction in one joint its equilibrium is not unique; others add up to one effect.
bool undetermined(const Kind& one, const Kind& other) {
  const auto are = [&](std::string_view a, std::string_view b) {
    return (one.id == a && other.id == b) || (one.id == b && other.id == a);
  };
  return one.id == other.id || (rubs(one) && (rubs(other) || other.id == "backlash")) ||
         (rubs(other) && one.id == "backlash") || are("joint_stop", "joint_stops") ||
         are("tip_payload", "force_bias") || are("run_tare", "force_bias") ||
         are("base_compliance", "train_compliance") || are("stiffness_scale", "force_gain");
}

/// Values at each joint contain nearly every other kind, so they come alone.
const Kind& simple(Kinds kinds, Random& random) {
  const Kind* kind = &random.one_of(kinds);
  while (!kind->each.empty()) kind = &random.one_of(kinds);
  return *kind;
}

Wish two_of(Kinds kinds, Random& random) {
  const Kind &one = simple(kinds, random), *other = &simple(kinds, random);
  while (undetermined(one, *other)) other = &simple(kinds, random);
  return {{&one, other}, {random.log_uniform(5, 40), random.log_uniform(5, 40)}};
}

}  // namespace

Wish draw_wish(Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.15) return {};
  if (kind < 0.75) return one_of(first_catalogue(), random);
  return kind < 0.87 ? one_outside(first_outside(), random) : two_of(first_catalogue(), random);
}

Wish draw_second_wish(Random& random) {
  const double third = random.uniform(0, 3), kind = random.uniform(0, 1);
  Wish wish;
  if (third < 1) {
    wish = one_outside(outside(), random);
  } else if (third < 2) {
    if (kind < 0.85) wish = one_with_groups(kind < 0.4, random);
    wish.tolerances = kind >= 0.4;
  } else if (kind < 0.8) {
    if (kind > 0.3) wish = one_of(catalogue(), random);
  } else {
    wish = two_of(catalogue(), random);
  }
  wish.rough = true;
  return wish;
}

std::vector<Effect> draw_tolerances(const Scene& scene, Random& random) {
  constexpr double stiffness = 0.05, length = 0.005, angle = 0.0087;
  Values k, l, q;
  for (const double nominal : scene.plan.nominal.stiffness) {
    const bool elastic = nominal > 0;
    k.push_back(elastic ? significant(random.uniform(-stiffness, stiffness), 4) : 0);
    l.push_back(significant(random.uniform(-length, length), 4));
    q.push_back(elastic ? significant(random.uniform(-angle, angle), 4) : 0);
  }
  return {{&kind("stiffness_spread", false), 0, k},
          {&kind("length_spread", false), 0, l},
          {&kind("rest_spread", false), 0, q}};
}

}  // namespace plumbline::simulator
