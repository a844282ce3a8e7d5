#include "trial/simulator/draw_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::simulator {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double place_unit = 1e-6, force_unit = 1e-5, angle_unit = 1e-4;  // of what is commanded

Nominal draw_chain(Random& random) {
  Nominal chain;
  const std::size_t n = random.one_of<std::size_t>({2, 3, 3, 4, 4, 4, 5, 5, 6, 6});
  const double length = random.log_uniform(0.05, 0.3), stiffness = random.log_uniform(0.3, 15);
  const bool equal_links = random.chance(0.35), equal_joints = random.chance(0.4);
  const double taper = random.chance(0.4) ? random.uniform(0.75, 1) : 1;  // distal joints are often softer
  const bool passive_base = n >= 3 && random.chance(0.15);
  for (std::size_t i = 0; i < n; ++i) {
    chain.length.push_back(rounded(length * (equal_links ? 1 : random.uniform(0.7, 1.3)), 1e-4));
    const double k =
        stiffness * (equal_joints ? 1 : random.uniform(0.7, 1.4)) * std::pow(taper, static_cast<double>(i));
    chain.stiffness.push_back(i == 0 && passive_base ? 0 : significant(k, 3));
  }
  return chain;
}

/// One sprung joint: an arm, or a strut whose second link carries axial force only.
Nominal draw_joint(Random& random) {
  const double length = random.log_uniform(0.05, 0.3), stiffness = random.log_uniform(0.3, 15);
  Nominal joint{{rounded(length, 1e-4)}, {significant(stiffness, 3)}, {}};
  if (random.chance(0.3)) return joint;
  joint.length.push_back(rounded(length * random.uniform(0.7, 1.3), 1e-4));
  joint.stiffness.push_back(0);
  return joint;
}
bool is_arm(const Nominal& chain) {
  return chain.length.size() == 1;
}
bool is_strut(const Nominal& chain) {
  return chain.stiffness.back() == 0;
}

void draw_gravity(Plan& plan, Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.45) return;
  if (kind < 0.5) {
    plan.plane = Plane::unknown;
    return;
  }
  plan.plane = Plane::vertical;
  plan.down = random.chance(0.85) ? Pair{0, random.sign()} : Pair{random.sign(), 0};
  if (random.chance(0.7)) return;
  plan.nominal.gravity = {9.81 * plan.down[0], 9.81 * plan.down[1]};
  const double sag = random.uniform(0.01, 0.1);  // moment of the weight over the stiffness of a joint
  for (const double length : plan.nominal.length)
    plan.nominal.mass.push_back(
        significant(sag * plan.typical_stiffness() * length / (9.81 * plan.reach() * plan.reach()), 3));
}

struct Shape {
  std::string name;
  std::vector<double> rest;
};

Shape draw_shape(const Nominal& chain, Random& random) {
  const bool strut = is_strut(chain);
  const std::string name =
      strut ? "strut" : random.one_of<std::string>({"u", "u", "u", "s", "z", "w", "flat"});
  const double bend = strut            ? random.uniform(0.4, 1.2)
                      : name == "flat" ? random.uniform(0.03, 0.12)
                                       : random.uniform(0.18, 0.6);
  const std::size_t n = chain.length.size();
  const double side = random.sign();
  std::vector<double> theta;
  double x = 0, y = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double s = (static_cast<double>(j) + 0.5) / static_cast<double>(n);
    double profile = 1 - 2 * s;  // u, flat
    if (strut) profile = j == 0 ? 1 : -1;
    if (name == "s") profile = std::cos(2 * pi * s);
    if (name == "z") profile = j % 2 == 0 ? 1 : -1;
    if (name == "w") profile = std::cos(3 * pi * s);
    theta.push_back(side * bend * profile + random.uniform(-0.03, 0.03));
    x += chain.length[j] * std::cos(theta[j]);
    y += chain.length[j] * std::sin(theta[j]);
  }
  const double turn = std::atan2(y, x) + random.uniform(-0.05, 0.05);
  Shape shape{name, {}};
  for (std::size_t j = 0; j < n; ++j)
    shape.rest.push_back(rounded(theta[j] - (j > 0 ? theta[j - 1] : turn), angle_unit));
  return shape;
}

/// Position of each reading along the path: 0 unloaded, 1 at the largest load.
std::vector<double> draw_profile(Random& random, std::string& name) {
  const auto leg = [](std::vector<double>& way, double to, std::size_t readings) {
    const double from = way.back();
    for (std::size_t i = 1; i <= readings; ++i)
      way.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(readings));
  };
  const std::size_t m = 24 + random.below(46);
  std::vector<double> way{0};
  name = random.one_of<std::string>({"loading", "unloading", "unloading", "cycle", "cycle", "hold"});
  if (name == "loading") {
    leg(way, 1, m);
  } else if (name == "unloading") {
    leg(way, 1, m / 2), leg(way, random.chance(0.7) ? 0 : 0.3, m - m / 2);
  } else if (name == "cycle") {
    leg(way, 1, m / 3), leg(way, random.uniform(0.2, 0.5), m / 4), leg(way, 1, m / 4), leg(way, 0.1, m / 5);
  } else {
    leg(way, 0.8, m / 3), leg(way, 0.8, m / 3), leg(way, 0, m / 3);
  }
  return way;
}

