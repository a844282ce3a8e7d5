#pragma once
/// \file
/// Typical sizes and bounds of the parameters of effects, in one table: by the kind of their quantity, in
/// units of the device itself. They are the prior of every effect; effects/README.md shows the table.

#include <functional>
#include <string_view>
#include <vector>

#include "diagnose/rig/parameter_range.hpp"

namespace plumbline::diagnose {

struct Place;

/// Kinds of quantities.
enum class ParameterKind {
  stiffness_error,     ///< relative error of a stiffness
  length_error,        ///< of a length
  mass_error,          ///< of a mass
  load_gain,           ///< of a sensor or lever of forces and torques
  place_gain,          ///< of a sensor or gear of places and angles
  spring_part,         ///< a spring beside that of a joint, over it
  plastic_part,        ///< plastic over elastic deflection
  asymmetry,           ///< of springs between both directions
  friction_asymmetry,  ///< of friction between both directions
  friction_fall,       ///< of friction with speed
  rope_friction,       ///< exponent of tensions
  cross_talk,          ///< between components
  held_share,          ///< of a weight that servos hold
  joint_angle,         ///< an offset of a joint, or its play
  fixture_angle,       ///< of a guide that is mounted by hand
  frame_angle,         ///< of a camera, a tracker, a base or a tool
  axis_angle,          ///< of an axis, an encoder or a flange
  hardening,           ///< of a spring, by the square of its deflection
  onset_angle,         ///< deflection at which a stop or a knee is met
  place,               ///< of a frame, a point or a load
  eccentricity,        ///< of a load on its link
  axis_place,          ///< of an axis
  centre_place,        ///< of a centre of mass
  stroke,              ///< an offset of a joint that slides
  weight,              ///< at the end point
  guide_force,         ///< friction of a guide
  force_zero,          ///< of a sensor
  force_drift,         ///< of a sensor, by time
  friction_torque,     ///< of a joint
  torque_zero,         ///< of a sensor
  torque_drift,        ///< of a sensor, by time
  angle_drift,         ///< of a sensor or a command, by time
  stroke_drift,        ///< of those of a joint that slides, by time
  place_drift,         ///< of a frame, by time
  pixel_zero,          ///< of a camera
  pixel_drift,         ///< of a camera, by time
  balance_torque,      ///< of a counterweight
  yield_torque,        ///< of a spring
  slip_torque,         ///< of a spring at its fixture
  mass,                ///< of a link
  density,             ///< of links, by their length
  coupling_stiffness,  ///< between joints
  end_stiffness,       ///< of an end pivot
  stop_stiffness,      ///< of a joint's stop
  end_compliance,      ///< of what holds the ends of a chain
  turning_compliance,  ///< of a joint, a tool or a base
  bending_rigidity,    ///< of links
  strain_by_force,     ///< of links
  sensor_curvature,    ///< of a load cell
  sensor_limit,        ///< of a load cell
  friction_growth,     ///< of friction with deflection
  lag,                 ///< of a sensor or of a command
  decay_time,          ///< of a spring that relaxes
  slip_way,            ///< turn after which dry friction slips
  slip_deflection,     ///< at which a part of a spring slips
  friction_speed,      ///< at which friction falls
  expansion,           ///< of a length with temperature
};

/// A row of the table. A parameter's scale and bounds are `typical`, `low` and `high` times `own`, the
/// device's own size. Those of a reciprocal are of the reciprocal. One that is fitted by its logarithm is as
/// probable between the bounds everywhere; one that is fitted by its growth has no own size but one.
struct TypicalSize {
  ParameterKind kind;
  std::string_view words;  ///< for the document
  std::string_view unit;   ///< of the parameter
  std::string_view size;   ///< `own`, in the symbols of effects/README.md
  double typical, low, high;
  double (*own)(const Place& at);
  Coordinate coordinate = Coordinate::plain;
  double (*own_high)(const Place& at) = nullptr;  ///< for the upper bound, where it is another
};

const std::vector<TypicalSize>& typical_sizes();

/// A parameter of that kind at a place.
ParameterRange of(ParameterKind kind, std::string_view name, const Place& at);
/// The parameter of a row that has one.
std::function<std::vector<ParameterRange>(const Place& at)> one_of(ParameterKind kind, std::string_view name);
/// The parameters of a row that has several of one kind.
std::function<std::vector<ParameterRange>(const Place& at)> some_of(ParameterKind kind,
                                                                    std::vector<std::string_view> names);

}  // namespace plumbline::diagnose
