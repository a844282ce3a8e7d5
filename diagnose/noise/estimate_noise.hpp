#pragma once
/// \file
/// The noise that readings show beside a discrepancy: outliers and departures from even noise, each accepted
/// where it is more probable than not.

#include "diagnose/inference/likelihood.hpp"

namespace plumbline::diagnose {

/// Departures are told from a gap beside a model that explains it.
enum class Departures { ignored, sought };

/// \param residual  flat, of the model that is believed so far
/// \param start     what is known of the noise already
NoiseShape estimate_noise(const Experiment& experiment, const Measurements& measurements,
                          const CommandStates& states, const VectorXd& nominal_residual,
                          const VectorXd& residual, NoiseShape start, Departures departures);

}  // namespace plumbline::diagnose
