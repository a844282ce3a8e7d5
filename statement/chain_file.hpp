#pragma once
/// \file
/// Chains as users write them, in the plane and in space: the one reader of all verbs, and of whoever states
/// a chain within another file. Every number is taken as the exact decimal that stands there.

#include <string>
#include <variant>

#include "statement/plane.hpp"
#include "statement/space.hpp"

namespace plumbline::statement {

/// A chain of a file: in space where it has the key `joints`.
using StatedChain = std::variant<PlaneChain, SpaceStructure<Rational>>;

/// A planar chain that is called something.
struct NamedChain : PlaneChain {
  std::string name;
  std::string place;  ///< "file:line", for messages
  std::string text;   ///< of its file; empty in a table of chains
};

/// From a table whose numbers are exact decimals (decimal_toml.hpp): the chain's keys themselves, or a table
/// [nominal] of them, as `plumbline chain` writes it.
/// \throws Error that names the source and the line or key
StatedChain read_chain(const toml::table& table, const std::string& source);
/// The same from TOML text.
StatedChain parse_chain(const std::string& text, const std::string& source);
/// A chain in the plane. \throws Error for one in space too
PlaneChain parse_plane_chain(const std::string& text, const std::string& source);

}  // namespace plumbline::statement
