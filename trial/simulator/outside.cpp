// Effects outside the catalogue, for which `unknown` is right. diagnose/ does not include this file. An
// effect that the catalogue absorbs leaves the list, and another takes its place.

#include <algorithm>
#include <cmath>

#include "trial/simulator/effect.hpp"

namespace plumbline::simulator {
namespace {

bool works(const Scene& s, Place j) {
  return s.plan.nominal.stiffness[j] > 0 && s.deflection[j] > 0.25;
}
bool rubs(const Scene& s, Place j) {
  return turns_back(s, j) && several_elastic(s, j);
}
bool imposed_and_long(const Scene& s, Place j) {
  return never_force_controlled(s, j) && s.duration > 15 * s.sampling_interval;
}
/// Parameters of a friction law other than its torque apply to every elastic joint.
void add_friction(Physics& is, const Friction& friction) {
  for (Joint& joint : is.joint)
    if (joint.stiffness > 0) joint.friction = friction;
}
/// The longest way of the end point along x.
double travel(const Scene& s) {
  double longest = 0;
  for (const PlannedRun& run : s.plan.runs)
    for (const Command& command : run.commands)
      if (!run.force_controlled)
        longest = std::max(longest, std::abs(command.value[0] - run.commands.front().value[0]));
  return longest;
}

/// The same in any direction.
double longest_way(const Scene& s) {
  double longest = 0;
  for (const PlannedRun& run : s.plan.runs)
    for (const Command& command : run.commands)
      if (!run.force_controlled)
        longest = std::max(longest, std::hypot(command.value[0] - run.commands.front().value[0],
                                               command.value[1] - run.commands.front().value[1]));
  return longest;
}

std::vector<Kind> pulls_and_ripples() {
  return {
      {"unknown",
       "the torque of one joint ripples with its angle, like a detent",
       true,
       {"amplitude", "waves"},
       {true, false},
       false,
       20,
       works,
       [](const Scene& s, Place j, Random& r) {
         return Values{0.03 * torque(s), 6.2832 * r.uniform(1.5, 3.5) / s.deflection[j]};
       },
       [](Physics& is, const Plan&, Place j, const Values& v) {
         is.joint[j].detent = v[0];
         is.joint[j].detent_waves = v[1];
       }},
      {"unknown",
       "dry friction that fades as the joints run in",
       false,
       {"tau_c", "run_in"},
       {true, false},
       false,
       20,
       rubs,
       [](const Scene& s, Place, Random& r) {
         return Values{0.03 * torque(s), r.uniform(0.4, 1) * largest_deflection(s)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         add_friction(is, {.torque = v[0], .run_in = v[1]});
       }},
      {"unknown",
       "dry friction in the pivot of the end point",
       false,
       {"tau_c"},
       {true},
       false,
       20,
       [](const Scene& s, Place) { return s.plan.size() > 2 && turns_back(s, 0); },
       [](const Scene& s, Place, Random&) { return Values{0.03 * torque(s)}; },
       [](Physics& is, const Plan&, Place, const Values& v) { is.pivot_friction += v[0]; }},
      {"unknown",
       "an elastic band between the base and the axis of a later joint",
       false,
       {"stiffness", "joint"},
       {true, false},
       false,
       100,
       [](const Scene& s, Place) { return s.plan.size() > 3; },
       [](const Scene& s, Place, Random& r) {
         const double size = s.plan.typical_stiffness() / (s.plan.reach() * s.plan.reach());
         return Values{5 * size, static_cast<double>(2 + r.below(s.plan.size() - 3))};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.band = {static_cast<std::size_t>(v[1]), v[0]};
       }},
      {"unknown",
       "the drive's screw has a pitch error",
       false,
       {"amplitude", "period"},
       {true, false},
       false,
       20,
       [](const Scene& s, Place) {
         return never_force_controlled(s, 0) && travel(s) > 0.02 * s.plan.reach();
       },
       [](const Scene& s, Place, Random& r) {
         return Values{5e-4 * s.plan.reach(), travel(s) / r.uniform(2, 4.5)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.screw = {{v[0], 0}, v[1]};
       }},
      {"unknown",
       "the load cell's zero goes up and down with the temperature of the room",
       false,
       {"along", "across", "period"},
       {true, true, false},
       false,
       20,
       never_force_controlled,
       [](const Scene& s, Place, Random& r) {
         return Values{0.01 * s.force, r.uniform(-0.01, 0.01) * s.force, s.duration / r.uniform(1.7, 4.5)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.zero = {{v[0], v[1]}, v[2]};
       }},
      {"unknown",
       "the spring of one joint loses stiffness with the largest deflection that it has seen",
       true,
       {"loss"},
       {true},
       false,
       10,
       [](const Scene& s, Place j) { return works(s, j) && turns_back(s, 0); },
       [](const Scene& s, Place j, Random&) { return Values{0.2 / s.deflection[j]}; },
       [](Physics& is, const Plan&, Place j, const Values& v) { is.joint[j].softening += v[0]; }},
      {"unknown",
       "a magnet beside the path pulls at the end point",
       false,
       {"strength", "width", "x", "y"},
       {true, false, false, false},
       false,
       50,
       [](const Scene& s, Place) {
         return never_force_controlled(s, 0) && travel(s) > 0.02 * s.plan.reach();
       },
       [](const Scene& s, Place, Random& r) {
         const Command& at = r.one_of(r.one_of(s.plan.runs).commands);
         const double width = 0.15 * travel(s);
         return Values{0.03 * s.force / width, width, at.value[0], at.value[1] + 0.3 * width};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.magnet = {{v[2], v[3]}, v[0], v[1]};
       }},
  };
}

std::vector<Kind> frictions_and_springs() {
  return {
      {"unknown",
       "joints that rub beyond an angle, as a seal does where it is pressed",
       false,
       {"tau_c", "clear"},
       {true, false},
       false,
       20,
       rubs,
       [](const Scene& s, Place, Random& r) {
         return Values{0.03 * torque(s), r.uniform(0.3, 0.6) * largest_deflection(s)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         add_friction(is, {.torque = v[0], .clear = v[1]});
       }},
      {"unknown",
       "dry friction that changes with the angle, as in a worn bearing",
       false,
       {"tau_c", "ripple", "waves"},
       {true, false, false},
       false,
       20,
       rubs,
       [](const Scene& s, Place, Random& r) {
         return Values{0.02 * torque(s), r.uniform(0.6, 0.95),
                       6.2832 * r.uniform(1, 2.5) / largest_deflection(s)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         add_friction(is, {.torque = v[0], .ripple = v[1], .waves = v[2]});
       }},
      {"unknown",
       "a notch worn into one joint at one angle",
       true,
       {"depth", "place", "width"},
       {true, false, false},
       false,
       20,
       works,
       [](const Scene& s, Place j, Random& r) {
         return Values{0.05 * torque(s), r.sign() * r.uniform(0.4, 0.7) * s.deflection[j],
                       0.12 * s.deflection[j]};
       },
       [](Physics& is, const Plan&, Place j, const Values& v) {
         is.joint[j].notch = {v[0], v[1], v[2]};
       }},
      {"unknown",
       "all springs soften with the logarithm of time, as moist plastics do",
       false,
       {"creep", "start"},
       {true, false},
       false,
       6,
       imposed_and_long,
       [](const Scene& s, Place, Random&) {
         return Values{0.02, 0.5 * s.sampling_interval};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.ageing.creep = v[0], joint.ageing.start = v[1];
       }},
      {"unknown",
       "the spring of one joint softens as it warms up in the course of a run",
       true,
       {"loss", "warming"},
       {true, false},
       false,
       6,
       [](const Scene& s, Place j) { return works(s, j) && imposed_and_long(s, j); },
       [](const Scene& s, Place, Random& r) {
         return Values{0.08, r.uniform(0.1, 0.4) * s.duration};
       },
       [](Physics& is, const Plan&, Place j, const Values& v) {
         is.joint[j].ageing.loss = v[0], is.joint[j].ageing.warming = v[1];
       }},
      {"unknown",
       "play in one joint that is filled with grease",
       true,
       {"b", "m", "tau"},
       {true, true, false},
       false,
       6,
       [](const Scene& s, Place j) { return works(s, j) && s.duration > 15 * s.sampling_interval; },
       [](const Scene& s, Place j, Random& r) {
         return Values{0.1 * s.deflection[j], r.uniform(0.3, 0.8), r.uniform(2, 8) * s.sampling_interval};
       },
       [](Physics& is, const Plan&, Place j, const Values& v) {
         is.joint[j].backlash = v[0];
         is.joint[j].arm.push_back({v[1], v[2]});
       }},
  };
}

/// Lateral displacement of the middle of a link: at the start of the runs, and at most.
struct Excursion {
  double start = -1e9, most = -1e9;
};
Excursion excursion(const Scene& s, Place link, double side) {
  Excursion all;
  for (const auto& run : s.states) {
    for (std::size_t i = 0; i < run.size(); ++i) {
      double theta = 0, y = 0;
      for (Place j = 0; j <= link; ++j) {
        theta += run[i].q[j];
        y += (j < link ? 1 : 0.5) * s.plan.nominal.length[j] * std::sin(theta);
      }
      if (i == 0) all.start = std::max(all.start, side * y);
      all.most = std::max(all.most, side * y);
    }
  }
  return all;
}

std::vector<Kind> benches_and_instruments() {
  return {
      {"unknown",
       "a wall beside the chain that a link comes to lean on",
       true,
       {"stiffness", "side", "height"},
       {true, false, false},
       false,
       50,
       [](const Scene& s, Place link) {
         const Excursion left = excursion(s, link, 1), right = excursion(s, link, -1);
         return std::max(left.most - left.start, right.most - right.start) > 0.02 * s.plan.reach();
       },
       [](const Scene& s, Place link, Random& r) {
         const Excursion left = excursion(s, link, 1), right = excursion(s, link, -1);
         const bool to_left = left.most - left.start > right.most - right.start;
         const Excursion& way = to_left ? left : right;
         const double size = s.plan.typical_stiffness() / (s.plan.reach() * s.plan.reach());
         return Values{3 * size, to_left ? 1.0 : -1.0,
                       way.start + r.uniform(0.3, 0.6) * (way.most - way.start)};
       },
       [](Physics& is, const Plan&, Place link, const Values& v) {
         is.wall = {link, v[1], v[2], v[0]};
       }},
      {"unknown",
       "the load cell has a loop of its own: below the largest force that it has seen it shows more",
       false,
       {"loop"},
       {true},
       false,
       20,
       [](const Scene& s, Place j) { return never_force_controlled(s, j) && turns_back(s, j); },
       [](const Scene&, Place, Random& r) { return Values{r.sign() * 0.01}; },
       [](Physics& is, const Plan&, Place, const Values& v) { is.cell_loop = v[0]; }},
      {"unknown",
       "the load cell's zero creeps to another value as it warms up",
       false,
       {"along", "across", "time"},
       {true, true, false},
       false,
       20,
       imposed_and_long,
       [](const Scene& s, Place, Random& r) {
         return Values{r.sign() * 0.02 * s.force, r.uniform(-0.02, 0.02) * s.force,
                       r.uniform(0.06, 0.2) * s.duration};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.warming = {v[0], v[1]};
         is.warming_time = v[2];
       }},
      {"unknown",
       "the rail is bent: half way it leads the carriage to one side",
       false,
       {"height", "span"},
       {true, false},
       false,
       20,
       never_force_controlled,
       [](const Scene& s, Place, Random& r) {
         return Values{r.sign() * 1e-3 * s.plan.reach(), longest_way(s)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.rail = {v[0], v[1]};
       }},
      {"unknown",
       "the grip slips once in the course of a run",
       false,
       {"way", "share"},
       {true, false},
       false,
       20,
       never_force_controlled,
       [](const Scene& s, Place, Random& r) {
         return Values{2e-3 * s.plan.reach(), r.uniform(0.25, 0.6)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.grip_slip = v[0];
         is.grip_slip_share = v[1];
       }},
  };
}

}  // namespace

const std::vector<Kind>& outside() {
  static const std::vector<Kind> all = [] {
    std::vector<Kind> kinds = pulls_and_ripples();
    for (const auto& more : {frictions_and_springs(), benches_and_instruments()})
      kinds.insert(kinds.end(), more.begin(), more.end());
    return kinds;
  }();
  return all;
}

std::span<const Kind> first_outside() {
  static const std::size_t count = pulls_and_ripples().size();
  return std::span(outside()).first(count);
}

}  // namespace plumbline::simulator
