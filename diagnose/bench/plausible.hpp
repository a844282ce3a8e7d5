#pragma once
/// \file
/// What no reading of a real chain can show.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// \throws Error, one line with run and reading, where the experiment cannot be physical or cannot be judged:
///         a commanded or measured end point out of reach, joint angles that put the end point elsewhere, a
///         measured channel whose declared noise is zero, a mechanism, too few measured values
void require_physical(const Experiment& experiment);

/// Largest and smallest distance of the end point from the base.
struct Reach {
  double smallest, largest;
};
Reach reach(const std::vector<double>& link_length);

}  // namespace plumbline::diagnose
