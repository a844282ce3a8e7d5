#include "diagnose/rig/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {
namespace {

double one(const Place&) {
  return 1;
}

double turn(const Place& at) {
  return at.scales.turn;
}

double deflection(const Place& at) {
  return at.scales.deflection;
}

double length(const Place& at) {
  return at.scales.length;
}

double link(const Place& at) {
  return at.scales.link;
}

double stroke(const Place& at) {
  return std::min(at.scales.length, 10 * at.scales.turn);
}

double force(const Place& at) {
  return at.scales.force;
}

double torque(const Place& at) {
  return at.scales.typical_load(at.joint);
}

double stiffness(const Place& at) {
  return at.scales.stiffness;
}

double own_stiffness(const Place& at) {
  return at.scales.stiffness_at(at.joint);
}

double mass(const Place& at) {
  return at.scales.mass;
}

double density(const Place& at) {
  return at.scales.stiffness / (standard_gravity * at.scales.length * at.scales.length);
}

double compliance(const Place& at) {
  return at.scales.compliance();
}

double flexibility(const Place& at) {
  return 1 / (at.scales.stiffness * at.scales.link);
}

double interval(const Place& at) {
  return at.scales.sampling_interval;
}

double duration(const Place& at) {
  return at.scales.duration;
}

/// The softening at which a spring carries nothing at the typical deflection; ten at least, for actual
/// deflections may be smaller than the loads suggest.
double hardening(const Place& at) {
  return std::max(10.0, 1 / (at.scales.deflection * at.scales.deflection));
}

template <double (*size)(const Place&)>
double per(const Place& at) {
  return 1 / size(at);
}

template <double (*size)(const Place&)>
double per_duration(const Place& at) {
  return size(at) / at.scales.duration;
}

/// To the typical deflection and back in the longest run.
double speed(const Place& at) {
  return 2 * at.scales.deflection / at.scales.duration;
}

}  // namespace

