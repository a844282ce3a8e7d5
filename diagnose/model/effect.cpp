#include "diagnose/model/effect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <plumbline/base/error.hpp>

namespace plumbline::diagnose {
namespace {

Vector2 gravity_direction(const Experiment& experiment) {
  if (experiment.bench.has_direction)
    return {experiment.bench.gravity_direction[0], experiment.bench.gravity_direction[1]};
  return {0, -1};
}

constexpr Coordinate plain = Coordinate::plain;

/// Where an effect is added, and how much of it.
struct Addition {
  Rig& rig;
  std::size_t joint;    ///< from 0
  Vector2 down;         ///< direction of gravity
  const double* value;  ///< in catalogue units, one a parameter
};

struct Entry {
  std::string_view name;
  bool at_joint;
  std::vector<Coordinate> coordinates;  ///< one a parameter
  void (*add)(const Addition& at);
};

const std::array<Entry, effect_count> catalogue{
    Entry{"joint_stiffness",
          true,
          {plain},
          [](const Addition& at) { at.rig.stiffness[at.joint] *= 1 + at.value[0]; }},
    Entry{
        "link_length", true, {plain}, [](const Addition& at) { at.rig.length[at.joint] *= 1 + at.value[0]; }},
    Entry{
        "rest_angle", true, {plain}, [](const Addition& at) { at.rig.rest_error[at.joint] += at.value[0]; }},
    Entry{"nonlinear_spring", false, {plain}, [](const Addition& at) { at.rig.hardening += at.value[0]; }},
    Entry{"backlash", true, {plain}, [](const Addition& at) { at.rig.backlash[at.joint] += at.value[0]; }},
    Entry{"joint_friction", false, {plain}, [](const Addition& at) { at.rig.friction += at.value[0]; }},
    Entry{"joint_stop",
          true,
          {plain, plain},
          [](const Addition& at) {
            at.rig.stop[at.joint] = at.value[0];
            at.rig.stop_stiffness[at.joint] = at.value[1];
          }},
    Entry{"joint_coupling", false, {plain}, [](const Addition& at) { at.rig.coupling += at.value[0]; }},
    Entry{"gravity",
          false,
          {plain},
          [](const Addition& at) {
            for (std::size_t j = 0; j < at.rig.length.size(); ++j)
              at.rig.weight[j] += at.value[0] * at.rig.length[j] * standard_gravity * at.down;
          }},
    Entry{"tip_payload", false, {plain}, [](const Addition& at) { at.rig.payload += at.value[0] * at.down; }},
    Entry{"base_compliance",
          false,
          {plain, plain},
          [](const Addition& at) { at.rig.base_compliance += Vector2(at.value[0], at.value[1]); }},
    Entry{"axial_compliance", false, {plain}, [](const Addition& at) { at.rig.axial += at.value[0]; }},
    Entry{"link_bending",
          false,
          {Coordinate::reciprocal},
          [](const Addition& at) { at.rig.flexibility += 1 / at.value[0]; }},
    Entry{
        "rail_misalignment", false, {plain}, [](const Addition& at) { at.rig.misalignment += at.value[0]; }},
    Entry{"eccentric_load", false, {plain}, [](const Addition& at) { at.rig.eccentricity += at.value[0]; }},
    Entry{"tip_stiffness", false, {plain}, [](const Addition& at) { at.rig.tip_stiffness += at.value[0]; }},
    Entry{"guide_friction", false, {plain}, [](const Addition& at) { at.rig.guide_friction += at.value[0]; }},
    Entry{"force_bias",
          false,
          {plain, plain},
          [](const Addition& at) { at.rig.force_bias += Vector2(at.value[0], at.value[1]); }},
    Entry{"force_gain", false, {plain}, [](const Addition& at) { at.rig.force_gain += at.value[0]; }},
    Entry{"position_offset",
          false,
          {plain, plain},
          [](const Addition& at) { at.rig.position_offset += Vector2(at.value[0], at.value[1]); }},
    Entry{"train_compliance",
          false,
          {plain},
          [](const Addition& at) { at.rig.train_compliance += at.value[0]; }},
    Entry{"viscoelasticity",
          false,
          {plain, Coordinate::logarithm},
          [](const Addition& at) {
            at.rig.arm_ratio += at.value[0];
            at.rig.relaxation = at.value[1];
          }},
    Entry{"sensor_drift",
          false,
          {plain, plain},
          [](const Addition& at) { at.rig.force_drift += Vector2(at.value[0], at.value[1]); }},
};

const Entry& entry(EffectId effect) {
  return catalogue[static_cast<std::size_t>(effect)];
}

/// Lengths, stiffnesses, forces and times that are typical of one experiment.
struct Typical {
  double stiffness = 0, length = 0, link = 0, force = 0, deflection = 0, duration = 0, pause = 0;
};

Typical typical(const Experiment& experiment) {
  Typical size;
  double elastic = 0;
  for (const double k : experiment.joint_stiffness) {
    size.stiffness += k;
    elastic += k > 0;
  }
  size.stiffness /= std::max(1.0, elastic);
  for (const double length : experiment.link_length) size.length += length;
  size.link = size.length / static_cast<double>(experiment.link_length.size());
  std::vector<double> force;
  for (const Run& run : experiment.runs) {
    for (const Reading& reading : run.readings) {
      force.push_back(std::hypot(std::isfinite(reading.Fx) ? reading.Fx : 0.0,
                                 std::isfinite(reading.Fy) ? reading.Fy : 0.0));
      size.duration = std::max(size.duration, reading.t);
    }
    if (run.readings.size() > 1 && size.pause == 0) size.pause = run.readings[1].t - run.readings[0].t;
  }
  if (!force.empty()) {
    const auto place = force.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(force.size()));
    std::nth_element(force.begin(), place, force.end());
    size.force = *place;
  }
  size.force = std::max(size.force, 1e-3 * size.stiffness / size.length);
  size.duration = std::max(size.duration, 1e-3);
  size.pause = size.pause > 0 ? size.pause : size.duration;
  // The deflection that the force gives a lever of half the chain, kept to what angles can be.
  size.deflection = std::clamp(0.3 * size.force * size.length / size.stiffness, 0.02, 1.0);
  return size;
}

ParameterRange both_ways(std::string_view name, double scale, double low, double high) {
  return {name, plain, scale, low, high};
}
ParameterRange one_way(std::string_view name, double scale, double high) {
  return {name, plain, scale, 0, high};
}

std::vector<ParameterRange> ranges(EffectId effect, const Typical& is, double own_stiffness) {
  const double compliance = is.length * is.length / is.stiffness;
  switch (effect) {
    case EffectId::joint_stiffness:
      return {both_ways("a", 0.2, -0.95, 9)};
    case EffectId::link_length:
      return {both_ways("a", 0.02, -0.3, 0.3)};
    case EffectId::rest_angle:
      return {both_ways("a", 0.05, -0.6, 0.6)};
    case EffectId::nonlinear_spring:
      return {both_ways("c", 0.5, -3, 50)};
    case EffectId::backlash:
      return {{"b", plain, 0.05, 0, 0.6}};
    case EffectId::joint_friction: {
      const double slip = is.stiffness * is.deflection;
      return {{"tau_c", plain, 0.05 * slip, 0, 2 * slip}};
    }
    case EffectId::joint_stop:
      return {{"s", plain, 0.3, 1e-3, 3}, {"k_s", plain, own_stiffness, 0, 100 * own_stiffness}};
    case EffectId::joint_coupling:
      return {both_ways("kappa", 0.1 * is.stiffness, -0.95 * is.stiffness, 0.95 * is.stiffness)};
    case EffectId::gravity: {
      const double density = is.stiffness / (standard_gravity * is.length * is.length);
      return {one_way("rho", 0.1 * density, 20 * density)};
    }
    case EffectId::tip_payload:
      return {one_way("weight", 0.1 * is.force, 10 * is.force)};
    case EffectId::base_compliance:
      return {one_way("c_x", 0.01 * compliance, compliance), one_way("c_y", 0.01 * compliance, compliance)};
    case EffectId::axial_compliance:
      return {one_way("c_a", 0.01 / is.force, 0.3 / is.force)};
    case EffectId::link_bending: {
      const double soft = 1 / (is.stiffness * is.link);
      return {{"EI", Coordinate::reciprocal, 0.1 * soft, 1e-6 * soft, 10 * soft}};
    }
    case EffectId::rail_misalignment:
      return {both_ways("eps", 0.05, -0.6, 0.6)};
    case EffectId::eccentric_load:
      return {both_ways("e", 0.03 * is.link, -is.link, is.link)};
    case EffectId::tip_stiffness:
      return {one_way("k_t", 0.1 * is.stiffness, 10 * is.stiffness)};
    case EffectId::guide_friction:
      return {one_way("f_c", 0.05 * is.force, 3 * is.force)};
    case EffectId::force_bias:
      return {both_ways("b_x", 0.05 * is.force, -3 * is.force, 3 * is.force),
              both_ways("b_y", 0.05 * is.force, -3 * is.force, 3 * is.force)};
    case EffectId::force_gain:
      return {both_ways("g", 0.05, -0.8, 3)};
    case EffectId::position_offset:
      return {both_ways("d_x", 0.005 * is.length, -0.1 * is.length, 0.1 * is.length),
              both_ways("d_y", 0.005 * is.length, -0.1 * is.length, 0.1 * is.length)};
    case EffectId::train_compliance:
      return {one_way("c_t", 0.01 * compliance, compliance)};
    case EffectId::viscoelasticity:
      return {one_way("m", 0.2, 20),
              {"tau", Coordinate::logarithm, 1, std::log(0.1 * is.pause), std::log(20 * is.duration)}};
    case EffectId::sensor_drift: {
      const double rate = is.force / is.duration;
      return {both_ways("r_x", 0.05 * rate, -3 * rate, 3 * rate),
              both_ways("r_y", 0.05 * rate, -3 * rate, 3 * rate)};
    }
  }
  return {};
}

bool measures_force(const Experiment& experiment) {
  for (const Run& run : experiment.runs) {
    for (const Reading& reading : run.readings) {
      if (run.control == Control::end_point && (std::isfinite(reading.Fx) || std::isfinite(reading.Fy)))
        return true;
    }
  }
  return false;
}

/// Whether the effect can change anything at this place in this experiment.
bool possible(const Experiment& experiment, const EffectAt& at, bool forces) {
  const bool elastic = at.joint > 0 && experiment.joint_stiffness[at.joint - 1] > 0;
  switch (at.effect) {
    case EffectId::joint_stiffness:
    case EffectId::rest_angle:
    case EffectId::backlash:
      return elastic;
    case EffectId::joint_coupling:
      return experiment.link_length.size() > 1;
    case EffectId::gravity:
    case EffectId::tip_payload:
      return experiment.bench.plane != Bench::Plane::horizontal;
    case EffectId::guide_friction:
    case EffectId::position_offset:
    case EffectId::train_compliance:
      return forces;
    default:
      return true;
  }
}

}  // namespace

