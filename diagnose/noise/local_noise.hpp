#pragma once
/// \file
/// How large the noise of a residual is from place to place.

#include <vector>

#include "diagnose/noise/measurement.hpp"

namespace plumbline::diagnose {

/// By value, flat: the standard deviation of the noise about it, of its run and sensor, over that of its
/// channel, where it is larger; else 1, for where slow noise is smooth it is no smaller. From second
/// differences, in which a slow gap hardly shows, of nine readings around and of all channels of the sensor
/// that were read with it; of few such they are drawn to 1.
/// \param residual  free of outliers
std::vector<double> local_noise(const Measurements& measurements, const std::vector<double>& residual);

}  // namespace plumbline::diagnose
