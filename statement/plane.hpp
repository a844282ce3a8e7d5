#pragma once
/// \file
/// A chain in the plane as a table of TOML says it: links, springs, ends, supports, loads and masses.

#include <optional>
#include <plumbline/structure/structure.hpp>
#include <string>

#include "statement/beam.hpp"

namespace plumbline::statement {

/// A chain with its ends and loads.
struct PlaneChain {
  Structure<Rational> structure;  ///< a unit force against x at the end point where it has no loads
  bool plain;                     ///< whether nothing is said of ends and loads: those of the paper
  std::optional<Beam> beam;       ///< that the chain stands for
};

/// \throws Error that names the source and the line
PlaneChain read_plane(const toml::table& table, const std::string& source);

}  // namespace plumbline::statement
