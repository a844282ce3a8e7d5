#include "diagnose/motion/joint_law.hpp"

#include <fmt/format.h>

#include <plumbline/base/error.hpp>

namespace plumbline::motion {

JointLaw joint_law(const Bench& bench, const Drive<double>& drive, double servo_gain) {
  const double torque = drive[Term::stall_torque] * Sizes(bench.logs).supply;
  return {drive[Term::armature],
          drive[Term::dry],
          drive[Term::viscous] + drive[Term::back_emf],
          drive[Term::spring],
          drive[Term::zero] - bench.nominal[Term::zero],
          torque * servo_gain,
          torque * drive[Term::derivative_gain],
          drive[Term::command_offset],
          torque * (1 - drive[Term::duty_missing]),
          drive[Term::command_delay],
          drive[Term::stall_torque],
          drive[Term::back_emf],
          drive[Term::viscous],
          drive[Term::zero]};
}

double servo_gain(const Bench& bench) {
  if (bench.model.gain) return *bench.model.gain;
  for (const MotionLog& log : bench.logs)
    if (log.gain != bench.logs.front().gain)
      throw Error(bench.name + ": model.gain",
                  fmt::format("logs with gains of {:g} and {:g} duty per rad, and none",
                              bench.logs.front().gain, log.gain),
                  "the gain of the servo that the model has, duty per rad");
  return bench.logs.front().gain;
}

}  // namespace plumbline::motion
