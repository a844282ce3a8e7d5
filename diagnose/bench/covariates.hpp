#pragma once
/// \file
/// Covariates: quantities noted at each reading that are no channel of the chain, such as a temperature.

#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Fills missing values by interpolation in time between those of the run, and with the nearest before the
/// first and after the last. Counts them in Run::interpolated.
/// \param place  of the runs, named in errors
/// \param named  by the experiment itself
/// \returns the names, the same in every run with readings; those of the experiment where no run has any
/// \throws Error where runs have different covariates, or one has no value of a covariate
std::vector<std::string> complete_covariates(std::vector<Run>& runs, const std::string& place,
                                             std::vector<std::string> named);

}  // namespace plumbline::diagnose
