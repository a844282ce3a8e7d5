// Effects of all joints or links: a common value, or a value at each.

#include <cmath>

#include "trial/simulator/effect.hpp"

namespace plumbline::simulator {
namespace {

constexpr std::string_view common = "common to all joints";
constexpr double stiffness_tolerance = 0.05, length_tolerance = 0.005, angle_tolerance = 0.0087;

}  // namespace

std::vector<Kind> common_to_all_joints() {
  return {
      {"stiffness_scale",
       "",
       false,
       {"a"},
       {true},
       false,
       4,
       anywhere,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.02, 0.2); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.stiffness *= 1 + v[0];
       },
       {},
       common},
      {"length_scale",
       "",
       false,
       {"a"},
       {true},
       false,
       6,
       anywhere,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.003, 0.02); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (double& length : is.length) length *= 1 + v[0];
       },
       {},
       common},
      {"rest_offset",
       "",
       false,
       {"a"},
       {true},
       false,
       6,
       anywhere,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.01, 0.04); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.rest_error += v[0];
       },
       {},
       common},
      {"stiffness_spread",
       "",
       false,
       {},
       {true},
       false,
       4,
       several_elastic,
       [](const Scene& s, Place, Random& r) { return at_every_joint(s, r, stiffness_tolerance, true); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < v.size(); ++j) is.joint[j].stiffness *= std::max(0.2, 1 + v[j]);
       },
       {"a"},
       one_at_each_joint},
      {"length_spread",
       "",
       false,
       {},
       {true},
       false,
       6,
       several_links,
       [](const Scene& s, Place, Random& r) { return at_every_joint(s, r, length_tolerance, false); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < v.size(); ++j) is.length[j] *= 1 + v[j];
       },
       {"a"},
       one_at_each_joint},
      {"rest_spread",
       "",
       false,
       {},
       {true},
       false,
       6,
       several_elastic,
       [](const Scene& s, Place, Random& r) { return at_every_joint(s, r, angle_tolerance, true); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < v.size(); ++j) is.joint[j].rest_error += v[j];
       },
       {"a"},
       one_at_each_joint},
      {"play",
       "",
       false,
       {},
       {true},
       false,
       6,
       several_elastic,
       [](const Scene& s, Place, Random& r) {
         Values all;
         for (const double k : s.plan.nominal.stiffness)
           all.push_back(k == 0 ? 0 : significant(r.log_uniform(0.02, 0.1) * largest_deflection(s), 4));
         return all;
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < v.size(); ++j) is.joint[j].backlash += v[j];
       },
       {"b"},
       one_at_each_joint},
  };
}

}  // namespace plumbline::simulator
