#pragma once
/// \file
/// One joint's encoder that is worse than the others', found in the readings themselves: no model enters.

#include <vector>

namespace plumbline::diagnose {

/// How many times more the angle of each joint scatters than that of the others does, in the middle of them;
/// 1 where it may be chance, where there are few readings of it, and of fewer than three joints.
/// \param sizes  by joint: third differences of its readings, in declared sigmas
std::vector<double> uneven_noise(const std::vector<std::vector<double>>& sizes);

}  // namespace plumbline::diagnose