const std::vector<TypicalSize>& typical_sizes() {
  using Q = ParameterKind;
  constexpr Coordinate logarithm = Coordinate::logarithm, reciprocal = Coordinate::reciprocal;
  static const std::vector<TypicalSize> all{
      {Q::stiffness_error, "error of a stiffness", "ratio", "1", 0.2, -0.999, 999, one, Coordinate::growth},
      {Q::length_error, "error of a length", "ratio", "1", 0.02, -0.3, 0.3, one},
      {Q::mass_error, "error of all masses", "ratio", "1", 0.1, -0.95, 3, one},
      {Q::load_gain, "error of a sensor or a lever of loads", "ratio", "1", 0.05, -0.9, 3, one},
      {Q::place_gain, "error of a sensor or a gear of places and angles", "ratio", "1", 0.01, -0.9, 3, one},
      {Q::spring_part, "further springs, over that of the joint", "ratio", "1", 0.2, 0, 20, one},
      {Q::plastic_part, "plastic over elastic deflection", "ratio", "1", 0.1, 0, 20, one},
      {Q::asymmetry, "asymmetry of springs", "ratio", "1", 0.05, -0.9, 0.9, one},
      {Q::friction_asymmetry, "asymmetry of friction", "ratio", "1", 0.3, -1, 1, one},
      {Q::friction_fall, "rise of friction at rest", "ratio", "1", 0.5, -0.95, 10, one},
      {Q::rope_friction, "friction of a rope or a pulley", "ratio", "1", 0.03, 0, 1, one},
      {Q::cross_talk, "cross-talk", "ratio", "1", 0.03, -0.8, 0.8, one},
      {Q::held_share, "share of a weight", "ratio", "1", 0.2, -2, 2, one},
      {Q::joint_angle, "offset or play of a joint", "rad", "w", 0.05, -0.6, 0.6, turn},
      {Q::fixture_angle, "turn of a guide", "rad", "1", 0.05, -0.6, 0.6, one},
      {Q::frame_angle, "turn of a camera, a tracker, a base, a tool", "rad", "1", 0.01, -0.6, 0.6, one},
      {Q::axis_angle, "tilt of an axis, ripple of an encoder, play of a flange", "rad", "1", 0.003, -0.3, 0.3,
       one},
      {Q::hardening, "hardening of springs", "1/rad²", "c_0", 0.05, -1, 20, hardening},
      {Q::onset_angle, "deflection at a stop or a knee", "rad", "w", 0.3, 1e-5, 3, turn},
      {Q::place, "place of a frame, a point or a load", "m", "L", 0.005, -1, 1, length},
      {Q::eccentricity, "place of a load across its link", "m", "l", 0.03, -1, 1, link},
      {Q::axis_place, "place of an axis", "m", "L", 0.002, -0.1, 0.1, length},
      {Q::centre_place, "place of a centre of mass", "m", "L", 0.02, -0.3, 0.3, length},
      {Q::stroke, "offset of a joint that slides", "m", "L", 0.005, -1, 1, stroke},
      {Q::weight, "weight", "N", "f", 0.1, 0, 10, force},
      {Q::guide_force, "friction of a guide", "N", "f", 0.05, 0, 3, force},
      {Q::force_zero, "zero of a sensor of forces", "N", "f", 0.05, -3, 3, force},
      {Q::force_drift, "drift of a sensor of forces", "N/s", "f / T", 0.05, -3, 3, per_duration<force>},
      {Q::friction_torque, "dry friction", "N m", "tau", 0.05, 0, 50, torque},
      {Q::torque_zero, "zero of a sensor of torques", "N m", "tau", 0.05, -10, 10, torque},
      {Q::torque_drift, "drift of a sensor of torques", "N m/s", "tau / T", 0.05, -10, 10,
       per_duration<torque>},
      {Q::angle_drift, "drift of a sensor of angles or of a command", "rad/s", "w / T", 0.01, -0.6, 0.6,
       per_duration<turn>},
      {Q::stroke_drift, "drift of those of a joint that slides", "m/s", "L / T", 0.002, -1, 1,
       per_duration<stroke>},
      {Q::place_drift, "drift of a frame", "m/s", "L / T", 0.002, -1, 1, per_duration<length>},
      {Q::pixel_zero, "zero of a camera", "px", "1", 5, -300, 300, one},
      {Q::pixel_drift, "drift of a camera", "px/s", "1 / T", 2, -300, 300, per_duration<one>},
      {Q::balance_torque, "torque of a counterweight", "N m", "tau", 0.1, -10, 10, torque},
      {Q::yield_torque, "torque of plastic yield", "N m", "tau", 0.3, 1e-3, 10, torque},
      {Q::slip_torque, "torque at which a spring slips at its fixture", "N m", "tau", 0.3, 1e-3, 10,
       per<torque>, reciprocal},
      {Q::mass, "mass of a link", "kg", "m", 0.1, -20, 20, mass},
      {Q::density, "mass of links by length", "kg/m", "k / 9.81 / L / L", 0.1, 0, 20, density},
      {Q::coupling_stiffness, "stiffness between joints", "N m/rad", "k", 0.1, -0.95, 0.95, stiffness},
      {Q::end_stiffness, "stiffness of an end pivot", "N m/rad", "k", 0.1, 0, 10, stiffness},
      {Q::stop_stiffness, "stiffness of a stop", "N m/rad", "k_j", 10, 0, 300, own_stiffness},
      {Q::end_compliance, "compliance of a base or a load train", "m/N", "L L / k", 0.01, 0, 1, compliance},
      {Q::turning_compliance, "compliance of a joint, a tool or a base", "rad/(N m)", "1 / tau", 1e-3, 0, 1,
       per<torque>},
      {Q::bending_rigidity, "rigidity of links", "N m²", "k l", 0.1, 1e-6, 100, flexibility, reciprocal},
      {Q::strain_by_force, "strain of links by force", "1/N", "1 / f", 0.01, 0, 0.3, per<force>},
      {Q::sensor_curvature, "curvature of a load cell", "1/N", "1 / f", 0.03, -0.25, 0.25, per<force>},
      {Q::sensor_limit, "range of a load cell", "N", "f", 0.3, 1e-3, 10, per<force>, reciprocal},
      {Q::friction_growth, "growth of friction with deflection", "1/rad", "1 / phi", 2, 0, 100,
       per<deflection>},
      {Q::lag, "lag or delay", "s", "dt", 0.3, 0, 1, interval, Coordinate::plain, duration},
      {Q::decay_time, "time constant of a spring or a sensor", "s", "dt", 1, 0.1, 20, interval, logarithm,
       duration},
      {Q::slip_way, "turn before friction slips", "rad", "phi", 1, 1e-4, 0.5, deflection, logarithm},
      {Q::slip_deflection, "deflection at which a part of a spring slips", "rad", "phi", 0.1, 1e-3, 4,
       deflection},
      {Q::friction_speed, "speed at which friction falls", "rad/s", "2 phi / T", 1, 0.01, 100, speed,
       logarithm},
      {Q::expansion, "thermal expansion", "1/K", "1", 1.2e-5, -1.2e-3, 1.2e-3, one},
  };
  return all;
}

ParameterRange of(ParameterKind kind, std::string_view name, const Place& at) {
  const TypicalSize& row = typical_sizes().at(static_cast<std::size_t>(kind));
  const double own = row.own(at), own_high = row.own_high != nullptr ? row.own_high(at) : own;
  if (row.coordinate == Coordinate::logarithm || row.coordinate == Coordinate::growth)
    return {name,
            row.unit,
            row.coordinate,
            row.typical,
            fitted_value(row.coordinate, row.low * own),
            fitted_value(row.coordinate, row.high * own_high)};
  return {name, row.unit, row.coordinate, row.typical * own, row.low * own, row.high * own_high};
}

std::function<std::vector<ParameterRange>(const Place& at)> one_of(ParameterKind kind,
                                                                   std::string_view name) {
  return some_of(kind, {name});
}

std::function<std::vector<ParameterRange>(const Place& at)> some_of(ParameterKind kind,
                                                                    std::vector<std::string_view> names) {
  return [kind, names = std::move(names)](const Place& at) {
    std::vector<ParameterRange> all;
    for (const std::string_view name : names) all.push_back(of(kind, name, at));
    return all;
  };
}

}  // namespace plumbline::diagnose
