#pragma once
/// \file
/// Our own format: the table [nominal] of an experiment, in a file.

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// Reads again, by diagnose::parse_nominal, as the same chain with the same effects: to the last bit.
Written to_toml(const Model& model);

}  // namespace plumbline::exchange
