// Effects that are in no catalogue: what a diagnosis must call unknown.

#include <algorithm>
#include <cmath>

#include "simulator/effect.hpp"

namespace plumbline::simulator {
namespace {

using Place = std::size_t;

bool works(const Scene& s, Place j) {
  return s.plan.nominal.stiffness[j] > 0 && s.deflection[j] > 0.25;
}
bool unloads(const Scene& s) {
  return std::any_of(s.plan.runs.begin(), s.plan.runs.end(), [](const PlannedRun& run) {
    return run.id.find("cycle") != std::string::npos || run.id.find("unloading") != std::string::npos;
  });
}
bool end_point_imposed(const Scene& s) {
  return std::all_of(s.plan.runs.begin(), s.plan.runs.end(),
                     [](const PlannedRun& run) { return !run.force_controlled; });
}
double torque(const Scene& s) {
  return s.plan.typical_stiffness() * *std::max_element(s.deflection.begin(), s.deflection.end());
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

}  // namespace

const std::vector<Kind>& outside() {
  static const std::vector<Kind> all{
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
       "dry friction in one joint alone",
       true,
       {"tau_c"},
       {true},
       false,
       20,
       [](const Scene& s, Place j) {
         return works(s, j) && unloads(s) &&
                std::count_if(s.deflection.begin(), s.deflection.end(), [](double d) { return d > 0.15; }) >
                    2;
       },
       [](const Scene& s, Place, Random&) { return Values{0.03 * torque(s)}; },
       [](Physics& is, const Plan&, Place j, const Values& v) { is.joint[j].friction += v[0]; }},
      {"unknown",
       "dry friction in the pivot of the end point",
       false,
       {"tau_c"},
       {true},
       false,
       20,
       [](const Scene& s, Place) { return s.plan.size() > 2 && unloads(s); },
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
       [](const Scene& s, Place) { return end_point_imposed(s) && travel(s) > 0.02 * s.plan.reach(); },
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
       [](const Scene& s, Place) { return end_point_imposed(s); },
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
       [](const Scene& s, Place j) { return works(s, j) && unloads(s); },
       [](const Scene& s, Place j, Random&) { return Values{0.2 / s.deflection[j]}; },
       [](Physics& is, const Plan&, Place j, const Values& v) { is.joint[j].softening += v[0]; }},
      {"unknown",
       "a magnet beside the path pulls at the end point",
       false,
       {"strength", "width", "x", "y"},
       {true, false, false, false},
       false,
       50,
       [](const Scene& s, Place) { return end_point_imposed(s) && travel(s) > 0.02 * s.plan.reach(); },
       [](const Scene& s, Place, Random& r) {
         const Command& at = r.one_of(r.one_of(s.plan.runs).commands);
         const double width = 0.15 * travel(s);
         return Values{0.03 * s.force / width, width, at.value[0], at.value[1] + 0.3 * width};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.magnet = {{v[2], v[3]}, v[0], v[1]};
       }},
  };
  return all;
}

}  // namespace plumbline::simulator
