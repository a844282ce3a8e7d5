#pragma once
/// \file
/// The key `beam` of a chain file: a rod in so many bars.

#include <plumbline/structure/structure.hpp>

#include "proofs/rod/rod_of_chain.hpp"
#include "statement/typed_table.hpp"

namespace plumbline::statement {

/// The rod that a chain stands for.
using Beam = proofs::StatedRod;

/// A chain of bars from the key `beam`, its ends being those of the rod.
/// \throws Error that names the source and the line
Structure<Rational> read_beam(const TypedTable& table, Beam& beam);

}  // namespace plumbline::statement
