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

/// ", there now and not before"; nothing where signs tell.
std::string senses(Sense sense);
/// As reports have them.
const char* sense_word(Sense sense);
const char* check_word(Check check);

}  // namespace plumbline::diagnose
