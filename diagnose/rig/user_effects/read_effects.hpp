#pragma once
/// \file
/// Reads a file of user effects: docs/user-effects.md.

#include <filesystem>

#include "diagnose/rig/user_effects/stated_effect.hpp"

namespace plumbline::diagnose {

/// \param source  names the text in errors
/// \throws Error that names line and key
std::vector<StatedEffect> parse_effects(const std::string& text, const std::string& source);

/// \throws Error for a file that cannot be read or does not conform
std::vector<StatedEffect> read_effects(const std::filesystem::path& file);

}  // namespace plumbline::diagnose
