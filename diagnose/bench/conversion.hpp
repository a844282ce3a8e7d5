#pragma once
/// \file
/// Units, signs, axes and orders in which a lab may have written an experiment, and their conversions to the
/// format.

#include <functional>
#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// A conversion of numbers that were written in another convention.
struct Conversion {
  std::string what;        ///< the columns or keys: "Fx, Fy"
  std::string looks_like;  ///< the suspected convention: "kgf"
  std::string expected;    ///< the convention of the format: "N"
  std::string remedy;      ///< what to write in experiment.toml: "columns.Fx.unit = …"
  double factor = 0;       ///< of a unit over the one as which it is read; 0 for other conventions
  bool mirror = false;     ///< a chain that buckles to the other side looks the same
  /// Converts one run; empty where the nominal model is converted.
  std::function<void(Run&)> run = {};
  /// Converts the nominal model and, in the runs, what depends on it.
  std::function<void(Experiment&)> chain = {};
  bool of_some = false;  ///< happens in some runs, while others are right
};

/// All conversions that are considered, the most common first: units of laboratories, without the one that
/// the experiment names.
std::vector<Conversion> conversions(const Experiment& experiment);

/// The experiment with every run, and the nominal model, converted.
Experiment converted(Experiment experiment, const Conversion& conversion);

}  // namespace plumbline::diagnose
