#pragma once
/// \file
/// Words of a column title that say the tension of a tendon or the pressure in an actuator.

#include <string>
#include <vector>

#include "diagnose/draft/column_words.hpp"

namespace plumbline::diagnose {

/// Kind::tension or Kind::pressure where the words say it, whatever the unit: "cable tension", "tendon
/// force", "Seilkraft", "Kammerdruck". Else Kind::none.
/// \param words  of the title, in small letters
Kind actuation_of(const std::vector<std::string>& words);

/// What a title says together with a unit of that kind alone: a tendon in N, a chamber or "p" in bar; else
/// Kind::none.
Kind actuation_with_unit(const std::vector<std::string>& words);

/// The name of a covariate out of the words of its title: "flexor_tension".
std::string variable_of(const std::vector<std::string>& words);

}  // namespace plumbline::diagnose
