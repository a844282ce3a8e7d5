// Torque laws of joints beyond a single parameter: dry friction, hysteresis, hardening, stops, relaxation,
// set, capstan, springs of two slopes.

#include <cmath>

#include "trial/simulator/effect.hpp"

namespace plumbline::simulator {
namespace {

constexpr std::string_view laws = "laws of joints";

/// Stiffness, over that of the joint, of one to five sliders beside a spring, and the turn after which each
/// yields, one after the other.
Values draw_sliders(double deflection, Random& r) {
  const std::size_t count = r.one_of<std::size_t>({1, 1, 2, 2, 3, 4, 5});
  Values all;
  for (std::size_t m = 0; m < count; ++m) {
    const double ratio = r.log_uniform(0.1, 0.6) / static_cast<double>(count);
    const double turn = deflection * 0.04 * std::pow(2.2, static_cast<double>(m)) * r.uniform(0.7, 1.3);
    all.insert(all.end(), {significant(ratio, 4), significant(turn, 4)});
  }
  return all;
}

/// \param stiffness  of the joint that yields at those turns
void add_sliders(Joint& joint, double stiffness, const Values& v) {
  if (joint.stiffness == 0) return;
  for (std::size_t m = 0; m + 1 < v.size(); m += 2)
    joint.slider.push_back({v[m], v[m] * stiffness * v[m + 1]});
}

/// The largest torque that a spring carries.
double spring_torque(const Scene& s) {
  double most = 0;
  for (Place j = 0; j < s.plan.size(); ++j)
    most = std::max(most, s.plan.nominal.stiffness[j] * s.deflection[j]);
  return most;
}

bool bent_at_rest(const Scene& s, Place) {
  return std::any_of(s.plan.runs.begin(), s.plan.runs.end(), [](const PlannedRun& run) {
    return std::any_of(run.rest.begin() + 1, run.rest.end(), [](double q) { return std::abs(q) > 0.15; });
  });
}

std::vector<Kind> friction() {
  return {
      {"friction_spread",
       "",
       false,
       {},
       {true},
       false,
       6,
       [](const Scene& s, Place j) { return turns_back(s, j) && several_elastic(s, j); },
       [](const Scene& s, Place, Random& r) {
         Values all;
         for (const double k : s.plan.nominal.stiffness)
           all.push_back(k == 0 ? 0 : significant(r.log_uniform(0.003, 0.06) * torque(s), 4));
         return all;
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < v.size(); ++j) is.joint[j].friction.torque += v[j];
       },
       {"tau"},
       one_at_each_joint},
      {"load_friction",
       "",
       false,
       {"tau_c", "growth"},
       {true, false},
       false,
       6,
       turns_back,
       [](const Scene& s, Place, Random& r) {
         return Values{significant(r.log_uniform(0.002, 0.02) * torque(s), 4),
                       significant(r.log_uniform(1.5, 6) / largest_deflection(s), 4)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) {
           if (joint.stiffness == 0) continue;
           joint.friction.torque += v[0];
           joint.friction.growth = v[1];
         }
       },
       {},
       laws},
      {"direction_friction",
       "",
       false,
       {"tau_c", "uneven"},
       {true, false},
       false,
       6,
       turns_back,
       [](const Scene& s, Place, Random& r) {
         return Values{significant(r.log_uniform(0.003, 0.03) * torque(s), 4),
                       significant(r.sign() * r.uniform(0.3, 0.9), 3)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint)
           if (joint.stiffness > 0) joint.friction = {.torque = v[0], .uneven = v[1]};
       },
       {},
       laws},
      {"speed_friction",
       "",
       false,
       {"tau_c", "fall", "speed"},
       {true, false, false},
       false,
       6,
       [](const Scene& s, Place j) { return turns_back(s, j) && s.duration > 15 * s.sampling_interval; },
       [](const Scene& s, Place, Random& r) {
         return Values{
             significant(r.log_uniform(0.003, 0.02) * torque(s), 4), significant(r.uniform(0.8, 3), 3),
             significant(r.uniform(0.3, 1) * largest_deflection(s) / (10 * s.sampling_interval), 4)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint)
           if (joint.stiffness > 0) joint.friction = {.torque = v[0], .fall = v[1], .speed = v[2]};
       },
       {},
       laws},
      {"hysteresis",
       "",
       false,
       {},
       {true, false},
       false,
       6,
       turns_back,
       [](const Scene& s, Place, Random& r) { return draw_sliders(largest_deflection(s), r); },
       [](Physics& is, const Plan& plan, Place, const Values& v) {
         for (Joint& joint : is.joint) add_sliders(joint, plan.typical_stiffness(), v);
       },
       {"r", "d"},
       laws},
      {"hysteresis",
       "",
       true,
       {},
       {true, false},
       false,
       6,
       [](const Scene& s, Place j) { return turns_back(s, j) && elastic(s, j); },
       [](const Scene& s, Place j, Random& r) { return draw_sliders(s.deflection[j], r); },
       [](Physics& is, const Plan& plan, Place j, const Values& v) {
         add_sliders(is.joint[j], plan.nominal.stiffness[j], v);
       },
       {"r", "d"},
       laws},
  };
}

/// Threshold of a piecewise spring, as a fraction of its largest deflection, and its softening.
Values draw_knee(double deflection, Random& r) {
  return {significant(r.uniform(0.25, 0.7) * deflection, 4), significant(r.uniform(0.1, 0.4), 3)};
}

std::vector<Kind> piecewise_springs() {
  return {
      {"piecewise_spring",
       "",
       false,
       {"s", "a"},
       {false, true},
       false,
       2.2,
       [](const Scene& s, Place j) { return several_elastic(s, j) && largest_deflection(s) > 0.15; },
       [](const Scene& s, Place, Random& r) { return draw_knee(largest_deflection(s), r); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.knee = v[0], joint.give = v[1];
       },
       {},
       laws},
      {"piecewise_spring",
       "",
       true,
       {"s", "a"},
       {false, true},
       false,
       2.2,
       [](const Scene& s, Place j) { return elastic(s, j) && s.deflection[j] > 0.15; },
       [](const Scene& s, Place j, Random& r) { return draw_knee(s.deflection[j], r); },
       [](Physics& is, const Plan&, Place j, const Values& v) {
         is.joint[j].knee = v[0];
         is.joint[j].give = v[1];
       },
       {},
       laws},
  };
}

std::vector<Kind> further_laws() {
  return {
      {"hardening_spread",
       "",
       false,
       {},
       {true},
       false,
       10,
       several_elastic,
       [](const Scene& s, Place, Random& r) { return at_every_joint(s, r, 0.4, true); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < v.size(); ++j) is.joint[j].hardening += v[j];
       },
       {"c"},
       one_at_each_joint},
      {"joint_stops",
       "",
       false,
       {"s", "k_s"},
       {false, true},
       false,
       8,
       [](const Scene& s, Place) { return largest_deflection(s) > 0.15; },
       [](const Scene& s, Place, Random& r) {
         return Values{significant(r.uniform(0.3, 0.65) * largest_deflection(s), 4),
                       significant(r.log_uniform(0.3, 3) * s.plan.typical_stiffness(), 4)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.stop = v[0], joint.stop_stiffness = v[1];
       },
       {},
       laws},
      {"joint_stops",
       "",
       false,
       {"k_s"},
       {true, false},
       false,
       8,
       [](const Scene& s, Place j) { return several_elastic(s, j) && largest_deflection(s) > 0.15; },
       [](const Scene& s, Place, Random& r) {
         Values all{significant(r.log_uniform(0.3, 3) * s.plan.typical_stiffness(), 4)};
         for (const double reach : s.deflection)
           all.push_back(significant(r.uniform(0.3, 0.9) * std::max(reach, 0.02), 4));
         return all;
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < is.joint.size(); ++j)
           is.joint[j].stop = v[1 + j], is.joint[j].stop_stiffness = v[0];
       },
       {"s"},
       one_at_each_joint},
      {"asymmetric_spring",
       "",
       false,
       {"e"},
       {true},
       false,
       6,
       anywhere,
       [](const Scene&, Place, Random& r) { return both_ways(r, 0.02, 0.12); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.asymmetry += v[0];
       },
       {},
       laws},
      {"asymmetric_spring",
       "",
       false,
       {},
       {true},
       false,
       6,
       several_elastic,
       [](const Scene& s, Place, Random& r) { return at_every_joint(s, r, 0.15, true); },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Place j = 0; j < v.size(); ++j)
           is.joint[j].asymmetry = std::clamp(is.joint[j].asymmetry + v[j], -0.9, 0.9);
       },
       {"e"},
       one_at_each_joint},
      {"relaxation_spectrum",
       "",
       false,
       {},
       {true, false},
       false,
       10,
       [](const Scene& s, Place) { return s.duration > 25 * s.sampling_interval; },
       [](const Scene& s, Place, Random& r) {
         return Values{significant(r.log_uniform(0.03, 0.2), 4),
                       significant(r.uniform(1.5, 4) * s.sampling_interval, 4),
                       significant(r.log_uniform(0.03, 0.2), 4),
                       significant(r.uniform(0.25, 0.6) * s.duration, 4)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint) joint.arm.insert(joint.arm.end(), {{v[0], v[1]}, {v[2], v[3]}});
       },
       {"m", "tau"},
       laws},
      {"plastic_set",
       "",
       false,
       {"tau_y", "slope"},
       {false, true},
       false,
       6,
       turns_back,
       [](const Scene& s, Place, Random& r) {
         return Values{significant(r.uniform(0.25, 0.6) * spring_torque(s), 4),
                       significant(r.log_uniform(0.03, 0.4), 4)};
       },
       [](Physics& is, const Plan&, Place, const Values& v) {
         for (Joint& joint : is.joint)
           if (joint.stiffness > 0) joint.yield = v[0], joint.flow = v[1];
       },
       {},
       laws},
      {"tendon_friction",
       "",
       false,
       {"mu"},
       {true},
       false,
       6,
       bent_at_rest,
       [](const Scene&, Place, Random& r) { return one_way(r, 0.005, 0.08); },
       [](Physics& is, const Plan&, Place, const Values& v) { is.capstan += v[0]; },
       {},
       laws},
  };
}

}  // namespace

std::vector<Kind> joint_laws() {
  std::vector<Kind> kinds;
  for (const auto& part : {friction, further_laws, piecewise_springs}) {
    const std::vector<Kind> more = part();
    kinds.insert(kinds.end(), more.begin(), more.end());
  }
  return kinds;
}

}  // namespace plumbline::simulator
