#pragma once
/// \file
/// Values and bounds of what was found.

#include <string>
#include <vector>

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// A parameter of the best explanation with its 95 % bounds, in catalogue units.
struct Estimate {
  std::string name, unit;
  double value, low, high;
  bool at_bound;
};

/// Puts elements of so many parameters each that may change places in the order of the last of them; the
/// names stay where they are.
void put_in_order(std::vector<Estimate>& estimates, std::size_t element);

/// Values and 95 % bounds by Laplace's method. \returns by effect, by parameter
/// \param temper  power at which the likelihood counts
std::vector<std::vector<Estimate>> estimate(const Study& study, const Hypothesis& found, double temper);

}  // namespace plumbline::diagnose
