#pragma once
/// \file
/// Where what is printed ends.

#include <cstddef>

namespace plumbline::app {

/// How many columns the terminal behind standard output (1) or standard error (2) has; 0 where there is none:
/// a pipe, a file. Under mpirun, which passes both on, it is mpirun's own that counts.
std::size_t terminal_columns(int stream);

}  // namespace plumbline::app
