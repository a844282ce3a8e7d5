#pragma once
/// \file
/// Texts in TOML.

#include <string>

namespace plumbline::diagnose {

/// A text as a basic string, with its quotes.
std::string quoted(const std::string& text);

}  // namespace plumbline::diagnose
