#pragma once
/// \file
/// Units, signs, axes and orders in which a lab may have written an experiment down, and the way from each to
/// what the format demands.

#include <functional>
#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Reads numbers that were meant otherwise as they were meant.
struct Conversion {
  std::string what;        ///< the columns or keys: "Fx, Fy"
  std::string looks_like;  ///< what they seem to be: "kgf"
  std::string expected;    ///< what the format demands: "N"
  /// What a scale error of the rig would have to be within to look the same, as a share of the factor; 0
  /// where the conversion is no factor.
  double tolerance = 0;
  /// Converts one run; not given where the nominal chain is converted.
  std::function<void(Run&)> run;
  /// Converts what is not in a run.
  std::function<void(Experiment&)> chain;
};

/// All that are looked for, the most common first.
const std::vector<Conversion>& conversions();

/// The experiment with every run, and the nominal chain, converted.
Experiment converted(Experiment experiment, const Conversion& conversion);

}  // namespace plumbline::diagnose
