#pragma once
/// \file
/// End point and joint angles of an unloaded chain.

#include <array>
#include <optional>
#include <vector>

#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::diagnose {

/// The end point at these joint angles; missing angles are zero.
std::array<double, 2> end_point(const NominalChain& chain, const std::vector<double>& rest);
/// The joint angles of a chain of one or two links with this end point, those nearest to `near`; empty where
/// there are none or the chain has more links.
std::optional<std::vector<double>> reaching(const NominalChain& chain, const std::vector<double>& near,
                                            std::array<double, 2> end);

}  // namespace plumbline::diagnose
