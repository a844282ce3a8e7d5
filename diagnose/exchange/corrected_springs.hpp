#pragma once
/// \file
/// The springs of a chain to which effects are added, out of a file's, in which they are.

#include <string>

#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::exchange {

/// Stiffnesses and angles of rest as they are in a file, with the chain's effects in them, become those to
/// which the effects are added.
/// \param file  named in errors
/// \throws Error where no spring becomes that of the file by the effects
void take_off_springs(diagnose::NominalChain& chain, const std::string& file);

/// Whether joints of a chain have dry friction by its effects.
/// \param file  named in errors
bool has_friction(const diagnose::NominalChain& chain, const std::string& file);

}  // namespace plumbline::exchange
