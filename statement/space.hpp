#pragma once
/// \file
/// A chain in space as a table of TOML says it: the key `joints` in place of `stiffness` and `rest`.

#include <plumbline/space/space_structure.hpp>
#include <string>

#include "support/files/toml_file.hpp"

namespace plumbline::statement {

/// \throws Error that names the source and the line
SpaceStructure<Rational> read_space(const toml::table& table, const std::string& source);

}  // namespace plumbline::statement
