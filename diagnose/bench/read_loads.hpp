#pragma once
/// \file
/// Reads the tables [[load]] of experiment.toml.

#include "diagnose/bench/load.hpp"
#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/bench/sample_format.hpp"
#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// The loads along a chain, in SI.
/// \param root    with the tables, and the units of their numbers
/// \param format  gets the columns of the loads' values, as its first covariates
/// \throws Error for a joint alone, or that names the key: none or several of the kinds of a load, moment arms
///         not one for each joint or all zero, a link that the chain does not have, a share outside 0 to 1, a
///         value that another load has
std::vector<Load> read_loads(const Section& root, const NominalChain& chain, SampleFormat& format);

}  // namespace plumbline::diagnose
