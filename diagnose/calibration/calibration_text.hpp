#pragma once
/// \file
/// How an arm was calibrated, in words and in JSON.

#include <nlohmann/json.hpp>

#include "diagnose/calibration/calibration.hpp"

namespace plumbline::diagnose {

/// What corrections leave of poses that they have not seen, how far joints are off, and the frames.
std::string calibration_as_text(const Calibration& of);

nlohmann::ordered_json calibration_as_json(const Calibration& of);

}  // namespace plumbline::diagnose
