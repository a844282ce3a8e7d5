#pragma once
/// \file
/// Tables as laboratories write them, as the reader of experiments takes them.

#include <string>

#include "diagnose/draft/guess.hpp"

namespace plumbline::diagnose {

/// The text itself, where an experiment can say how it is written. Else CSV with one header and a decimal
/// point, and with numbers alone in the columns of numbers: clocks become seconds, units of cells and of a
/// column of units stand in the header, lines that are no rows are left out.
/// \param guesses  gets what was changed, and why
std::string readable_table(const std::string& text, const std::string& source, Guesses& guesses);

}  // namespace plumbline::diagnose
