#pragma once
/// \file
/// Whether readings that stand off together do so by one event of the device, or each by chance.

#include "diagnose/inference/likelihood.hpp"

namespace plumbline::diagnose {

/// Logarithm of the Bayes factor of a local departure over independent outliers. In a local departure a few
/// readings in a row of one run lie anywhere (the Cauchy density of an outlier), in each channel or not, as
/// probably; every run and place is as probable, and every number of readings up to a quarter of the run. A
/// snap, a stop that is met or a cell at its end do so.
/// \param left   what a model leaves, flat, declared sigmas
/// \param noise  of the readings, with the outliers that were marked
double log_local_departure(const Measurements& measurements, const VectorXd& left,
                           const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
