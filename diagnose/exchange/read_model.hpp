#pragma once
/// \file
/// A nominal chain out of a model's file, ours or a simulator's.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/planar_chain.hpp"

namespace plumbline::exchange {

/// \param kept  the joints of a simulator's model that make the chain, the others held; empty: all
/// \throws Error, one line: for an ending of no format, a file that is none of its format, and what is no
///         planar serial chain of hinges
PlanarChain read_model(const std::filesystem::path& file, const std::vector<std::string>& kept = {});

}  // namespace plumbline::exchange
