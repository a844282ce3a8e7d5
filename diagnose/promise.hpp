#pragma once
/// \file
/// What one more effect promises beside a fitted explanation, from a single prediction.

#include <optional>

#include "diagnose/fit.hpp"

namespace plumbline {

/// A combination, and where its fit should start.
struct Promise {
  Candidate candidate;
  std::vector<double> start;
  double cost;  ///< what the linearised model expects to reach, comparable with Fit::cost
};

/// Linearises the combination of a fit and a newcomer where the one was fitted and the other has just begun
/// (an effect with a kink, whose beginning says nothing: where it stood alone), and takes one robust step.
/// \param alone  the newcomer fitted by itself
/// \returns nothing where the rig cannot follow the experiment
std::optional<Promise> promise(const Experiment& experiment, const Measurements& measurements,
                               const Fit& base, const Fit& alone, const std::vector<double>& beginning,
                               const FitSettings& settings);

}  // namespace plumbline
