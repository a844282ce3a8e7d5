#pragma once
/// \file
/// Reads a file of user effects: docs/user-effects.md.

#include <filesystem>

#include "diagnose/rig/user_effects/stated_effect.hpp"

namespace plumbline::diagnose {

/// \param source      names the text in errors
/// \param covariates  of the experiment: variables of every expression
/// \throws Error that names line and key
std::vector<StatedEffect> parse_effects(const std::string& text, const std::string& source,
                                        const std::vector<std::string>& covariates = {});

/// \throws Error for a file that cannot be read or does not conform
std::vector<StatedEffect> read_effects(const std::filesystem::path& file,
                                       const std::vector<std::string>& covariates);

}  // namespace plumbline::diagnose
