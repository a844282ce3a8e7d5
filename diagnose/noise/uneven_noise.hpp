#pragma once
/// \file
/// A joint's encoder that is worse than the others', or a run that is rougher, found in the readings
/// themselves: no model enters.

#include <vector>

#include "diagnose/noise/differences.hpp"

namespace plumbline::diagnose {

/// How many times more each group of readings (of one joint, of one run) scatters than the others do, in the
/// middle of them, of two groups than the quieter one; 1 where it may be chance, where there are few readings
/// of it, where they scatter in proportion to themselves and one group has larger ones, or where it scatters
/// no more than others at the same place of the path: it is bent more than they are.
std::vector<double> uneven_noise(const std::vector<std::vector<SeenNoise>>& groups);

}  // namespace plumbline::diagnose
