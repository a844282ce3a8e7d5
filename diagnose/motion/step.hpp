#pragma once
/// \file
/// One step in time of a driven joint: half a step of the angles, a whole one of the speeds, half a step of
/// the angles (Störmer-Verlet). What sticks has the speed zero to the last bit.

#include "diagnose/motion/drive.hpp"

namespace plumbline::motion {

/// Forces of a step, at its middle.
template <class Real>
struct Forces {
  Real motor;    ///< torque of the motor at rest
  Real against;  ///< weight, springs, contacts and offset
  Real damping;  ///< torque over speed, all that is proportional to it
  Real warm{1};  ///< factor of friction by temperature
};

/// The motor's torque with what of it depends on the angle: cogging, and a share of the torque itself
/// (ripple).
template <class Real>
Real rippled(const Drive<Real>& drive, const Real& motor, const Real& angle) {
  using std::sin, std::cos;
  if (!drive.has(Term::periods)) return motor;
  const Real phase = drive[Term::periods] * angle, sine = sin(phase), cosine = cos(phase);
  return motor * (1 + drive[Term::ripple_sine] * sine + drive[Term::ripple_cosine] * cosine) +
         drive[Term::cogging_sine] * sine + drive[Term::cogging_cosine] * cosine;
}

/// The torque of springs that act from an angle on.
template <class Real>
Real against_contacts(const Drive<Real>& drive, const Real& angle) {
  Real against(0);
  if (drive.has(Term::contact_above) && angle > drive[Term::above_from])
    against = drive[Term::contact_above] * (angle - drive[Term::above_from]);
  if (drive.has(Term::contact_below) && angle < drive[Term::below_from])
    against = against + drive[Term::contact_below] * (angle - drive[Term::below_from]);
  return against;
}

template <class Real>
Forces<Real> forces_at(const Drive<Real>& drive, const Imposed<Real>& now, const Real& acting,
                       const Real& q) {
  using std::sin, std::cos;
  constexpr double standard_gravity = 9.81;  // m/s^2
  const Real at = joint_angle(drive, q), angle = at + drive[Term::zero];
  Real against = now.gravity * sin(angle);
  if (drive.has(Term::base_motion))
    against = against + drive[Term::base_motion] * (now.gravity * now.base_acceleration / standard_gravity) *
                            cos(angle);
  if (drive.has(Term::load_mass)) against = (1 + drive[Term::load_mass]) * against;
  if (drive.has(Term::spring)) against = against + drive[Term::spring] * angle;
  if (drive.has(Term::contact_above) || drive.has(Term::contact_below))
    against = against + against_contacts(drive, angle);
  if (drive.has(Term::torque_offset)) against = against - drive[Term::torque_offset];
  const Real motor = now.powered ? drive[Term::stall_torque] * now.supply * acting : Real(0);
  Forces<Real> forces{rippled(drive, motor, at), against,
                      drive[Term::viscous] + drive[now.powered ? Term::back_emf : Term::brake]};
  if (drive.has(Term::friction_warming)) {
    forces.warm = 1 + now.warmer * drive[Term::friction_warming];
    forces.damping = forces.damping + (forces.warm - 1) * drive[Term::viscous];
  }
  return forces;
}

/// Friction while sliding. A gear loses a share of the torque that passes it, another one by the direction in
/// which power flows (Hamon, Gautier and Garrec 2010).
/// \param way     1 or -1
/// \param speed   at the begin of the step
/// \param passed  torque through the gear without the loss
/// \param warm    factor by temperature
template <class Real>
Real friction_of(const Drive<Real>& drive, double way, const Real& speed, const Real& passed,
                 const Real& warm) {
  using std::abs, std::exp;
  Real friction = drive[Term::dry];
  if (drive.has(Term::direction)) friction = friction + way * drive[Term::direction];
  const Term loss = value_of(passed) * way > 0 ? Term::loss_driving : Term::loss_driven;
  if (drive.has(loss)) friction = friction + drive[loss] * abs(passed);
  if (drive.has(Term::drag)) friction = friction + drive[Term::drag] * speed * speed;
  if (drive.has(Term::dry_rising))
    friction = friction + drive[Term::dry_rising] * exp(-(abs(speed) / drive[Term::rising_speed]));
  if (drive.has(Term::friction_warming)) friction = warm * friction;
  return friction;
}

/// A speed at the end of a step, and its mean over the step.
template <class Real>
struct Moved {
  Real speed, mean;
};

/// Joint and rotor in one piece, a time h later. A speed that ends within the step ends when it does: what is
/// left of the step begins at rest, so that stops and turns are as accurate as motion.
template <class Real>
Moved<Real> moved_rigid(const Drive<Real>& drive, const Real& load, const Forces<Real>& f, const Real& speed,
                        double h) {
  const Real inertia = load + drive[Term::armature], push = f.motor - f.against;
  const bool loses = drive.has(Term::loss_driving) || drive.has(Term::loss_driven);
  const Real passed = loses ? (f.against * drive[Term::armature] + f.motor * load) / inertia : Real(0);
  const auto slid = [&](double way, const Real& from, const auto& during) -> Real {
    const Real force = push - way * friction_of(drive, way, from, passed, f.warm),
               half = during / 2.0 * f.damping;
    return ((inertia - half) * from + during * force) / (inertia + half);
  };
  Real rest(h), before(0);  // what is left of the step, and the way until then over it
  if (const double way = value_of(speed); way != 0) {
    const Real end = slid(way > 0 ? 1 : -1, speed, h);
    if (value_of(end) * way > 0) return {end, (speed + end) / 2.0};
    const Real share = speed / (speed - end);
    rest = h * (1 - share), before = share * speed / 2.0;
  }
  const double way = value_of(push) > 0 ? 1 : -1;
  const Real end = slid(way, Real(0), rest);
  if (!(value_of(end) * way > 0)) return {Real(0), before};
  return {end, before + rest / h * end / 2.0};
}

/// Rotor and joint with a gear between them that gives way.
template <class Real>
struct Gear {
  Real rotor, load;  ///< inertias
  Real compliance;
  Real play, damping;
  double implicitness;  ///< 1/2 resolves the elastic motion, 1 stops what is too stiff for the step

