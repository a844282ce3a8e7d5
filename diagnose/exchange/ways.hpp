#pragma once
/// \file
/// What each format can carry of each effect.

#include <string_view>

#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/exchange/format.hpp"

namespace plumbline::exchange {

struct Way {
  bool carried;
  std::string_view how;  ///< as what, or why not
  /// Whether the format has a word of its own for what changes, which is read as such; else the file has the
  /// row of the catalogue beside the elements that act it out.
  bool in_place = false;
  bool weighs = false;  ///< adds what weighs, so that the file has gravity
};

/// For every row of the catalogue that a planar chain may have.
/// \throws Error for another id
Way way_of(Format format, const diagnose::NominalEffect& effect);

/// Whether an effect, by its id or its label, adds what weighs.
bool adds_weight(std::string_view effect);

}  // namespace plumbline::exchange
