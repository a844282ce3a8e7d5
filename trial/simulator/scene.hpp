#pragma once
/// \file
/// The expected course of an experiment: possible places of effects, and the scales of their sizes.

#include <algorithm>
#include <string>
#include <vector>

#include "trial/simulator/random.hpp"
#include "trial/simulator/simulation.hpp"

namespace plumbline::simulator {

struct Scene {
  const Plan& plan;
  const std::vector<std::vector<State>>& states;  ///< without any effect
  std::vector<double> deflection;                 ///< the largest of each joint
  double force = 0;                               ///< the largest
  double duration = 0, sampling_interval = 0;     ///< of the longest run; the shortest time between readings
};

using Place = std::size_t;           ///< joint, from 0
using Values = std::vector<double>;  ///< parameters, in the order of their names

inline bool anywhere(const Scene&, Place) {
  return true;
}
/// Whether joint `j` has a spring that is loaded.
inline bool elastic(const Scene& s, Place j) {
  return s.plan.nominal.stiffness[j] > 0 && s.deflection[j] > 0.04;
}
/// The number of such joints.
inline std::size_t elastic_joints(const Scene& s) {
  std::size_t count = 0;
  for (Place j = 0; j < s.plan.size(); ++j) count += elastic(s, j);
  return count;
}
inline bool several_elastic(const Scene& s, Place) {
  return elastic_joints(s) > 1;
}
inline bool several_links(const Scene& s, Place) {
  return s.plan.size() > 1;
}
inline std::size_t imposed_runs(const Scene& s) {
  return static_cast<std::size_t>(std::count_if(s.plan.runs.begin(), s.plan.runs.end(),
                                                [](const PlannedRun& run) { return !run.force_controlled; }));
}
inline bool end_point_imposed(const Scene& s, Place) {
  return imposed_runs(s) > 0;
}
/// No reading depends on where a force-controlled carriage is taken to be.
inline bool never_force_controlled(const Scene& s, Place) {
  return imposed_runs(s) == s.plan.runs.size();
}
/// Some run turns back: profiles that do are named so.
inline bool turns_back(const Scene& s, Place) {
  return std::any_of(s.plan.runs.begin(), s.plan.runs.end(),
                     [](const PlannedRun& run) { return run.id.find("-loading") == std::string::npos; });
}

inline double largest_deflection(const Scene& s) {
  return *std::max_element(s.deflection.begin(), s.deflection.end());
}
inline double torque(const Scene& s) {
  return s.plan.typical_stiffness() * largest_deflection(s);
}

inline Values both_ways(Random& r, double low, double high) {
  return {significant(r.sign() * r.log_uniform(low, high), 4)};
}
inline Values one_way(Random& r, double low, double high) {
  return {significant(r.log_uniform(low, high), 4)};
}
/// Two components, of any direction.
inline Values in_plane(Random& r, double size) {
  const double angle = r.uniform(-3.14159, 3.14159);
  return {significant(size * std::cos(angle), 4), significant(size * std::sin(angle), 4)};
}
/// A value a joint, normal with this deviation; zero at a passive joint where `elastic_only`.
inline Values at_every_joint(const Scene& s, Random& r, double deviation, bool elastic_only) {
  Values all;
  for (const double k : s.plan.nominal.stiffness)
    all.push_back(k == 0 && elastic_only ? 0 : significant(deviation * r.normal(), 4));
  return all;
}

}  // namespace plumbline::simulator
