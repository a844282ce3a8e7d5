#pragma once
/// \file
/// Ends, supports and loads of a chain as its file says them, and as a person reads them.

#include <array>
#include <plumbline/structure/structure.hpp>
#include <string>
#include <string_view>

#include "support/files/toml_file.hpp"

namespace plumbline::app {

/// The keys of a chain file that say how the chain is held and loaded.
inline constexpr std::array<std::string_view, 7> structure_keys{
    "base", "end_point", "supports", "foundation", "loads", "masses", "beam"};

/// "free", "held" or the stiffness of a spring. \throws Error at the place where it is none of them
Restraint<Rational> read_restraint(const toml::node& node, const std::string& where);
/// The node of a chain of n links that "end_point", or the number of a joint from 2 on, is.
/// \throws Error at the place where it is none of them
std::size_t read_node(const toml::node& node, const std::string& where, std::size_t n);

/// The rod that a chain stands for: bending stiffness, and length of each of its bars.
struct Beam {
  Rational EI, bar;
};

/// A chain of bars from the key `beam`, its ends being `base` and `end_point`, words here.
/// \throws Error that names the source and the line
Structure<Rational> read_beam(const toml::table& table, const std::string& source, Beam& beam);

/// What a chain file says of ends, supports, loads and masses; a unit force against x at the end point where
/// it has no loads. \throws Error that names the source and the line
void read_structure(const toml::table& table, const std::string& source, Structure<Rational>& structure);

/// "base sprung, end point guided, dead force at the end point".
std::string case_of(const Structure<Rational>& structure);
/// Whether the loads are the one of the paper, whose factor is the force.
bool has_unit_compression(const Structure<Rational>& structure);

}  // namespace plumbline::app
