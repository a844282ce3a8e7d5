#pragma once
/// \file
/// How readings scatter beside scale and correlation: which of them are outliers, and which scatter more.

#include "diagnose/next/likelihood.hpp"

namespace plumbline::diagnose::next {

/// All readings alike.
NoiseShape even_noise(const Data& data);

/// The shape that the readings themselves show, beside a discrepancy, where a model leaves this residual.
NoiseShape noise_shape(const Data& data, const States& states, const Hyperpriors& priors,
                       const std::vector<VectorXd>& nominal_residual, const std::vector<VectorXd>& residual,
                       NoiseShape start);

}  // namespace plumbline::diagnose::next
