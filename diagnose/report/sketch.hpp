#pragma once
/// \file
/// The unexplained residual as a picture of characters.

#include <string>

#include "diagnose/discrepancy/unexplained.hpp"

namespace plumbline::diagnose {

/// Value over abscissa: '>' rising, '<' falling, '8' both; the zero line dotted, scales at the edges. At most
/// 72 columns.
std::string picture(const Missing& missing);

}  // namespace plumbline::diagnose
