#pragma once
/// \file
/// A change of a joint in motion as text and as JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "diagnose/change/motion_change.hpp"

namespace plumbline::diagnose {

/// The answer, the logs that were compared, and the diagnosis of them.
std::string as_text(const MotionChange& change);
/// Format "motion-report/1", with "against".
nlohmann::ordered_json as_json(const MotionChange& change);

}  // namespace plumbline::diagnose
