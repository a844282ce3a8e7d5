#pragma once
/// \file
/// The rig: the nominal chain and bench with the parameters of every effect. Zero additions give the nominal
/// model, so that any set of effects can act together.

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/free_law.hpp"
#include "diagnose/rig/arm_rig.hpp"
#include "diagnose/rig/sensors.hpp"
#include "diagnose/rig/stated.hpp"

namespace plumbline::diagnose {

using Vector2 = Eigen::Vector2d;

/// Gravity in the catalogue, m/s^2.
inline constexpr double standard_gravity = 9.81;

/// A Maxwell arm in parallel with every spring: stiffness relative to the spring, and time constant, s.
struct Arm {
  double ratio, time;
  friend bool operator==(const Arm&, const Arm&) = default;
};

/// A Jenkins element in parallel with a spring: stiffness relative to the spring, and slip torque, N m.
struct Slider {
  double ratio, yield;
  friend bool operator==(const Slider&, const Slider&) = default;
};

/// The slip torque of dry contacts at deflection d, in direction s = 1 or -1, at joint speed w:
/// (tau_c + growth |d|) (1 + uneven s) (1 + fall exp(-w / speed)).
struct FrictionLaw {
  double growth = 0;           ///< N m/rad
  double uneven = 0;           ///< asymmetry between the directions
  double fall = 0, speed = 1;  ///< Stribeck: relative rise at rest, and its decay speed, rad/s
  friend bool operator==(const FrictionLaw&, const FrictionLaw&) = default;
};

/// An encoder that says q of a joint that stands at (1 + scale) q + zero + ripple . (cos q, sin q).
struct Encoder {
  double zero = 0, scale = 0;
  Vector2 ripple = Vector2::Zero();
  /// By how much the joint stands off what it says.
  [[nodiscard]] double off(double q) const {
    const double even = scale * q + zero;
    return ripple.isZero(0) ? even : even + ripple.dot(Vector2(std::cos(q), std::sin(q)));
  }
  friend bool operator==(const Encoder&, const Encoder&) = default;
};

/// A covariate is (1 + gain) v + zero + drift t where v is told of it, after its response.
struct ToldValue {
  double zero = 0, gain = 0;
  double drift = 0;  ///< of the zero, by second
  Response response;
  friend bool operator==(const ToldValue&, const ToldValue&) = default;
};

/// How drives follow what they are commanded, and loads along the chain what is told of them.
struct Drive {
  Response response;
  std::vector<double> drift;  ///< of the zero of each joint, rad/s
  double gain = 0;            ///< of the way of an end that is held, from where it is unloaded
  std::map<std::size_t, ToldValue> covariates;  ///< by number; others are as they are told
  [[nodiscard]] bool is_exact() const;
  friend bool operator==(const Drive&, const Drive&) = default;
};

/// The angles between which a joint turns.
struct Travel {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  friend bool operator==(const Travel&, const Travel&) = default;
};

struct Rig {
  bool alone = false;  ///< the one joint has no link: force.x is its torque, and the place x its angle

  // The chain, per joint or link.
  std::vector<double> length;      ///< L_j
  std::vector<double> stiffness;   ///< k_i
  std::vector<double> rest_error;  ///< added to the commanded rest angle
  std::vector<double> backlash;    ///< half the play, b
  std::vector<double> stop;        ///< s, deflection at which the stop is reached; infinite without a stop
  std::vector<double> stop_stiffness;        ///< k_s
  std::vector<Travel> travel;                ///< of the joint's angle
  std::vector<double> slip;                  ///< torque at which the spring slips at its fixture; or infinite
  std::vector<double> hardening;             ///< c of k d (1 + c d^2), 1/rad^2
  std::vector<double> asymmetry;             ///< e: stiffness k (1 + e) for d > 0, k (1 - e) for d < 0
  std::vector<double> knee;                  ///< deflection beyond which the spring is softer; or infinite
  std::vector<double> give;                  ///< a: relative loss of stiffness beyond the knee
  std::vector<double> friction;              ///< tau_c, N m; acts at elastic joints
  std::vector<std::vector<Slider>> sliders;  ///< at elastic joints
  std::vector<Vector2> weight;               ///< dead weight of each link, N
  std::vector<Vector2> centre;               ///< of its mass, from its middle, along it and across, m
  std::vector<Vector2> balance;              ///< torque on it, of the cosine and the sine of its angle, N m

  // The drives of the joints, and what reads them.
  Drive drive;                        ///< of what drives impose
  std::vector<double> command_scale;  ///< g: a joint is led to 1 + g times its command
  std::vector<double> gear_coupling;  ///< share of the command of the joint before by which it turns too
  std::vector<Encoder> encoder;       ///< by which a servo leads it; the angles read are theirs
  double compensated = 0;  ///< share of the nominal torque of gravity that they hold without yielding

