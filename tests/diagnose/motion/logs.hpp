#pragma once
/// \file
/// Logs for tests: a pendulum on a position servo that follows two sines.

#include <cmath>
#include <random>

#include "diagnose/motion/roll_out.hpp"

namespace plumbline::motion {

/// The drive of the tests, with one term beside.
inline Drive<double> planted_drive(Term term, double value) {
  Drive<double> drive;
  drive[Term::stall_torque] = 0.3, drive[Term::back_emf] = 0.25, drive[Term::armature] = 0.006;
  drive[Term::zero] = 0.01, drive[Term::dry] = 0.06;
  drive[term] += value;
  return drive;
}

/// Four seconds at 100 Hz, from rest at an angle; readings with this noise, rad.
inline MotionLog test_log(const Drive<double>& drive, double gain, double sigma, unsigned seed = 1,
                          double from = 0) {
  MotionLog log;
  log.name = "test";
  log.gain = 0.16 * gain, log.inertia = 0.0072, log.gravity = 0.59;
  for (int k = 0; k < 400; ++k) {
    const double t = 0.01 * k;
    log.time.push_back(t);
    log.command.push_back(0.7 * std::sin(2.2 * t) + 0.25 * std::sin((5 + gain / 8) * t));
    log.supply.push_back(12), log.powered.push_back(true);
  }
  log.position.assign(log.time.size(), 0);
  log.position = angles_of(drive, log, {0, 0, log.time.size()}, from, 0.0);
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0, sigma);
  if (sigma > 0)
    for (double& q : log.position) q += noise(generator);
  return log;
}

}  // namespace plumbline::motion
