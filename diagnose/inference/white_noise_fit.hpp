#pragma once
/// \file
/// Fits beside white noise, where nothing is known of a discrepancy: of planned or simulated readings.

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// The most likely parameters beside white noise of one scale for each channel, from the best of the
/// candidate's initial guesses; tolerances keep their priors. Every reading counts, none is an outlier. Not
/// converged where the rig cannot follow the experiment with any of the guesses.
Hypothesis fit_in_white_noise(const Study& study, const Candidate& candidate);

}  // namespace plumbline::diagnose
