#pragma once
/// \file
/// The file in which a user states effects: docs/user-effects.md.

#include <filesystem>

#include "diagnose/stated/stated_effect.hpp"

namespace plumbline::diagnose {

/// \param source  names the text in errors
/// \throws Error that names line and key
std::vector<StatedEffect> parse_effects(const std::string& text, const std::string& source);

/// The rows of a file, each of them defined on what a study looks at.
/// \throws Error for what is no such file, and as require_defined() does
std::shared_ptr<const std::vector<Effect>> read_effects(const std::filesystem::path& file,
                                                        const Study& study);

}  // namespace plumbline::diagnose
