#pragma once
/// \file
/// Readings that stand off their neighbours.

#include <vector>

#include "diagnose/noise/measurement.hpp"

namespace plumbline::diagnose {

/// Marks readings that stand off their neighbours, alone or in twos (Hampel's identifier, nine readings
/// wide, five where a series is short).
/// \param residual  flat, in declared sigmas
std::vector<bool> outliers(const Measurements& measurements, const std::vector<double>& residual);

/// The residual with each outlier replaced by the median of its neighbourhood.
std::vector<double> without_outliers(const Measurements& measurements, const std::vector<double>& residual);

}  // namespace plumbline::diagnose