  // The chain as a whole.
  double presliding = 0;                                   ///< turn after which dry friction slips, rad
  FrictionLaw friction_law;                                ///< of the dry friction of all joints
  double yield = std::numeric_limits<double>::infinity();  ///< tau_y, torque of plastic yield, N m
  double flow = 0;           ///< plastic change of the rest angle over (torque - tau_y) / k
  double capstan = 0;        ///< mu: rest angles decrease by exp(-mu) from joint to joint
  double coupling = 0;       ///< kappa between neighbouring joints, N m/rad
  double axial = 0;          ///< c_a, strain per newton
  double flexibility = 0;    ///< 1/EI of every link, 1/(N m^2)
  std::vector<Arm> arms;     ///< beside every spring
  double tip_stiffness = 0;  ///< k_t, N m/rad
  double eccentricity = 0;   ///< e, m

  // The bench.
  Vector2 payload = Vector2::Zero();                          ///< weight at the end point, N
  Vector2 base_compliance = Vector2::Zero();                  ///< c_x, c_y, m/N
  double train_compliance = 0;                                ///< c_t, m/N
  double misalignment = 0;                                    ///< eps, rad
  Vector3<double> position_offset = Vector3<double>::Zero();  ///< of the frame in which places are told, m
  Vector3<double> place_drift = Vector3<double>::Zero();      ///< of that frame, m/s
  double pulley_friction = 0;   ///< mu: an imposed force acts times exp(-mu) while it grows
  double moment_arm_error = 0;  ///< a: tendons and pressures turn joints by 1 + a times their moment
  double capstan_friction = 0;  ///< mu: a tendon slips at a joint at a ratio exp(mu) of tensions

  // The camera or the tracker that reads places.
  double place_scale = 0;  ///< it shows 1 + a times the distance from its origin
  /// Its axes are not square: x shows shares of y and z, y one of z.
  Vector3<double> place_skew = Vector3<double>::Zero();
  Vector3<double> place_turn = Vector3<double>::Zero();  ///< turned by this rotation vector, rad

  // The load cell and the drive.
  double guide_friction = 0;                              ///< f_c, N
  double force_gain = 0;                                  ///< g
  Vector3<double> force_bias = Vector3<double>::Zero();   ///< N
  Vector3<double> force_drift = Vector3<double>::Zero();  ///< N/s
  Vector2 cross_talk = Vector2::Zero();                   ///< c_xy, c_yx
  Vector2 cell_curvature = Vector2::Zero();               ///< c_x, c_y, 1/N

  // What reads it, in its turn.
  Sensors sensors;

  // By run number; later runs have no addition.
  std::vector<std::vector<double>> run_rest;  ///< [run][joint], beside rest_error
  std::vector<Vector2> run_tare;              ///< [run], beside force_bias

  // An arm in space; none for a chain in the plane.
  std::optional<ArmRig> arm;

  // Free torque laws.
  std::vector<FreeLaw> laws;

  // User effects.
  std::vector<StatedTorque> stated_torques;
  std::vector<StatedCorrection> stated_corrections;

  /// Adds to the mass of a link, at its own centre.
  /// \param gravity  of a chain in the plane; an arm in space has its own
  void add_mass(std::size_t link, double kilograms, const Vector2& gravity);
  /// Adds a mass that lies evenly along a link.
  void add_bar(std::size_t link, double kilograms, const Vector2& gravity);
  /// Hangs a weight at the end point or the tip, N.
  void add_payload(double weight, const Vector2& down);
  void scale_masses(double factor);
  /// Stretches a link, and with it where its mass lies.
  void scale_length(std::size_t link, double factor);
  /// Lets all links bend. \param flexibility  1/EI, 1/(N m^2)
  void bend(double flexibility);
  /// Lets all links stretch. \param strain  by a newton along them
  void stretch(double strain);
  /// The offset of the frame in which places are told, at a time.
  [[nodiscard]] Vector3<double> frame_at(double t) const { return position_offset + t * place_drift; }
  /// A place, in axes that are turned as those of the camera, as it shows it.
  [[nodiscard]] Vector3<double> seen(const Vector3<double>& place) const;

  friend bool operator==(const Rig&, const Rig&) = default;
};

/// The rig in the run of that number.
Rig in_run(const Rig& rig, std::size_t run);

/// The end point of the nominal chain at rest.
Vector2 unloaded_end(const Experiment& experiment, const std::vector<double>& rest);

}  // namespace plumbline::diagnose