std::string_view effect_name(EffectId effect) {
  return entry(effect).name;
}

EffectId effect_id(std::string_view name) {
  for (std::size_t i = 0; i < effect_count; ++i)
    if (catalogue[i].name == name) return static_cast<EffectId>(i);
  throw Error("effect", std::string(name), "an id of the effect catalogue");
}

bool sits_at_joint(EffectId effect) {
  return entry(effect).at_joint;
}

std::vector<ParameterRange> parameter_ranges(const Experiment& experiment, const EffectAt& at) {
  const Typical is = typical(experiment);
  const double own = at.joint > 0 ? experiment.joint_stiffness[at.joint - 1] : 0;
  return ranges(at.effect, is, own > 0 ? own : is.stiffness);
}

std::vector<ParameterRange> parameter_ranges(const Experiment& experiment, const Candidate& candidate) {
  std::vector<ParameterRange> all;
  for (const EffectAt& at : candidate.effects)
    for (const ParameterRange& range : parameter_ranges(experiment, at)) all.push_back(range);
  return all;
}

Instance part(const Candidate& candidate, const std::vector<double>& parameters,
              const std::function<bool(const EffectAt&)>& stays) {
  Instance left;
  auto value = parameters.begin();
  for (const EffectAt& at : candidate.effects) {
    const auto next = value + static_cast<std::ptrdiff_t>(entry(at.effect).coordinates.size());
    if (stays(at)) {
      left.candidate.effects.push_back(at);
      left.parameters.insert(left.parameters.end(), value, next);
    }
    value = next;
  }
  return left;
}

