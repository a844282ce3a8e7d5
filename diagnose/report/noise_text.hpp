#pragma once
/// \file
/// The noise of the readings in the terminal report.

#include <string>

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

/// The noise over the declared one: "Fx 2.00, q 0.45 to 0.62".
std::string noise_scales(const NoiseEstimate& noise);

/// "2 readings have no weight: outliers up to 300 standard deviations off, the largest Fx at reading 12 of
/// press-1"; empty where there are none.
std::string outliers_in_words(const std::vector<Outlier>& outliers);

/// Indented lines: the noise beside the declared one, each departure from it that was found, the outliers.
std::string noise_as_text(const Diagnosis& diagnosis);

}  // namespace plumbline::diagnose
