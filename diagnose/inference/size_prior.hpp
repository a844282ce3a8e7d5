#pragma once
/// \file
/// The prior of sizes, over their typical size: one law for the effects of the catalogue and for causes
/// outside of it (docs/how-it-decides.md).

#include <vector>

namespace plumbline::diagnose {

struct Hyperpriors;

/// Logarithm of the probability that a size is smaller than this one.
double log_smaller(double size);

/// A size on a grid, with the logarithm of its prior probability.
struct GridSize {
  double size, log_prior;
};

/// Sizes of equal ratios, from where smaller ones are rare to where larger ones are.
const std::vector<GridSize>& size_grid();

/// Logarithm of the prior of each size of the discrepancy that effects leave of a cause outside which they
/// imitate: half-Cauchy about the typical size, and never none.
std::vector<double> log_amplitude_imitated(const Hyperpriors& priors);

}  // namespace plumbline::diagnose
