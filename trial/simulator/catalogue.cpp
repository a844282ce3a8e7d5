// The catalogue, and the first of its parts: single joints, links, loads and the bench.
// Each lambda reads: possible at this joint; of this size; adds that.

#include <algorithm>
#include <cmath>

#include "trial/simulator/effect.hpp"

namespace plumbline::simulator {
namespace {

bool in_gravity(const Scene& s, Place) {
  return s.plan.plane == Plane::vertical;
}
bool heavy_as_modelled(const Scene& s, Place) {
  return !s.plan.nominal.mass.empty();
}
bool along_imposed_and_turned(const Scene& s, Place j) {
  return end_point_imposed(s, j) && turns_back(s, j);
}

/// Deflection of the end point by a newton, as a scale.
double compliance(const Scene& s) {
  return s.plan.reach() * s.plan.reach() / s.plan.typical_stiffness();
}

std::vector<Kind> springs() {
  return {
      {"joint_stiffness",
       "",
       true,
       {"a"},
       {true},
       false,
       4,
       elastic,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.03, 0.2); },
       [](Physics& is, const Plan&, Place j, const Values& v) { is.joint[j].stiffness *= 1 + v[0]; }},
      {"link_length",
       "",
       true,
       {"a"},
       {true},
       false,
       6,
       anywhere,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.003, 0.02); },
       [](Physics& is, const Plan&, Place j, const Values& v) { is.length[j] *= 1 + v[0]; }},
      {"rest_angle",
       "",
       true,
       {"a"},
       {true},
       false,
       8,
       elastic,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.01, 0.04); },
       [](Physics& is, const Plan&, Place j, const Values& v) { is.joint[j].rest_error += v[0]; }},
      {"nonlinear_spring",
       "",
       false,
       {"c"},
       {true},
       false,
       20,
       anywhere,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.05, 0.4); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.hardening += v[0];
       }},
      {"backlash",
       "",
       true,
       {"b"},
       {true},
       false,
       8,
       elastic,
       [](const Scene& s, Place j, Random& r) { return one_way(r, 0.005, 0.2 * s.deflection[j]); },
       [](Physics& is, const Plan&, Place j, const Values& v) { is.joint[j].backlash += v[0]; }},
      {"joint_friction",
       "",
       false,
       {"tau_c"},
       {true},
       false,
       6,
       turns_back,
       [](const Scene& s, Place, Random& r) { return one_way(r, 0.004 * torque(s), 0.05 * torque(s)); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint)
           if (joint.stiffness > 0) joint.friction.torque += v[0];
       }},
      {"joint_stop",
       "",
       true,
       {"s", "k_s"},
       {false, true},
       false,
       8,
       [](const Scene& s, Place j) { return elastic(s, j) && s.deflection[j] > 0.15; },
       [](const Scene& s, Place j, Random& r) {
         return Values{significant(r.uniform(0.35, 0.75) * s.deflection[j], 4),
                       significant(r.log_uniform(0.3, 3) * s.plan.nominal.stiffness[j], 4)};
       },
       [](Physics& is, const Plan&, Place j, const Values& v) {
         is.joint[j].stop = v[0];
         is.joint[j].stop_stiffness = v[1];
       }},
      {"joint_coupling",
       "",
       false,
       {"kappa"},
       {true},
       false,
       10,
       anywhere,
       [](const Scene& s, Place, Random& r) {
         return both_ways(r, 0.01 * s.plan.typical_stiffness(), 0.05 * s.plan.typical_stiffness());
       },
       [](Physics& is, const Plan&, Place, const Values& v) { is.coupling += v[0]; }},
      {"viscoelasticity",
       "",
       false,
       {"m", "tau"},
       {true, false},
       false,
       30,
       anywhere,
       [](const Scene& s, Place, Random& r) {
         return Values{significant(r.log_uniform(0.02, 0.3), 4),
                       significant(r.log_uniform(3 * s.sampling_interval, 0.5 * s.duration), 4)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.arm.push_back({v[0], v[1]});
       }},
  };
}

