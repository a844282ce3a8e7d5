#pragma once
/// \file
/// Reads a nominal model: the table [nominal] of an experiment, or of a file of its own.

#include <string>

#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// \throws Error that names the key, what was found and what was expected
NominalChain read_nominal(const Section& nominal);

/// A nominal model from TOML text with the table [nominal] alone.
/// \param source  named in errors
NominalChain parse_nominal(const std::string& text, const std::string& source);

/// An effect as the table [[nominal.effect]], which read_nominal() reads.
std::string nominal_effect_table(const NominalEffect& effect);

}  // namespace plumbline::diagnose
