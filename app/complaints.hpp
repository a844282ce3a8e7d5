#pragma once
/// \file
/// What is wrong, on standard error: a line each, fit for a terminal.

#include <string>
#include <vector>

namespace plumbline::app {

/// "plumbline: TEXT", in one line whatever the text holds.
void complain(const std::string& text);

/// All of them, up to a number that a person reads; then how many more there are.
void complain(const std::vector<std::string>& errors);

}  // namespace plumbline::app
