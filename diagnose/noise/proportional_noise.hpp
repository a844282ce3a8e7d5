#pragma once
/// \file
/// Noise that goes with the reading, as load cells and encoders with a gain that flickers have it, found in
/// the readings themselves: no model enters.

#include <vector>

#include "diagnose/noise/differences.hpp"

namespace plumbline::diagnose {

/// By what share of the reading the values of a channel scatter beside what they all scatter, over the
/// latter: their variance is s^2 (1 + r^2 value^2), and r is what is returned, per unit of the values. Zero
/// where uniform noise explains the differences nearly as well, or where they are those of a curve: the
/// ones of independent noise alternate. Of the shares that explain them nearly alike, as all large ones do
/// where no value is small, it is the one with which s comes nearest to the declared sigma.
double proportional_noise(const std::vector<Differences>& series);

/// Whether differences are not likelier without such a proportion; few are not.
bool is_likely(const std::vector<Differences>& series, double ratio);

}  // namespace plumbline::diagnose
