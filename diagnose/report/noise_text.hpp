#pragma once
/// \file
/// What the terminal report says of the noise of the readings.

#include <string>

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

/// Indented lines: the noise beside the declared one, then each departure from it that was found.
std::string noise_as_text(const Diagnosis& diagnosis);

}  // namespace plumbline::diagnose
