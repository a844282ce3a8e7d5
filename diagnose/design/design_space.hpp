#pragma once
/// \file
/// The design space of a bench: the runs that it could make, and the prediction of each effect in them.

#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// The runs that a bench could make.
struct DesignSpace {
  Experiment bench;                       ///< all runs, with the readings of the nominal model
  std::vector<std::string> descriptions;  ///< of the runs
  std::size_t planned = 0;                ///< the first runs are those that the lab plans
  std::vector<EffectAt> impossible;  ///< effects that cannot act on this bench, or that it cannot measure
  std::vector<Instance> effects;     ///< every other effect alone, at its typical size
};

/// The planned runs, and presses or loads, there and back, from their rest shapes and mirror images. Runs
/// that the nominal model or some effect cannot follow are left out, and so are effects that differ from run
/// to run, for no run is repeated.
/// \param bench  its measured channels are empty; its runs may have no readings
/// \throws Error where the nominal model cannot follow a planned run, or no run is left
DesignSpace design_space(const Experiment& bench);

/// The experiment with noise-free readings.
/// \param predicted  the readings; channels without a declared noise stay empty
Experiment measured_as(Experiment experiment, const Prediction& predicted);

}  // namespace plumbline::diagnose
