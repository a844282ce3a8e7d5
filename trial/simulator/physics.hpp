#pragma once
/// \file
/// The rig as it really is. As `physics_of(plan)` makes it, it is what the lab believes; an effect changes
/// some of it.

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "trial/simulator/plan.hpp"

namespace plumbline::simulator {

/// Standard gravity as the effect catalogue counts it, m/s^2.
inline constexpr double standard_gravity = 9.81;

/// A spring in series with a slider that yields at a torque, or with a dashpot.
struct Slider {
  double ratio;  ///< its stiffness over that of the joint
  double yield;  ///< N m
};
struct Arm {
  double ratio;
  double time;  ///< constant, s
};

/// Dry friction of a joint: it slips at `torque` times what follows.
struct Friction {
  double torque = 0;
  double growth = 0;             ///< 1 + growth |d|
  double uneven = 0;             ///< 1 + uneven * the side to which it slips
  double ripple = 0, waves = 0;  ///< 1 + ripple sin(waves d)
  double fall = 0, speed = 1;    ///< 1 + fall exp(-|rate| / speed), rate over about one reading
  double run_in = std::numeric_limits<double>::infinity();  ///< exp(-way turned / run_in)
  double clear = 0;                                         ///< nothing where |d| is smaller
};

/// A dip of the torque about one angle, where the joint is worn: -depth u exp(-u^2 / 2), u = (d - place) /
/// width.
struct Notch {
  double depth = 0, place = 0, width = 1;
};

/// A spring that loses stiffness in the course of a run: k / (1 + creep ln(1 + t / start)) (1 - loss (1 -
/// exp(-t / warming))).
struct Ageing {
  double creep = 0, start = 1, loss = 0, warming = 1;
};

struct Joint {
  double stiffness = 0, rest_error = 0;
  double backlash = 0;
  double stop = std::numeric_limits<double>::infinity(), stop_stiffness = 0;
  double hardening = 0;  ///< c of k d (1 + c d^2)
  double asymmetry = 0;  ///< e of k (1 + e sign d)
  /// Beyond this deflection the spring is softer, by this share of its stiffness.
  double knee = std::numeric_limits<double>::infinity(), give = 0;
  /// Beyond this torque the rest angle moves, by `flow` times what the excess would bend; it stays there and
  /// moves again beyond the largest torque so far.
  double yield = std::numeric_limits<double>::infinity(), flow = 0;
  Friction friction = {};
  std::vector<Slider> slider = {};
  std::vector<Arm> arm = {};
  double detent = 0;        ///< amplitude of a ripple A sin(w d)
  double detent_waves = 0;  ///< w
  double softening = 0;     ///< stiffness lost per radian of the largest deflection so far
  Notch notch = {};
  Ageing ageing = {};

  /// Whether MuJoCo's own spring will do.
  [[nodiscard]] bool plain() const {
    return backlash == 0 && asymmetry == 0 && flow == 0 && softening == 0 && ageing.creep == 0 &&
           ageing.loss == 0;
  }
};

/// A spring between the base pivot and the axis of a joint; slack in the unloaded shape.
struct Band {
  std::size_t joint = 0;  ///< counted from 0; 0 is none
  double stiffness = 0;
};

/// A magnet beside the path that pulls the end point: strength * r exp(-r^2 / 2 width^2).
struct Magnet {
  Pair place{0, 0};
  double strength = 0, width = 1;
};

/// A wall beside the middle of a link: it pushes back where the middle is more than `height` to its side.
struct Wall {
  std::size_t link = 0;
  double side = 1, height = 0, stiffness = 0;
};

/// Changes of a run made on another day: a new clamping, a new zero of the load cell.
struct OtherDay {
  std::vector<double> rest;  ///< to the rest angles; or none
  Pair tare{0, 0};           ///< to the load cell's zero
};

/// A sine in time or along the way.
struct Wave {
  Pair amplitude{0, 0};
  double period = 1;
};

/// A rail that is bent sideways: half way along its span it is so far beside the straight line.
struct Bow {
  double height = 0, span = 1;
};

struct Physics {
  std::vector<Joint> joint;
  std::vector<double> length, mass;
  double coupling = 0, axial = 0, flexibility = 0;  ///< kappa, c_a, 1/EI
  double capstan = 0;  ///< the moment of the tendon that sets the rest angles falls by exp(-capstan) a joint
  double tip_stiffness = 0, eccentricity = 0;
  double tip_mass = 0;
  double pivot_friction = 0;  ///< dry friction of the end pivot
  Band band;
  Pair base_compliance{0, 0};
  double train_compliance = 0;
  // The carriage.
  double misalignment = 0;
  Pair position_offset{0, 0};
  Wave screw;  ///< pitch error of the drive: x goes astray by a sine of the way
  Magnet magnet;
  Bow rail;
  double grip_slip = 0;        ///< the grip slips so far along x, once,
  double grip_slip_share = 1;  ///< after this share of the readings
  Wall wall;
  // The load cell and the drive.
  double guide_friction = 0, gain = 0;
  Pair bias{0, 0}, drift{0, 0};
  Wave zero;           ///< of the load cell, with the temperature of the room
  Pair warming{0, 0};  ///< its zero goes there by 1 - exp(-t / warming_time)
  double warming_time = 1;
  Pair cross_talk{0, 0};  ///< c_xy, c_yx
  Pair curvature{0, 0};   ///< F (1 + curvature F)
  double cell_loop = 0;   ///< how much it shows more at half of the largest force, as a share of that
  double saturation = std::numeric_limits<double>::infinity();
  double lag = 0;                             ///< time constant, s
  std::map<std::string, OtherDay> other_day;  ///< by the run's id

  [[nodiscard]] Pair tare(const PlannedRun& run) const {
    const auto other = other_day.find(run.id);
    return other == other_day.end() ? Pair{0, 0} : other->second.tare;
  }
};

inline Physics physics_of(const Plan& plan) {
  Physics is;
  is.length = plan.nominal.length;
  is.mass = plan.nominal.mass;
  is.mass.resize(plan.size(), 0.0);
  for (const double k : plan.nominal.stiffness) is.joint.push_back({.stiffness = k});
  return is;
}

/// The angle at which a joint's spring is slack, in the actual run.
inline double rest_angle(const Physics& is, const PlannedRun& run, std::size_t j) {
  const auto other = is.other_day.find(run.id);
  const double anew = other == is.other_day.end() || other->second.rest.empty() ? 0 : other->second.rest[j];
  return run.rest[j] * std::exp(-is.capstan * static_cast<double>(j)) + is.joint[j].rest_error + anew;
}

}  // namespace plumbline::simulator
