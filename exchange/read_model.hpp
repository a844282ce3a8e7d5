#pragma once
/// \file
/// A nominal chain out of a model's file, ours or a simulator's.

#include <filesystem>

#include "exchange/planar_chain.hpp"

namespace plumbline::exchange {

/// \throws Error, one line: for an ending of no format, a file that its parser refuses, a parser that this
///         program was built without, and what is no planar serial chain of hinges
PlanarChain read_model(const std::filesystem::path& file);

}  // namespace plumbline::exchange
