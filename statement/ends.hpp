#pragma once
/// \file
/// The parts of a chain file that say what holds a chain, alike in the plane and in space.

#include <plumbline/structure/support.hpp>
#include <utility>

#include "statement/typed_table.hpp"

namespace plumbline::statement {

/// An end that has a word of its own, and what that word stands for.
using EndWord = std::pair<std::string_view, Support<Rational>>;

/// `base` or `end_point`: one of the words, or a table of `along`, `across`, `turn`, each "free", "held" or
/// the stiffness of a spring; what the table leaves out, and a missing key, is as otherwise.
/// \throws Error that names the source and the line
Support<Rational> read_end(const TypedTable& table, std::string_view key, const std::vector<EndWord>& words,
                           const Support<Rational>& otherwise);

/// The node of a chain of n links that "end_point", or the number of a joint from 2 on, is.
/// \throws Error that names the source and the line
std::size_t read_node(const TypedTable& table, std::string_view key, std::size_t n);

/// `supports`: what holds the nodes 1 … n - 1 of a chain of n links across; empty where the key is not there.
/// \throws Error that names the source and the line, for a joint that occurs twice too
std::vector<Restraint<Rational>> read_supports(const TypedTable& table, std::size_t n);

}  // namespace plumbline::statement
