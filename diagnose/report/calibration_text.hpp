#pragma once
/// \file
/// How an arm was calibrated, in words and in JSON.

#include <nlohmann/json.hpp>

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

/// What corrections leave of poses that they have not seen, how far joints are off, and the frames; empty
/// without a calibration.
std::string calibration_as_text(const Diagnosis& diagnosis);

nlohmann::ordered_json calibration_as_json(const Calibration& calibration);

}  // namespace plumbline::diagnose
