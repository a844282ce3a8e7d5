#pragma once
/// \file
/// A diagnosis as machines read it (format "gap-diagnosis/1") and as a person does.

#include <nlohmann/json.hpp>

#include "diagnose/diagnosis.hpp"

namespace plumbline {

/// "joint_friction", "backlash(3)".
std::string label(const EffectAt& at);

nlohmann::ordered_json as_json(const Diagnosis& diagnosis);

}  // namespace plumbline
