#pragma once
/// \file
/// Messages on standard error, one line each.

#include <string>
#include <vector>

namespace plumbline::app {

/// "plumbline: TEXT", in one line whatever the text holds.
void complain(const std::string& text);

/// All messages up to a limit, then the number of the others.
void complain(const std::vector<std::string>& errors);

}  // namespace plumbline::app
