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
  std::string expected;    ///< what they are read as: "N"
  std::string remedy;      ///< what to write in experiment.toml if they are: "columns.Fx.unit = …"
  double factor = 0;       ///< of a unit over the one that they are read in; 0 where it is no unit
  bool mirror = false;     ///< whether a chain that buckles to its other side looks the same
  /// Converts one run; not given where the nominal chain is converted.
  std::function<void(Run&)> run = {};
  /// Converts the nominal chain, and in the runs what goes with it.
  std::function<void(Experiment&)> chain = {};
};

/// All that are looked for, the most common first. Units are those that labs use, but for the one that the
/// experiment itself names.
std::vector<Conversion> conversions(const Experiment& experiment);

/// The experiment with every run, and the nominal chain, converted.
Experiment converted(Experiment experiment, const Conversion& conversion);

}  // namespace plumbline::diagnose
