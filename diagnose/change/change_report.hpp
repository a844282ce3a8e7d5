#pragma once
/// \file
/// A change as text and as JSON (format "gap-diagnosis/2", with "against").

#include <nlohmann/json.hpp>
#include <string>

#include "diagnose/change/change.hpp"

namespace plumbline::diagnose {

/// The answer, what was compared, and the questions as for a single experiment.
std::string as_text(const Change& change);
nlohmann::ordered_json as_json(const Change& change);

}  // namespace plumbline::diagnose
