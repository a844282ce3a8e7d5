#pragma once
/// \file
/// A small picture in characters of what is missing.

#include <string>

#include "diagnose/discrepancy/unexplained.hpp"

namespace plumbline::diagnose {

/// Value over abscissa: '>' where that was rising, '<' where it was falling, '8' where both fall together;
/// the zero line dotted; scales at the edges. At most 72 columns wide.
std::string picture(const Missing& missing);

}  // namespace plumbline::diagnose