/// The largest displacement from the unloaded end point.
Pair draw_way(const Shape& shape, double reach, const Pair& start, Random& random, std::string& name) {
  const bool slack = std::hypot(start[0], start[1]) < 0.95 * reach;
  name = slack ? random.one_of<std::string>({"x", "x", "x", "xy", "y"})
               : random.one_of<std::string>({"x", "x", "xy"});
  const double along = shape.name == "flat" ? random.uniform(0.01, 0.08) : random.uniform(0.03, 0.16);
  const double across = random.sign() * random.uniform(0.02, 0.12);
  if (name == "x") return {-along * reach, 0};
  if (name == "y") return {0, across * reach};
  return {-along * reach, (slack ? across : 0.5 * std::copysign(along, across)) * reach};
}

bool reachable(const PlannedRun& run, double reach) {
  const Pair& start = run.commands.front().value;
  const double limit = std::max(0.985 * reach, std::hypot(start[0], start[1]) + 1e-9);
  return std::all_of(run.commands.begin(), run.commands.end(), [&](const Command& command) {
    return std::hypot(command.value[0], command.value[1]) < limit;
  });
}

/// The end point of the bench at these joint angles.
Pair unloaded_end(const std::vector<double>& length, const std::vector<double>& rest) {
  Pair end{0, 0};
  double heading = 0;
  for (std::size_t i = 0; i < length.size(); ++i) {
    heading += rest[i];
    end[0] += length[i] * std::cos(heading);
    end[1] += length[i] * std::sin(heading);
  }
  return end;
}

PlannedRun draw_run(const Plan& plan, std::size_t number, Random& random) {
  const Nominal& chain = plan.nominal;
  const Shape shape = draw_shape(chain, random);
  const Pair end = unloaded_end(chain.length, shape.rest);
  const bool mechanism = chain.stiffness.front() == 0;  // under a force, with a passive base
  PlannedRun run;
  run.rest = shape.rest;
  run.force_controlled = is_arm(chain) || (!mechanism && !is_strut(chain) && random.chance(0.15));
  const Pair start =
      run.force_controlled ? Pair{0, 0} : Pair{rounded(end[0], place_unit), rounded(end[1], place_unit)};
  std::string motion = "push", profile;
  Pair way;
  if (is_arm(chain)) {
    const double size = random.uniform(0.05, 0.5) * plan.typical_stiffness() / plan.reach();
    const double across = random.sign() * 0.5 * pi + random.uniform(-0.3, 0.3);
    way = {size * std::cos(across), size * std::sin(across)};
  } else if (run.force_controlled) {
    // a share of the buckling load of the straight chain with a free end, roughly that of a clamped column
    const double size = random.uniform(0.15, 0.5) * 2.5 * plan.typical_stiffness() /
                        (static_cast<double>(plan.size()) * plan.reach());
    const double angle = random.uniform(0.55 * pi, 1.45 * pi);
    way = {size * std::cos(angle), size * std::sin(angle)};
  } else {
    way = draw_way(shape, plan.reach(), start, random, motion);
  }
  const double pause = rounded(random.log_uniform(0.5, 4), 1e-3);
  const double unit = run.force_controlled ? force_unit : place_unit;
  double t = 0;
  for (const double share : draw_profile(random, profile)) {
    run.commands.push_back(
        {t, {rounded(start[0] + share * way[0], unit), rounded(start[1] + share * way[1], unit)}});
    t += pause;
  }
  run.id = fmt::format("{}-{}-{}-{}", shape.name, profile, motion, number);
  return run;
}

Plan plan_for(const Nominal& chain, Random& random) {
  Plan plan;
  plan.nominal = chain;
  draw_gravity(plan, random);
  plan.angles_measured = random.chance(0.4);
  plan.cross_force_measured = random.chance(0.95);
  const std::size_t runs = 2 + random.below(3);
  while (plan.runs.size() < runs) {
    PlannedRun run = draw_run(plan, plan.runs.size() + 1, random);
    if (run.force_controlled || reachable(run, plan.reach())) plan.runs.push_back(std::move(run));
  }
  return plan;
}

}  // namespace

Plan draw_plan(Random& random) {
  return plan_for(draw_chain(random), random);
}

Plan draw_joint_plan(Random& random) {
  return plan_for(draw_joint(random), random);
}

}  // namespace plumbline::simulator