std::vector<Kind> links_and_loads() {
  return {
      {"gravity",
       "",
       false,
       {"rho"},
       {true},
       false,
       20,
       in_gravity,
       [](const Scene& s, Place, Random& r) {
         const double density =
             s.plan.typical_stiffness() / (standard_gravity * s.plan.reach() * s.plan.reach());
         return one_way(r, 0.01 * density, 0.1 * density);
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (std::size_t j = 0; j < is.mass.size(); ++j) is.mass[j] += v[0] * is.length[j];
       }},
      {"tip_payload",
       "",
       false,
       {"weight"},
       {true},
       false,
       30,
       in_gravity,
       [](const Scene& s, Place, Random& r) { return one_way(r, 0.01 * s.force, 0.1 * s.force); },
       [](Physics& is, const Plan&, Place, const Values& v) { is.tip_mass += v[0] / standard_gravity; }},
      {"axial_compliance",
       "",
       false,
       {"c_a"},
       {true},
       false,
       20,
       anywhere,
       [](const Scene& s, Place, Random& r) { return one_way(r, 0.001 / s.force, 0.01 / s.force); },
       [](Physics& is, const Plan&, Place, const Values& v) { is.axial += v[0]; }},
      {"link_bending",
       "",
       false,
       {"EI"},
       {true},
       true,
       6,
       anywhere,
       [](const Scene& s, Place, Random& r) {
         const double rigidity =
             s.plan.typical_stiffness() * s.plan.reach() / static_cast<double>(s.plan.size());
         return one_way(r, 3 * rigidity, 30 * rigidity);
       },
       [](Physics& is, const Plan&, Place, const Values& v) { is.flexibility += 1 / v[0]; }},
      {"eccentric_load",
       "",
       false,
       {"e"},
       {true},
       false,
       10,
       anywhere,
       [](const Scene& s, Place, Random& r) {
         const double link = s.plan.reach() / static_cast<double>(s.plan.size());
         return both_ways(r, 0.01 * link, 0.08 * link);
       },
       [](Physics& is, const Plan&, Place, const Values& v) { is.eccentricity += v[0]; }},
      {"tip_stiffness",
       "",
       false,
       {"k_t"},
       {true},
       false,
       20,
       anywhere,
       [](const Scene& s, Place, Random& r) {
         return one_way(r, 0.01 * s.plan.typical_stiffness(), 0.1 * s.plan.typical_stiffness());
       },
       [](Physics& is, const Plan&, Place, const Values& v) { is.tip_stiffness += v[0]; }},
  };
}

std::vector<Kind> bench() {
  return {
      {"base_compliance",
       "",
       false,
       {"c_x", "c_y"},
       {true, true},
       false,
       20,
       anywhere,
       [](const Scene& s, Place, Random& r) {
         const double size = r.log_uniform(0.001, 0.01) * compliance(s);
         return Values{significant(size, 4), significant(size * r.log_uniform(0.3, 3), 4)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.base_compliance = {v[0], v[1]};
       }},
      {"rail_misalignment",
       "",
       false,
       {"eps"},
       {true},
       false,
       10,
       anywhere,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.01, 0.06); },
       [](Physics& is, const Plan&, Place, const Values& v) { is.misalignment += v[0]; }},
      {"position_offset",
       "",
       false,
       {"d_x", "d_y"},
       {true, true},
       false,
       8,
       never_force_controlled,
       [](const Scene& s, Place, Random& r) {
         return in_plane(r, r.log_uniform(5e-4, 5e-3) * s.plan.reach());
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.position_offset = {v[0], v[1]};
       }},
      {"train_compliance",
       "",
       false,
       {"c_t"},
       {true},
       false,
       20,
       never_force_controlled,
       [](const Scene& s, Place, Random& r) {
         return one_way(r, 0.001 * compliance(s), 0.01 * compliance(s));
       },
       [](Physics& is, const Plan&, Place, const Values& v) { is.train_compliance += v[0]; }},
      {"guide_friction",
       "",
       false,
       {"f_c"},
       {true},
       false,
       20,
       along_imposed_and_turned,
       [](const Scene& s, Place, Random& r) { return one_way(r, 0.005 * s.force, 0.05 * s.force); },
       [](Physics& is, const Plan&, Place, const Values& v) { is.guide_friction += v[0]; }},
      {"force_bias",
       "",
       false,
       {"b_x", "b_y"},
       {true, true},
       false,
       20,
       end_point_imposed,
       [](const Scene& s, Place, Random& r) { return in_plane(r, r.log_uniform(0.005, 0.05) * s.force); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.bias = {v[0], v[1]};
       }},
      {"force_gain",
       "",
       false,
       {"g"},
       {true},
       false,
       8,
       end_point_imposed,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.01, 0.06); },
       [](Physics& is, const Plan&, Place, const Values& v) { is.gain += v[0]; }},
      {"sensor_drift",
       "",
       false,
       {"r_x", "r_y"},
       {true, true},
       false,
       20,
       end_point_imposed,
       [](const Scene& s, Place, Random& r) {
         return in_plane(r, r.log_uniform(0.005, 0.05) * s.force / s.duration);
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         is.drift = {v[0], v[1]};
       }},
  };
}

std::vector<Kind> joined(std::initializer_list<std::vector<Kind>> parts) {
  std::vector<Kind> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<Kind> masses() {
  return {{"mass_scale",
           "",
           false,
           {"a"},
           {true},
           false,
           4,
           heavy_as_modelled,
           [](const Scene&, Place, Random& r) { return both_ways(r, 0.05, 0.3); },
           [](Physics& is, const Plan&, Place, const Values& v) {
             for (double& mass : is.mass) mass *= 1 + v[0];
           }}};
}

const std::vector<Kind>& catalogue() {
  static const std::vector<Kind> all = joined(
      {springs(), links_and_loads(), bench(), common_to_all_joints(), joint_laws(), sensors(), masses()});
  return all;
}

std::span<const Kind> first_catalogue() {
  static const std::size_t count = joined({springs(), links_and_loads(), bench()}).size();
  return std::span(catalogue()).first(count);
}

}  // namespace plumbline::simulator
