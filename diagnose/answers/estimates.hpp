#pragma once
/// \file
/// Values and bounds of what was found.

#include <string>
#include <vector>

#include "diagnose/inference/fit.hpp"

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

/// Values and 95 % bounds, in the noise that it leaves. \returns by effect, by parameter
std::vector<std::vector<Estimate>> estimate(const Study& study, const Fit& found, const NoiseModel& noise);

}  // namespace plumbline::diagnose
