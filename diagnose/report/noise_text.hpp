#pragma once
/// \file
/// The noise of the readings in the terminal report.

#include <string>

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

/// Indented lines: the noise beside the declared one, then each departure from it that was found.
std::string noise_as_text(const Diagnosis& diagnosis);

}  // namespace plumbline::diagnose
