#pragma once
/// \file
/// Units as people spell them.

#include <string>
#include <vector>

#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {

/// The letters A to Z as small ones, and those with accents without: "Déplacement" is "deplacement".
std::string folded(const std::string& text);

/// As experiment.toml spells it, where the text is a unit of the quantity: "degrees" is "deg", a gram of
/// force "gf", "urad" "0.001 mrad"; else empty.
std::string unit_in(std::string text, const Quantity& quantity);

/// The first of some texts that is a unit of the quantity; or empty.
std::string unit_among(const std::vector<std::string>& said, const Quantity& quantity);

/// Whether a text is a unit of temperature, or of a current.
bool is_temperature_unit(const std::string& text);
bool is_current_unit(const std::string& text);

}  // namespace plumbline::diagnose
