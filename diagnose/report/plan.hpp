#pragma once
/// \file
/// An identifiability study as JSON (format "experiment-plan/2") and as text.

#include <nlohmann/json.hpp>
#include <string>

#include "diagnose/design/plan.hpp"

namespace plumbline::diagnose {

nlohmann::ordered_json as_json(const Plan& plan);

/// The text: effects that are not detected, effects that are not distinguished, the planned runs, the fewest
/// runs.
std::string as_text(const Plan& plan);

}  // namespace plumbline::diagnose
