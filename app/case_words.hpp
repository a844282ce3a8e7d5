#pragma once
/// \file
/// Ends, supports and loads of a chain as a person reads them.

#include <plumbline/space/space_structure.hpp>
#include <string>

namespace plumbline::app {

/// "base sprung, end point guided, dead force at the end point".
std::string case_of(const Structure<Rational>& structure);
/// "in space, base jointed, end point guided, dead force at the end point".
std::string case_of(const SpaceStructure<Rational>& structure);
/// Whether the loads are the one of the paper, whose factor is the force.
bool has_unit_compression(const Structure<Rational>& structure);

}  // namespace plumbline::app
