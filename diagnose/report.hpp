#pragma once
/// \file
/// A diagnosis as machines read it (format "gap-diagnosis/1") and as a person does.

#include <nlohmann/json.hpp>

#include "diagnose/diagnosis.hpp"

namespace plumbline {

/// "joint_friction", "backlash(3)".
std::string label(const EffectAt& at);

nlohmann::ordered_json as_json(const Diagnosis& diagnosis);

/// The questions in order: is there a gap; where; what; how far; what next.
std::string as_text(const Diagnosis& diagnosis);

}  // namespace plumbline
