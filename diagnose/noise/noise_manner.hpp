#pragma once
/// \file
/// How the noise of a residual is to be looked at.

#include <vector>

#include "diagnose/noise/noise_model.hpp"
#include "diagnose/noise/measurement.hpp"

namespace plumbline::diagnose {

/// How to look at these readings. Where runs are read at different paces, noise is forgotten with time where
/// that makes it likelier than one correlation for all; what is slow may be a gap and is left out. Where
/// first differences tell of more correlation than second ones do, by more than chance, a slope is in them.
Manner manner_of(const Measurements& measurements, const std::vector<double>& residual);

}  // namespace plumbline::diagnose
