#pragma once
/// \file
/// The key `beam` of a chain file: a rod in so many bars.

#include <plumbline/structure/structure.hpp>

#include "statement/typed_table.hpp"

namespace plumbline::statement {

/// The rod that a chain stands for: bending stiffness, and length of each of its bars.
struct Beam {
  Rational EI, bar;
};

/// A chain of bars from the key `beam`, its ends being `base` and `end_point`, words here.
/// \throws Error that names the source and the line
Structure<Rational> read_beam(const TypedTable& table, Beam& beam);

}  // namespace plumbline::statement
