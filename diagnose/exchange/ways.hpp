#pragma once
/// \file
/// What each format can carry of each effect.

#include <string_view>

#include "diagnose/exchange/format.hpp"

namespace plumbline::exchange {

struct Way {
  bool carried;
  std::string_view how;  ///< as what, or why not
};

/// For every row of the catalogue.
/// \throws Error for another word
Way way_of(Format format, std::string_view effect);

}  // namespace plumbline::exchange
