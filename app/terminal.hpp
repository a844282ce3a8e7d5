#pragma once
/// \file
/// The width of the terminal.

#include <cstddef>

namespace plumbline::app {

/// Number of columns of the terminal behind standard output (1) or standard error (2), or of mpirun's; 0 for
/// a pipe or file.
std::size_t terminal_columns(int stream);

}  // namespace plumbline::app
