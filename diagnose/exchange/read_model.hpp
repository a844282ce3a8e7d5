#pragma once
/// \file
/// A nominal chain out of a model's file, ours or a simulator's.

#include <filesystem>

#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/planar_chain.hpp"

namespace plumbline::exchange {

/// A simulator's model as its own parser has it.
/// \throws Error for a file that the parser refuses, and of a program that was built without it
ReadModel parsed(const std::filesystem::path& file, Format format);

/// \throws Error, one line: for an ending of no format, a file that its parser refuses, a parser that this
///         program was built without, and what is no planar serial chain of hinges
PlanarChain read_model(const std::filesystem::path& file);

}  // namespace plumbline::exchange
