#pragma once
/// \file
/// The instruments: load cell, encoders and camera with their errors, noise and resolution.

#include <string>

#include "trial/simulator/random.hpp"
#include "trial/simulator/simulation.hpp"

namespace plumbline::simulator {

/// One line of a sample file; a value is NaN where the field stays empty.
struct Reading {
  double t;
  Pair end_point, force;
  std::vector<double> q;  ///< empty where joint angles are not measured
};
using Readings = std::vector<Reading>;

/// A value for each kind of sensor: force, position, angle.
struct Sigma {
  double force = 0, position = 0, angle = 0;
};

/// The noise of the readings.
struct Scatter {
  /// or misdeclared, outliers, ar1, ar1 of one sensor, proportional, interference, one channel
  std::string kind = "declared";
  Sigma sigma;  ///< true standard deviations
  Sigma declared;
  Sigma correlation;    ///< of successive readings, by sensor
  double outliers = 0;  ///< fraction of outliers
  Sigma proportional;   ///< standard deviation relative to the reading, beside sigma
  double interference = 0, interference_period = 1;  ///< periodic interference: amplitude in sigmas; s
  std::string bad_channel = {};                      ///< the channel with a larger sigma
  double bad_factor = 1;                             ///< its factor
  double missing = 0;                                ///< fraction of empty fields
  double resolution = 0;                             ///< of the instruments, in sigmas
};

/// Noise-free readings.
Readings show(const Plan& plan, const Physics& physics, const PlannedRun& run,
              const std::vector<State>& states);

/// Readings with noise.
Readings scattered(const PlannedRun& run, Readings readings, const Scatter& scatter, Random& random);

/// A measured value minus a reference, in sigmas.
struct Excess {
  std::string channel;
  double value;
};

/// Every measured value of `readings` beside that of `reference`.
std::vector<Excess> gap(const Plan& plan, const std::vector<Readings>& readings,
                        const std::vector<Readings>& reference, const Sigma& sigma);

}  // namespace plumbline::simulator