double catalogue_value(Coordinate coordinate, double fitted) {
  switch (coordinate) {
    case Coordinate::logarithm:
      return std::exp(fitted);
    case Coordinate::reciprocal:
      return 1 / fitted;
    case Coordinate::plain:
      break;
  }
  return fitted;
}

double fitted_value(Coordinate coordinate, double catalogue_units) {
  switch (coordinate) {
    case Coordinate::logarithm:
      return std::log(catalogue_units);
    case Coordinate::reciprocal:
      return 1 / catalogue_units;
    case Coordinate::plain:
      break;
  }
  return catalogue_units;
}

Rig rig_with(const Experiment& experiment, const Candidate& candidate,
             const std::vector<double>& parameters) {
  Rig rig = nominal_rig(experiment);
  std::size_t next = 0;
  for (const EffectAt& at : candidate.effects) {
    std::vector<double> values;
    for (const Coordinate coordinate : entry(at.effect).coordinates)
      values.push_back(catalogue_value(coordinate, parameters.at(next++)));
    entry(at.effect).add(
        {rig, at.joint > 0 ? at.joint - 1 : 0, gravity_direction(experiment), values.data()});
  }
  return rig;
}

std::vector<EffectAt> possible_effects(const Experiment& experiment) {
  std::vector<EffectAt> all;
  const bool forces = measures_force(experiment);
  for (std::size_t e = 0; e < effect_count; ++e) {
    const auto effect = static_cast<EffectId>(e);
    const std::size_t first = sits_at_joint(effect) ? 1 : 0;
    const std::size_t last = sits_at_joint(effect) ? experiment.link_length.size() : 0;
    for (std::size_t joint = first; joint <= last; ++joint)
      if (const EffectAt at{effect, joint}; possible(experiment, at, forces)) all.push_back(at);
  }
  return all;
}

}  // namespace plumbline::diagnose
