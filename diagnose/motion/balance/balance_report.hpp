#pragma once
/// \file
/// The report of a balance of torque.

#include <nlohmann/json.hpp>
#include <string>

#include "diagnose/motion/balance/balance.hpp"

namespace plumbline::motion {

std::string as_text(const Balance& balance);

/// Format `torque-report/1`.
nlohmann::ordered_json as_json(const Balance& balance);

}  // namespace plumbline::motion
