#pragma once
/// \file
/// How well a smooth function of the command, its direction and the run predicts readings that it has not
/// seen: what a cause that is named in part has to surpass.

#include <optional>

#include "diagnose/decision/cross_validation.hpp"

namespace plumbline::diagnose {

/// The discrepancy of the nominal model, of its most probable size and length by channel, held out in turn as
/// causes are.
std::optional<Shrink> smooth_forecast(const Study& study, const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
