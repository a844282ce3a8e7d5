#pragma once
/// \file
/// The report of a diagnosis of logs: for people, and as JSON.

#include <nlohmann/json.hpp>

#include "diagnose/motion/diagnosis.hpp"

namespace plumbline::motion {

std::string as_text(const Diagnosis& diagnosis);
/// The motion in which the two most probable explanations differ most.
std::string next_text(const Diagnosis& diagnosis);

/// Format "motion-report/1" (docs/motion.md). SI units, radians.
nlohmann::ordered_json as_json(const Diagnosis& diagnosis);

}  // namespace plumbline::motion
