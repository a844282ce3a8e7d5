#pragma once
/// \file
/// A bench before any data: the runs that it could make, and what each effect would do in them.

#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Everything that a bench could measure.
struct DesignSpace {
  Experiment bench;  ///< every run that it could make, measured as the nominal chain would be
  std::vector<std::string> descriptions;  ///< of the runs
  std::size_t planned = 0;                ///< so many of the runs, the first, are those that the lab plans
  std::vector<EffectAt> impossible;       ///< effects that cannot act on this bench, or that nothing shows
  std::vector<Instance> effects;          ///< each of the others alone, of the size that a lab calls sizeable
};

/// The runs that are planned, and presses or loads, there and back, from their rest shapes and from these
/// turned over, as the plan's runs hold the end point or load it. Left out is what the nominal chain or some
/// effect could not follow. What differs from run to run is not looked at: no run is made twice.
/// \param bench  with its measured channels empty; its runs may have no readings
/// \throws Error where the nominal chain cannot follow what is planned, or no run is left
DesignSpace design_space(const Experiment& bench);

/// The experiment measured without noise.
/// \param predicted  what its channels show; those without a noise stay empty
Experiment measured_as(Experiment experiment, const Prediction& predicted);

}  // namespace plumbline::diagnose
