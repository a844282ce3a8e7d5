#pragma once
/// \file
/// The bifurcated branch on which a chain was measured, where its nominal model may take either.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Imperfections that are too small to be measured choose the post-critical branch of a straight or nearly
/// symmetric chain. For a run whose readings are far from the nominal prediction, the predictions with one
/// rest angle changed by 0.6 degrees in either direction are tried. The Branch of the run is set to that of
/// the best of them, if it leaves at most a quarter of the nominal residual; where the nominal model has no
/// prediction, to that of the nearest.
Experiment on_observed_branches(const Study& study);

}  // namespace plumbline::diagnose
