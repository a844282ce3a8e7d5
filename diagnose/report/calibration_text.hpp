#pragma once
/// \file
/// How an arm was calibrated, in words and in JSON.

#include <nlohmann/json.hpp>

#include "diagnose/inference/calibration.hpp"

namespace plumbline::diagnose {

/// "zeros of 10 mrad and tilts of axes of 4 mrad at all joints"; "no error of all joints" where none shows
std::string tolerances_in_words(const Calibration& of);

/// What corrections leave of poses that they have not seen, and the frames.
std::string calibration_as_text(const Calibration& of);

nlohmann::ordered_json calibration_as_json(const Calibration& of);

}  // namespace plumbline::diagnose