  /// A rotor below a thousandth of the load, and an elastic motion that is faster than the step, are not
  /// resolved: an impact leaves a hundredth of the speed.
  Gear(const Drive<Real>& drive, const Real& of_load, double h)
      : rotor(drive[Term::armature]),
        load(of_load),
        play(drive[Term::play]),
        damping(drive[Term::gear_damping]) {
    if (rotor < 1e-3 * load) rotor = 1e-3 * load;
    const double together = value_of(rotor) * value_of(load) / (value_of(rotor) + value_of(load));
    const double least = h * h / (100 * together);
    compliance = drive[Term::gear_compliance] + least;
    implicitness = 0.5 + 0.5 * least / value_of(compliance);
  }
  /// The twist at which a torque rests.
  [[nodiscard]] Real twist_under(const Real& torque) const {
    return compliance * torque + (value_of(torque) > 0 ? 0.5 : -0.5) * play;
  }
};

/// Speeds of joint and rotor a time h later.
template <class Real>
struct Speeds {
  Real joint, rotor;
};

/// \param from   speeds at the begin
/// \param twist  of the rotor against the joint, at the middle of the step
template <class Real>
Speeds<Real> geared_speeds(const Drive<Real>& drive, const Gear<Real>& gear, const Forces<Real>& f,
                           const Speeds<Real>& from, const Real& twist, double h) {
  // Torque through the gear where it touches: at_rest + rising (rotor - joint), speeds at the end.
  const double side = value_of(twist) + h * (value_of(from.rotor) - value_of(from.joint)) > 0 ? 1 : -1;
  const auto moved = [&](const Real& at_rest, const Real& rising) -> Speeds<Real> {
    const Real joint_pushed = gear.load * from.joint + h * (at_rest - f.against),
               joint_inertia = gear.load + h * rising;
    const Real share = h * rising / joint_inertia;
    const Real pushed =
        (gear.rotor - h / 2 * f.damping) * from.rotor + h * (f.motor - at_rest) + share * joint_pushed;
    const Real inertia = gear.rotor + h / 2 * f.damping + share * gear.load;
    const double way = value_of(pushed) > 0 ? 1 : -1;
    const Real passed = at_rest + rising * (from.rotor - from.joint);
    const Real sliding = (pushed - way * h * friction_of(drive, way, from.rotor, passed, f.warm)) / inertia;
    const Real rotor = value_of(sliding) * way > 0 ? sliding : Real(0);
    return {(joint_pushed + h * rising * rotor) / joint_inertia, rotor};
  };
  const Real at_rest = (twist - side / 2 * gear.play) / gear.compliance;
  const Real rising = h * gear.implicitness / gear.compliance + gear.damping;
  const Speeds<Real> touching = moved(at_rest, rising);
  const bool pulls = side * value_of(at_rest + rising * (touching.rotor - touching.joint)) < 0;
  return pulls && value_of(gear.play) > 0 ? moved(Real(0), Real(0)) : touching;
}

/// The duty that the servo asks for at the middle of a step, where `next` has the angles and the reference.
template <class Real>
void ask(const Drive<Real>& drive, const Imposed<Real>& now, const Motion<Real>& from, Motion<Real>& next,
         double h) {
  const Real reading = next.reading(now.encoder), error = servo_error(drive, next.reference, reading);
  Real speed(0), integral(0);
  if (drive.has(Term::derivative_gain)) speed = from.speed(now.encoder) + h / 2 * from.speeding;
  if (drive.has(Term::integral_gain)) {
    integral = now.powered ? integrated(drive, from.integrated, error, h / 2) : Real(0);
    next.integrated = integrated(drive, integral, error, h / 2);
  }
  next.asked = asked_duty(drive, now, error, reading, speed, integral);
}

/// The state a time h later.
template <class Real>
Motion<Real> after(const Drive<Real>& drive, const Imposed<Real>& now, const Motion<Real>& from, double h) {
  using std::exp;
  const bool geared = drive.gives_way();
  Motion<Real> next = from;
  next.q = from.q + h / 2 * from.v;
  if (geared) next.twist = from.twist + h / 2 * from.twisting;
  next.reference = now.command;
  if (drive.has(Term::command_slowness))
    next.reference =
        from.reference + limited<Real>(now.command - from.reference, Real(h) / drive[Term::command_slowness]);
  ask(drive, now, from, next, h);
  next.acting = next.asked;
  if (drive.has(Term::drive_lag))
    next.acting = next.acting + (from.acting - next.acting) * exp(Real(-h) / drive[Term::drive_lag]);
  const Forces<Real> f = forces_at(drive, now, next.acting, next.q);
  const Real load = drive.has(Term::load_mass) ? now.inertia * (1 + drive[Term::load_mass]) : now.inertia;
  if (geared) {
    const Speeds<Real> begin{joint_angle(drive, from.v), joint_angle(drive, Real(from.v + from.twisting))};
    const Speeds<Real> end =
        geared_speeds(drive, Gear<Real>(drive, load, h), f, begin, joint_angle(drive, next.twist), h);
    next.v = encoder_angle(drive, end.joint);
    next.twisting = encoder_angle(drive, Real(end.rotor - end.joint));
    next.twist = next.twist + h / 2 * next.twisting;
    next.q = next.q + h / 2 * next.v;
  } else {
    const Moved<Real> moved = moved_rigid(drive, load, f, joint_angle(drive, from.v), h);
    next.v = encoder_angle(drive, moved.speed);
    next.q = from.q + h * encoder_angle(drive, moved.mean);
  }
  if (drive.has(Term::derivative_gain))
    next.speeding = (next.speed(now.encoder) - from.speed(now.encoder)) / h;
  return next;
}

/// The state of a joint whose encoder reads an angle and a speed, where the gear is at rest under the load.
/// \param integrated  duty of the servo's integral part
template <class Real>
Motion<Real> begun(const Drive<Real>& drive, const Imposed<Real>& now, const Real& reading, const Real& v,
                   const Real& integrated, double h) {
  Motion<Real> state{reading, v};
  state.reference = now.command;
  state.integrated = integrated;
  state.asked = asked_duty(drive, now, servo_error(drive, now.command, reading), reading, v, integrated);
  state.acting = state.asked;
  if (!drive.gives_way()) return state;
  const Real load = now.inertia * (1 + drive[Term::load_mass]);
  const Forces<Real> f = forces_at(drive, now, state.acting, reading);
  state.twist = encoder_angle(drive, Gear<Real>(drive, load, h).twist_under(f.against));
  if (now.encoder == EncoderSide::motor) state.q = reading - state.twist;
  return state;
}

}  // namespace plumbline::motion
