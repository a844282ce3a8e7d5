#pragma once
/// \file
/// The plan of motions as text and JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "diagnose/motion/motion_plan.hpp"

namespace plumbline::motion {

std::string as_text(const MotionPlan& plan);

/// Format `motion-plan/1`.
nlohmann::ordered_json as_json(const MotionPlan& plan);

}  // namespace plumbline::motion
