#pragma once
/// \file
/// A plan as machines read it (format "experiment-plan/2") and as a person reads it in the terminal.

#include <nlohmann/json.hpp>
#include <string>

#include "diagnose/design/plan.hpp"

namespace plumbline::diagnose {

nlohmann::ordered_json as_json(const Plan& plan);

/// The questions in order: what is never seen; what is never told apart; what the planned runs leave open;
/// which runs separate the rest.
std::string as_text(const Plan& plan);

}  // namespace plumbline::diagnose
